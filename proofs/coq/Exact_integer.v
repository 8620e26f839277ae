(** The slow paths of the backend `nearest`: interval/include/graze/rounding/exact.hpp, directed
    rounding in integers. `round`, `add` and `mul` towards +inf yield what IEEE 754's operations do,
    bit for bit, for every input ([exact_add_correct], [exact_mul_correct]). So the backend `nearest`
    as the code has it is the directed one, with nothing assumed ([nearest_as_coded_is_directed]),
    and the test over it never misses ([never_miss_nearest_binary64]).

    The model is in integers of any size; that the code's hold what they should is part of the
    statements where it matters ([width]: n has at most 128 bits; what is kept fits 64). *)
From Coq Require Import ZArith Bool Reals Lra Lia SpecFloat FunctionalExtensionality.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model Negation Bounds Never_miss Nearest.

Section Exact.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.
Hypothesis prec_more_than_1 : (1 < prec)%Z.

(** The width of the integers that `round` takes: 128. *)
Variable width : Z.
Hypothesis width_positive : (0 < width)%Z.

Notation float := (float prec emax).
Notation fexp := (SpecFloat.fexp prec emax).
Notation emin := (3 - emax - prec)%Z.
Notation RU := (round radix2 fexp Zceil).
Notation result := (result prec emax).

Local Instance valid_fexp' : Valid_exp fexp := fexp_correct prec emax Hprec.
Local Instance monotone_fexp' : Monotone_exp fexp := FLT_exp_monotone emin prec.
Local Hint Resolve valid_fexp' monotone_fexp' valid_rnd_UP : core.

(** The bits of a number: below the hidden bit it is subnormal or 0. *)
Definition assemble (negative : bool) (kept quantum : Z) : spec_float :=
  match kept with
  | Zpos m => S754_finite negative m quantum
  | _ => S754_zero negative
  end.

(** exact::round towards +inf. *)
Definition exact_round (negative : bool) (n exponent : Z) (more : bool) : spec_float :=
  let quantum := Z.max (exponent + Zdigits radix2 n - prec) emin in
  let shift := (quantum - exponent)%Z in
  let kept := if (width <=? shift)%Z then 0%Z
              else if (0 <? shift)%Z then Z.shiftr n shift else Z.shiftl n (- shift) in
  let more := if (width <=? shift)%Z then true
              else if (0 <? shift)%Z then more || negb (Z.land n (2 ^ shift - 1) =? 0)%Z else more in
  let away := negb negative in
  let stepped := if more && away then (kept + 1)%Z else kept in
  let carry := more && away && (stepped =? 2 ^ prec)%Z in
  let kept' := if carry then (2 ^ (prec - 1))%Z else stepped in
  let quantum' := if carry then (quantum + 1)%Z else quantum in
  if (2 ^ (prec - 1) <=? kept')%Z && (emax - prec <? quantum')%Z
  then binary_overflow prec emax mode_UP negative
  else assemble negative kept' quantum'.

Lemma pow_IZR : forall n, (0 <= n)%Z -> IZR (2 ^ n) = bpow radix2 n.
Proof. intros n H. now apply (IZR_Zpower radix2). Qed.

(** What the bits say is what the rounded value is, overflow included. *)
Lemma assemble_correct : forall (negative : bool) (k q : Z) (w : float),
  (0 <= k < 2 ^ prec)%Z -> (emin <= q)%Z -> ((k < 2 ^ (prec - 1))%Z -> q = emin) ->
  let v := F2R (Float radix2 (cond_Zopp negative k) q) in
  (if Rlt_bool (Rabs v) (bpow radix2 emax)
   then B2R w = v /\ is_finite w = true /\ Bsign w = negative
   else B2SF w = binary_overflow prec emax mode_UP negative) ->
  B2SF w = if (2 ^ (prec - 1) <=? k)%Z && (emax - prec <? q)%Z
           then binary_overflow prec emax mode_UP negative else assemble negative k q.
