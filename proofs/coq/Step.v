(** A step of a number's bits is the next number: what `up_if` of
    interval/include/graze/rounding/nearest.hpp does (add 1 to the bits of a positive double,
    subtract 1 from those of a negative one) is Flocq's [Bsucc], which Nearest.v has in its place.

    [magnitude_bits] is the encoding of IEEE 754 without the sign bit, as Flocq's Bits.v has it:
    subnormal numbers and zero have the field 0, infinities the largest. [step_is_succ] is the
    theorem; -0 and +inf, and NaN, are not stepped (Nearest.v proves it of the operations). *)
From Coq Require Import ZArith Bool Reals Lra Lia SpecFloat.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model Negation Bounds Nearest.

Section Step.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.

Notation float := (float prec emax).
Notation fexp := (SpecFloat.fexp prec emax).
Notation emin := (3 - emax - prec)%Z.
Local Instance valid_fexp_step : Valid_exp fexp := fexp_correct prec emax Hprec.
Local Instance monotone_fexp_step : Monotone_exp fexp := FLT_exp_monotone emin prec.
Local Hint Resolve valid_fexp_step monotone_fexp_step : core.

(** The exponent field and the trailing significand as one integer. A significand m with the hidden
    bit 2^(prec - 1) has the field e - emin + 1, one without has e = emin and the field 0: in both
    cases field * 2^(prec - 1) + trailing = (e - emin) 2^(prec - 1) + m. *)
Definition magnitude_bits (f : float) : Z :=
  match f with
  | B754_zero _ => 0
  | B754_infinity _ => (2 * emax - 1) * 2 ^ (prec - 1)
  | B754_nan => (2 * emax - 1) * 2 ^ (prec - 1) + 2 ^ (prec - 2)
  | B754_finite _ m e _ => (e - emin) * 2 ^ (prec - 1) + Z.pos m
  end.

(** That integer, split in field and trailing significand. *)
Lemma magnitude_bits_fields : forall s m e H,
  let f : float := B754_finite s m e H in
  magnitude_bits f = if (2 ^ (prec - 1) <=? Z.pos m)%Z
                     then ((e - emin + 1) * 2 ^ (prec - 1) + (Z.pos m - 2 ^ (prec - 1)))%Z
                     else Z.pos m.
Proof.
  intros s m e H f. unfold f, magnitude_bits. case Z.leb_spec; intros L; [ring |].
  pose proof H as B. unfold SpecFloat.bounded in B. apply andb_prop in B as [B _].
  unfold SpecFloat.canonical_mantissa in B. apply Zeq_bool_eq in B. rewrite Zpos_digits2_pos in B.
  unfold SpecFloat.fexp in B. change (SpecFloat.emin prec emax) with emin in B.
  pose proof (Zdigits_le_Zpower radix2 (prec - 1) (Z.pos m) L).
  replace e with emin by lia. ring.
Qed.

Lemma power_double : (2 ^ prec = 2 * 2 ^ (prec - 1))%Z.
Proof. pose proof (prec_gt_0 prec). rewrite <- Z.pow_succ_r by lia. f_equal. lia. Qed.

(** The number above a positive one has the next bits. *)
Lemma step_positive : forall (m : positive) (e : Z) (H : SpecFloat.bounded prec emax m e = true),
  let f : float := B754_finite false m e H in
  Bsign (Bsucc f) = false /\ magnitude_bits (Bsucc f) = (magnitude_bits f + 1)%Z.
