(** The slow paths of the backend `nearest`: interval/include/graze/rounding/exact.hpp, directed
    rounding in integers. `round`, `add` and `mul` towards +inf yield what IEEE 754's operations do,
    bit for bit, for every input ([exact_add_correct], [exact_mul_correct]). So the backend `nearest`
    as the code has it is the directed one, with nothing assumed ([nearest_as_coded_is_directed]),
    and the test over it never misses ([never_miss_nearest_binary64]).

    The model is in integers of any size; that `round` gets at most [width] = 128 bits is proved of
    each call (the hypothesis of [exact_round_correct]), and so is that what it keeps has at most prec
    + 1 bits, within its proof. *)
From Coq Require Import ZArith Bool Reals Lra Lia SpecFloat FunctionalExtensionality.
From Flocq Require Import Core Operations BinarySingleNaN.
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

(** ** The product and the sum *)

(** Where a sum reaches further than this many bits below the larger term, the smaller is replaced:
    64. *)
Variable guard : Z.
Hypothesis guard_enough : (prec <= guard)%Z.
Hypothesis width_enough_product : (2 * prec <= width)%Z.
Hypothesis width_enough_sum : (prec + guard + 1 <= width)%Z.

(** exact::take_apart: the significand with its leading bit in place, and its exponent. *)
Definition take_apart (m : positive) (e : Z) : Z * Z :=
  let shift := (prec - Zdigits radix2 (Z.pos m))%Z in (Z.pos m * 2 ^ shift, e - shift)%Z.

Lemma take_apart_correct : forall (s : bool) (m : positive) (e : Z),
  SpecFloat.bounded prec emax m e = true ->
  let (n, k) := take_apart m e in
  (2 ^ (prec - 1) <= n < 2 ^ prec)%Z /\ (emin - prec + 1 <= k)%Z /\
  F2R (Float radix2 (cond_Zopp s (Z.pos m)) e) = F2R (Float radix2 (cond_Zopp s n) k).
Proof.
  intros s m e H. unfold take_apart.
  pose proof (significand_below prec emax m e H) as U.
  set (d := Zdigits radix2 (Z.pos m)).
  assert (D : (d <= prec)%Z) by now apply Zdigits_le_Zpower.
  assert (Dp : (0 < d)%Z) by now apply Zdigits_gt_0.
  destruct (Zdigits_correct radix2 (Z.pos m)) as [D1 D2]. fold d in D1, D2.
  change (Z.abs (Z.pos m)) with (Z.pos m) in D1, D2.
  change (Zpower radix2) with (Z.pow 2) in D1, D2.
  assert (E : (emin <= e)%Z).
  { unfold SpecFloat.bounded in H. apply andb_prop in H as [H _].
    unfold SpecFloat.canonical_mantissa in H. apply Zeq_bool_eq in H. unfold SpecFloat.fexp in H.
    change (SpecFloat.emin prec emax) with emin in H. lia. }
  assert (P : (0 < 2 ^ (prec - d))%Z) by (apply Z.pow_pos_nonneg; lia).
  repeat split.
  - replace (prec - 1)%Z with ((d - 1) + (prec - d))%Z by lia. rewrite Z.pow_add_r by lia. nia.
  - replace (2 ^ prec)%Z with (2 ^ d * 2 ^ (prec - d))%Z by (rewrite <- Z.pow_add_r by lia; f_equal; lia).
    nia.
  - lia.
  - unfold F2R. cbn [Fnum Fexp].
    replace (cond_Zopp s (Z.pos m * 2 ^ (prec - d)))%Z with (cond_Zopp s (Z.pos m) * 2 ^ (prec - d))%Z
      by (destruct s; cbn [cond_Zopp]; ring).
    rewrite mult_IZR, pow_IZR, Rmult_assoc, <- bpow_plus by lia. f_equal. f_equal. lia.
Qed.

(** exact::mul towards +inf. *)
Definition exact_mul (x y : float) : spec_float :=
  match x, y with
  | B754_finite sx mx ex _, B754_finite sy my ey _ =>
      let (a, ea) := take_apart mx ex in
      let (b, eb) := take_apart my ey in exact_round (xorb sx sy) (a * b) (ea + eb) false
  | _, _ => B2SF (Bmult mode_NE x y)
  end.

