(** The filter of the exact test (certainly_greater in determinant_sign.hpp, the speeds of
    exact_touch.hpp): what it takes for certain is so, in every rounding mode, underflow and overflow
    included. IEEE arithmetic without flushing to zero. *)
From Coq Require Import ZArith Bool List Reals Lia Lra Psatz.
From Flocq Require Import Core BinarySingleNaN Relative Plus_error Mult_error.
From Graze Require Import Model Interval_arith Determinant_sign Sum_sign Exact_predicate Exact_touch.
Open Scope R_scope.

Notation fexp64 := (SpecFloat.fexp 53 1024).
Notation le := (Model.le 53 1024).

(** Constants of the code: 1 + 16 2^-52, 2^-1000, 2^1000, 2^1023. *)
Definition margin : double := @B754_finite 53 1024 false 4503599627370512 (-52) eq_refl.
Definition tiny : double := @B754_finite 53 1024 false 4503599627370496 (-1052) eq_refl.
Definition most : double := @B754_finite 53 1024 false 4503599627370496 948 eq_refl.
Definition certain_distance : double := @B754_finite 53 1024 false 4503599627370496 971 eq_refl.

Section Mode.
Variable m : mode.

Definition certainly_greater (x y : double) : bool :=
  lt (Bplus m (Bmult m y margin) tiny) x && le x most.
Definition rounded_distance (greater less : double) : double := Bminus m greater less.
Definition rounded_product (greater less factor : double) : double :=
  Bmult m (rounded_distance greater less) factor.

(** * Errors *)
Definition e : R := / 4503599627370496.
Definition eta : R := bpow radix2 (-1074).
Lemma e_is : bpow radix2 (Z.opp 53 + 1) = e. Proof. reflexivity. Qed.
Lemma eta_pos : 0 < eta. Proof. apply bpow_gt_0. Qed.
Lemma eta_small : eta <= 1. Proof. apply (bpow_le radix2 (-1074) 0). lia. Qed.

Lemma error_bound v : 0 <= v -> Rabs (round radix2 fexp64 (round_mode m) v - v) <= e * v + eta.
Proof.
  intros V. assert (E : 0 < e) by (unfold e; lra). pose proof eta_pos.
  destruct (Rle_or_lt (bpow radix2 (-1022)) v) as [H1|H1].
  - pose proof (relative_error_FLT radix2 (-1074) 53 eq_refl (round_mode m) v) as Rl.
    rewrite e_is, (Rabs_pos_eq v V) in Rl. specialize (Rl H1).
    change (FLT_exp (-1074) 53) with fexp64 in Rl. lra.
  - pose proof (error_le_ulp radix2 (FLT_exp (-1074) 53) (round_mode m) v) as U.
    rewrite ulp_FLT_small in U.
    + change (FLT_exp (-1074) 53) with fexp64 in U. fold eta in U. nra.
    + reflexivity.
    + rewrite Rabs_pos_eq by exact V. apply Rlt_trans with (1 := H1). apply bpow_lt. lia.
Qed.

(** A correctly rounded z of v >= 0: what it says about v. *)
Definition at_least (z : double) (b : R) : Prop :=
  z = B754_infinity false \/ (is_finite z = true /\ b <= B2R z).
Definition good_for (z : double) (v : R) : Prop :=
  at_least z (Rmin (v * (1 - e) - eta) (bpow radix2 1023)) /\
  (is_finite z = true -> B2R z <= bpow radix2 1000 -> B2R z <= v * (1 + e) + eta).

Lemma correct_good z v : 0 <= v ->
  (if Rlt_bool (Rabs (round radix2 fexp64 (round_mode m) v)) (bpow radix2 1024)
   then B2R z = round radix2 fexp64 (round_mode m) v /\ is_finite z = true
   else B2SF z = binary_overflow 53 1024 m false) ->
  good_for z v.
Proof.
  intros V H. pose proof (error_bound v V) as B. apply Rabs_le_inv in B.
  destruct (Rlt_bool _ _).
  - destruct H as [E F]. split.
    + right. split; [exact F|]. rewrite E. apply Rle_trans with (1 := Rmin_l _ _). lra.
    + intros _ _. rewrite E. lra.
  - assert (Big : forall mx (H0 : SpecFloat.bounded 53 1024 mx 971 = true), (4503599627370496 <= Zpos mx)%Z ->
      bpow radix2 1023 <= @B2R 53 1024 (B754_finite false mx 971 H0)).
    { intros mx H0 L. unfold B2R, F2R, Fnum, Fexp, cond_Zopp.
      change 1023%Z with (52 + 971)%Z. rewrite bpow_plus. apply Rmult_le_compat_r; [apply bpow_ge_0|].
      change (bpow radix2 52) with (IZR 4503599627370496). apply IZR_le. exact L. }
    destruct z as [s|s| |s mx ex H0]; unfold binary_overflow in H;
      destruct (overflow_to_inf m false); simpl in H; try discriminate.
    + injection H as ->. split; [left; reflexivity|discriminate].
    + injection H as -> -> ->.
      assert (L : bpow radix2 1023 <= @B2R 53 1024 (B754_finite false 9007199254740991 971 H0))
        by (apply Big; lia).
      split.
      * right. split; [reflexivity|]. apply Rle_trans with (1 := Rmin_r _ _). exact L.
      * intros _ L'. exfalso. assert (bpow radix2 1000 < bpow radix2 1023) by (apply bpow_lt; lia). lra.
