(** Rounding downwards is rounding upwards of the opposite, bit for bit: RD(x y) = -RU((-x) y) and
    RD(x - y) = -RU(y - x), for every input, zeros, infinities and NaN included. Hence the backend
    that never leaves upward rounding (`upward` of interval/include/graze/rounding/upward.hpp) and
    the directed ones are the same functions, and so is the ray/octant test over either;
    and `uppb(p, q) = -lowb(q, p)`, as octree/geometry/include/graze/octree/ray_bounds.hpp says.

    For every precision and exponent range; at the end for binary64. *)
From Coq Require Import ZArith Bool Reals Lra FunctionalExtensionality SpecFloat.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model.

Section Negation.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.

Notation float := (float prec emax).
Notation fexp := (SpecFloat.fexp prec emax).
Notation directed := (directed prec emax).
Notation upward := (upward prec emax).

(** The opposite of a float on the level of its bits. *)
Lemma Bopp_B2SF : forall x y : float,
  B2SF x = match B2SF y with
           | S754_zero s => S754_zero (negb s)
           | S754_infinity s => S754_infinity (negb s)
           | S754_nan => S754_nan
           | S754_finite s m e => S754_finite (negb s) m e
           end -> x = Bopp y.
Proof.
  intros x y E. apply B2SF_inj. rewrite E. now destruct y.
Qed.

(** What overflows downwards is the opposite of what overflows upwards with the other sign. *)
Lemma overflow_opposite : forall (x y : float) s,
  B2SF x = binary_overflow prec emax mode_DN s ->
  B2SF y = binary_overflow prec emax mode_UP (negb s) -> x = Bopp y.
Proof.
  intros x y s Ex Ey. apply Bopp_B2SF. rewrite Ex, Ey. now destruct s.
Qed.

(** RD r = - RU (- r) over the reals. *)
Lemma round_down_opposite : forall r,
  round radix2 fexp (round_mode mode_DN) r = (- round radix2 fexp (round_mode mode_UP) (- r))%R.
Proof.
  intros r. simpl. rewrite round_UP_opp. lra.
Qed.

(** RD(x - y) = -RU(y - x), bit for bit, for every x and y. *)
Theorem sub_down_by_negation : forall x y : float,
  Bminus mode_DN x y = Bopp (Bminus mode_UP y x).
Proof.
  intros x y.
  destruct (is_finite x && is_finite y) eqn:F.
  - apply andb_prop in F as [Fx Fy].
    generalize (Bminus_correct _ _ _ _ mode_DN x y Fx Fy) (Bminus_correct _ _ _ _ mode_UP y x Fy Fx).
    rewrite round_down_opposite, Rabs_Ropp.
    replace (- (B2R x - B2R y))%R with (B2R y - B2R x)%R by lra.
    case Rlt_bool.
    + intros (Rd & Fd & Sd) (Ru & Fu & Su).
      apply B2R_Bsign_inj; trivial.
      * now rewrite is_finite_Bopp.
      * now rewrite B2R_Bopp, Rd, Ru.
      * rewrite Bsign_Bopp, Sd, Su.
        2: now destruct (Bminus mode_UP y x).
        destruct (Rcompare_spec (B2R x - B2R y) 0); destruct (Rcompare_spec (B2R y - B2R x) 0);
          try lra; trivial.
        now destruct (Bsign x), (Bsign y).
    + intros (Ed & S) (Eu & _). apply overflow_opposite with (Bsign x); trivial.
      now rewrite S, negb_involutive.
  - destruct x as [sx|sx| |sx mx ex Hx], y as [sy|sy| |sy my ey Hy]; try discriminate F;
      simpl; trivial; try (destruct sx); try (destruct sy); trivial.
Qed.

(** RD(x y) = -RU((-x) y), bit for bit, for every x and y. *)
Theorem mul_down_by_negation : forall x y : float,
  Bmult mode_DN x y = Bopp (Bmult mode_UP (Bopp x) y).
Proof.
  intros x y.
  destruct (is_finite_strict x && is_finite_strict y) eqn:F.
  - apply andb_prop in F as [Fx Fy].
    assert (Gx : is_finite x = true) by now destruct x.
    assert (Gy : is_finite y = true) by now destruct y.
    assert (Nx : is_nan x = false) by now destruct x.
    generalize (Bmult_correct _ _ _ _ mode_DN x y) (Bmult_correct _ _ _ _ mode_UP (Bopp x) y).
    rewrite round_down_opposite, Rabs_Ropp, B2R_Bopp, <- Ropp_mult_distr_l, is_finite_Bopp, Gx, Gy.
    rewrite Bsign_Bopp by trivial.
    case Rlt_bool.
    + intros (Rd & Fd & Sd) (Ru & Fu & Su).
      assert (Nd : is_nan (Bmult mode_DN x y) = false) by now destruct (Bmult mode_DN x y).
      assert (Nu : is_nan (Bmult mode_UP (Bopp x) y) = false) by now destruct (Bmult mode_UP (Bopp x) y).
      apply B2R_Bsign_inj; trivial.
      * now rewrite is_finite_Bopp.
      * now rewrite B2R_Bopp, Rd, Ru.
      * rewrite Bsign_Bopp, Sd, Su by trivial. now destruct (Bsign x), (Bsign y).
    + intros Ed Eu. apply overflow_opposite with (xorb (Bsign x) (Bsign y)); trivial.
      rewrite Eu. f_equal. now destruct (Bsign x), (Bsign y).
  - destruct x as [sx|sx| |sx mx ex Hx], y as [sy|sy| |sy my ey Hy]; try discriminate F;
      simpl; trivial; try (destruct sx); try (destruct sy); trivial.