Proof.
  intros m e H f. pose proof (prec_gt_0 prec) as Hp. pose proof (prec_lt_emax prec emax) as He.
  assert (V : succ radix2 fexp (B2R f) = F2R (Float radix2 (Z.pos m + 1) e)).
  { rewrite succ_eq_pos by now apply F2R_ge_0.
    change (B2R f) with (F2R (Float radix2 (cond_Zopp false (Z.pos m)) e)).
    rewrite ulp_canonical by (discriminate || now apply (canonical_bounded prec emax false)).
    unfold F2R. cbn [Fnum Fexp cond_Zopp]. rewrite plus_IZR. ring. }
  pose proof (significand_below prec emax m e H) as U.
  assert (Ue : (e <= emax - prec)%Z).
  { pose proof H as K. apply andb_prop in K as [_ K]. now apply Zle_bool_imp_le. }
  generalize (Bsucc_correct _ _ _ _ f eq_refl). rewrite V. case Rlt_bool_spec; intros B.
  - intros (E & F & S). change (Bsign (Bsucc f) = false) in S. split; trivial.
    assert (P : (0 < B2R (Bsucc f))%R) by (rewrite E; now apply F2R_gt_0).
    destruct (Bsucc f) as [s|s| |s m' e' H']; try discriminate; [simpl in P; lra |].
    simpl in S. subst s.
    pose proof (canonical_bounded prec emax false m' e' H') as C'.
    change (F2R (Float radix2 (Z.pos m') e') = F2R (Float radix2 (Z.pos m + 1) e)) in E.
    destruct (Z_lt_le_dec (Z.pos m + 1) (2 ^ prec)) as [L | L].
    + (* the significand grows *)
      assert (C : canonical radix2 fexp (Float radix2 (Z.pos m + 1) e)).
      { unfold canonical, cexp. rewrite mag_F2R_Zdigits by lia. cbn [Fexp].
        pose proof (canonical_bounded prec emax false m e H) as Cm.
        unfold canonical, cexp in Cm. rewrite mag_F2R_Zdigits in Cm by discriminate.
        cbn [Fexp cond_Zopp] in Cm. unfold SpecFloat.fexp in *.
        pose proof (Zdigits_le_Zpower radix2 prec (Z.pos m + 1) L).
        assert (Zdigits radix2 (Z.pos m) <= Zdigits radix2 (Z.pos m + 1))%Z by (apply Zdigits_le; lia).
        lia. }
      pose proof (canonical_unique _ _ _ _ C' C E) as K.
      pose proof (f_equal Fnum K) as K1. pose proof (f_equal Fexp K) as K2. cbn [Fnum Fexp cond_Zopp] in K1, K2.
      unfold magnitude_bits, f. rewrite K1, K2. ring.
    + (* it carries into the exponent *)
      assert (M : (Z.pos m + 1 = 2 ^ prec)%Z) by lia.
      assert (PP : (0 < 2 ^ (prec - 1))%Z) by (apply Z.pow_pos_nonneg; lia).
      assert (C : canonical radix2 fexp (Float radix2 (2 ^ (prec - 1)) (e + 1))).
      { unfold canonical, cexp. rewrite mag_F2R_Zdigits by lia. cbn [Fexp].
        assert (D : Zdigits radix2 (2 ^ (prec - 1)) = prec).
        { apply Zdigits_unique. rewrite Z.abs_eq by lia. change (Zpower radix2) with (Z.pow 2).
          rewrite power_double. lia. }
        pose proof (canonical_bounded prec emax false m e H) as Cm.
        unfold canonical, cexp in Cm. rewrite mag_F2R_Zdigits in Cm by discriminate.
        cbn [Fexp cond_Zopp] in Cm. unfold SpecFloat.fexp in *. lia. }
      assert (E' : F2R (Float radix2 (Z.pos m') e') = F2R (Float radix2 (2 ^ (prec - 1)) (e + 1))).
      { rewrite E, M, power_double. unfold F2R. cbn [Fnum Fexp].
        rewrite mult_IZR, bpow_plus. change (bpow radix2 1) with 2%R. ring. }
      pose proof (canonical_unique _ _ _ _ C' C E') as K.
      pose proof (f_equal Fnum K) as K1. pose proof (f_equal Fexp K) as K2. cbn [Fnum Fexp cond_Zopp] in K1, K2.
      unfold magnitude_bits, f. rewrite K1, K2. pose proof power_double. nia.
  - intros E. assert (Z : Bsucc f = B754_infinity false) by now apply B2SF_inj.
    rewrite Z. split; trivial. unfold F2R in B. cbn [Fnum Fexp] in B.
    (* only the largest number's successor overflows *)
    assert (Me : e = (emax - prec)%Z /\ (Z.pos m + 1 = 2 ^ prec)%Z).
    { assert (I : (IZR (Z.pos m + 1) <= bpow radix2 prec)%R).
      { change (bpow radix2 prec) with (bpow radix2 prec). rewrite <- (IZR_Zpower radix2) by lia.
        apply IZR_le. change (Zpower radix2 prec) with (2 ^ prec)%Z. lia. }
      assert (Ee : e = (emax - prec)%Z).
      { apply Z.le_antisymm; trivial. apply Znot_gt_le. intros G.
        assert (bpow radix2 e <= bpow radix2 (emax - prec - 1))%R by (apply bpow_le; lia).
        assert (bpow radix2 prec * bpow radix2 (emax - prec - 1) < bpow radix2 emax)%R
          by (rewrite <- bpow_plus; apply bpow_lt; lia).
        pose proof (bpow_gt_0 radix2 e). pose proof (bpow_gt_0 radix2 prec). nra. }
      split; trivial. subst e.
      replace emax with (prec + (emax - prec))%Z in B at 1 by lia. rewrite bpow_plus in B.
      apply Rmult_le_reg_r in B; [| apply bpow_gt_0].
      rewrite <- (IZR_Zpower radix2) in B by lia. apply le_IZR in B.
      change (Zpower radix2 prec) with (2 ^ prec)%Z in B. lia. }
    destruct Me as [Ee Em]. unfold magnitude_bits, f. rewrite Ee. pose proof power_double. nia.
Qed.

(** Going up from -g, a negative number, is going down from g. *)
Lemma succ_of_pred : forall g : float, is_finite_strict g = true -> Bsign g = false ->
  Bsucc (Bopp (Bsucc (Bopp g))) = g /\ Bsign (Bsucc (Bopp g)) = true /\ is_finite (Bsucc (Bopp g)) = true.
Proof.
  intros g Fg Sg.
  assert (F : is_finite g = true) by now destruct g.
  assert (P : (0 < B2R g)%R).
  { destruct g as [| | |s m e H]; try discriminate. simpl in Sg. subst s. now apply F2R_gt_0. }
  assert (Fo : is_finite (Bopp g) = true) by now rewrite is_finite_Bopp.
  pose proof (B2R_between _ _ g) as Bg.
  generalize (Bsucc_correct _ _ _ _ (Bopp g) Fo). rewrite B2R_Bopp, succ_opp, is_finite_strict_Bopp, Fg.
  rewrite Bsign_Bopp, Sg by now destruct g.
  assert (P0 : (0 <= pred radix2 fexp (B2R g))%R)
    by (apply pred_ge_0; auto using generic_format_B2R).
  rewrite Rlt_bool_true by (pose proof (bpow_gt_0 radix2 emax); lra).
  intros (E & Fs & S). split; [| split]; trivial.
  set (h := Bopp (Bsucc (Bopp g))).
  assert (Fh : is_finite h = true) by (unfold h; now rewrite is_finite_Bopp).
  assert (Eh : B2R h = pred radix2 fexp (B2R g)) by (unfold h; rewrite B2R_Bopp, E; ring).
  assert (Sh : Bsign h = false).
  { unfold h. rewrite Bsign_Bopp, S; trivial. now destruct (Bsucc (Bopp g)). }
  generalize (Bsucc_correct _ _ _ _ h Fh). rewrite Eh, succ_pred by auto using generic_format_B2R.
  rewrite Rlt_bool_true by lra. intros (E' & F' & S').
  apply B2R_Bsign_inj; trivial. now rewrite S', Sh, Sg.
Qed.

(** The step of the bits is the next number up: one more for positive numbers and +0, one less for
    negative ones; the sign bit stays (so that -2^-1074 goes to -0, and -inf to the least number). *)
Theorem step_is_succ : forall f : float,
  f <> B754_nan -> f <> B754_zero true -> f <> B754_infinity false ->
  Bsign (Bsucc f) = Bsign f /\
  magnitude_bits (Bsucc f) = (magnitude_bits f + if Bsign f then -1 else 1)%Z.
Proof.
  assert (Zero : magnitude_bits (Bsucc (B754_zero false)) = 1%Z).
  { change (((SpecFloat.emin prec emax) - emin) * 2 ^ (prec - 1) + 1 = 1)%Z.
    change (SpecFloat.emin prec emax) with emin. ring. }
  assert (Opp : forall g : float, magnitude_bits (Bopp g) = magnitude_bits g) by now intros [| | |].
  intros f Nan Z I. destruct f as [[]|[]| |[] m e H]; try contradiction.
  - now split.
  - (* -inf *)
    change (Bsucc (B754_infinity true)) with (Bopp (@Bmax_float prec emax _ _)).
    pose proof (Bmax_is_overflow prec emax) as T.
    rewrite Opp. destruct (@Bmax_float prec emax _ _) as [| | |s m e H]; try discriminate.
    unfold binary_overflow in T. cbn [overflow_to_inf] in T. inversion T as [[T1 T2 T3]].
    split; trivial. unfold magnitude_bits.
    assert (1 < 2 ^ prec)%Z by (apply (Zpower_gt_1 radix2), (prec_gt_0 prec)).
    rewrite T2. change (Zpower 2 prec) with (2 ^ prec)%Z. rewrite Z2Pos.id by lia.
    pose proof power_double. cbn [Bsign]. nia.
  - (* negative *)
    set (g := B754_finite false m e H : float).
    destruct (succ_of_pred g eq_refl eq_refl) as (E & S & F).
    change (B754_finite true m e H) with (Bopp g).
    split; trivial. rewrite (Opp g). change (Bsign (Bopp g)) with true. cbv iota.
    set (h := Bopp (Bsucc (Bopp g))) in *.
    assert (Eh : magnitude_bits (Bsucc (Bopp g)) = magnitude_bits h) by (unfold h; now rewrite Opp).
    rewrite Eh.
    assert (Sh : Bsign h = false) by (unfold h; rewrite Bsign_Bopp, S; trivial; now destruct (Bsucc (Bopp g))).
    assert (Fh : is_finite h = true) by (unfold h; now rewrite is_finite_Bopp).
    clearbody h. clear Eh.
    destruct h as [s|s| |s m' e' H']; try discriminate; simpl in Sh; subst s.
    + rewrite <- E, Zero. reflexivity.
    + destruct (step_positive m' e' H') as [_ K]. rewrite E in K. lia.
  - now apply step_positive.
Qed.

End Step.

Definition step_is_succ_binary64 := step_is_succ 53 1024.