(** It is RU(x y), bit for bit, for every x and y. *)
Theorem exact_mul_correct : forall x y : float, exact_mul x y = B2SF (Bmult mode_UP x y).
Proof.
  intros x y. destruct (is_finite_strict x && is_finite_strict y) eqn:F.
  2: { rewrite (mult_special _ _ mode_UP mode_NE x y F).
       now destruct x as [|[]| |], y as [|[]| |]. }
  apply andb_prop in F as [Fx Fy].
  pose proof (mult_result _ _ mode_UP x y Fx Fy) as H.
  destruct x as [| | |sx mx ex Hx]; try discriminate. destruct y as [| | |sy my ey Hy]; try discriminate.
  simpl Bsign in H. set (w := Bmult mode_UP _ _) in *. clearbody w. simpl (B2R _) in H. unfold exact_mul.
  pose proof (take_apart_correct sx mx ex Hx) as Tx. pose proof (take_apart_correct sy my ey Hy) as Ty.
  destruct (take_apart mx ex) as [a ea]. destruct (take_apart my ey) as [b eb].
  destruct Tx as ([A1 A2] & _ & Ex). destruct Ty as ([B1 B2] & _ & Ey).
  rewrite Ex, Ey, <- F2R_mult in H. symmetry. apply exact_round_correct.
  - assert (0 < 2 ^ (prec - 1))%Z by (apply Z.pow_pos_nonneg; lia).
    split; [nia |]. apply Z.lt_le_trans with (2 ^ (2 * prec))%Z.
    + replace (2 * prec)%Z with (prec + prec)%Z by lia. rewrite Z.pow_add_r by lia. nia.
    + apply Z.pow_le_mono_r; lia.
  - replace (Float radix2 (cond_Zopp (xorb sx sy) (a * b)) (ea + eb))
      with (Fmult (Float radix2 (cond_Zopp sx a) ea) (Float radix2 (cond_Zopp sy b) eb)); trivial.
    unfold Fmult. f_equal. destruct sx, sy; cbn [cond_Zopp xorb]; ring.
Qed.

(** The rest of exact::add, from the term of larger magnitude, (-1)^s A 2^E, and the smaller. *)
Definition add_ordered (s : bool) (A E : Z) (t : bool) (B F : Z) : spec_float :=
  let gap := (E - F)%Z in
  let deep := (guard <? gap)%Z in
  let shift := if deep then guard else gap in
  let a := Z.shiftl A shift in
  let b := if deep then 1%Z else B in
  exact_round s (if Bool.eqb s t then a + b else a - b) (E - shift) false.

(** Numbers of magnitude 2^(prec - 1 + E) and more are 2^(E - 1) apart at least. *)
Lemma neighbours_apart : forall (L : R) (E : Z), generic_format radix2 fexp L -> (emin < E)%Z ->
  (bpow radix2 (prec - 1 + E) <= Rabs L)%R ->
  (L + bpow radix2 (E - 1) <= succ radix2 fexp L /\ pred radix2 fexp L <= L - bpow radix2 (E - 1))%R.