Qed.

Lemma positive_sign (x : double) : 0 < B2R x -> Bsign x = false.
Proof. intros H. pose proof (sign_of_real 53 1024 x). destruct (Bsign x); [lra|reflexivity]. Qed.

Lemma overflow_positive v : 0 <= v ->
  bpow radix2 1024 <= Rabs (round radix2 fexp64 (round_mode m) v) -> 0 < v.
Proof.
  intros [V|V] H; [exact V|]. rewrite <- V, round_0, Rabs_R0 in H by auto with typeclass_instances.
  pose proof (bpow_gt_0 radix2 1024). lra.
Qed.

Lemma mult_good (x y : double) : is_finite x = true -> is_finite y = true ->
  0 <= B2R x -> 0 <= B2R y -> good_for (Bmult m x y) (B2R x * B2R y).
Proof.
  intros Fx Fy X Y. assert (V : 0 <= B2R x * B2R y) by (apply Rmult_le_pos; assumption).
  apply correct_good; [exact V|].
  pose proof (Bmult_correct 53 1024 _ _ m x y) as C. rewrite Fx, Fy in C. revert C.
  case Rlt_bool_spec; intros L C; [split; apply C|].
  pose proof (overflow_positive _ V L) as P.
  rewrite (positive_sign x), (positive_sign y) in C by nra. exact C.
Qed.
Lemma plus_good (x y : double) : is_finite x = true -> is_finite y = true ->
  0 <= B2R x -> 0 < B2R y -> good_for (Bplus m x y) (B2R x + B2R y).
Proof.
  intros Fx Fy X Y. apply correct_good; [lra|].
  pose proof (Bplus_correct 53 1024 _ _ m x y Fx Fy) as C. revert C.
  case Rlt_bool_spec; intros L C; [split; apply C|]. destruct C as [C S].
  rewrite S, (positive_sign y Y) in C. exact C.
Qed.

(** A difference that did not overflow has a relative error alone. *)
Lemma distance_good (g l : double) : is_finite g = true -> is_finite l = true -> B2R l <= B2R g ->
  le (rounded_distance g l) certain_distance = true ->
  is_finite (rounded_distance g l) = true /\
  (B2R g - B2R l) * (1 - e) <= B2R (rounded_distance g l) <= (B2R g - B2R l) * (1 + e).
Proof.
  intros Fg Fl O L. unfold rounded_distance in *.
  pose proof (Bminus_correct 53 1024 _ _ m g l Fg Fl) as C. revert C.
  case Rlt_bool_spec; intros B C.
  - destruct C as (E & F & _). split; [exact F|]. rewrite E.
    set (v := B2R g - B2R l) in *. assert (V : 0 <= v) by (unfold v; lra).
    assert (P : 0 < e) by (unfold e; lra).
    destruct (Rle_or_lt (bpow radix2 (-1022)) v) as [H|H].
    + pose proof (relative_error_FLT radix2 (-1074) 53 eq_refl (round_mode m) v) as Rl.
      rewrite e_is, (Rabs_pos_eq v V) in Rl. specialize (Rl H).
      change (FLT_exp (-1074) 53) with fexp64 in Rl. apply Rabs_lt_inv in Rl. lra.
    + rewrite round_generic; [nra|auto with typeclass_instances|].
      unfold v, Rminus. apply (FLT_format_plus_small radix2 (-1074) 53).
      * apply (generic_format_B2R 53 1024).
      * apply generic_format_opp, (generic_format_B2R 53 1024).
      * change (B2R g + - B2R l) with v. rewrite Rabs_pos_eq by exact V.
        apply Rlt_le, Rlt_trans with (1 := H). apply bpow_lt. lia.
  - exfalso. destruct C as [C S].
    set (v := B2R g - B2R l) in *.
    assert (V : 0 <= v) by (unfold v; lra).
    pose proof (overflow_positive v V B) as P.
    assert (Sg : Bsign g = false).
    { pose proof (sign_of_real 53 1024 g) as Sg. pose proof (sign_of_real 53 1024 l) as Sl.
      destruct (Bsign g); [|reflexivity]. destruct (Bsign l); [discriminate|]. unfold v in P. lra. }
    rewrite Sg in C. unfold Model.le, Bleb in L. rewrite C in L. unfold binary_overflow in L.
    destruct (overflow_to_inf m false); vm_compute in L; discriminate L.
Qed.