Proof.
  intros s k q w [K0 K1] Q Sub v.
  pose proof (prec_lt_emax prec emax) as Hlt.
  assert (A : Rabs v = (IZR k * bpow radix2 q)%R).
  { unfold v, F2R. cbn [Fnum Fexp]. rewrite Rabs_mult, (Rabs_pos_eq (bpow _ _)) by apply bpow_ge_0.
    f_equal. rewrite <- abs_IZR. f_equal. destruct s; simpl; lia. }
  rewrite A. pose proof (bpow_gt_0 radix2 q) as Q0.
  destruct ((2 ^ (prec - 1) <=? k)%Z && (emax - prec <? q)%Z) eqn:Over.
  - apply andb_prop in Over as [O1 O2]. apply Z.leb_le, IZR_le in O1. apply Z.ltb_lt in O2.
    rewrite pow_IZR in O1 by lia. rewrite Rlt_bool_false; trivial.
    replace emax with ((prec - 1) + (emax - prec + 1))%Z by lia. rewrite bpow_plus.
    assert (bpow radix2 (emax - prec + 1) <= bpow radix2 q)%R by (apply bpow_le; lia).
    apply Rmult_le_compat; trivial; apply bpow_ge_0.
  - assert (Small : (q <= emax - prec)%Z).
    { apply andb_false_iff in Over as [O | O].
      - apply Z.leb_gt in O. apply Sub in O. lia.
      - now apply Z.ltb_ge in O. }
    rewrite Rlt_bool_true.
    2: { replace emax with (prec + (emax - prec))%Z by lia. rewrite bpow_plus.
         assert (bpow radix2 q <= bpow radix2 (emax - prec))%R by (apply bpow_le; lia).
         apply Rlt_le_trans with (bpow radix2 prec * bpow radix2 q)%R.
         - apply Rmult_lt_compat_r; trivial. rewrite <- pow_IZR by lia. now apply IZR_lt.
         - apply Rmult_le_compat_l; trivial. apply bpow_ge_0. }
    intros (Ew & Fw & Sw). unfold assemble. destruct k as [|m|m]; [| | lia].
    + change (B2SF w = B2SF (@B754_zero prec emax s)). f_equal.
      apply B2R_Bsign_inj; trivial. rewrite Ew. unfold v. destruct s; apply F2R_0.
    + assert (B : SpecFloat.bounded prec emax m q = true).
      { unfold SpecFloat.bounded. apply andb_true_intro. split; [| now apply Zle_bool_true].
        unfold SpecFloat.canonical_mantissa. apply Zeq_bool_true.
        rewrite Zpos_digits2_pos. unfold SpecFloat.fexp.
        change (SpecFloat.emin prec emax) with emin.
        destruct (Z_lt_le_dec (Z.pos m) (2 ^ (prec - 1))) as [L | L].
        - rewrite (Sub L).
          pose proof (Zdigits_le_Zpower radix2 (prec - 1) (Z.pos m) L). lia.
        - assert (D : Zdigits radix2 (Z.pos m) = prec) by (apply Zdigits_unique; split; trivial).
          rewrite D. lia. }
      change (B2SF w = B2SF (B754_finite s m q B)). f_equal.
      apply B2R_Bsign_inj; trivial.
Qed.

(** `round` is correctly rounded: the operation that yields w has its bits. *)
Theorem exact_round_correct : forall (negative : bool) (n exponent : Z) (w : float),
  (0 < n < 2 ^ width)%Z ->
  result mode_UP w (F2R (Float radix2 (cond_Zopp negative n) exponent)) negative ->
  B2SF w = exact_round negative n exponent false.