Qed.

(** RU(x - y) = -RD(y - x), the same read the other way. *)
Lemma sub_up_by_negation : forall x y : float, Bminus mode_UP x y = Bopp (Bminus mode_DN y x).
Proof. intros. now rewrite sub_down_by_negation, Bopp_involutive. Qed.

(** RU(x y) = -RD((-x) y), the same read the other way. *)
Lemma mul_up_by_negation : forall x y : float, Bmult mode_UP x y = Bopp (Bmult mode_DN (Bopp x) y).
Proof. intros. now rewrite mul_down_by_negation, !Bopp_involutive. Qed.

(** The product does not mind which factor carries the sign, nor the factors' order. *)
Lemma mult_sign_either : forall m (x y : float), Bmult m (Bopp x) y = Bmult m x (Bopp y).
Proof.
  intros m x y.
  destruct (is_finite_strict x && is_finite_strict y) eqn:F.
  - apply andb_prop in F as [Fx Fy].
    assert (Gx : is_finite x = true) by now destruct x.
    assert (Gy : is_finite y = true) by now destruct y.
    generalize (Bmult_correct _ _ _ _ m (Bopp x) y) (Bmult_correct _ _ _ _ m x (Bopp y)).
    rewrite !B2R_Bopp, !is_finite_Bopp, Gx, Gy.
    assert (Nx : is_nan x = false) by now destruct x.
    assert (Ny : is_nan y = false) by now destruct y.
    rewrite (Bsign_Bopp _ _ x Nx), (Bsign_Bopp _ _ y Ny).
    replace (- B2R x * B2R y)%R with (B2R x * - B2R y)%R by lra.
    replace (xorb (negb (Bsign x)) (Bsign y)) with (xorb (Bsign x) (negb (Bsign y)))
      by now destruct (Bsign x), (Bsign y).
    case Rlt_bool.
    + intros (R1 & F1 & S1) (R2 & F2 & S2).
      apply B2R_Bsign_inj; trivial; try congruence.
      rewrite S1, S2; trivial.
      * now destruct (Bmult m x (Bopp y)).
      * now destruct (Bmult m (Bopp x) y).
    + intros E1 E2. apply B2SF_inj. now rewrite E1, E2.
  - destruct x as [sx|sx| |sx mx ex Hx], y as [sy|sy| |sy my ey Hy]; try discriminate F;
      simpl; trivial; try (destruct sx); try (destruct sy); trivial.
Qed.

(** Operation by operation, `upward` is the directed backend. *)
Theorem upward_is_directed : upward = directed.
Proof.
  unfold upward, directed. f_equal.
  - do 2 (apply functional_extensionality; intro). symmetry. apply sub_down_by_negation.
  - do 2 (apply functional_extensionality; intro). symmetry. apply mul_down_by_negation.
Qed.

(** u > 0 exactly if -u < 0. *)
Lemma lt_zero_opposite : forall u : float,
  Model.lt _ _ (Bopp u) (zero _ _) = Model.lt _ _ (zero _ _) u.
Proof. now intros [[]|[]| |[] m e H]. Qed.

(** uppb(p, q) = -lowb(q, p), bit for bit, whatever the axis holds (NaN included). *)
Theorem uppb_is_opposite_lowb : forall (a : axis prec emax) (p q : float),
  uppb _ _ directed a p q = Bopp (lowb _ _ directed a q p).
Proof.
  intros a p q. unfold uppb, lowb. simpl.
  rewrite (sub_down_by_negation q p), lt_zero_opposite.
  set (u := Bminus mode_UP p q). set (c := if Model.lt _ _ _ u then _ else _).
  now rewrite mul_down_by_negation, Bopp_involutive, mult_sign_either, Bopp_involutive.
Qed.

(** The same for the backend of upward rounding. *)
Corollary uppb_is_opposite_lowb_upward : forall (a : axis prec emax) (p q : float),
  uppb _ _ upward a p q = Bopp (lowb _ _ upward a q p).
Proof. rewrite upward_is_directed. exact uppb_is_opposite_lowb. Qed.

(** A prepared ray is the same over either backend. *)
Theorem prepare_upward : forall o d : three float,
  prepare _ _ upward o d = prepare _ _ directed o d.
Proof. now rewrite upward_is_directed. Qed.

(** The test is the same over either backend, for every input. *)
Theorem touches_box_upward : forall (r : three (axis prec emax)) (lo hi : three float),
  touches_box _ _ upward r lo hi = touches_box _ _ directed r lo hi.
Proof. now rewrite upward_is_directed. Qed.

End Negation.

(** Binary64. *)
Definition prec_gt_0_64 : Prec_gt_0 53 := eq_refl.
Definition prec_lt_emax_64 : Prec_lt_emax 53 1024 := eq_refl.
#[global] Existing Instance prec_gt_0_64.
#[global] Existing Instance prec_lt_emax_64.

Definition sub_down_by_negation_binary64 := sub_down_by_negation 53 1024.
Definition mul_down_by_negation_binary64 := mul_down_by_negation 53 1024.
Definition upward_is_directed_binary64 : upward 53 1024 = directed 53 1024 :=
  upward_is_directed 53 1024.
Definition uppb_is_opposite_lowb_binary64 := uppb_is_opposite_lowb 53 1024.
Definition touches_box_upward_binary64 := touches_box_upward 53 1024.
