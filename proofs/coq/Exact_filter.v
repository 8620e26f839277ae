(** The filter of the exact test (certainly_greater in determinant_sign.hpp, the speeds of
    exact_touch.hpp): what it takes for certain is so, in every rounding mode, underflow and overflow
    included. IEEE arithmetic without flushing to zero. *)
From Coq Require Import ZArith Bool List Reals Lia Lra Psatz.
From Flocq Require Import Core BinarySingleNaN Relative Plus_error.
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