Proof.
  intros s n e w [N0 N1] [_ Hw]. unfold exact_round.
  set (quantum := Z.max (e + Zdigits radix2 n - prec) emin).
  set (shift := (quantum - e)%Z).
  set (x := (IZR n * bpow radix2 (- shift))%R).
  destruct (Zdigits_correct radix2 n) as [D1 D2]. rewrite Z.abs_eq in D1, D2 by lia.
  assert (Dp : (0 < Zdigits radix2 n)%Z) by (apply Zdigits_gt_0; lia).
  assert (X0 : (0 < x)%R) by (apply Rmult_lt_0_compat; [now apply IZR_lt | apply bpow_gt_0]).
  (* what is kept is the integral part *)
  set (kept := if (width <=? shift)%Z then 0%Z
               else if (0 <? shift)%Z then Z.shiftr n shift else Z.shiftl n (- shift)).
  set (more := if (width <=? shift)%Z then true
               else if (0 <? shift)%Z then false || negb (Z.land n (2 ^ shift - 1) =? 0)%Z else false).
  assert (KM : (IZR kept <= x < IZR (kept + 1))%R /\ (more = false <-> IZR kept = x)).
  { unfold kept, more. destruct (width <=? shift)%Z eqn:Wide.
    - apply Z.leb_le in Wide.
      assert (X1 : (x < 1)%R).
      { unfold x. replace 1%R with (bpow radix2 shift * bpow radix2 (- shift))%R
          by (rewrite <- bpow_plus, Z.add_opp_diag_r; reflexivity).
        apply Rmult_lt_compat_r; [apply bpow_gt_0 |].
        apply Rlt_le_trans with (bpow radix2 width); [| now apply bpow_le].
        rewrite <- pow_IZR by lia. now apply IZR_lt. }
      simpl. repeat split; try lra; discriminate.
    - destruct (0 <? shift)%Z eqn:Right.
      + apply Z.ltb_lt in Right. rewrite Z.shiftr_div_pow2 by lia.
        replace (2 ^ shift - 1)%Z with (Z.ones shift) by (rewrite Z.ones_equiv; lia).
        rewrite Z.land_ones by lia.
        assert (P : (0 < 2 ^ shift)%Z) by (apply Z.pow_pos_nonneg; lia).
        pose proof (Z.div_mod n (2 ^ shift)) as DM. pose proof (Z.mod_pos_bound n _ P) as MB.
        set (a := (n / 2 ^ shift)%Z) in *. set (b := (n mod 2 ^ shift)%Z) in *.
        assert (E : x = (IZR a + IZR b * bpow radix2 (- shift))%R).
        { unfold x. rewrite DM by lia. rewrite plus_IZR, mult_IZR, pow_IZR by lia.
          rewrite bpow_opp. field. apply Rgt_not_eq, bpow_gt_0. }
        assert (B0 : (0 <= IZR b)%R) by (apply IZR_le; lia).
        assert (B1 : (IZR b * bpow radix2 (- shift) < 1)%R).
        { replace 1%R with (bpow radix2 shift * bpow radix2 (- shift))%R
            by (rewrite <- bpow_plus, Z.add_opp_diag_r; reflexivity).
          apply Rmult_lt_compat_r; [apply bpow_gt_0 |]. rewrite <- pow_IZR by lia. apply IZR_lt. lia. }
        pose proof (bpow_gt_0 radix2 (- shift)) as S0.
        rewrite plus_IZR, E. simpl. repeat split; try nra.
        * intros H. apply negb_false_iff, Z.eqb_eq in H. rewrite H. ring.
        * intros H. apply negb_false_iff, Z.eqb_eq. apply eq_IZR. nra.
      + apply Z.ltb_ge in Right. rewrite Z.shiftl_mul_pow2 by lia.
        assert (E : IZR (n * 2 ^ (- shift)) = x) by (rewrite mult_IZR, pow_IZR by lia; reflexivity).
        rewrite plus_IZR, E. repeat split; trivial; lra. }
  destruct KM as [[KL KU] MI].
  set (stepped := if more && negb s then (kept + 1)%Z else kept).
  assert (Stepped : Zceil (if s then - x else x)%R = cond_Zopp s stepped).
  { unfold stepped. apply Zceil_imp. rewrite minus_IZR. destruct s; simpl.
    - rewrite andb_false_r, opp_IZR. rewrite plus_IZR in KU. lra.
    - rewrite andb_true_r. rewrite plus_IZR in KU. destruct more.
      + rewrite plus_IZR. assert (IZR kept <> x) by (intros C; apply MI in C; discriminate). lra.
      + rewrite (proj1 MI eq_refl). lra. }
  (* its bounds *)
  assert (XU : (x < bpow radix2 prec)%R).
  { unfold x. apply Rlt_le_trans with (bpow radix2 (Zdigits radix2 n) * bpow radix2 (- shift))%R.
    - apply Rmult_lt_compat_r; [apply bpow_gt_0 |]. rewrite <- pow_IZR by lia. now apply IZR_lt.
    - rewrite <- bpow_plus. apply bpow_le. unfold shift, quantum. lia. }
  assert (XL : (emin < quantum)%Z -> (bpow radix2 (prec - 1) <= x)%R).
  { intros Q. unfold x.
    apply Rle_trans with (bpow radix2 (Zdigits radix2 n - 1) * bpow radix2 (- shift))%R.
    - rewrite <- bpow_plus. apply bpow_le. unfold shift, quantum in *. lia.
    - apply Rmult_le_compat_r; [apply bpow_ge_0 |]. rewrite <- pow_IZR by lia. now apply IZR_le. }
  assert (K0 : (0 <= kept)%Z).
  { apply Z.lt_succ_r. apply lt_IZR. rewrite <- Z.add_1_r. lra. }
  assert (K1 : (kept < 2 ^ prec)%Z).
  { apply lt_IZR. rewrite pow_IZR by lia. lra. }
  assert (KN : (emin < quantum)%Z -> (2 ^ (prec - 1) <= kept)%Z).
  { intros Q. apply XL in Q. apply Z.lt_succ_r. apply lt_IZR. rewrite <- Z.add_1_r, pow_IZR by lia. lra. }
  assert (P2 : (2 ^ prec = 2 * 2 ^ (prec - 1))%Z).
  { rewrite <- Z.pow_succ_r by lia. f_equal. lia. }
  assert (PP : (0 < 2 ^ (prec - 1))%Z) by (apply Z.pow_pos_nonneg; lia).
  assert (SK : (kept <= stepped <= kept + 1)%Z) by (unfold stepped; destruct (more && negb s); lia).
  (* the rounded value *)
  assert (V : RU (F2R (Float radix2 (cond_Zopp s n) e)) = F2R (Float radix2 (cond_Zopp s stepped) quantum)).
  { assert (C : cexp radix2 fexp (F2R (Float radix2 (cond_Zopp s n) e)) = quantum).
    { unfold cexp. rewrite mag_F2R_Zdigits by (destruct s; simpl; lia).
      replace (Zdigits radix2 (cond_Zopp s n)) with (Zdigits radix2 n)
        by (destruct s; trivial; simpl; now rewrite <- (Zdigits_abs _ (- n)), Z.abs_opp, Zdigits_abs).
      unfold SpecFloat.fexp, quantum. change (SpecFloat.emin prec emax) with emin. f_equal. lia. }
    unfold round. rewrite C. f_equal. f_equal. rewrite <- Stepped. f_equal.
    unfold scaled_mantissa. rewrite C. unfold F2R, x. cbn [Fnum Fexp].
    rewrite Rmult_assoc, <- bpow_plus.
    replace (e + - quantum)%Z with (- shift)%Z by (unfold shift; lia).
    destruct s; simpl; trivial. rewrite opp_IZR. ring. }
  simpl round_mode in Hw. rewrite V in Hw.
  set (carry := more && negb s && (stepped =? 2 ^ prec)%Z).
  destruct carry eqn:Carry.
  - unfold carry in Carry. apply andb_prop in Carry as [_ Full]. apply Z.eqb_eq in Full.
    apply assemble_correct.
    + lia.
    + unfold quantum. lia.
    + lia.
    + replace (F2R (Float radix2 (cond_Zopp s (2 ^ (prec - 1))) (quantum + 1)))
        with (F2R (Float radix2 (cond_Zopp s stepped) quantum)); trivial.
      assert (P2' : IZR (2 ^ prec) = (2 * IZR (2 ^ (prec - 1)))%R) by now rewrite P2, mult_IZR.
      rewrite Full. unfold F2R. cbn [Fnum Fexp]. rewrite bpow_plus.
      destruct s; cbn [cond_Zopp]; rewrite ?opp_IZR, P2'; change (bpow radix2 1) with 2%R; ring.
  - apply assemble_correct; trivial.
    + split; [lia |].
      destruct (Z.eq_dec stepped (2 ^ prec)) as [Full | NotFull]; [| lia].
      unfold carry in Carry. rewrite Full, Z.eqb_refl, andb_true_r in Carry.
      unfold stepped in Full. rewrite Carry in Full. lia.
    + unfold quantum. lia.
    + intros L. destruct (Z_lt_le_dec emin quantum) as [Q | Q]; [apply KN in Q; lia |].
      unfold quantum in *. lia.
Qed.

End Exact.