Lemma margin_real : B2R margin = 1 + 16 * e.
Proof. unfold margin, B2R, F2R, Fnum, Fexp, cond_Zopp, e. change (bpow radix2 (-52)) with (/ 4503599627370496). lra. Qed.
Lemma tiny_real : B2R tiny = bpow radix2 (-1000).
Proof.
  unfold tiny, B2R, F2R, Fnum, Fexp, cond_Zopp. change (-1000)%Z with (52 + -1052)%Z.
  rewrite bpow_plus. reflexivity.
Qed.
Lemma tiny_eta : bpow radix2 (-1000) = 18889465931478580854784 * eta.
Proof. unfold eta. change (-1000)%Z with (74 + -1074)%Z. rewrite bpow_plus. reflexivity. Qed.
Lemma most_real : B2R most = bpow radix2 1000.
Proof.
  unfold most, B2R, F2R, Fnum, Fexp, cond_Zopp. change 1000%Z with (52 + 948)%Z.
  rewrite bpow_plus. reflexivity.
Qed.

Lemma nonneg_product_or_inf (z : double) v : good_for z v -> 0 <= v -> is_nan z = false ->
  z = B754_infinity false \/ is_finite z = true.
Proof. intros [[H|[H _]] _] _ _; auto. Qed.

Lemma rounded_nonneg (x y : double) : is_finite (Bmult m x y) = true ->
  is_finite x = true -> is_finite y = true -> 0 <= B2R x -> 0 <= B2R y -> 0 <= B2R (Bmult m x y).
Proof.
  intros F Fx Fy X Y. pose proof (sign_of_real 53 1024 (Bmult m x y)) as S.
  pose proof (Bmult_correct 53 1024 _ _ m x y) as C. revert C.
  case Rlt_bool_spec; intros L C.
  - destruct C as (-> & _).
    apply round_ge_generic; [apply (fexp_correct 53 1024); reflexivity|auto with typeclass_instances| |].
    + apply generic_format_0.
    + apply Rmult_le_pos; assumption.
  - pose proof (overflow_positive _ (Rmult_le_pos _ _ X Y) L) as P.
    rewrite (positive_sign x), (positive_sign y) in C by nra. simpl xorb in C.
    destruct (Bmult m x y) as [s|s| |s mx ex H0]; simpl; try lra.
    unfold binary_overflow in C. destruct (overflow_to_inf m false); simpl in C; try discriminate.
    injection C as -> _ _. apply F2R_ge_0. simpl. lia.
Qed.

(** The filter: certain is true. Factors are >= 0; a NaN proves nothing. *)
Theorem certainly_greater_sound (g1 l1 f1 g2 l2 f2 : double) :
  is_finite g1 = true -> is_finite l1 = true -> B2R l1 <= B2R g1 ->
  is_finite g2 = true -> is_finite l2 = true -> B2R l2 <= B2R g2 ->
  is_finite f1 = true -> 0 <= B2R f1 -> is_finite f2 = true -> 0 <= B2R f2 ->
  le (rounded_distance g1 l1) certain_distance = true ->
  le (rounded_distance g2 l2) certain_distance = true ->
  certainly_greater (rounded_product g1 l1 f1) (rounded_product g2 l2 f2) = true ->
  (B2R g2 - B2R l2) * B2R f2 < (B2R g1 - B2R l1) * B2R f1.