Proof.
  intros L E FL HE HL.
  assert (Ulp : forall y, (bpow radix2 (prec - 2 + E) <= Rabs y)%R -> (bpow radix2 (E - 1) <= ulp radix2 fexp y)%R).
  { intros y Hy. rewrite ulp_neq_0.
    - apply bpow_le. unfold cexp, SpecFloat.fexp. change (SpecFloat.emin prec emax) with emin.
      assert (prec - 1 + E <= Raux.mag radix2 y)%Z; [| lia].
      apply mag_ge_bpow. now replace (prec - 1 + E - 1)%Z with (prec - 2 + E)%Z by lia.
    - intros Z. rewrite Z, Rabs_R0 in Hy. pose proof (bpow_gt_0 radix2 (prec - 2 + E)). lra. }
  assert (Lt : (bpow radix2 (prec - 2 + E) < bpow radix2 (prec - 1 + E))%R) by (apply bpow_lt; lia).
  assert (Pos : forall l, generic_format radix2 fexp l -> (bpow radix2 (prec - 1 + E) <= l)%R ->
    (l + bpow radix2 (E - 1) <= succ radix2 fexp l /\ pred radix2 fexp l <= l - bpow radix2 (E - 1))%R).
  { intros l Fl Hl. pose proof (bpow_gt_0 radix2 (prec - 2 + E)) as P0. split.
    - rewrite succ_eq_pos by lra.
      assert (bpow radix2 (E - 1) <= ulp radix2 fexp l)%R by (apply Ulp; rewrite Rabs_pos_eq; lra). lra.
    - assert (Pl : (bpow radix2 (prec - 2 + E) <= pred radix2 fexp l)%R).
      { apply pred_ge_gt; auto; [| lra]. apply generic_format_bpow.
        unfold SpecFloat.fexp. change (SpecFloat.emin prec emax) with emin. lia. }
      assert (U : (bpow radix2 (E - 1) <= ulp radix2 fexp (pred radix2 fexp l))%R)
        by (apply Ulp; rewrite Rabs_pos_eq; lra).
      assert (pred radix2 fexp l + ulp radix2 fexp (pred radix2 fexp l) = l)%R
        by (apply pred_plus_ulp; auto; lra). lra. }
  destruct (Rle_or_lt 0 L) as [S | S].
  - rewrite Rabs_pos_eq in HL by trivial. now apply Pos.
  - rewrite Rabs_left in HL by trivial.
    destruct (Pos (- L)%R) as [P1 P2]; trivial; [now apply generic_format_opp |].
    rewrite succ_opp in P1. rewrite pred_opp in P2. lra.
Qed.

