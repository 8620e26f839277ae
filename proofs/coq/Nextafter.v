(** Rounding to nearest and then a step outwards (`nextafter`), which some implementations take for
    directed rounding. Graze's backends are not of this kind; this shows what one would have to add.

    - [nextafter_not_monotone]: with the test of ray_bounds.hpp over it, a child passes and its parent
      does not: Cdn = -2^-1074 where |dy| |dz| underflows, and `uppb` then grows as the plane recedes;
    - [nextafter_clamped_ordered], [nextafter_clamped_monotone]: with Cdn clamped to 0 it is monotone
      as the directed form is. *)
From Coq Require Import ZArith Bool Reals Lra Lia SpecFloat.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model Negation Bounds Never_miss Monotone Nearest.

Section Nextafter.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.

Notation float := (float prec emax).
Notation fexp := (SpecFloat.fexp prec emax).
Notation axis := (axis prec emax).
Notation "x <=? y" := (Model.le prec emax x y).
Notation "x <? y" := (Model.lt prec emax x y).
Notation zero := (Model.zero prec emax).
Notation extended := (extended prec emax).
Notation c_down := (c_down prec emax).
Notation c_up := (c_up prec emax).
Notation RN := (round radix2 fexp ZnearestE).

Local Instance valid_fexp_next : Valid_exp fexp := fexp_correct prec emax Hprec.
Local Instance monotone_fexp_next : Monotone_exp fexp := FLT_exp_monotone (3 - emax - prec) prec.
Local Hint Resolve valid_fexp_next monotone_fexp_next valid_rnd_N : core.

(** To nearest, then one number outwards. *)
Definition nextafter : backend prec emax := {|
  sub_down := fun x y => Bpred (Bminus mode_NE x y);
  sub_up := fun x y => Bsucc (Bminus mode_NE x y);
  mul_down := fun x y => Bpred (Bmult mode_NE x y);
  mul_up := fun x y => Bsucc (Bmult mode_NE x y) |}.

(** Cdn, not below 0. *)
Definition clamp (a : axis) : axis := {|
  origin := origin _ _ a;
  Model.c_down := if c_down a <? zero then zero else c_down a;
  Model.c_up := c_up a;
  direction := direction _ _ a |}.

(** A result to nearest among the reals, overflow as 2^emax. *)
Definition nearest_real (r : R) : R := Rmax (- bpow radix2 emax) (Rmin (bpow radix2 emax) (RN r)).

