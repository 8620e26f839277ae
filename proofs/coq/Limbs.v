(** The chain of 64-bit limbs in sign_of_close_sum (octree/geometry/include/graze/octree/determinant_sign.hpp)
    adds a term, or subtracts it by complement and carry, modulo 2^(64 n): what Sum_sign.v takes as
    addition modulo 2^512, for n = 8.

    OPEN: that the three limbs at[0..2], shifted, hold magnitude * 2^shift. *)
From Coq Require Import ZArith Bool List Lia.
From Graze Require Import Determinant_sign.
Import ListNotations.
Open Scope Z_scope.

(** The number that limbs hold, the lowest first. *)
Fixpoint held (l : list Z) : Z := match l with [] => 0 | x :: r => x + w64 * held r end.
Fixpoint range (l : list Z) : Z := match l with [] => 1 | _ :: r => w64 * range r end.

(** s = sum[j] + placed[j] + carry; sum[j] = low half, carry = high half. *)
Fixpoint add_limbs (xs ys : list Z) (carry : Z) : list Z :=
  match xs, ys with
  | x :: xs', y :: ys' =>
      let s := x + y + carry in s mod w64 :: add_limbs xs' ys' (s / w64)
  | _, _ => []
  end.

Lemma range_positive l : 0 < range l.
Proof. induction l; cbn [range]; [lia|]. assert (0 < w64) by reflexivity. nia. Qed.

(** The chain adds modulo its range. *)
Theorem add_limbs_correct xs ys carry : length xs = length ys ->
  held (add_limbs xs ys carry) = (held xs + held ys + carry) mod range xs.
Proof.
  revert ys carry. induction xs as [|x xs IH]; intros [|y ys] carry L; try discriminate.
  - cbn [add_limbs held range]. symmetry. apply Z.mod_1_r.
  - cbn [add_limbs held range]. cbv zeta. cbn [held]. injection L as L. rewrite IH by exact L.
    pose proof (range_positive xs) as P. assert (W : 0 < w64) by reflexivity.
    rewrite Z.rem_mul_r by lia.
    replace (x + w64 * held xs + (y + w64 * held ys) + carry)
      with (x + y + carry + (held xs + held ys) * w64) by ring.
    rewrite Z.mod_add, Z.div_add by lia. do 3 f_equal. lia.
Qed.

Definition limb (x : Z) : Prop := 0 <= x < w64.
(** placed[j] ^ flip, flip all ones. *)
Definition complement (l : list Z) : list Z := map (fun y => Z.lxor y (w64 - 1)) l.

Lemma complement_correct l : Forall limb l -> held (complement l) = range l - 1 - held l.
Proof.
  induction 1 as [|x r X R IH]; [reflexivity|]. unfold complement in *. cbn [map held range].
  rewrite IH. unfold limb in X.
  assert (E : Z.lxor x (w64 - 1) = w64 - 1 - x) by (apply (flipped x 64); [lia|exact X]).
  rewrite E. ring.
Qed.

(** Complement with a carry of 1 subtracts. *)
Theorem subtract_limbs_correct xs ys : length xs = length ys -> Forall limb ys ->
  held (add_limbs xs (complement ys) 1) = (held xs - held ys) mod range xs.
Proof.
  intros L F. rewrite add_limbs_correct by (unfold complement; rewrite map_length; exact L).
  rewrite complement_correct by exact F.
  assert (E : range ys = range xs).
  { clear F. revert ys L. induction xs as [|x xs IH]; intros [|y ys] L; try discriminate; [reflexivity|].
    cbn [range]. injection L as L. rewrite (IH ys L). reflexivity. }
  rewrite E. pose proof (range_positive xs).
  replace (held xs + (range xs - 1 - held ys) + 1) with (held xs - held ys + 1 * range xs) by ring.
  apply Z.mod_add. lia.
Qed.

(** Eight limbs are 512 bits. *)
Lemma range_of_eight a b c d e f g h : range [a; b; c; d; e; f; g; h] = w512.
Proof. reflexivity. Qed.
