(** The exact predicate's path for operands of any exponents (sign_of_sum, sign_of_close_sum and
    determinant_sign_of_any of octree/geometry/include/graze/octree/determinant_sign.hpp): a sum of at most
    four products, taken in groups from the highest exponents down, each group in 512 bits of two's
    complement, has the sign that is returned, whatever the gaps of the exponents.

    The eight 64-bit limbs of sign_of_close_sum are taken as addition modulo 2^512: Limbs.v proves
    the chain of carries and complements, and says what is open (where a term's limbs are placed). *)
From Coq Require Import ZArith Bool List Lia Permutation.
From Graze Require Import Determinant_sign.
Import ListNotations.
Open Scope Z_scope.

(** magnitude * 2^exponent, or its negative. *)
Record term := { magnitude : Z; term_exponent : Z; term_negative : bool }.
Definition good (t : term) : Prop := 0 < magnitude t < 2 ^ 106.
Definition signed_term (t : term) : Z := if term_negative t then - magnitude t else magnitude t.

(** The sum in units of 2^base. *)
Fixpoint total (base : Z) (l : list term) : Z :=
  match l with
  | [] => 0
  | t :: r => signed_term t * 2 ^ (term_exponent t - base) + total base r
  end.

(** * sign_of_close_sum: addition modulo 2^512, the sign by the highest bit *)
Fixpoint sum512 (lowest : Z) (l : list term) (sum : Z) : Z :=
  match l with
  | [] => sum
  | t :: r =>
      let placed := magnitude t * 2 ^ (term_exponent t - lowest) in
      sum512 lowest r ((sum + (if term_negative t then - placed else placed)) mod w512)
  end.
Definition sign512 (s : Z) : Z := if 2 ^ 511 <=? s then -1 else if s =? 0 then 0 else 1.
Definition sign_of_close_sum (l : list term) (lowest : Z) : Z := sign512 (sum512 lowest l 0).

Lemma sum512_total lowest l s :
  sum512 lowest l (s mod w512) = (s + total lowest l) mod w512.
Proof.
  revert s. induction l as [|t r IH]; intros s; cbn [sum512 total].
  - f_equal. lia.
  - cbv zeta. rewrite Z.add_mod_idemp_l by (unfold w512; lia). rewrite IH. f_equal.
    unfold signed_term. destruct (term_negative t); lia.
Qed.

(** Two's complement of 512 bits shows the sign of what is smaller than 2^511. *)
Lemma sign512_correct s : Z.abs s < 2 ^ 511 -> sign512 (s mod w512) = Z.sgn s.
Proof.
  intros H. unfold sign512.
  assert (W : w512 = 2 ^ 511 + 2 ^ 511) by reflexivity.
  assert (P : 0 < 2 ^ 511) by reflexivity.
  set (h := 2 ^ 511) in *. clearbody h.
  destruct (Z.lt_trichotomy s 0) as [L|[->|L]].
  - replace (s mod w512) with (s + w512).
    + destruct (Z.leb_spec h (s + w512)); [|lia]. symmetry. apply Z.sgn_neg. exact L.
    + rewrite <- (Z_mod_plus_full s 1 w512), Z.mul_1_l. symmetry. apply Z.mod_small. lia.
  - rewrite Z.mod_0_l by lia. destruct (Z.leb_spec h 0); [lia|reflexivity].
  - rewrite Z.mod_small by lia. destruct (Z.leb_spec h s); [lia|].
    destruct (Z.eqb_spec s 0); [lia|]. symmetry. apply Z.sgn_pos. exact L.
Qed.

(** Terms whose exponents reach from `lowest` up to `highest` have a sum below that of as many of the
    largest. *)
Lemma total_bound base highest l :
  Forall good l -> Forall (fun t => base <= term_exponent t <= highest) l ->
  Z.abs (total base l) <= Z.of_nat (length l) * (2 ^ 106 * 2 ^ (highest - base)).
Proof.
  intros G F. induction l as [|t r IH]; [simpl; lia|].
  inversion G as [|? ? Gt Gr]; subst. inversion F as [|? ? Ft Fr]; subst.
  specialize (IH Gr Fr). cbn [total length]. rewrite Nat2Z.inj_succ.
  assert (P : 0 < 2 ^ (term_exponent t - base) <= 2 ^ (highest - base)).
  { split; [apply pow2_pos; lia|apply Z.pow_le_mono_r; lia]. }
  assert (B : Z.abs (signed_term t * 2 ^ (term_exponent t - base)) <= 2 ^ 106 * 2 ^ (highest - base)).
  { rewrite Z.abs_mul. destruct Gt as [G1 G2].
    assert (A : Z.abs (signed_term t) = magnitude t) by (unfold signed_term; destruct (term_negative t); lia).
    rewrite A, (Z.abs_eq (2 ^ _)) by lia. apply Z.mul_le_mono_nonneg; lia. }
  lia.
Qed.

Theorem sign_of_close_sum_correct l lowest highest :
  Forall good l -> Forall (fun t => lowest <= term_exponent t <= highest) l ->
  (length l <= 4)%nat -> highest - lowest <= 402 ->
  sign_of_close_sum l lowest = Z.sgn (total lowest l).
Proof.
  intros G F N H. unfold sign_of_close_sum.
  change 0 with (0 mod w512) at 1. rewrite sum512_total, Z.add_0_l. apply sign512_correct.
  destruct l as [|t r] eqn:E; [reflexivity|]. rewrite <- E in *.
  assert (H0 : 0 <= highest - lowest) by (rewrite E in F; inversion F; lia).
  pose proof (total_bound lowest highest l G F) as B.
  assert (P : 0 < 2 ^ (highest - lowest) <= 2 ^ 402).
  { split; [apply pow2_pos; lia|apply Z.pow_le_mono_r; lia]. }
  assert (Q : 4 * (2 ^ 106 * 2 ^ 402) < 2 ^ 511) by reflexivity.
  assert (N' : Z.of_nat (length l) <= 4) by lia.
  assert (X : Z.of_nat (length l) * (2 ^ 106 * 2 ^ (highest - lowest)) <= 4 * (2 ^ 106 * 2 ^ 402)).
  { apply Z.mul_le_mono_nonneg; try lia. }
  lia.
Qed.

(** * sign_of_sum: groups of terms whose neighbours are less than 108 apart *)
Fixpoint group (t : term) (l : list term) : list term * list term :=
  match l with
  | [] => ([], [])
  | u :: r =>
      if term_exponent t - term_exponent u <? 108
      then let (g, rest) := group u r in (u :: g, rest)
      else ([], l)
  end.
Fixpoint last_exponent (t : term) (g : list term) : Z :=
  match g with [] => term_exponent t | u :: r => last_exponent u r end.

Fixpoint sign_of_sum (fuel : nat) (l : list term) : Z :=
  match fuel, l with
  | S n, t :: r =>
      let (g, rest) := group t r in
      let sign := sign_of_close_sum (t :: g) (last_exponent t g) in
      if sign =? 0 then sign_of_sum n rest else sign
  | _, _ => 0
  end.

(** Highest exponents first. *)
Fixpoint descending_from (t : term) (l : list term) : Prop :=
  match l with [] => True | u :: r => term_exponent u <= term_exponent t /\ descending_from u r end.
Definition descending (l : list term) : Prop :=
  match l with [] => True | t :: r => descending_from t r end.

Lemma descending_below t l : descending_from t l ->
  Forall (fun u => term_exponent u <= term_exponent t) l.
Proof.
  revert t. induction l as [|u r IH]; intros t H; constructor; [apply H|].
  destruct H as [H1 H2]. specialize (IH u H2).
  apply Forall_impl with (2 := IH). intros. lia.
Qed.

(** What a group is. *)
Lemma group_spec t l g rest : descending_from t l -> group t l = (g, rest) ->
  l = g ++ rest /\ descending rest /\
  Forall (fun u => last_exponent t g <= term_exponent u <= term_exponent t) (t :: g) /\
  term_exponent t - last_exponent t g <= 107 * Z.of_nat (length g) /\
  Forall (fun u => term_exponent u <= last_exponent t g - 108) rest.
Proof.
  revert t g rest. induction l as [|u r IH]; intros t g rest D E; cbn [group] in E.
  - injection E as <- <-. repeat split; try constructor; simpl; try lia; constructor.
  - destruct D as [D1 D2]. destruct (Z.ltb_spec (term_exponent t - term_exponent u) 108) as [L|L].
    + destruct (group u r) as [g' rest'] eqn:E'. injection E as <- <-.
      destruct (IH u g' rest' D2 E') as (-> & Dr & F & B & R). cbn [last_exponent length].
      inversion F as [|? ? Fu Fg]; subst.
      split; [reflexivity|]. split; [exact Dr|]. split; [|split; [lia|exact R]].
      constructor; [lia|]. constructor; [lia|].
      apply Forall_impl with (2 := Fg). intros. cbv beta in *. lia.
    + injection E as <- <-. cbn [last_exponent length]. split; [reflexivity|].
      split; [exact D2|]. split; [constructor; [lia|constructor]|]. split; [lia|].
      constructor; [lia|]. apply Forall_impl with (2 := descending_below _ _ D2). intros. cbv beta in *. lia.
Qed.

Lemma total_app base l r : total base (l ++ r) = total base l + total base r.
Proof. induction l; cbn [app total]; [reflexivity|rewrite IHl; ring]. Qed.

Lemma total_units base lower l : base <= lower -> Forall (fun t => lower <= term_exponent t) l ->
  total base l = total lower l * 2 ^ (lower - base).
Proof.
  intros H F. induction F as [|t r Ft Fr IH]; [reflexivity|]. cbn [total]. rewrite IH.
  replace (term_exponent t - base) with ((term_exponent t - lower) + (lower - base)) by ring.
  rewrite Z.pow_add_r by lia. ring.
Qed.

(** The sign of a sum of at most four terms. *)
Theorem sign_of_sum_correct fuel l base :
  (length l <= fuel)%nat -> (length l <= 4)%nat -> Forall good l -> descending l ->
  Forall (fun t => base <= term_exponent t) l ->
  sign_of_sum fuel l = Z.sgn (total base l).
Proof.
  revert l. induction fuel as [|n IH]; intros [|t r] Hf H4 G D B; try reflexivity.
  { simpl in Hf. lia. }
  cbn [sign_of_sum]. destruct (group t r) as [g rest] eqn:E.
  destruct (group_spec t r g rest D E) as (-> & Dr & F & W & R).
  cbn [length] in Hf, H4. rewrite app_length in Hf, H4.
  rewrite app_comm_cons in G, B |- *. apply Forall_app in G. destruct G as [Gg Gr].
  apply Forall_app in B. destruct B as [Bg Br].
  set (low := last_exponent t g) in *.
  assert (Lb : base <= low).
  { unfold low. clear - Bg. revert t Bg. induction g as [|u g' IHg]; intros t Bg.
    - inversion Bg; assumption.
    - cbn [last_exponent]. apply IHg. inversion Bg; assumption. }
  rewrite (sign_of_close_sum_correct (t :: g) low (term_exponent t)); try assumption;
    try (cbn [length]; lia).
  rewrite total_app, (total_units base low (t :: g) Lb)
    by (apply Forall_impl with (2 := F); intros; cbv beta in *; lia).
  pose proof (pow2_pos (low - base) ltac:(lia)) as P.
  set (S := total low (t :: g)) in *.
  destruct (Z.eqb_spec (Z.sgn S) 0) as [Z|Z].
  - apply (proj1 (Z.sgn_null_iff S)) in Z. rewrite Z, Z.mul_0_l, Z.add_0_l. apply IH; try assumption; lia.
  - assert (TR : Z.abs (total base rest) < 2 ^ (low - base)).
    { destruct (Z.lt_ge_cases (low - 108) base) as [L|L].
      - destruct rest as [|u r']; [simpl; lia|].
        inversion R; inversion Br; subst. lia.
      - pose proof (total_bound base (low - 108) rest Gr) as T.
        assert (F' : Forall (fun u => base <= term_exponent u <= low - 108) rest).
        { apply Forall_forall. intros u U. rewrite Forall_forall in R, Br.
          specialize (R u U). specialize (Br u U). cbv beta in *. lia. }
        specialize (T F').
        assert (X : 2 ^ (low - base) = 4 * (2 ^ 106 * 2 ^ (low - 108 - base))).
        { change 4 with (2 ^ 2). rewrite <- !Z.pow_add_r by lia. f_equal. lia. }
        pose proof (pow2_pos (low - 108 - base) ltac:(lia)).
        assert (Z.of_nat (length rest) <= 3) by lia.
        assert (Z.of_nat (length rest) * (2 ^ 106 * 2 ^ (low - 108 - base)) <=
                3 * (2 ^ 106 * 2 ^ (low - 108 - base)))
          by (apply Z.mul_le_mono_nonneg_r; [apply Z.mul_nonneg_nonneg; lia|lia]).
        lia. }
    destruct (Z.lt_trichotomy S 0) as [N|[N|N]]; [|rewrite N in Z; contradiction|].
    + rewrite (Z.sgn_neg S N). symmetry. apply Z.sgn_neg. nia.
    + rewrite (Z.sgn_pos S N). symmetry. apply Z.sgn_pos. nia.
Qed.

(** * determinant_sign_of_any *)
Definition product_term (a b : parts) (subtract : bool) : list term :=
  let m := significand a * significand b in
  if m =? 0 then []
  else [{| magnitude := m; term_exponent := exponent a + exponent b;
           term_negative := negb (Bool.eqb subtract (negative a)) |}].
Definition determinant_terms (xg xl xf yg yl yf : parts) : list term :=
  product_term xg xf false ++ product_term xl xf true ++
  product_term yg yf true ++ product_term yl yf false.

Lemma product_term_good a b s : proper a -> proper b -> Forall good (product_term a b s).
Proof.
  intros [A1 A2] [B1 B2]. unfold product_term. cbv zeta.
  destruct (Z.eqb_spec (significand a * significand b) 0) as [E|E]; constructor; [|constructor].
  unfold good. cbn [magnitude]. change (2 ^ 106) with (2 ^ 53 * 2 ^ 53). nia.
Qed.
Lemma product_term_length a b s : (length (product_term a b s) <= 1)%nat.
Proof. unfold product_term. cbv zeta. destruct (_ =? _); simpl; lia. Qed.
Lemma product_term_exponents a b s base fbase : base <= exponent a -> fbase <= exponent b ->
  Forall (fun t => base + fbase <= term_exponent t) (product_term a b s).
Proof.
  intros. unfold product_term. cbv zeta. destruct (_ =? _); constructor; [|constructor].
  cbn [term_exponent]. lia.
Qed.
Lemma product_term_total a b (s : bool) base fbase : base <= exponent a -> fbase <= exponent b ->
  total (base + fbase) (product_term a b s) =
  (if s then -1 else 1) * (in_units base a * significand b * 2 ^ (exponent b - fbase)).
Proof.
  intros A B. unfold product_term, in_units. cbv zeta.
  destruct (Z.eqb_spec (significand a * significand b) 0) as [E|E]; cbn [total].
  - replace (signed a * 2 ^ (exponent a - base) * significand b * 2 ^ (exponent b - fbase))
      with (signed a * significand b * (2 ^ (exponent a - base) * 2 ^ (exponent b - fbase))) by ring.
    replace (signed a * significand b) with 0; [destruct s; reflexivity|].
    unfold signed. destruct (negative a); lia.
  - unfold signed_term, signed. cbn [magnitude term_exponent term_negative].
    replace (exponent a + exponent b - (base + fbase))
      with ((exponent a - base) + (exponent b - fbase)) by ring.
    rewrite Z.pow_add_r by lia. destruct s, (negative a); cbn [negb Bool.eqb]; ring.
Qed.

Lemma total_permutation base l l' : Permutation l l' -> total base l = total base l'.
Proof. induction 1; cbn [total]; lia. Qed.

(** The slow path, for any exponents: sorted terms give the sign of the determinant. *)
Theorem determinant_sign_of_any_correct xg xl xf yg yl yf base fbase sorted :
  proper xg -> proper xl -> proper xf -> proper yg -> proper yl -> proper yf ->
  base <= exponent xg -> base <= exponent xl -> base <= exponent yg -> base <= exponent yl ->
  fbase <= exponent xf -> fbase <= exponent yf ->
  Permutation (determinant_terms xg xl xf yg yl yf) sorted -> descending sorted ->
  sign_of_sum 4 sorted = Z.sgn (determinant base fbase xg xl xf yg yl yf).
Proof.
  intros P1 P2 P3 P4 P5 P6 B1 B2 B3 B4 B5 B6 Perm D.
  assert (L : (length (determinant_terms xg xl xf yg yl yf) <= 4)%nat).
  { unfold determinant_terms. rewrite !app_length.
    pose proof (product_term_length xg xf false). pose proof (product_term_length xl xf true).
    pose proof (product_term_length yg yf true). pose proof (product_term_length yl yf false). lia. }
  rewrite (Permutation_length Perm) in L.
  rewrite (sign_of_sum_correct 4 sorted (base + fbase)); try assumption.
  - f_equal. rewrite <- (total_permutation _ _ _ Perm). unfold determinant_terms, determinant.
    rewrite !total_app, !product_term_total by assumption. ring.
  - apply (Permutation_Forall Perm). unfold determinant_terms.
    repeat (apply Forall_app; split); apply product_term_good; assumption.
  - apply (Permutation_Forall Perm). unfold determinant_terms.
    repeat (apply Forall_app; split); apply product_term_exponents; assumption.
Qed.