Lemma RN_monotone : forall r r', (r <= r')%R -> (RN r <= RN r')%R.
Proof. intros. apply round_le; auto. Qed.

Lemma nearest_real_monotone : forall r r', (r <= r')%R -> (nearest_real r <= nearest_real r')%R.
Proof.
  intros r r' H. apply RN_monotone in H. unfold nearest_real.
  apply Rle_max_compat_l. now apply Rle_min_compat_l.
Qed.

Lemma nearest_real_0 : nearest_real 0 = 0%R.
Proof.
  unfold nearest_real. rewrite round_0 by auto. pose proof (bpow_gt_0 radix2 emax).
  rewrite Rmin_right, Rmax_right; lra.
Qed.

Lemma rounded_nearest : forall (z : float) (r : R) (s : bool),
  (if Rlt_bool (Rabs (RN r)) (bpow radix2 emax) then B2R z = RN r /\ is_finite z = true
   else B2SF z = binary_overflow prec emax mode_NE s /\ (if s then r <= 0 else 0 <= r)%R) ->
  is_nan z = false /\ extended z = nearest_real r.
Proof.
  intros z r s. pose proof (bpow_gt_0 radix2 emax) as P. unfold nearest_real.
  assert (N0 : RN 0 = 0%R) by (apply round_0; auto).
  case Rlt_bool_spec; intros B.
  - intros [E F]. apply Rabs_lt_inv in B. rewrite Rmin_right, Rmax_right by lra. rewrite <- E.
    now destruct z.
  - intros [E S]. assert (Z : z = B754_infinity s) by now apply B2SF_inj.
    rewrite Z. split; trivial. destruct s; apply RN_monotone in S; rewrite N0 in S.
    + rewrite Rabs_left1 in B by trivial. rewrite Rmin_right, Rmax_left by lra. reflexivity.
    + rewrite Rabs_pos_eq in B by trivial. rewrite Rmin_left, Rmax_right by lra. reflexivity.
Qed.

Lemma minus_nearest : forall x y : float, is_finite x = true -> is_finite y = true ->
  is_nan (Bminus mode_NE x y) = false /\ extended (Bminus mode_NE x y) = nearest_real (B2R x - B2R y).
Proof.
  intros x y Fx Fy. apply rounded_nearest with (Bsign x).
  generalize (Bminus_correct _ _ _ _ mode_NE x y Fx Fy). simpl round_mode. case Rlt_bool.
  - now intros (E & F & _).
  - intros (E & S). split; trivial.
    pose proof (sign_of_value _ _ x) as Sx. pose proof (sign_of_value _ _ y) as Sy.
    rewrite S in *. destruct (Bsign y); simpl in *; lra.
Qed.

Lemma mult_nearest : forall x y : float, is_finite x = true -> is_finite y = true ->
  is_nan (Bmult mode_NE x y) = false /\ extended (Bmult mode_NE x y) = nearest_real (B2R x * B2R y).
Proof.
  intros x y Fx Fy. apply rounded_nearest with (xorb (Bsign x) (Bsign y)).
  generalize (Bmult_correct _ _ _ _ mode_NE x y). simpl round_mode. rewrite Fx, Fy. case Rlt_bool.
  - now intros (E & F & _).
  - intros E. split; trivial.
    pose proof (sign_of_value _ _ x) as Sx. pose proof (sign_of_value _ _ y) as Sy.
    destruct (Bsign x), (Bsign y); simpl; nra.
Qed.

(** A step upwards preserves order. *)
Lemma Bsucc_above : forall f : float, is_nan f = false -> f <=? Bsucc f = true.
Proof.
  intros f N. apply le_iff. rewrite is_nan_Bsucc. repeat split; trivial.
  pose proof (bpow_gt_0 radix2 emax) as P.
  destruct (is_finite f) eqn:F.
  - pose proof (B2R_between _ _ f) as Bf.
    assert (E : extended f = B2R f) by now destruct f. rewrite E.
    generalize (Bsucc_correct _ _ _ _ f F). case Rlt_bool_spec; intros B.
    + intros (V & Fs & _). replace (extended (Bsucc f)) with (B2R (Bsucc f)) by now destruct (Bsucc f).
      rewrite V. apply succ_ge_id.
    + intros V. assert (Z : Bsucc f = B754_infinity false) by now apply B2SF_inj.
      rewrite Z. simpl. lra.
  - destruct f as [|[]| |]; try discriminate; [| simpl; lra].
    pose proof (B2R_between _ _ (Bopp (@Bmax_float prec emax _ _))) as Bm.
    change (Bsucc (B754_infinity true)) with (Bopp (@Bmax_float prec emax _ _)).
    unfold Bounds.extended at 1. destruct (Bopp Bmax_float) as [|[]| |]; cbn -[B2R bpow] in *; lra.
Qed.

Lemma Bsucc_monotone : forall f g : float, f <=? g = true -> Bsucc f <=? Bsucc g = true.
Proof.
  intros f g H. apply le_iff in H as (Nf & Ng & H).
  pose proof (bpow_gt_0 radix2 emax) as P.
  pose proof (B2R_between _ _ f) as Bf. pose proof (B2R_between _ _ g) as Bg.
  destruct (is_finite f && is_finite g) eqn:F.
  - apply andb_prop in F as [Ff Fg].
    assert (Le : (B2R f <= B2R g)%R) by now destruct f, g.
    apply le_iff. rewrite !is_nan_Bsucc. repeat split; trivial.
    assert (S : (succ radix2 fexp (B2R f) <= succ radix2 fexp (B2R g))%R)
      by (apply succ_le; auto using generic_format_B2R).
    generalize (Bsucc_correct _ _ _ _ f Ff) (Bsucc_correct _ _ _ _ g Fg).
    pose proof (B2R_between _ _ (Bsucc f)) as Bsf.
    case Rlt_bool_spec; intros B; [intros (V & Fs & _) | intros V];
      (case Rlt_bool_spec; intros B'; [intros (V' & Fs' & _) | intros V']).
    + replace (extended (Bsucc f)) with (B2R (Bsucc f)) by now destruct (Bsucc f).
      replace (extended (Bsucc g)) with (B2R (Bsucc g)) by now destruct (Bsucc g). lra.
    + replace (extended (Bsucc f)) with (B2R (Bsucc f)) by now destruct (Bsucc f).
      assert (Z : Bsucc g = B754_infinity false) by now apply B2SF_inj. rewrite Z. simpl. lra.
    + lra.
    + assert (Z : Bsucc g = B754_infinity false) by now apply B2SF_inj.
      assert (Z' : Bsucc f = B754_infinity false) by now apply B2SF_inj. rewrite Z, Z'. simpl. lra.
  - destruct (is_finite f) eqn:Ff.
    + destruct g as [|[]| |]; try discriminate.
      * destruct f; try discriminate; cbn -[B2R bpow] in *; lra.
      * apply le_iff. rewrite !is_nan_Bsucc. repeat split; trivial.
        destruct (is_finite (Bsucc f)) eqn:Fs.
        -- replace (extended (Bsucc f)) with (B2R (Bsucc f)) by now destruct (Bsucc f).
           pose proof (B2R_between _ _ (Bsucc f)). simpl. lra.
        -- pose proof (is_nan_Bsucc _ _ _ _ f) as Nn. rewrite Nf in Nn.
           destruct (Bsucc f) as [|[]| |]; try discriminate; simpl; lra.
    + destruct f as [|[]| |]; try discriminate.
      * destruct (is_finite g) eqn:Fg.
        -- apply le_trans with g; [| now apply Bsucc_above].
           change (Bsucc (B754_infinity true)) with (Bopp (@Bmax_float prec emax _ _)).
           assert (T : B2SF (@Bmax_float prec emax _ _) = binary_overflow prec emax mode_DN false)
             by now apply Bmax_is_overflow.
           destruct (overflow_down_largest _ _ Bmax_float (Bopp g) T) as [Fm Lm];
             [now rewrite is_finite_Bopp |].
           apply le_finite; trivial. rewrite B2R_Bopp in *. lra.
        -- destruct g as [|[]| |]; try discriminate.
           ++ apply le_refl. now rewrite is_nan_Bsucc.
           ++ apply le_iff. rewrite !is_nan_Bsucc. repeat split; trivial.
              change (Bsucc (B754_infinity true)) with (Bopp (@Bmax_float prec emax _ _)).
              pose proof (B2R_between _ _ (Bopp (@Bmax_float prec emax _ _))) as Bm.
              destruct (Bopp Bmax_float) as [|[]| |]; cbn -[B2R bpow] in *; lra.
      * destruct g as [|[]| |]; try discriminate; cbn -[B2R bpow] in *; (lra || reflexivity).
Qed.

(** A step downwards preserves order. *)
Lemma Bpred_monotone : forall f g : float, f <=? g = true -> Bpred f <=? Bpred g = true.
Proof.
  intros f g H. unfold Bpred. rewrite le_opposite. apply Bsucc_monotone. now rewrite le_opposite.
Qed.

(** Steps do not reach the infinity behind them. *)
Lemma Bsucc_not_minus_infinity : forall f : float, Bsucc f <> B754_infinity true.
Proof.
  intros f E. destruct (is_finite f) eqn:F.
  - generalize (Bsucc_correct _ _ _ _ f F). rewrite E. case Rlt_bool; [intros (_ & C & _) | intros C];
      discriminate.
  - destruct f as [|[]| |]; discriminate.
Qed.

Lemma Bpred_not_infinity : forall f : float, Bpred f <> B754_infinity false.
Proof.
  intros f E. apply (Bsucc_not_minus_infinity (Bopp f)). unfold Bpred in E.
  rewrite <- (Bopp_involutive _ _ (Bsucc (Bopp f))), E. reflexivity.
Qed.

(** Products by something positive preserve order among numbers of one sign. *)
Lemma mult_side : forall c u : float, zero <? c = true ->
  (u <? zero = true -> Bmult mode_NE c u <=? zero = true) /\
  (zero <? u = true -> zero <=? Bmult mode_NE c u = true).
Proof.
  intros c u Hc.
  destruct (is_finite c && is_finite u) eqn:F.
  - apply andb_prop in F as [Fc Fu]. destruct (mult_nearest c u Fc Fu) as [N E].
    apply lt_finite in Hc; trivial. simpl in Hc.
    split; intros Hu; apply lt_finite in Hu; trivial; simpl in Hu; apply le_iff; rewrite E;
      repeat split; trivial; change (extended zero) with 0%R; rewrite <- nearest_real_0;
      apply nearest_real_monotone; nra.
  - destruct c as [|[]| |[]], u as [|[]| |[]]; try discriminate; split; trivial; discriminate.
Qed.

Lemma mult_monotone_side : forall c u v : float, zero <? c = true -> u <=? v = true ->
  (v <? zero = true \/ zero <? u = true) -> Bmult mode_NE c u <=? Bmult mode_NE c v = true.
Proof.
  intros c u v Hc L Side.
  destruct (is_finite c && is_finite u && is_finite v) eqn:F.
  - apply andb_prop in F as [F Fv]. apply andb_prop in F as [Fc Fu].
    destruct (mult_nearest c u Fc Fu) as [Nu Eu]. destruct (mult_nearest c v Fc Fv) as [Nv Ev].
    apply le_iff. rewrite Eu, Ev. repeat split; trivial. apply nearest_real_monotone.
    apply le_finite in L; trivial. apply lt_finite in Hc; trivial. simpl in Hc. nra.
  - destruct c as [|[]| |[] mc ec Bc]; try discriminate;
      destruct u as [su|[]| |[] mu eu Bu]; try discriminate;
      destruct v as [sv|[]| |[] mv ev Bv]; try discriminate;
      try (destruct Side; discriminate); try (destruct su); try (destruct sv); trivial;
      try (destruct Side; discriminate); cbn -[Bmult B2R bpow] in *;
      try match goal with
      | |- _ <=? Bmult mode_NE ?c ?v = true =>
          match goal with
          | |- Bmult mode_NE ?c' ?u <=? _ = true =>
              change (Bmult mode_NE c' u) with (@B754_infinity prec emax true);
              destruct (mult_nearest c v eq_refl eq_refl) as [N _];
              apply le_iff; repeat split; trivial;
              pose proof (B2R_between _ _ (Bmult mode_NE c v));
              pose proof (bpow_gt_0 radix2 emax);
              destruct (Bmult mode_NE c v) as [|[]| |]; try discriminate; cbn -[B2R bpow] in *; lra
          end
      end;
      try match goal with
      | |- Bmult mode_NE ?c ?u <=? Bmult mode_NE ?c' ?v = true =>
              change (Bmult mode_NE c' v) with (@B754_infinity prec emax false);
              destruct (mult_nearest c u eq_refl eq_refl) as [N _];
              apply le_iff; repeat split; trivial;
              pose proof (B2R_between _ _ (Bmult mode_NE c u));
              pose proof (bpow_gt_0 radix2 emax);
              destruct (Bmult mode_NE c u) as [|[]| |]; try discriminate; cbn -[B2R bpow] in *; lra
      end.
Qed.

(** Products by the finite c >= 0 preserve order. *)
Lemma mult_monotone_down : forall c u v : float, is_finite c = true -> zero <=? c = true ->
  is_finite u = true -> is_finite v = true -> u <=? v = true ->
  Bmult mode_NE c u <=? Bmult mode_NE c v = true.
Proof.
  intros c u v Fc Hc Fu Fv L.
  destruct (mult_nearest c u Fc Fu) as [Nu Eu]. destruct (mult_nearest c v Fc Fv) as [Nv Ev].
  apply le_iff. rewrite Eu, Ev. repeat split; trivial. apply nearest_real_monotone.
  apply le_finite in L; trivial. apply le_finite in Hc; trivial. simpl in Hc. nra.
Qed.

Lemma mult_down_side : forall c u : float, is_finite c = true -> zero <=? c = true -> is_finite u = true ->
  (u <=? zero = true -> Bmult mode_NE c u <=? zero = true) /\
  (zero <=? u = true -> zero <=? Bmult mode_NE c u = true).
Proof.
  intros c u Fc Hc Fu. destruct (mult_nearest c u Fc Fu) as [N E].
  apply le_finite in Hc; trivial. simpl in Hc.
  split; intros Hu; apply le_finite in Hu; trivial; simpl in Hu; apply le_iff; rewrite E;
    repeat split; trivial; change (extended zero) with 0%R; rewrite <- nearest_real_0;
    apply nearest_real_monotone; nra.
Qed.

(** What is asked of the constants. *)
Definition sound_constants (a : axis) : Prop :=
  is_finite (c_down a) = true /\ zero <=? c_down a = true /\ zero <? c_up a = true.

(** Both bounds preserve order. *)
Theorem nextafter_ordered : forall a : axis, sound_constants a -> ordered prec emax nextafter a.
Proof.
  intros a (Fd & Hd & Hu) p q p' q' Fp Fq Fp' Fq' L.
  destruct (minus_nearest p q Fp Fq) as [N E]. destruct (minus_nearest p' q' Fp' Fq') as [N' E'].
  assert (D : Bminus mode_NE p q <=? Bminus mode_NE p' q' = true).
  { apply le_iff. rewrite E, E'. repeat split; trivial. now apply nearest_real_monotone. }
  unfold lowb, uppb, nextafter. cbn [sub_down sub_up mul_down mul_up].
  split; [apply Bpred_monotone | apply Bsucc_monotone].
  - apply Bpred_monotone in D.
    pose proof (Bpred_not_infinity (Bminus mode_NE p q)) as I.
    pose proof (Bpred_not_infinity (Bminus mode_NE p' q')) as I'.
    set (u := Bpred (Bminus mode_NE p q)) in *. set (v := Bpred (Bminus mode_NE p' q')) in *.
    clearbody u v. destruct (le_not_nan _ _ _ _ D) as [Nu Nv].
    assert (NN : forall w : float, is_nan w = false -> w <> B754_infinity false -> w <? zero = false ->
      is_finite w = true /\ zero <=? w = true).
    { intros w Nw Iw H. rewrite lt_negb_le in H by trivial. apply negb_false_iff in H. split; trivial.
      destruct w as [|[]| |]; trivial; try discriminate. now elim Iw. }
    destruct (u <? zero) eqn:Su; destruct (v <? zero) eqn:Sv.
    + apply mult_monotone_side; auto.
    + destruct (NN v Nv I' Sv) as [Fv Hv]. apply le_trans with zero.
      * now apply mult_side.
      * now apply mult_down_side.
    + destruct (NN u Nu I Su) as [Fu Hu']. rewrite lt_negb_le in Sv by trivial.
      rewrite (le_trans _ _ _ _ _ Hu' D) in Sv. discriminate.
    + destruct (NN u Nu I Su). destruct (NN v Nv I' Sv). now apply mult_monotone_down.
  - apply Bsucc_monotone in D.
    pose proof (Bsucc_not_minus_infinity (Bminus mode_NE p q)) as I.
    pose proof (Bsucc_not_minus_infinity (Bminus mode_NE p' q')) as I'.
    set (u := Bsucc (Bminus mode_NE p q)) in *. set (v := Bsucc (Bminus mode_NE p' q')) in *.
    clearbody u v. destruct (le_not_nan _ _ _ _ D) as [Nu Nv].
    assert (NN : forall w : float, is_nan w = false -> w <> B754_infinity true -> zero <? w = false ->
      is_finite w = true /\ w <=? zero = true).
    { intros w Nw Iw H. rewrite lt_negb_le in H by trivial. apply negb_false_iff in H. split; trivial.
      destruct w as [|[]| |]; trivial; try discriminate. now elim Iw. }
    destruct (zero <? u) eqn:Su; destruct (zero <? v) eqn:Sv.
    + apply mult_monotone_side; auto.
    + destruct (NN v Nv I' Sv) as [Fv Hv]. rewrite lt_negb_le in Su by trivial.
      rewrite (le_trans _ _ _ _ _ D Hv) in Su. discriminate.
    + destruct (NN u Nu I Su) as [Fu Hu']. apply le_trans with zero.
      * now apply mult_down_side.
      * now apply mult_side.
    + destruct (NN u Nu I Su). destruct (NN v Nv I' Sv). now apply mult_monotone_down.
Qed.

(** Preparation and the clamp deliver it. *)
Lemma clamped_sound : forall o d other1 other2 : float,
  is_finite other1 = true -> is_finite other2 = true ->
  sound_constants (clamp (prepare_axis _ _ nextafter o d other1 other2)).
Proof.
  intros o d x y Fx Fy.
  destruct (mag_exact _ _ x Fx) as [Mx Ex]. destruct (mag_exact _ _ y Fy) as [My Ey].
  pose proof (magnitude_positive (B2R x)) as Px. pose proof (magnitude_positive (B2R y)) as Py.
  destruct (mult_nearest _ _ Mx My) as [N E]. rewrite Ex, Ey in E.
  unfold sound_constants, clamp, prepare_axis, nextafter. cbn [Model.c_down Model.c_up mul_down mul_up].
  set (product := Bmult mode_NE (mag _ _ x) (mag _ _ y)) in *.
  assert (Z : zero <=? product = true).
  { apply le_iff. rewrite E. repeat split; trivial. change (extended zero) with 0%R.
    rewrite <- nearest_real_0. apply nearest_real_monotone. nra. }
  pose proof (Bpred_monotone _ _ Z) as D. pose proof (Bsucc_monotone _ _ Z) as U.
  destruct (le_not_nan _ _ _ _ D) as [_ Nd]. destruct (le_not_nan _ _ _ _ U) as [_ Nu].
  pose proof (Bpred_not_infinity product) as I.
  assert (F : is_finite (Bpred product) = true).
  { destruct (Bpred product) as [|[]| |]; trivial; try discriminate; (discriminate D || now elim I). }
  repeat split.
  - now destruct (Bpred product <? zero).
  - destruct (Bpred product <? zero) eqn:L; trivial.
    rewrite lt_negb_le in L by trivial. now apply negb_false_iff in L.
  - rewrite lt_negb_le by trivial. apply negb_true_iff.
    destruct (Bsucc product <=? zero) eqn:C; trivial.
    pose proof (le_trans _ _ _ _ _ U C) as K. discriminate K.
Qed.

(** A ray prepared so. *)
Definition prepare_clamped (o d : three float) : three axis :=
  let r := prepare _ _ nextafter o d in triple (clamp (at_x r)) (clamp (at_y r)) (clamp (at_z r)).

Theorem nextafter_clamped_ordered : forall o d : three float, finite3 _ _ d ->
  all3 (ordered prec emax nextafter) (prepare_clamped o d).
Proof.
  intros [ox oy oz] [dx dy dz] (Fdx & Fdy & Fdz).
  repeat apply conj; apply nextafter_ordered; now apply clamped_sound.
Qed.

(** Clamped, a box that passes lies in no box that does not. *)
Theorem nextafter_clamped_monotone : forall (o d lo hi lo' hi' : three float),
  finite3 _ _ o -> finite3 _ _ d ->
  finite3 _ _ lo -> finite3 _ _ hi -> finite3 _ _ lo' -> finite3 _ _ hi' ->
  (B2R (at_x lo') <= B2R (at_x lo))%R -> (B2R (at_x hi) <= B2R (at_x hi'))%R ->
  (B2R (at_y lo') <= B2R (at_y lo))%R -> (B2R (at_y hi) <= B2R (at_y hi'))%R ->
  (B2R (at_z lo') <= B2R (at_z lo))%R -> (B2R (at_z hi) <= B2R (at_z hi'))%R ->
  touches_box _ _ nextafter (prepare_clamped o d) lo hi = true ->
  touches_box _ _ nextafter (prepare_clamped o d) lo' hi' = true.
Proof.
  intros o d lo hi lo' hi' (? & ? & ?) Fd. apply touches_box_ordered.
  - now apply nextafter_clamped_ordered.
  - repeat split; trivial.
Qed.

End Nextafter.

(** Not clamped, over binary64: o = 0, d = (1, 2^-500, 2^-600). The child [-2^1001, -2^1000] x
    [2^200, 2^201] x [-1, 2^200] passes; the parent, which reaches to x = -1, does not. *)
Definition power (e : Z) (H : SpecFloat.bounded 53 1024 4503599627370496 (e - 52) = true) (s : bool) :
  float 53 1024 := B754_finite s 4503599627370496 (e - 52) H.
Definition origin64 : three (float 53 1024) := triple (zero _ _) (zero _ _) (zero _ _).
Definition direction64 : three (float 53 1024) :=
  triple (power 0 eq_refl false) (power (-500) eq_refl false) (power (-600) eq_refl false).
Definition child_lo : three (float 53 1024) :=
  triple (power 1001 eq_refl true) (power 200 eq_refl false) (power 0 eq_refl true).
Definition child_hi : three (float 53 1024) :=
  triple (power 1000 eq_refl true) (power 201 eq_refl false) (power 200 eq_refl false).
Definition parent_hi : three (float 53 1024) :=
  triple (power 0 eq_refl true) (power 201 eq_refl false) (power 200 eq_refl false).

Theorem nextafter_not_monotone :
  let b := nextafter 53 1024 in
  let r := prepare 53 1024 b origin64 direction64 in
  Model.le 53 1024 (at_x child_hi) (at_x parent_hi) = true /\
  touches_box 53 1024 b r child_lo child_hi = true /\
  touches_box 53 1024 b r child_lo parent_hi = false.
Proof. repeat split; vm_compute; reflexivity. Qed.

(** With the clamp neither passes. *)
Theorem nextafter_clamped_example :
  let b := nextafter 53 1024 in
  let r := prepare_clamped 53 1024 origin64 direction64 in
  touches_box 53 1024 b r child_lo child_hi = false /\
  touches_box 53 1024 b r child_lo parent_hi = false.
Proof. split; vm_compute; reflexivity. Qed.

Definition nextafter_clamped_monotone_binary64 := nextafter_clamped_monotone 53 1024.