(** What is added to such a number, if small, matters by its sign alone. *)
Lemma small_by_sign : forall (L S S' : R) (E : Z), generic_format radix2 fexp L -> (emin < E)%Z ->
  (bpow radix2 (prec - 1 + E) <= Rabs L)%R ->
  (Rabs S < bpow radix2 (E - 1))%R -> (Rabs S' < bpow radix2 (E - 1))%R ->
  (0 < S /\ 0 < S' \/ S < 0 /\ S' < 0)%R -> RU (L + S) = RU (L + S').
Proof.
  intros L S S' E FL HE HL HS HS' Sg.
  destruct (neighbours_apart L E FL HE HL) as [Up Dn].
  apply Rabs_lt_inv in HS, HS'.
  destruct Sg as [[P P'] | [N N']].
  - assert (K : forall r, (0 < r < bpow radix2 (E - 1))%R -> RU (L + r) = succ radix2 fexp L).
    { intros r Hr. apply round_UP_eq; auto.
      - now apply generic_format_succ.
      - rewrite pred_succ; auto. lra. }
    rewrite !K; trivial; lra.
  - assert (K : forall r, (- bpow radix2 (E - 1) < r < 0)%R -> RU (L + r) = L).
    { intros r Hr. apply round_UP_eq; auto. lra. }
    rewrite !K; trivial; lra.
Qed.

(** The sum from its ordered terms is correctly rounded. *)
Lemma add_ordered_correct : forall (s : bool) (A E : Z) (t : bool) (B F : Z) (w : float),
  let L := F2R (Float radix2 (cond_Zopp s A) E) in
  let S := F2R (Float radix2 (cond_Zopp t B) F) in
  (2 ^ (prec - 1) <= A < 2 ^ prec)%Z -> (2 ^ (prec - 1) <= B < 2 ^ prec)%Z ->
  (emin - prec + 1 <= F)%Z -> generic_format radix2 fexp L ->
  (F < E \/ F = E /\ B <= A)%Z -> (L + S <> 0)%R ->
  result mode_UP w (L + S) s -> B2SF w = add_ordered s A E t B F.
Proof.
  intros s A E t B F w L S [A1 A2] [B1 B2] HF FL Order NZ Hw. unfold add_ordered.
  assert (PP : (0 < 2 ^ (prec - 1))%Z) by (apply Z.pow_pos_nonneg; lia).
  assert (P2 : (2 ^ prec = 2 * 2 ^ (prec - 1))%Z).
  { rewrite <- Z.pow_succ_r by lia. f_equal. lia. }
  destruct (guard <? E - F)%Z eqn:Deep.
  - apply Z.ltb_lt in Deep. rewrite Z.shiftl_mul_pow2 by lia.
    assert (G : (2 <= 2 ^ guard)%Z) by (change 2%Z with (2 ^ 1)%Z at 1; apply Z.pow_le_mono_r; lia).
    set (n := (if Bool.eqb s t then A * 2 ^ guard + 1 else A * 2 ^ guard - 1)%Z).
    set (S' := F2R (Float radix2 (cond_Zopp t 1) (E - guard))).
    assert (V : F2R (Float radix2 (cond_Zopp s n) (E - guard)) = (L + S')%R).
    { unfold L, S', n, F2R. cbn [Fnum Fexp].
      replace (bpow radix2 E) with (IZR (2 ^ guard) * bpow radix2 (E - guard))%R
        by (rewrite pow_IZR, <- bpow_plus by lia; f_equal; lia).
      destruct s, t; cbn [cond_Zopp Bool.eqb]; rewrite ?opp_IZR, ?plus_IZR, ?minus_IZR, ?mult_IZR; ring. }
    apply exact_round_correct.
    + split.
      * unfold n. destruct (Bool.eqb s t); nia.
      * apply Z.lt_le_trans with (2 ^ (prec + guard + 1))%Z; [| apply Z.pow_le_mono_r; lia].
        rewrite !Z.pow_add_r by lia. unfold n. destruct (Bool.eqb s t); nia.
    + rewrite V.
      assert (HL : (bpow radix2 (prec - 1 + E) <= Rabs L)%R).
      { unfold L, F2R. cbn [Fnum Fexp]. rewrite Rabs_mult, (Rabs_pos_eq (bpow _ _)), bpow_plus by apply bpow_ge_0.
        apply Rmult_le_compat_r; [apply bpow_ge_0 |].
        rewrite <- abs_IZR, <- pow_IZR by lia. apply IZR_le. destruct s; simpl cond_Zopp; lia. }
      assert (HS : (Rabs S < bpow radix2 (E - 1))%R).
      { unfold S, F2R. cbn [Fnum Fexp]. rewrite Rabs_mult, (Rabs_pos_eq (bpow _ _)) by apply bpow_ge_0.
        apply Rlt_le_trans with (bpow radix2 prec * bpow radix2 F)%R.
        - apply Rmult_lt_compat_r; [apply bpow_gt_0 |].
          rewrite <- abs_IZR, <- pow_IZR by lia. apply IZR_lt. destruct t; simpl cond_Zopp; lia.
        - rewrite <- bpow_plus. apply bpow_le. lia. }
      assert (HS' : (Rabs S' < bpow radix2 (E - 1))%R).
      { unfold S', F2R. cbn [Fnum Fexp]. rewrite Rabs_mult, (Rabs_pos_eq (bpow _ _)) by apply bpow_ge_0.
        replace (Rabs (IZR (cond_Zopp t 1))) with 1%R
          by (destruct t; simpl; [rewrite Rabs_left | rewrite Rabs_pos_eq]; lra).
        rewrite Rmult_1_l. apply bpow_lt. lia. }
      assert (Sg : (0 < S /\ 0 < S' \/ S < 0 /\ S' < 0)%R).
      { unfold S, S'. destruct t; simpl cond_Zopp; [right | left]; split;
          (apply F2R_gt_0 || apply F2R_lt_0); simpl; lia. }
      assert (BL : (bpow radix2 (E - 1) <= bpow radix2 (prec - 1 + E))%R) by (apply bpow_le; lia).
      assert (SL : if s then (L < 0)%R else (0 < L)%R).
      { unfold L. destruct s; simpl cond_Zopp; [apply F2R_lt_0 | apply F2R_gt_0]; simpl; lia. }
      destruct Hw as [_ Hw]. split.
      * apply Rabs_lt_inv in HS'. destruct s;
          [rewrite Rabs_left in HL | rewrite Rabs_pos_eq in HL]; lra.
      * simpl round_mode in *. rewrite (small_by_sign L S' S E); trivial; try lia. tauto.
  - apply Z.ltb_ge in Deep. rewrite Z.shiftl_mul_pow2 by lia.
    replace (E - (E - F))%Z with F by lia.
    set (n := (if Bool.eqb s t then A * 2 ^ (E - F) + B else A * 2 ^ (E - F) - B)%Z).
    assert (V : F2R (Float radix2 (cond_Zopp s n) F) = (L + S)%R).
    { unfold L, S, n, F2R. cbn [Fnum Fexp].
      replace (bpow radix2 E) with (IZR (2 ^ (E - F)) * bpow radix2 F)%R
        by (rewrite pow_IZR, <- bpow_plus by lia; f_equal; lia).
      destruct s, t; cbn [cond_Zopp Bool.eqb]; rewrite ?opp_IZR, ?plus_IZR, ?minus_IZR, ?mult_IZR; ring. }
    rewrite <- V in Hw, NZ. apply exact_round_correct; trivial.
    assert (N : n <> 0%Z).
    { intros N. rewrite N in NZ. apply NZ. destruct s; apply F2R_0. }
    assert (G0 : (1 <= 2 ^ (E - F))%Z) by (apply (Z.pow_le_mono_r 2 0); lia).
    split.
    + assert (0 <= n)%Z; [| lia]. unfold n. destruct (Bool.eqb s t); [nia |].
      destruct Order as [O | [O O']]; [| nia].
      assert (2 <= 2 ^ (E - F))%Z by (apply (Z.pow_le_mono_r 2 1); lia). nia.
    + apply Z.lt_le_trans with (2 ^ (prec + guard + 1))%Z; [| apply Z.pow_le_mono_r; lia].
      assert (G1 : (2 ^ (E - F) <= 2 ^ guard)%Z) by (apply Z.pow_le_mono_r; lia).
      rewrite !Z.pow_add_r by lia. unfold n. destruct (Bool.eqb s t); nia.
Qed.

(** exact::add towards +inf. *)
Definition exact_add (x y : float) : spec_float :=
  match x, y with
  | B754_nan, _ | _, B754_nan | B754_infinity _, _ | _, B754_infinity _ => B2SF (Bplus mode_NE x y)
  | B754_zero sx, B754_zero sy => if Bool.eqb sx sy then B2SF x else S754_zero false
  | B754_zero _, _ => B2SF y
  | _, B754_zero _ => B2SF x
  | B754_finite sx mx ex _, B754_finite sy my ey _ =>
      if Model.eq prec emax x (Bopp y) then S754_zero false
      else
        let (a, ea) := take_apart mx ex in
        let (b, eb) := take_apart my ey in
        if (ea <? eb)%Z || (ea =? eb)%Z && (a <? b)%Z
        then add_ordered sy b eb sx a ea else add_ordered sx a ea sy b eb
  end.

(** It is RU(x + y), bit for bit, for every x and y. *)
Theorem exact_add_correct : forall x y : float, exact_add x y = B2SF (Bplus mode_UP x y).
Proof.
  intros x y. destruct (is_finite_strict x && is_finite_strict y) eqn:Str.
  2: { destruct x as [[]|[]| |], y as [[]|[]| |]; trivial; discriminate. }
  apply andb_prop in Str as [Sx Sy].
  assert (Fx : is_finite x = true) by now destruct x.
  assert (Fy : is_finite y = true) by now destruct y.
  pose proof (plus_result _ _ mode_UP x y (or_intror eq_refl) Fx Fy) as H.
  pose proof (format_float _ _ x) as Gx. pose proof (format_float _ _ y) as Gy.
  assert (Eq : Model.eq prec emax x (Bopp y) = Req_bool (B2R x + B2R y) 0).
  { unfold Model.eq. rewrite Beqb_correct, B2R_Bopp by (trivial; now rewrite is_finite_Bopp).
    case Req_bool_spec; case Req_bool_spec; trivial; intros; lra. }
  set (w := Bplus mode_UP x y) in *. clearbody w.
  destruct x as [| | |sx mx ex Hx]; try discriminate. destruct y as [| | |sy my ey Hy]; try discriminate.
  unfold exact_add. rewrite Eq. simpl Bsign in H.
  destruct (Req_bool_spec (B2R (B754_finite sx mx ex Hx) + B2R (B754_finite sy my ey Hy)) 0) as [Z | NZ].
  - rewrite Z in H. rewrite Rcompare_Eq in H by trivial.
    destruct H as [_ H]. simpl round_mode in H. rewrite round_0, Rabs_R0, Rlt_bool_true in H by (auto; apply bpow_gt_0).
    destruct H as (Ew & Fw & Sw).
    change (S754_zero false) with (B2SF (@B754_zero prec emax false)). f_equal. symmetry.
    apply B2R_Bsign_inj; trivial. rewrite Sw. simpl.
    destruct sx, sy; trivial. exfalso.
    assert (B2R (B754_finite true mx ex Hx) < 0)%R by now apply F2R_lt_0.
    assert (B2R (B754_finite true my ey Hy) < 0)%R by now apply F2R_lt_0. lra.
  - simpl B2R in *.
    pose proof (take_apart_correct sx mx ex Hx) as Tx. pose proof (take_apart_correct sy my ey Hy) as Ty.
    destruct (take_apart mx ex) as [a ea]. destruct (take_apart my ey) as [b eb].
    destruct Tx as ([A1 A2] & Ha & Ex). destruct Ty as ([B1 B2] & Hb & Ey).
    rewrite Ex, Ey in *. symmetry.
    assert (PP : (0 < 2 ^ (prec - 1))%Z) by (apply Z.pow_pos_nonneg; lia).
    assert (P2 : (2 ^ prec = 2 * 2 ^ (prec - 1))%Z).
    { rewrite <- Z.pow_succ_r by lia. f_equal. lia. }
    (* the sign of the sum is that of the term of larger magnitude *)
    assert (Sign : forall (s t : bool) (A E B F : Z),
      (2 ^ (prec - 1) <= A < 2 ^ prec)%Z -> (2 ^ (prec - 1) <= B < 2 ^ prec)%Z ->
      (F < E \/ F = E /\ B <= A)%Z ->
      let r := (F2R (Float radix2 (cond_Zopp s A) E) + F2R (Float radix2 (cond_Zopp t B) F))%R in
      r <> 0%R -> (match Rcompare r 0 with Eq => sx && sy | Lt => true | Gt => false end) = s).
    { intros s t A E B F [A1' A2'] [B1' B2'] Order r Hr.
      assert (Le : (IZR B * bpow radix2 F <= IZR A * bpow radix2 E)%R).
      { replace (bpow radix2 E) with (bpow radix2 (E - F) * bpow radix2 F)%R
          by (rewrite <- bpow_plus; f_equal; lia).
        rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [apply bpow_ge_0 |].
        rewrite <- pow_IZR, <- mult_IZR by lia. apply IZR_le.
        destruct Order as [O | [O O']].
        - assert (2 <= 2 ^ (E - F))%Z by (apply (Z.pow_le_mono_r 2 1); lia). nia.
        - rewrite O, Z.sub_diag. simpl. lia. }
      assert (P : (0 < IZR B * bpow radix2 F)%R)
        by (apply Rmult_lt_0_compat; [apply IZR_lt; lia | apply bpow_gt_0]).
      unfold r, F2R in *. cbn [Fnum Fexp] in *.
      destruct s, t; cbn [cond_Zopp] in *; rewrite ?opp_IZR in *;
        first [rewrite Rcompare_Lt; [reflexivity | lra] | rewrite Rcompare_Gt; [reflexivity | lra]]. }
    destruct ((ea <? eb)%Z || (ea =? eb)%Z && (a <? b)%Z) eqn:Order.
    + rewrite Rplus_comm in H, NZ.
      assert (O : (ea < eb \/ ea = eb /\ a <= b)%Z).
      { apply orb_prop in Order as [O | O]; [left; now apply Z.ltb_lt |].
        apply andb_prop in O as [O1 O2]. apply Z.eqb_eq in O1. apply Z.ltb_lt in O2. lia. }
      apply add_ordered_correct; trivial; try lia.
      now rewrite (Sign sy sx b eb a ea) in H by (trivial; lia).
    + assert (O : (eb < ea \/ eb = ea /\ b <= a)%Z).
      { apply orb_false_iff in Order as [O1 O2]. apply Z.ltb_ge in O1.
        apply andb_false_iff in O2 as [O2 | O2]; [apply Z.eqb_neq in O2 | apply Z.ltb_ge in O2]; lia. }
      apply add_ordered_correct; trivial; try lia.
      now rewrite (Sign sx sy a ea b eb) in H by (trivial; lia).
Qed.

(** ** As numbers *)

(** The number that the bits say; NaN where they are none of the format's. *)
Definition of_bits (f : spec_float) : float :=
  match f with
  | S754_zero s => B754_zero s
  | S754_infinity s => B754_infinity s
  | S754_nan => B754_nan
  | S754_finite s m e =>
      match Sumbool.sumbool_of_bool (SpecFloat.bounded prec emax m e) with
      | left H => B754_finite s m e H
      | right _ => B754_nan
      end
  end.

Lemma of_bits_B2SF : forall f : float, of_bits (B2SF f) = f.
Proof.
  intros [| | |s m e H]; trivial. simpl. destruct (Sumbool.sumbool_of_bool _) as [H' | H'].
  - apply B2SF_inj. reflexivity.
  - congruence.
Qed.

Definition slow_add (x y : float) : float := of_bits (exact_add x y).
Definition slow_mul (x y : float) : float := of_bits (exact_mul x y).

Lemma slow_add_correct : forall x y, slow_add x y = Bplus mode_UP x y.
Proof. intros. unfold slow_add. now rewrite exact_add_correct, of_bits_B2SF. Qed.

Lemma slow_mul_correct : forall x y, slow_mul x y = Bmult mode_UP x y.
Proof. intros. unfold slow_mul. now rewrite exact_mul_correct, of_bits_B2SF. Qed.

End Exact.

(** Binary64, 128-bit integers, 64 guard bits: `nearest` as the code has it, without and with a fused
    multiply-add. *)
Definition nearest_as_coded : backend 53 1024 :=
  nearest_binary64 (slow_add 53 1024 128 64) (slow_mul 53 1024 128).
Definition nearest_fma_as_coded : backend 53 1024 :=
  nearest_fma_binary64 (slow_add 53 1024 128 64) (slow_mul 53 1024 128).

(** Both are the directed backend, for every input. *)
Theorem nearest_as_coded_is_directed :
  nearest_as_coded = directed 53 1024 /\ nearest_fma_as_coded = directed 53 1024.
Proof.
  apply nearest_is_directed_binary64; intros.
  - now apply slow_add_correct.
  - now apply slow_mul_correct.
Qed.

(** The test over `nearest` never misses. *)
Theorem never_miss_nearest_binary64 : forall b : backend 53 1024,
  b = nearest_as_coded \/ b = nearest_fma_as_coded ->
  forall o d lo hi : three (float 53 1024),
  finite3 _ _ o -> finite3 _ _ d -> finite3 _ _ lo -> finite3 _ _ hi ->
  (exists t, (0 <= t)%R /\ ray_in _ _ closed o d lo hi t) ->
  touches_box 53 1024 b (prepare 53 1024 b o d) lo hi = true.
Proof.
  intros b Hb. destruct nearest_as_coded_is_directed as [E1 E2].
  destruct Hb as [-> | ->]; rewrite ?E1, ?E2; exact never_miss_binary64.
Qed.

(** Every backend of the code is one function of its inputs: what is proved of the directed
    operations, monotonicity among it, holds over each. *)
Theorem backends_are_one :
  upward 53 1024 = directed 53 1024 /\ nearest_as_coded = directed 53 1024 /\
  nearest_fma_as_coded = directed 53 1024.
Proof. exact (conj upward_is_directed_binary64 nearest_as_coded_is_directed). Qed.