Proof.
  intros A1 A2 O1 A3 A4 O2 A5 P1 A6 P2 C1 C2 H.
  destruct (distance_good g1 l1 A1 A2 O1 C1) as [Fd1 [L1 U1]].
  destruct (distance_good g2 l2 A3 A4 O2 C2) as [Fd2 [L2 U2]].
  unfold rounded_product in H. set (p1 := rounded_distance g1 l1) in *.
  set (p2 := rounded_distance g2 l2) in *. clearbody p1 p2.
  set (D1 := B2R g1 - B2R l1) in *. set (D2 := B2R g2 - B2R l2) in *.
  assert (D1p : 0 <= D1) by (unfold D1; lra). assert (D2p : 0 <= D2) by (unfold D2; lra).
  clearbody D1 D2.
  assert (Ee : e = / 4503599627370496) by reflexivity.
  assert (Q1 : 0 <= B2R p1) by nra. assert (Q2 : 0 <= B2R p2) by nra.
  pose proof (mult_good p1 f1 Fd1 A5 Q1 P1) as [Gx Ux].
  pose proof (mult_good p2 f2 Fd2 A6 Q2 P2) as [Gy _].
  pose proof (rounded_nonneg p2 f2) as Ny.
  set (x := Bmult m p1 f1) in *. set (y := Bmult m p2 f2) in *. clearbody x y.
  unfold certainly_greater in H. apply andb_true_iff in H. destruct H as [H Hm].
  assert (BigM : bpow radix2 1023 = 8388608 * bpow radix2 1000)
    by (change 1023%Z with (23 + 1000)%Z; rewrite bpow_plus; reflexivity).
  assert (M1 : 1 <= bpow radix2 1000) by (apply (bpow_le radix2 0 1000); lia).
  (* x is finite and not too large *)
  assert (Fx : is_finite x = true).
  { destruct Gx as [->|[F _]]; [discriminate Hm|exact F]. }
  rewrite le_finite in Hm by (try exact Fx; reflexivity). rewrite most_real in Hm.
  assert (Xm : B2R x <= bpow radix2 1000) by (revert Hm; case Rle_bool_spec; [auto|discriminate]).
  specialize (Ux Fx Xm).
  (* y, y k and y k + tiny are finite *)
  destruct Gy as [->|[Fy Gy]].
  { exfalso. change (Bmult m (B754_infinity false) margin) with (@B754_infinity 53 1024 false) in H.
    change (Bplus m (B754_infinity false) tiny) with (@B754_infinity 53 1024 false) in H.
    change (@B754_infinity 53 1024 false) with (Model.infinity 53 1024) in H.
    rewrite inf_lt_finite in H by exact Fx. discriminate H. }
  specialize (Ny Fy Fd2 A6 Q2 P2).
  pose proof margin_real as Mr. pose proof tiny_real as Tr. pose proof tiny_eta as Te.
  pose proof eta_pos as Ep. pose proof eta_small as Es.
  assert (Kp : 0 <= B2R margin) by (rewrite Mr, Ee; lra).
  pose proof (mult_good y margin Fy eq_refl Ny Kp) as [Gk _].
  pose proof (rounded_nonneg y margin) as Nk.
  set (yk := Bmult m y margin) in *. clearbody yk.
  destruct Gk as [->|[Fk Gk]].
  { exfalso. change (Bplus m (B754_infinity false) tiny) with (@B754_infinity 53 1024 false) in H.
    change (@B754_infinity 53 1024 false) with (Model.infinity 53 1024) in H.
    rewrite inf_lt_finite in H by exact Fx. discriminate H. }
  specialize (Nk Fk Fy eq_refl Ny Kp).
  assert (Tp : 0 < B2R tiny) by (rewrite Tr; apply bpow_gt_0).
  pose proof (plus_good yk tiny Fk eq_refl Nk Tp) as [Gw _].
  set (w := Bplus m yk tiny) in *. clearbody w.
  destruct Gw as [->|[Fw Gw]].
  { exfalso. change (@B754_infinity 53 1024 false) with (Model.infinity 53 1024) in H.
    rewrite inf_lt_finite in H by exact Fx. discriminate H. }
  rewrite lt_finite in H by assumption.
  assert (Hw : B2R w < B2R x) by (revert H; case Rlt_bool_spec; [auto|discriminate]).
  (* no clamp was reached *)
  set (M := bpow radix2 1000) in *. clearbody M. rewrite BigM in *.
  rewrite Mr, Tr, Te in *. set (h := eta) in *. clearbody h.
  assert (Gw' : (B2R yk + 18889465931478580854784 * h) * (1 - e) - h <= B2R w).
  { revert Gw. apply Rmin_case_strong; intros; [assumption|lra]. }
  assert (Gk' : B2R y * (1 + 16 * e) * (1 - e) - h <= B2R yk).
  { revert Gk. apply Rmin_case_strong; intros; [assumption|]. rewrite Ee in *. lra. }
  assert (Gy' : B2R p2 * B2R f2 * (1 - e) - h <= B2R y).
  { revert Gy. apply Rmin_case_strong; intros; [assumption|]. rewrite Ee in *. lra. }
  (* the errors are within the margin *)
  assert (X1 : B2R p1 * B2R f1 <= D1 * (1 + e) * B2R f1) by (apply Rmult_le_compat_r; lra).
  assert (X2 : D2 * (1 - e) * B2R f2 <= B2R p2 * B2R f2) by (apply Rmult_le_compat_r; lra).
  set (A := D1 * B2R f1). set (B := D2 * B2R f2).
  assert (Bp : 0 <= B) by (apply Rmult_le_pos; assumption).
  replace (D1 * (1 + e) * B2R f1) with (A * (1 + e)) in X1 by (unfold A; ring).
  replace (D2 * (1 - e) * B2R f2) with (B * (1 - e)) in X2 by (unfold B; ring).
  clearbody A B.
  destruct (Rlt_or_le B A) as [R|R]; [exact R|exfalso].
  rewrite Ee in *. lra.
Qed.
End Mode.

(** * Speeds: |direction| times a power of two, or NaN where that would be rounded *)
Definition two_to_600 : double := @B754_finite 53 1024 false 4503599627370496 548 eq_refl.
Definition two_to_minus_600 : double := @B754_finite 53 1024 false 4503599627370496 (-652) eq_refl.
Definition two_to_400 : double := @B754_finite 53 1024 false 4503599627370496 348 eq_refl.
Definition two_to_minus_400 : double := @B754_finite 53 1024 false 4503599627370496 (-452) eq_refl.
Definition two_to_minus_422 : double := @B754_finite 53 1024 false 4503599627370496 (-474) eq_refl.

Lemma power_of_two k (H : SpecFloat.bounded 53 1024 4503599627370496 (k - 52) = true) :
  @B2R 53 1024 (B754_finite false 4503599627370496 (k - 52) H) = bpow radix2 k.
Proof.
  unfold B2R, F2R, Fnum, Fexp, cond_Zopp. replace k with (52 + (k - 52))%Z at 2 by ring.
  rewrite bpow_plus. reflexivity.
Qed.

Section Touch.
Variable m : mode.
(** The largest |direction|. *)
Variable largest : double.

Definition factor : double :=
  if lt largest two_to_minus_400 then two_to_600
  else if lt two_to_400 largest then two_to_minus_600 else one 53 1024.
Definition speed_of (a : axis_of_box) : double :=
  let size := Babs (d a) in
  if le (one 53 1024) factor || le two_to_minus_422 size then Bmult m size factor else B754_nan.

Lemma one_real : B2R (one 53 1024) = 1. Proof. apply Bone_correct. Qed.

Lemma factor_cases : is_finite largest = true ->
  (factor = two_to_600 /\ B2R factor = bpow radix2 600 /\ B2R largest < bpow radix2 (-400)) \/
  (factor = two_to_minus_600 /\ B2R factor = bpow radix2 (-600)) \/
  (factor = one 53 1024 /\ B2R factor = 1).
Proof.
  intros F. unfold factor. rewrite lt_finite by (exact F || reflexivity).
  rewrite (power_of_two (-400) eq_refl : B2R two_to_minus_400 = _).
  case Rlt_bool_spec; intros L.
  - left. split; [reflexivity|]. split; [exact (power_of_two 600 eq_refl)|exact L].
  - right. destruct (lt two_to_400 largest).
    + left. split; [reflexivity|exact (power_of_two (-600) eq_refl)].
    + right. split; [reflexivity|exact one_real].
Qed.

(** A speed is exact, or NaN. *)
Lemma speed_exact a : is_finite largest = true -> is_finite (d a) = true ->
  Rabs (B2R (d a)) <= B2R largest ->
  speed_of a = B754_nan \/
  (is_finite (speed_of a) = true /\ B2R (speed_of a) = Rabs (B2R (d a)) * B2R factor).
Proof.
  intros Fl Fd L.
  assert (Fs : is_finite (Babs (d a)) = true) by (rewrite is_finite_Babs; exact Fd).
  assert (Es : B2R (Babs (d a)) = Rabs (B2R (d a))) by apply B2R_Babs.
  assert (X : forall f : double, is_finite f = true ->
    generic_format radix2 fexp64 (Rabs (B2R (d a)) * B2R f) ->
    Rabs (Rabs (B2R (d a)) * B2R f) < bpow radix2 1024 ->
    is_finite (Bmult m (Babs (d a)) f) = true /\
    B2R (Bmult m (Babs (d a)) f) = Rabs (B2R (d a)) * B2R f).
  { intros f Ff G B. pose proof (Bmult_correct 53 1024 _ _ m (Babs (d a)) f) as C. rewrite Es in C.
    rewrite round_generic in C by (exact G || auto with typeclass_instances).
    rewrite Rlt_bool_true in C by exact B. destruct C as (E & F & _). rewrite Fs, Ff in F. auto. }
  assert (Gd : generic_format radix2 (FLT_exp (-1074) 53) (Rabs (B2R (d a)))).
  { rewrite <- Es. apply (generic_format_B2R 53 1024). }
  pose proof (abs_B2R_lt_emax 53 1024 (d a)) as Bd.
  unfold speed_of. cbv zeta.
  destruct (factor_cases Fl) as [(-> & R & S)|[(-> & R)|(-> & R)]].
  - replace (le (one 53 1024) two_to_600) with true by (vm_compute; reflexivity). cbn [orb].
    right. apply X; [reflexivity| |].
    + rewrite R. apply (mult_bpow_pos_exact_FLT radix2 (-1074) 53); [exact Gd|lia].
    + rewrite R, Rabs_mult, Rabs_Rabsolu, (Rabs_pos_eq (bpow _ _)) by apply bpow_ge_0.
      apply Rle_lt_trans with (bpow radix2 (-400) * bpow radix2 600).
      * apply Rmult_le_compat_r; [apply bpow_ge_0|lra].
      * rewrite <- bpow_plus. apply bpow_lt. lia.
  - replace (le (one 53 1024) two_to_minus_600) with false by (vm_compute; reflexivity). cbn [orb].
    rewrite le_finite by (exact Fs || reflexivity). rewrite Es.
    rewrite (power_of_two (-422) eq_refl : B2R two_to_minus_422 = _).
    case Rle_bool_spec; intros H; [right|left; reflexivity].
    apply X; [reflexivity| |].
    + rewrite R. apply (mult_bpow_exact_FLT radix2 (-1074) 53); [exact Gd|].
      assert (-421 <= Raux.mag radix2 (Rabs (B2R (d a))))%Z; [|lia].
      apply mag_ge_bpow. rewrite Rabs_Rabsolu. exact H.
    + rewrite R, Rabs_mult, Rabs_Rabsolu, (Rabs_pos_eq (bpow _ _)) by apply bpow_ge_0.
      apply Rle_lt_trans with (Rabs (B2R (d a)) * 1); [|lra].
      apply Rmult_le_compat_l; [apply Rabs_pos|]. apply (bpow_le radix2 (-600) 0). lia.
  - replace (le (one 53 1024) (one 53 1024)) with true by (vm_compute; reflexivity). cbn [orb].
    right. apply X; [reflexivity| |]; rewrite R, Rmult_1_r; [exact Gd|].
    rewrite Rabs_Rabsolu. exact Bd.
Qed.

(** * The test with its filter *)
Variable sort : list term -> list term.
Hypothesis sort_permutes : forall l, Permutation.Permutation l (sort l).
Hypothesis sort_sorts : forall l, descending (sort l).

Definition certain_axis (a : axis_of_box) : bool :=
  le (rounded_distance m (near_plane a) (origin a)) certain_distance &&
  le (rounded_distance m (far_plane a) (origin a)) certain_distance.

(** The exact decision for a pair that matters, and the same after the filter. *)
Definition exact_decision (a b : axis_of_box) : bool :=
  let sign := determinant_sign sort (near_plane a) (origin a) (d b) (far_plane b) (origin b) (d a) in
  (0 <? sign)%Z || ((sign =? 0)%Z && negb (near_is_closed a && far_is_closed b)).
Definition filtered_decision (certain : bool) (a b : axis_of_box) : bool :=
  let entry := rounded_product m (near_plane a) (origin a) (speed_of b) in
  let exit := rounded_product m (far_plane b) (origin b) (speed_of a) in
  if certain && certainly_greater m entry exit then true
  else if certain && certainly_greater m exit entry then false
  else exact_decision a b.
Definition filtered_fails (certain : bool) (a b : axis_of_box) : bool :=
  negb (after_near a) && negb (still b) && filtered_decision certain a b.

Definition filtered_meets (x : index -> axis_of_box) : bool :=
  let certain := certain_axis (x i0) && certain_axis (x i1) && certain_axis (x i2) in
  negb (is_outside (x i0) || is_outside (x i1) || is_outside (x i2)) &&
  negb (filtered_fails certain (x i0) (x i1) || filtered_fails certain (x i0) (x i2) ||
        filtered_fails certain (x i1) (x i0) || filtered_fails certain (x i1) (x i2) ||
        filtered_fails certain (x i2) (x i0) || filtered_fails certain (x i2) (x i1)).

Lemma nan_greater p y : certainly_greater m (Bmult m p B754_nan) y = false.
Proof.
  unfold certainly_greater. replace (Bmult m p B754_nan) with (@B754_nan 53 1024) by (destruct p; reflexivity).
  destruct (Bplus m (Bmult m y margin) tiny) as [|[]| |[]]; reflexivity.
Qed.
Lemma greater_nan x p : certainly_greater m x (Bmult m p B754_nan) = false.
Proof.
  unfold certainly_greater. replace (Bmult m p B754_nan) with (@B754_nan 53 1024) by (destruct p; reflexivity).
  reflexivity.
Qed.

(** The filter never changes a decision. *)
Lemma filtered_fails_same certain a b :
  finite_axis a -> finite_axis b -> is_outside b = false ->
  is_finite largest = true -> Rabs (B2R (d a)) <= B2R largest -> Rabs (B2R (d b)) <= B2R largest ->
  (certain = true -> certain_axis a = true /\ certain_axis b = true) ->
  filtered_fails certain a b = fails sort a b.
Proof.
  intros Fa Fb Ob Fl La Lb C. unfold filtered_fails, fails. cbv zeta.
  destruct (after_near a) eqn:A; [reflexivity|]. destruct (still b); [reflexivity|]. cbn [negb andb].
  change (filtered_decision certain a b = exact_decision a b).
  unfold filtered_decision. cbv zeta. destruct certain; [|reflexivity]. cbn [andb].
  destruct (C eq_refl) as [Ca Cb]. apply andb_true_iff in Ca. apply andb_true_iff in Cb.
  destruct Ca as [Ca _], Cb as [_ Cb].
  destruct (finite_parts a Fa) as (A1 & A2 & A3), (finite_parts b Fb) as (B1 & B2 & B3).
  pose proof Fa as (_ & Da & _). pose proof Fb as (_ & Db & _).
  assert (G1 : B2R (origin a) <= B2R (near_plane a)).
  { unfold after_near in A. rewrite lt_finite in A by assumption. apply orb_false_iff in A.
    destruct A as [A _]. revert A. case Rlt_bool_spec; [discriminate|auto]. }
  assert (G2 : B2R (origin b) <= B2R (far_plane b)).
  { unfold is_outside in Ob. apply orb_false_iff in Ob. destruct Ob as [Ob _].
    apply negb_false_iff in Ob. unfold before_far in Ob. apply orb_true_iff in Ob.
    rewrite lt_finite, eq_finite in Ob by assumption. revert Ob.
    case Rlt_bool_spec; [lra|]. case Req_bool_spec; [lra|].
    intros _ _ [H|H]; [discriminate|]. discriminate H. }
  destruct (speed_exact a Fl Da La) as [Na|[Fsa Ea]].
  { unfold rounded_product. rewrite Na, nan_greater, greater_nan. reflexivity. }
  destruct (speed_exact b Fl Db Lb) as [Nb|[Fsb Eb]].
  { unfold rounded_product. rewrite Nb, nan_greater, greater_nan. reflexivity. }
  assert (Fp : 0 < B2R factor).
  { destruct (factor_cases Fl) as [(_ & -> & _)|[(_ & ->)|(_ & ->)]]; try apply bpow_gt_0; lra. }
  assert (Pa : 0 <= B2R (speed_of a)) by (rewrite Ea; apply Rmult_le_pos; [apply Rabs_pos|lra]).
  assert (Pb : 0 <= B2R (speed_of b)) by (rewrite Eb; apply Rmult_le_pos; [apply Rabs_pos|lra]).
  destruct (determinant_sign_correct sort sort_permutes sort_sorts
    (near_plane a) (origin a) (d b) (far_plane b) (origin b) (d a)
    A2 A1 Db B3 B1 Da G1 G2) as [P N]. cbv zeta in P, N. unfold real_determinant in P, N.
  unfold exact_decision. cbv zeta.
  set (s := determinant_sign sort (near_plane a) (origin a) (d b) (far_plane b) (origin b) (d a)) in *.
  destruct (certainly_greater m (rounded_product m (near_plane a) (origin a) (speed_of b)) _) eqn:G.
  - apply certainly_greater_sound in G; try assumption. rewrite Ea, Eb in G.
    assert (S : (0 < s)%Z).
    { apply P. rewrite <- !Rmult_assoc in G. apply Rmult_lt_reg_r in G; [lra|exact Fp]. }
    apply Z.ltb_lt in S. rewrite S. reflexivity.
  - clear G.
    destruct (certainly_greater m (rounded_product m (far_plane b) (origin b) (speed_of a)) _) eqn:G;
      [|reflexivity].
    apply certainly_greater_sound in G; try assumption. rewrite Ea, Eb in G.
    rewrite <- !Rmult_assoc in G. apply Rmult_lt_reg_r in G; [|exact Fp].
    destruct (Z.ltb_spec 0 s) as [S|S]; [apply P in S; lra|].
    destruct (Z.eqb_spec s 0) as [Z|Z]; [apply N in Z; lra|]. reflexivity.
Qed.

(** The shipped test, filter and all, is true if and only if the ray has a point in the box; in every
    rounding mode. *)
Theorem filtered_meets_exact (x : index -> axis_of_box) :
  (forall i, finite_axis (x i)) -> is_finite largest = true ->
  (forall i, Rabs (B2R (d (x i))) <= B2R largest) ->
  filtered_meets x = true <->
  exists t, 0 <= t /\ forall i,
    B2R (lo (x i)) <= B2R (o (x i)) + t * B2R (d (x i)) /\
    (if hi_closed (x i) then B2R (o (x i)) + t * B2R (d (x i)) <= B2R (hi (x i))
     else B2R (o (x i)) + t * B2R (d (x i)) < B2R (hi (x i))).
Proof.
  intros F Fl L. rewrite <- (meets_exact sort sort_permutes sort_sorts x F).
  replace (filtered_meets x) with (meets sort x); [tauto|].
  unfold filtered_meets, meets. cbv zeta.
  destruct (is_outside (x i0)) eqn:O0; [reflexivity|].
  destruct (is_outside (x i1)) eqn:O1; [reflexivity|].
  destruct (is_outside (x i2)) eqn:O2; [reflexivity|]. cbn [orb negb andb].
  set (certain := certain_axis (x i0) && certain_axis (x i1) && certain_axis (x i2)).
  assert (C : certain = true -> forall i, certain_axis (x i) = true).
  { unfold certain. intros H. apply andb_true_iff in H. destruct H as [H H2].
    apply andb_true_iff in H. destruct H as [H0 H1]. intros []; assumption. }
  rewrite !filtered_fails_same; auto.
Qed.
End Touch.

(** * Nothing assumed: with a sort, and the largest component as the code takes it *)
Fixpoint insert (t : term) (l : list term) : list term :=
  match l with
  | nil => (t :: nil)%list
  | u :: r => if (term_exponent u <=? term_exponent t)%Z then (t :: l)%list else (u :: insert t r)%list
  end%list.
Fixpoint insertion_sort (l : list term) : list term :=
  match l with nil => nil | (t :: r)%list => insert t (insertion_sort r) end.
Lemma insert_permutes t l : Permutation.Permutation (t :: l) (insert t l).
Proof.
  induction l as [|u r IH]; cbn [insert]; [apply Permutation.Permutation_refl|].
  destruct (_ <=? _)%Z; [apply Permutation.Permutation_refl|].
  apply Permutation.perm_trans with (u :: t :: r)%list; [apply Permutation.perm_swap|].
  apply Permutation.perm_skip, IH.
Qed.
Lemma insertion_sort_permutes l : Permutation.Permutation l (insertion_sort l).
Proof.
  induction l as [|t r IH]; cbn [insertion_sort]; [apply Permutation.perm_nil|].
  apply Permutation.perm_trans with (t :: insertion_sort r)%list; [apply Permutation.perm_skip, IH|].
  apply insert_permutes.
Qed.
Lemma insert_from v t l : descending_from v l -> (term_exponent t <= term_exponent v)%Z ->
  descending_from v (insert t l).
Proof.
  revert v. induction l as [|u r IH]; intros v D T; cbn [insert]; [split; [exact T|exact I]|].
  destruct D as [D1 D2]. destruct (Z.leb_spec (term_exponent u) (term_exponent t)).
  - split; [exact T|]. split; assumption.
  - split; [exact D1|]. apply IH; [exact D2|lia].
Qed.
Lemma insertion_sort_sorts l : descending (insertion_sort l).
Proof.
  induction l as [|t r IH]; [exact I|]. cbn [insertion_sort].
  destruct (insertion_sort r) as [|u s]; [exact I|]. cbn [insert].
  destruct (Z.leb_spec (term_exponent u) (term_exponent t)) as [L|L].
  - split; assumption.
  - apply insert_from; [exact IH|lia].
Qed.

(** std::max({|dx|, |dy|, |dz|}) *)
Definition larger (a b : double) : double := if lt a b then b else a.
Definition largest_speed (x : index -> axis_of_box) : double :=
  larger (larger (Babs (d (x i0))) (Babs (d (x i1)))) (Babs (d (x i2))).
Lemma larger_correct a b : is_finite a = true -> is_finite b = true ->
  is_finite (larger a b) = true /\ B2R a <= B2R (larger a b) /\ B2R b <= B2R (larger a b).
Proof.
  intros Fa Fb. unfold larger. rewrite lt_finite by assumption.
  case Rlt_bool_spec; intros; repeat split; auto; lra.
Qed.

(** exact_touch::meets, in any rounding mode m. *)
Definition exact_touch (m : mode) (x : index -> axis_of_box) : bool :=
  filtered_meets m (largest_speed x) insertion_sort x.

(** The exact test: true if and only if the ray has a point in the box, for every finite ray. *)
Theorem exact_touch_is_exact (m : mode) (x : index -> axis_of_box) :
  (forall i, finite_axis (x i)) ->
  exact_touch m x = true <->
  exists t, 0 <= t /\ forall i,
    B2R (lo (x i)) <= B2R (o (x i)) + t * B2R (d (x i)) /\
    (if hi_closed (x i) then B2R (o (x i)) + t * B2R (d (x i)) <= B2R (hi (x i))
     else B2R (o (x i)) + t * B2R (d (x i)) < B2R (hi (x i))).
Proof.
  intros F. unfold exact_touch.
  assert (A : forall i, is_finite (Babs (d (x i))) = true).
  { intros i. rewrite is_finite_Babs. apply (F i). }
  destruct (larger_correct _ _ (A i0) (A i1)) as (F1 & L0 & L1).
  destruct (larger_correct _ _ F1 (A i2)) as (F2 & L01 & L2).
  apply filtered_meets_exact.
  - exact insertion_sort_permutes.
  - exact insertion_sort_sorts.
  - exact F.
  - exact F2.
  - intros i. rewrite <- B2R_Babs. unfold largest_speed. destruct i; lra.
Qed.

(** The model runs. From (2, 2, 2) along (-2^600, -2^600, -2^600) the ray meets the closed cube
    [0, 1]^3. From (2, 0, 0) along (-1, 1, 2^-1074) it passes through the edge x = y = 1 at t = 1: it
    meets the closed cube, and has no point in the half-open one. *)
Example through_an_edge :
  let number k := binary_normalize 53 1024 eq_refl eq_refl mode_NE 1 k false in
  let axis closed (i : index) := {| o := number 1%Z; d := Bopp (number 600%Z);
    lo := zero; hi := number 0%Z; hi_closed := closed |} in
  exact_touch mode_UP (axis true) = true /\
  let graze closed i := {| o := match i with i0 => number 1%Z | _ => zero end;
    d := match i with i0 => Bopp (number 0%Z) | i1 => number 0%Z | i2 => number (-1074)%Z end;
    lo := zero; hi := number 0%Z; hi_closed := closed |} in
  exact_touch mode_UP (graze true) = true /\ exact_touch mode_UP (graze false) = false.
Proof. vm_compute. repeat split. Qed.
