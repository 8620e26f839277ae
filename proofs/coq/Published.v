(** The paper's ray/octant test as printed (fuzz/peers/paper2005/published.hpp) misses octants:
    the gap of the paper as theorems, by computation inside Coq.

    [published] below is `published::enter` (and, for an octant, the test of `split`, which takes the
    octant's own planes) line by line over binary64. Each case names a finite ray and an octant; the
    point at which the ray is inside is a rational t >= 0, checked in integers and carried over to
    the reals; the test is evaluated by vm_compute. Of every case is also said that the sound test of
    Model.v passes it, and which single repair of the printed test would have found it. *)
From Coq Require Import ZArith Bool List Reals Lia Lra.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model.
Open Scope R_scope.

Definition prec64 := 53%Z.
Definition emax64 := 1024%Z.
#[global] Instance prec64_gt_0 : Prec_gt_0 prec64 := eq_refl.
#[global] Instance prec64_lt_emax : Prec_lt_emax prec64 emax64 := eq_refl.

Definition double := float prec64 emax64.
Definition times m (x y : double) : double := Bmult m x y.
Definition minus m (x y : double) : double := Bminus m x y.
Notation "x <? y" := (lt prec64 emax64 x y).
Definition zero64 : double := zero prec64 emax64.
Definition one64 : double := one prec64 emax64.

(** * The test as printed *)
Record bounds := { lower : double; upper : double }.

(** c = sign(d) (|d'| |d''|), rounded once. *)
Definition printed_c (d other1 other2 : double) : double :=
  let sign := if d <? zero64 then Bopp one64 else if zero64 <? d then one64 else zero64 in
  times mode_NE sign (times mode_NE (Babs other1) (Babs other2)).

(** `bound`: one rounding of the difference, then the product rounded both ways. *)
Definition printed_bound (c o x : double) : bounds :=
  let difference := minus mode_NE x o in
  {| lower := times mode_DN c difference; upper := times mode_UP c difference |}.

Definition between (c : double) (lo hi : bounds) : bounds :=
  if c <? zero64 then {| lower := lower hi; upper := upper lo |}
  else {| lower := lower lo; upper := upper hi |}.

(** std::min and std::max of three, as the C++ library defines them (NaN included). *)
Definition min3 (x y z : double) : double :=
  let m := if y <? x then y else x in if z <? m then z else m.
Definition max3 (x y z : double) : double :=
  let m := if x <? y then y else x in if m <? z then z else m.

(** "No overlap when a lower bound of an interval is equal to the upper bound of another." *)
Definition printed_overlap (x y z : bounds) : bool :=
  let least := min3 (upper x) (upper y) (upper z) in
  (max3 (lower x) (lower y) (lower z) <? least) && (zero64 <? least).

Definition printed_axis (o d other1 other2 lo hi : double) : bounds :=
  let c := printed_c d other1 other2 in
  between c (printed_bound c o lo) (printed_bound c o hi).

Definition published (o d lo hi : three double) : bool :=
  printed_overlap
    (printed_axis (at_x o) (at_x d) (at_y d) (at_z d) (at_x lo) (at_x hi))
    (printed_axis (at_y o) (at_y d) (at_z d) (at_x d) (at_y lo) (at_y hi))
    (printed_axis (at_z o) (at_z d) (at_x d) (at_y d) (at_z lo) (at_z hi)).

(** * The printed test with single repairs: which rounding or rule is to blame *)
Record repair := {
  two_sided_c : bool;          (** c rounded both ways, each bound takes its own *)
  two_sided_difference : bool; (** x - x0 rounded both ways *)
  touching : bool }.           (** bounds that are equal overlap *)
Definition as_printed := {| two_sided_c := false; two_sided_difference := false; touching := false |}.
Definition only_c := {| two_sided_c := true; two_sided_difference := false; touching := false |}.
Definition only_difference :=
  {| two_sided_c := false; two_sided_difference := true; touching := false |}.
Definition only_touching :=
  {| two_sided_c := false; two_sided_difference := false; touching := true |}.
Definition all_three := {| two_sided_c := true; two_sided_difference := true; touching := true |}.

Section Repaired.
Variable r : repair.
Definition size_c m (other1 other2 : double) : double :=
  times (if two_sided_c r then m else mode_NE) (Babs other1) (Babs other2).
(** A bound of c (x - x0) for c > 0 and of (x0 - x) |c| for c < 0; 0 (x - x0) for c = 0. *)
Definition repaired_low (d o1 o2 p q : double) : double :=
  let u := minus (if two_sided_difference r then mode_DN else mode_NE) p q in
  times mode_DN (size_c (if u <? zero64 then mode_UP else mode_DN) o1 o2) u.
Definition repaired_high (d o1 o2 p q : double) : double :=
  let u := minus (if two_sided_difference r then mode_UP else mode_NE) p q in
  times mode_UP (size_c (if zero64 <? u then mode_UP else mode_DN) o1 o2) u.
Definition repaired_axis (o d o1 o2 lo hi : double) : bounds :=
  if d <? zero64 then {| lower := repaired_low d o1 o2 o hi; upper := repaired_high d o1 o2 o lo |}
  else if zero64 <? d
  then {| lower := repaired_low d o1 o2 lo o; upper := repaired_high d o1 o2 hi o |}
  else {| lower := zero64; upper := zero64 |}.
Definition repaired_overlap (x y z : bounds) : bool :=
  let least := min3 (upper x) (upper y) (upper z) in
  let greatest := max3 (lower x) (lower y) (lower z) in
  if touching r then negb (least <? greatest) && negb (least <? zero64)
  else (greatest <? least) && (zero64 <? least).
Definition repaired (o d lo hi : three double) : bool :=
  repaired_overlap
    (repaired_axis (at_x o) (at_x d) (at_y d) (at_z d) (at_x lo) (at_x hi))
    (repaired_axis (at_y o) (at_y d) (at_z d) (at_x d) (at_y lo) (at_y hi))
    (repaired_axis (at_z o) (at_z d) (at_x d) (at_y d) (at_z lo) (at_z hi)).
End Repaired.

(** The sound test, for comparison. *)
Definition sound (o d lo hi : three double) : bool :=
  let b := directed prec64 emax64 in
  touches_box prec64 emax64 b (prepare prec64 emax64 b o d) lo hi.

(** * Ray and octant over the reals *)
Definition real (x : double) : R := B2R x.
Definition all_finite (v : three double) : Prop :=
  is_finite (at_x v) = true /\ is_finite (at_y v) = true /\ is_finite (at_z v) = true.

(** The ray meets the closed box. *)
Definition meets (o d lo hi : three double) : Prop :=
  exists t : R, 0 <= t /\
  real (at_x lo) <= real (at_x o) + t * real (at_x d) <= real (at_x hi) /\
  real (at_y lo) <= real (at_y o) + t * real (at_y d) <= real (at_y hi) /\
  real (at_z lo) <= real (at_z o) + t * real (at_z d) <= real (at_z hi).

(** The ray passes through the box's interior, at t > 0. *)
Definition crosses (o d lo hi : three double) : Prop :=
  exists t : R, 0 < t /\
  real (at_x lo) < real (at_x o) + t * real (at_x d) < real (at_x hi) /\
  real (at_y lo) < real (at_y o) + t * real (at_y d) < real (at_y hi) /\
  real (at_z lo) < real (at_z o) + t * real (at_z d) < real (at_z hi).

(** x in units of 2^-k; None where it is not a multiple of that. *)
Definition in_units (k : Z) (x : double) : option Z :=
  match x with
  | B754_zero _ => Some 0%Z
  | B754_finite s m e _ =>
      if (0 <=? e + k)%Z then Some (cond_Zopp s (Zpos m) * 2 ^ (e + k))%Z else None
  | _ => None
  end.

(** in_units is exact. *)
Lemma in_units_correct k x n : in_units k x = Some n -> real x = IZR n * bpow radix2 (- k).
Proof.
  destruct x as [s|s| |s m e H]; try discriminate; simpl.
  - intros [= <-]. unfold real. simpl. ring.
  - destruct (0 <=? e + k)%Z eqn:E; try discriminate. intros [= <-].
    apply Z.leb_le in E. unfold real, B2R, F2R, Fnum, Fexp.
    rewrite mult_IZR. change (2 ^ (e + k))%Z with (radix_val radix2 ^ (e + k))%Z.
    rewrite IZR_Zpower by exact E. rewrite Rmult_assoc, <- bpow_plus.
    f_equal. f_equal. lia.
Qed.

(** At t = n/q the ray is between (strictly, or not) two planes: decided in integers. *)
Definition inside_units (cmp : Z -> Z -> bool) (k n q : Z) (o d lo hi : double) : bool :=
  match in_units k o, in_units k d, in_units k lo, in_units k hi with
  | Some o, Some d, Some lo, Some hi =>
      (cmp (q * lo) (q * o + n * d) && cmp (q * o + n * d) (q * hi))%Z
  | _, _, _, _ => false
  end.
Definition inside3 cmp k n q (o d lo hi : three double) : bool :=
  inside_units cmp k n q (at_x o) (at_x d) (at_x lo) (at_x hi) &&
  inside_units cmp k n q (at_y o) (at_y d) (at_y lo) (at_y hi) &&
  inside_units cmp k n q (at_z o) (at_z d) (at_z lo) (at_z hi).

Lemma inside_units_le k n q o d lo hi :
  (0 < q)%Z -> inside_units Z.leb k n q o d lo hi = true ->
  real lo <= real o + IZR n / IZR q * real d <= real hi.
Proof.
  intros Hq. unfold inside_units.
  destruct (in_units k o) as [o'|] eqn:Eo; [|discriminate].
  destruct (in_units k d) as [d'|] eqn:Ed; [|discriminate].
  destruct (in_units k lo) as [l'|] eqn:El; [|discriminate].
  destruct (in_units k hi) as [h'|] eqn:Eh; [|discriminate].
  rewrite (in_units_correct _ _ _ Eo), (in_units_correct _ _ _ Ed),
    (in_units_correct _ _ _ El), (in_units_correct _ _ _ Eh).
  intros H. apply andb_true_iff in H. destruct H as [H1 H2].
  apply Z.leb_le, IZR_le in H1. apply Z.leb_le, IZR_le in H2.
  rewrite plus_IZR, !mult_IZR in H1. rewrite plus_IZR, !mult_IZR in H2.
  assert (Q : 0 < IZR q) by (apply IZR_lt; exact Hq).
  pose proof (bpow_gt_0 radix2 (- k)) as B.
  replace (IZR o' * bpow radix2 (- k) + IZR n / IZR q * (IZR d' * bpow radix2 (- k)))
    with ((IZR q * IZR o' + IZR n * IZR d') / IZR q * bpow radix2 (- k)) by (field; lra).
  split; apply Rmult_le_compat_r; try lra.
  - apply Rmult_le_reg_r with (IZR q); [exact Q|]. unfold Rdiv.
    rewrite Rmult_assoc, Rinv_l by lra. lra.
  - apply Rmult_le_reg_r with (IZR q); [exact Q|]. unfold Rdiv.
    rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.

Lemma inside_units_lt k n q o d lo hi :
  (0 < q)%Z -> inside_units Z.ltb k n q o d lo hi = true ->
  real lo < real o + IZR n / IZR q * real d < real hi.
Proof.
  intros Hq. unfold inside_units.
  destruct (in_units k o) as [o'|] eqn:Eo; [|discriminate].
  destruct (in_units k d) as [d'|] eqn:Ed; [|discriminate].
  destruct (in_units k lo) as [l'|] eqn:El; [|discriminate].
  destruct (in_units k hi) as [h'|] eqn:Eh; [|discriminate].
  rewrite (in_units_correct _ _ _ Eo), (in_units_correct _ _ _ Ed),
    (in_units_correct _ _ _ El), (in_units_correct _ _ _ Eh).
  intros H. apply andb_true_iff in H. destruct H as [H1 H2].
  apply Z.ltb_lt, IZR_lt in H1. apply Z.ltb_lt, IZR_lt in H2.
  rewrite plus_IZR, !mult_IZR in H1. rewrite plus_IZR, !mult_IZR in H2.
  assert (Q : 0 < IZR q) by (apply IZR_lt; exact Hq).
  pose proof (bpow_gt_0 radix2 (- k)) as B.
  replace (IZR o' * bpow radix2 (- k) + IZR n / IZR q * (IZR d' * bpow radix2 (- k)))
    with ((IZR q * IZR o' + IZR n * IZR d') / IZR q * bpow radix2 (- k)) by (field; lra).
  split; apply Rmult_lt_compat_r; try lra.
  - apply Rmult_lt_reg_r with (IZR q); [exact Q|]. unfold Rdiv.
    rewrite Rmult_assoc, Rinv_l by lra. lra.
  - apply Rmult_lt_reg_r with (IZR q); [exact Q|]. unfold Rdiv.
    rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.

(** The integer check proves that the ray meets the box. *)
Lemma meets_by_integers k n q o d lo hi :
  ((0 <=? n) && (0 <? q))%Z && inside3 Z.leb k n q o d lo hi = true -> meets o d lo hi.
Proof.
  intros H. apply andb_true_iff in H. destruct H as [H I].
  apply andb_true_iff in H. destruct H as [Hn Hq].
  apply Z.leb_le in Hn. apply Z.ltb_lt in Hq.
  apply andb_true_iff in I. destruct I as [I Iz]. apply andb_true_iff in I. destruct I as [Ix Iy].
  exists (IZR n / IZR q). split.
  - apply Rmult_le_pos; [apply IZR_le; exact Hn|].
    apply Rlt_le, Rinv_0_lt_compat, IZR_lt; exact Hq.
  - split; [|split]; apply inside_units_le with k; assumption.
Qed.

(** The strict integer check proves that it crosses the interior. *)
Lemma crosses_by_integers k n q o d lo hi :
  ((0 <? n) && (0 <? q))%Z && inside3 Z.ltb k n q o d lo hi = true -> crosses o d lo hi.
Proof.
  intros H. apply andb_true_iff in H. destruct H as [H I].
  apply andb_true_iff in H. destruct H as [Hn Hq].
  apply Z.ltb_lt in Hn. apply Z.ltb_lt in Hq.
  apply andb_true_iff in I. destruct I as [I Iz]. apply andb_true_iff in I. destruct I as [Ix Iy].
  exists (IZR n / IZR q). split.
  - apply Rmult_lt_0_compat; [apply IZR_lt; exact Hn|].
    apply Rinv_0_lt_compat, IZR_lt; exact Hq.
  - split; [|split]; apply inside_units_lt with k; assumption.
Qed.

Lemma crosses_meets o d lo hi : crosses o d lo hi -> meets o d lo hi.
Proof. intros (t & H & (?&?) & (?&?) & (?&?)). exists t. repeat split; lra. Qed.

(** m 2^e. The cases below are exact in binary64, so that the rounding does nothing; the integer
    check takes the number made, not the text. *)
Definition num (m e : Z) : double := binary_normalize prec64 emax64 _ _ mode_NE m e false.
Definition whole (m : Z) : double := num m 0.
Definition plus_size (lo : three double) (s : double) : three double :=
  triple (Bplus mode_NE (at_x lo) s) (Bplus mode_NE (at_y lo) s) (Bplus mode_NE (at_z lo) s).

(** * The cases *)
Open Scope Z_scope. Import ListNotations.

(** ** Rounding c once: level 50; |d'||d''| rounded once. *)
Definition rounding_c_once_origin := triple (num 3460251946553831 (-52)) (num 7527047594773849 (-53)) (num 291652044531773 (-50)).
Definition rounding_c_once_direction := triple (num (-2658440160191947) (-52)) (num (-2094348739917309) (-51)) (num 1137253683404383 (-51)).
Definition rounding_c_once_low := triple (num 316475398454405 (-50)) (num 76514136618029 (-50)) (num 761012434639025 (-50)).
Definition rounding_c_once_high := plus_size rounding_c_once_low (num 1 (-50)).
Theorem published_misses_by_rounding_c_once :
  all_finite rounding_c_once_origin /\ all_finite rounding_c_once_direction /\
  all_finite rounding_c_once_low /\ all_finite rounding_c_once_high /\
  crosses rounding_c_once_origin rounding_c_once_direction
    rounding_c_once_low rounding_c_once_high /\
  published rounding_c_once_origin rounding_c_once_direction
    rounding_c_once_low rounding_c_once_high = false /\
  sound rounding_c_once_origin rounding_c_once_direction
    rounding_c_once_low rounding_c_once_high = true.
Proof.
  split; [|split; [|split; [|split; [|split; [|split]]]]].
  1-4: repeat split; vm_compute; reflexivity.
  - apply crosses_by_integers with (k := 60%Z) (n := 7434792461297729%Z) (q := (2 ^ 53)%Z). vm_compute. reflexivity.
  - vm_compute. reflexivity.
  - vm_compute. reflexivity.
Qed.

(** Repaired by: rounding c both ways. *)
Lemma repairs_of_rounding_c_once :
  map (fun r => repaired r rounding_c_once_origin rounding_c_once_direction
    rounding_c_once_low rounding_c_once_high)
    [as_printed; only_c; only_difference; only_touching; all_three] =
  [false; true; false; false; true].
Proof. vm_compute. reflexivity. Qed.

(** ** Rounding the difference once: level 50, origin far away; x - x0 rounded once. *)
Definition rounding_the_difference_once_origin := triple (num 5095009533934923 (-46)) (num 647115896114805 (-42)) (num 3415810183582387 (-44)).
Definition rounding_the_difference_once_direction := triple (num (-5062802000323227) (-46)) (num (-2571706351715915) (-44)) (num (-849986567995687) (-42)).
Definition rounding_the_difference_once_low := triple (num 357904684556729 (-50)) (num 188154597704739 (-48)) (num 9256831131803 (-44)).
Definition rounding_the_difference_once_high := plus_size rounding_the_difference_once_low (num 1 (-50)).
Theorem published_misses_by_rounding_the_difference_once :
  all_finite rounding_the_difference_once_origin /\ all_finite rounding_the_difference_once_direction /\
  all_finite rounding_the_difference_once_low /\ all_finite rounding_the_difference_once_high /\
  crosses rounding_the_difference_once_origin rounding_the_difference_once_direction
    rounding_the_difference_once_low rounding_the_difference_once_high /\
  published rounding_the_difference_once_origin rounding_the_difference_once_direction
    rounding_the_difference_once_low rounding_the_difference_once_high = false /\
  sound rounding_the_difference_once_origin rounding_the_difference_once_direction
    rounding_the_difference_once_low rounding_the_difference_once_high = true.
Proof.
  split; [|split; [|split; [|split; [|split; [|split]]]]].
  1-4: repeat split; vm_compute; reflexivity.
  - apply crosses_by_integers with (k := 60%Z) (n := 18049405704011091%Z) (q := (2 ^ 54)%Z). vm_compute. reflexivity.
  - vm_compute. reflexivity.
  - vm_compute. reflexivity.
Qed.

(** Repaired by: rounding c both ways, or by rounding the difference both ways. *)
Lemma repairs_of_rounding_the_difference_once :
  map (fun r => repaired r rounding_the_difference_once_origin rounding_the_difference_once_direction
    rounding_the_difference_once_low rounding_the_difference_once_high)
    [as_printed; only_c; only_difference; only_touching; all_three] =
  [false; true; true; false; true].
Proof. vm_compute. reflexivity. Qed.

(** ** Zero component: the zero component makes two of the three c zero, and all bounds 0. *)
Definition zero_component_origin := triple (num 1 (-4)) (whole 0) (whole 0).
Definition zero_component_direction := triple (whole 0) (whole 1) (whole 1).
Definition zero_component_low := triple (whole 0) (whole 0) (whole 0).
Definition zero_component_high := plus_size zero_component_low (whole 1).
Theorem published_misses_by_zero_component :
  all_finite zero_component_origin /\ all_finite zero_component_direction /\
  all_finite zero_component_low /\ all_finite zero_component_high /\
  crosses zero_component_origin zero_component_direction
    zero_component_low zero_component_high /\
  published zero_component_origin zero_component_direction
    zero_component_low zero_component_high = false /\
  sound zero_component_origin zero_component_direction
    zero_component_low zero_component_high = true.
Proof.
  split; [|split; [|split; [|split; [|split; [|split]]]]].
  1-4: repeat split; vm_compute; reflexivity.
  - apply crosses_by_integers with (k := 60%Z) (n := 1%Z) (q := (2 ^ 1)%Z). vm_compute. reflexivity.
  - vm_compute. reflexivity.
  - vm_compute. reflexivity.
Qed.

(** Repaired by: letting equal bounds overlap. *)
Lemma repairs_of_zero_component :
  map (fun r => repaired r zero_component_origin zero_component_direction
    zero_component_low zero_component_high)
    [as_printed; only_c; only_difference; only_touching; all_three] =
  [false; false; false; true; true].
Proof. vm_compute. reflexivity. Qed.

(** ** Underflow: every c underflows to 0. *)
Definition underflow_origin := triple (num 1 (-2)) (num 1 (-2)) (num 1 (-2)).
Definition underflow_direction := triple (num 1 (-540)) (num 1 (-540)) (num 1 (-540)).
Definition underflow_low := triple (whole 0) (whole 0) (whole 0).
Definition underflow_high := plus_size underflow_low (whole 1).
Theorem published_misses_by_underflow :
  all_finite underflow_origin /\ all_finite underflow_direction /\
  all_finite underflow_low /\ all_finite underflow_high /\
  crosses underflow_origin underflow_direction
    underflow_low underflow_high /\
  published underflow_origin underflow_direction
    underflow_low underflow_high = false /\
  sound underflow_origin underflow_direction
    underflow_low underflow_high = true.
Proof.
  split; [|split; [|split; [|split; [|split; [|split]]]]].
  1-4: repeat split; vm_compute; reflexivity.
  - apply crosses_by_integers with (k := 600%Z) (n := (2 ^ 539)%Z) (q := 1%Z). vm_compute. reflexivity.
  - vm_compute. reflexivity.
  - vm_compute. reflexivity.
Qed.

(** Repaired by: rounding c both ways, or by letting equal bounds overlap. *)
Lemma repairs_of_underflow :
  map (fun r => repaired r underflow_origin underflow_direction
    underflow_low underflow_high)
    [as_printed; only_c; only_difference; only_touching; all_three] =
  [false; true; false; true; true].
Proof. vm_compute. reflexivity. Qed.

(** ** Overflow: every c is infinite, and inf * 0 a NaN. *)
Definition overflow_origin := triple (whole 0) (num 1 (-2)) (num 1 (-2)).
Definition overflow_direction := triple (num 1 600) (num 1 600) (num 1 600).
Definition overflow_low := triple (whole 0) (whole 0) (whole 0).
Definition overflow_high := plus_size overflow_low (whole 1).
Theorem published_misses_by_overflow :
  all_finite overflow_origin /\ all_finite overflow_direction /\
  all_finite overflow_low /\ all_finite overflow_high /\
  crosses overflow_origin overflow_direction
    overflow_low overflow_high /\
  published overflow_origin overflow_direction
    overflow_low overflow_high = false /\
  sound overflow_origin overflow_direction
    overflow_low overflow_high = true.
Proof.
  split; [|split; [|split; [|split; [|split; [|split]]]]].
  1-4: repeat split; vm_compute; reflexivity.
  - apply crosses_by_integers with (k := 60%Z) (n := 1%Z) (q := (2 ^ 601)%Z). vm_compute. reflexivity.
  - vm_compute. reflexivity.
  - vm_compute. reflexivity.
Qed.

(** Repaired by: rounding c both ways, or by letting equal bounds overlap. *)
Lemma repairs_of_overflow :
  map (fun r => repaired r overflow_origin overflow_direction
    overflow_low overflow_high)
    [as_printed; only_c; only_difference; only_touching; all_three] =
  [false; true; false; true; true].
Proof. vm_compute. reflexivity. Qed.

(** ** The difference alone: as above, with c exact: only x - x0 is rounded. *)
Definition the_difference_alone_origin := triple (num 2480414634102651 (-43)) (num 5673740634520257 (-47)) (num 268380459837407 (-42)).
Definition the_difference_alone_direction := triple (whole (-14)) (whole (-2)) (whole (-3)).
Definition the_difference_alone_low := triple (num 97741441291587 (-47)) (num 9092266949355 (-46)) (num 209681127729407 (-48)).
Definition the_difference_alone_high := plus_size the_difference_alone_low (num 1 (-50)).
Theorem published_misses_by_the_difference_alone :
  all_finite the_difference_alone_origin /\ all_finite the_difference_alone_direction /\
  all_finite the_difference_alone_low /\ all_finite the_difference_alone_high /\
  crosses the_difference_alone_origin the_difference_alone_direction
    the_difference_alone_low the_difference_alone_high /\
  published the_difference_alone_origin the_difference_alone_direction
    the_difference_alone_low the_difference_alone_high = false /\
  sound the_difference_alone_origin the_difference_alone_direction
    the_difference_alone_low the_difference_alone_high = true.
Proof.
  split; [|split; [|split; [|split; [|split; [|split]]]]].
  1-4: repeat split; vm_compute; reflexivity.
  - apply crosses_by_integers with (k := 60%Z) (n := 361955590439779007%Z) (q := (2 ^ 54)%Z). vm_compute. reflexivity.
  - vm_compute. reflexivity.
  - vm_compute. reflexivity.
Qed.

(** Repaired by: rounding the difference both ways. *)
Lemma repairs_of_the_difference_alone :
  map (fun r => repaired r the_difference_alone_origin the_difference_alone_direction
    the_difference_alone_low the_difference_alone_high)
    [as_printed; only_c; only_difference; only_touching; all_three] =
  [false; false; true; false; true].
Proof. vm_compute. reflexivity. Qed.

(** ** Strict overlap: all of it exact; the ray touches an edge of the octant. *)
Definition strict_overlap_origin := triple (whole 0) (whole 2) (num 1 (-1)).
Definition strict_overlap_direction := triple (whole 1) (whole (-1)) (num 1 (-4)).
Definition strict_overlap_low := triple (whole 0) (whole 0) (whole 0).
Definition strict_overlap_high := plus_size strict_overlap_low (whole 1).
Theorem published_misses_by_strict_overlap :
  all_finite strict_overlap_origin /\ all_finite strict_overlap_direction /\
  all_finite strict_overlap_low /\ all_finite strict_overlap_high /\
  meets strict_overlap_origin strict_overlap_direction
    strict_overlap_low strict_overlap_high /\
  published strict_overlap_origin strict_overlap_direction
    strict_overlap_low strict_overlap_high = false /\
  sound strict_overlap_origin strict_overlap_direction
    strict_overlap_low strict_overlap_high = true.
Proof.
  split; [|split; [|split; [|split; [|split; [|split]]]]].
  1-4: repeat split; vm_compute; reflexivity.
  - apply meets_by_integers with (k := 60%Z) (n := 1%Z) (q := 1%Z). vm_compute. reflexivity.
  - vm_compute. reflexivity.
  - vm_compute. reflexivity.
Qed.

(** Repaired by: letting equal bounds overlap. *)
Lemma repairs_of_strict_overlap :
  map (fun r => repaired r strict_overlap_origin strict_overlap_direction
    strict_overlap_low strict_overlap_high)
    [as_printed; only_c; only_difference; only_touching; all_three] =
  [false; false; false; true; true].
Proof. vm_compute. reflexivity. Qed.
(** The paper's claim that its test is safe is refuted: for finite rays through the interior of an
    octant of finite corners, the printed test may be false. (Six such rays and one that touches are above.) *)
Theorem published_is_not_sound :
  ~ (forall o d lo hi, all_finite o -> all_finite d -> all_finite lo -> all_finite hi ->
     crosses o d lo hi -> published o d lo hi = true).
Proof.
  intros H.
  destruct published_misses_by_rounding_c_once as (Fo & Fd & Fl & Fh & C & P & _).
  pose proof (H _ _ _ _ Fo Fd Fl Fh C) as Q. rewrite P in Q. discriminate Q.
Qed.
