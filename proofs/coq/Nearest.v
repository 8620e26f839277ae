(** The backend `nearest` (interval/include/graze/rounding/nearest.hpp) rounds as the directed ones
    do, bit for bit, for every input: rounding to nearest, then a step to the neighbour where the
    sign of the error says so.

    - [add_up_correct]: the sum, whose error is Knuth's TwoSum; an overflow anywhere reaches the
      error and is detected there;
    - [mul_up_fma_correct]: the product with a fused multiply-add, exact in sign where the product is
      not tiny;
    - [mul_up_integer_correct]: the product without one, whose error is an integer modulo 2^64;
    - [nearest_is_directed]: hence the backend, whose other operations are these by negation.

    The slow paths (exact.hpp: integer arithmetic for what those leave over) are a parameter here,
    with the hypothesis that they are correctly rounded; Exact_integer.v proves it and concludes with
    [never_miss_nearest_binary64]. The step of `up_if`, on the bits, is Flocq's [Bsucc] here; Step.v
    proves that it is. *)
From Coq Require Import ZArith Bool Reals Lra Lia SpecFloat FunctionalExtensionality.
From Flocq Require Import Core BinarySingleNaN Plus_error Mult_error Pff2Flocq.
From Graze Require Import Model Negation Bounds Never_miss.

Section Nearest.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.
Hypothesis prec_more_than_1 : (1 < prec)%Z.

Notation float := (float prec emax).
Notation fexp := (SpecFloat.fexp prec emax).
Notation emin := (3 - emax - prec)%Z.
Notation "x <? y" := (Model.lt prec emax x y).
Notation zero := (Model.zero prec emax).
Notation RN := (round radix2 fexp ZnearestE).
Notation RU := (round radix2 fexp Zceil).

Local Instance valid_fexp : Valid_exp fexp := fexp_correct prec emax Hprec.
Local Instance monotone_fexp : Monotone_exp fexp := FLT_exp_monotone emin prec.
Local Hint Resolve valid_fexp monotone_fexp valid_rnd_N valid_rnd_UP valid_rnd_DN : core.

(** ** The neighbour above *)

(** What an operation that is correctly rounded in mode m returns for the exact result r, whose sign
    is s where r is 0 or the result overflows. *)
Definition result (m : mode) (f : float) (r : R) (s : bool) : Prop :=
  (if s then r <= 0 else 0 <= r)%R /\
  if Rlt_bool (Rabs (round radix2 fexp (round_mode m) r)) (bpow radix2 emax)
  then B2R f = round radix2 fexp (round_mode m) r /\ is_finite f = true /\ Bsign f = s
  else B2SF f = binary_overflow prec emax m s.

Lemma format_float : forall f : float, generic_format radix2 fexp (B2R f).
Proof. intros f. apply generic_format_B2R. Qed.

(** Where rounding to nearest stays below r, rounding upwards gives the next number. *)
Lemma next_above : forall r, (RN r < r)%R -> RU r = succ radix2 fexp (RN r).
Proof.
  intros r H.
  assert (N : ~ generic_format radix2 fexp r).
  { intros F. rewrite round_generic in H; trivial; lra. }
  destruct (round_DN_or_UP radix2 fexp ZnearestE r) as [E | E]; rewrite E in *.
  - symmetry. apply succ_DN_eq_UP; trivial.
  - destruct (round_UP_pt radix2 fexp r) as (_ & U & _). lra.
Qed.

(** Where it does not, it is the upward one. *)
Lemma already_above : forall r, (r <= RN r)%R -> RU r = RN r.
Proof.
  intros r H.
  destruct (round_DN_or_UP radix2 fexp ZnearestE r) as [E | E]; rewrite E in *; trivial.
  assert (D : round radix2 fexp Zfloor r = r).
  { apply Rle_antisym; trivial. apply (round_DN_pt radix2 fexp r). }
  rewrite D. apply round_generic; auto. rewrite <- D.
  apply generic_format_round; auto.
Qed.

(** A finite result to nearest that is not below r is the one upwards, sign included. *)
Lemma neighbour_same : forall (z w : float) (r : R) (s : bool),
  result mode_NE z r s -> result mode_UP w r s -> is_finite z = true -> (r <= B2R z)%R -> w = z.
Proof.
  intros z w r s [_ Hz] [_ Hw] F L. revert Hz Hw. simpl round_mode.
  case Rlt_bool_spec; intros B.
  - intros (Ez & _ & Sz). rewrite Ez in L. rewrite already_above, Rlt_bool_true by trivial.
    intros (Ew & Fw & Sw). apply B2R_Bsign_inj; trivial; congruence.
  - intros Ez. destruct z; try discriminate.
Qed.

(** One that is below r and not 0 has the upward one as its successor. *)
Lemma neighbour_next : forall (z w : float) (r : R) (s : bool),
  result mode_NE z r s -> result mode_UP w r s -> is_finite z = true -> (B2R z < r)%R ->
  B2R z <> 0%R -> w = Bsucc z.
Proof.
  intros z w r s [S Hz] [_ Hw] F L Z. revert Hz Hw. simpl round_mode.
  case Rlt_bool_spec; intros B; [| intros Ez; destruct z; discriminate].
  intros (Ez & _ & Sz). rewrite next_above by now rewrite <- Ez. rewrite <- Ez.
  pose proof (Bsucc_correct _ _ _ _ z F) as Hs.
  assert (U : (B2R z < succ radix2 fexp (B2R z))%R) by now apply succ_gt_id.
  assert (Up : (- bpow radix2 emax < succ radix2 fexp (B2R z))%R)
    by (pose proof (B2R_between _ _ z); lra).
  assert (Strict : is_finite_strict z = true).
  { destruct z as [|[]| |]; trivial; try discriminate. now elim Z. }
  rewrite Strict, andb_true_r in Hs. revert Hs. case Rlt_bool_spec; intros Small.
  - intros (Es & Fs & Ss). rewrite Rlt_bool_true by now apply Rabs_lt.
    intros (Ew & Fw & Sw). apply B2R_Bsign_inj; trivial; congruence.
  - intros Es. rewrite Rlt_bool_false by (apply Rle_trans with (1 := Small); apply Rle_abs).
    intros Ew. apply B2SF_inj. rewrite Es, Ew.
    (* succ z <= 0 if z < 0 *)
    destruct s; trivial.
    assert (B2R z <= 0)%R.
    { rewrite Ez. rewrite <- (round_0 radix2 fexp ZnearestE).
      apply round_le; auto. }
    assert (succ radix2 fexp (B2R z) <= 0)%R.
    { apply succ_le_lt; auto using format_float, generic_format_0. lra. }
    pose proof (bpow_gt_0 radix2 emax). lra.
Qed.

(** The largest finite float, written as overflow towards zero yields it. *)
Lemma Bmax_is_overflow : B2SF (@Bmax_float prec emax _ _) = binary_overflow prec emax mode_DN false.
Proof.
  clear prec_more_than_1. unfold Bmax_float. rewrite B2SF_SF2B. unfold binary_overflow. cbn [overflow_to_inf]. f_equal.
  apply Pos2Z.inj.
  assert (E : Z.pos (shift_pos (Z.to_pos prec) 1) = (2 ^ prec)%Z).
  { rewrite shift_pos_correct, Z.mul_1_r. change (Z.pow_pos 2 (Z.to_pos prec)) with (2 ^ Z.pos (Z.to_pos prec))%Z.
    rewrite Z2Pos.id; trivial. }
  assert (1 < 2 ^ prec)%Z by (apply (Zpower_gt_1 radix2), (prec_gt_0 prec)).
  change (Zpower 2 prec) with (2 ^ prec)%Z.
  rewrite Pos2Z.inj_sub by lia. rewrite E, Z2Pos.id; lia.
Qed.

(** An overflow to nearest: upwards it is +inf, or the largest number of the negative ones. *)
Lemma neighbour_overflow : forall (z w : float) (r : R) (s : bool),
  result mode_NE z r s -> result mode_UP w r s -> is_finite z = false ->
  z = B754_infinity s /\ w = if s then Bsucc z else z.
Proof.
  intros z w r s [S Hz] [_ Hw] F. revert Hz Hw. simpl round_mode.
  case Rlt_bool_spec; intros B; [intros (_ & Fz & _); congruence |].
  intros Ez. assert (Z : z = B754_infinity s) by now apply B2SF_inj.
  intros Hw. split; trivial. subst z. clear Ez F.
  pose proof (bpow_gt_0 radix2 emax) as P.
  assert (M : forall x y, (x <= y)%R -> (RN x <= RN y)%R)
    by (intros; apply round_le; auto).
  assert (G : forall f : float, RN (B2R f) = B2R f)
    by (intros; apply round_generic; auto using format_float).
  destruct s.
  - assert (N : (RN r <= - bpow radix2 emax)%R).
    { assert (RN r <= 0)%R by (rewrite <- (round_0 radix2 fexp ZnearestE); now apply M).
      rewrite Rabs_left1 in B by trivial. lra. }
    pose proof Bmax_is_overflow as T. change (w = Bopp Bmax_float).
    set (top := Bmax_float) in *. clearbody top.
    assert (L : (r <= - B2R top)%R).
    { apply Rnot_lt_le. intros K. apply Rlt_le, M in K. rewrite <- B2R_Bopp, G in K.
      pose proof (B2R_between _ _ (Bopp top)). lra. }
    revert Hw. case Rlt_bool_spec; intros Small.
    + intros (Ew & Fw & Sw).
      destruct (overflow_down_largest _ _ top (Bopp w) T) as [Ft Lw]; [now rewrite is_finite_Bopp |].
      rewrite B2R_Bopp in Lw.
      assert (Uw : (B2R w <= - B2R top)%R).
      { rewrite Ew, <- B2R_Bopp.
        rewrite <- (round_generic radix2 fexp Zceil (B2R (Bopp top))) by auto using format_float.
        apply round_le; auto. now rewrite B2R_Bopp. }
      apply B2R_Bsign_inj; trivial.
      * now rewrite is_finite_Bopp.
      * rewrite B2R_Bopp. lra.
      * rewrite Sw. rewrite Bsign_Bopp by (destruct top; trivial; discriminate).
        destruct top as [| | |st mt et Ht]; try discriminate. now destruct st; inversion T.
    + intros Ew. apply Bopp_B2SF. now rewrite Ew, T.
  - assert (N : (bpow radix2 emax <= RN r)%R).
    { assert (0 <= RN r)%R by (rewrite <- (round_0 radix2 fexp ZnearestE); now apply M).
      rewrite Rabs_pos_eq in B by trivial. lra. }
    revert Hw. rewrite Rlt_bool_false.
    + intros Ew. now apply B2SF_inj.
    + apply Rle_trans with (2 := Rle_abs _). apply Rle_trans with (1 := N).
      rewrite <- (round_generic radix2 fexp ZnearestE (RU r)).
      * apply M. now apply round_UP_pt.
      * apply generic_format_round; auto.
Qed.

(** Nearest.hpp's `up_if`: the next float above, by a step of the bits. -0 and +inf are not stepped
    there; the model has NaN for them, so that no theorem rests on what the bits would give. *)
Definition up_if (inexact : bool) (x : float) : float :=
  if inexact then match x with
                  | B754_zero true | B754_infinity false => B754_nan
                  | _ => Bsucc x
                  end
  else x.

(** ** The sum *)

Definition add_up (slow : float -> float -> float) (x y : float) : float :=
  let sum := Bplus mode_NE x y in
  let y_part := Bminus mode_NE sum x in
  let error := Bplus mode_NE (Bminus mode_NE x (Bminus mode_NE sum y_part)) (Bminus mode_NE y y_part) in
  if negb (Model.eq prec emax (Bminus mode_NE error error) zero) then slow x y
  else up_if (zero <? error) sum.

(** The sum's result in either mode. *)
Lemma plus_result : forall m (x y : float), (m = mode_NE \/ m = mode_UP) ->
  is_finite x = true -> is_finite y = true ->
  result m (Bplus m x y) (B2R x + B2R y)
    match Rcompare (B2R x + B2R y) 0 with
    | Eq => Bsign x && Bsign y | Lt => true | Gt => false end.
Proof.
  intros m x y Hm Fx Fy. unfold result.
  pose proof (sign_of_value _ _ x) as Sx. pose proof (sign_of_value _ _ y) as Sy.
  generalize (Bplus_correct _ _ _ _ m x y Fx Fy).
  assert (V : Valid_rnd (round_mode m)) by apply valid_rnd_round_mode.
  destruct (Rcompare_spec (B2R x + B2R y) 0) as [C | C | C]; (split; [
    try lra; destruct (Bsign x && Bsign y); lra |]); revert H; case Rlt_bool_spec; intros B.
  - tauto.
  - intros [E S]. rewrite E. f_equal. rewrite <- S in Sy. destruct (Bsign x); trivial. lra.
  - intros (E & F & S). repeat split; trivial. rewrite S. now destruct Hm; subst m.
  - exfalso. rewrite C, round_0, Rabs_R0 in B by trivial. pose proof (bpow_gt_0 radix2 emax). lra.
  - tauto.
  - intros [E S]. rewrite E. f_equal. rewrite <- S in Sy. destruct (Bsign x); trivial. lra.
Qed.

(** A finite sum to nearest has finite terms and is what it should be. *)
Lemma plus_finite : forall x y : float, is_finite (Bplus mode_NE x y) = true ->
  is_finite x = true /\ is_finite y = true /\ B2R (Bplus mode_NE x y) = RN (B2R x + B2R y).
Proof.
  intros x y F.
  assert (Fx : is_finite x = true) by (destruct x as [|[]| |], y as [|[]| |]; trivial; discriminate).
  assert (Fy : is_finite y = true) by (destruct x as [|[]| |], y as [|[]| |]; trivial; discriminate).
  repeat split; trivial. generalize (Bplus_correct _ _ _ _ mode_NE x y Fx Fy). simpl round_mode.
  case Rlt_bool; [tauto |]. intros [E _]. destruct (Bplus mode_NE x y); discriminate.
Qed.

(** The same of a difference. *)
Lemma minus_finite : forall x y : float, is_finite (Bminus mode_NE x y) = true ->
  is_finite x = true /\ is_finite y = true /\ B2R (Bminus mode_NE x y) = RN (B2R x - B2R y).
Proof.
  intros x y F.
  assert (Fx : is_finite x = true) by (destruct x as [|[]| |], y as [|[]| |]; trivial; discriminate).
  assert (Fy : is_finite y = true) by (destruct x as [|[]| |], y as [|[]| |]; trivial; discriminate).
  repeat split; trivial. generalize (Bminus_correct _ _ _ _ mode_NE x y Fx Fy). simpl round_mode.
  case Rlt_bool; [tauto |]. intros [E _]. destruct (Bminus mode_NE x y); discriminate.
Qed.

(** TwoSum: if the error is finite, nothing overflowed, and sum + error = x + y. *)
Lemma two_sum : forall x y : float,
  let sum := Bplus mode_NE x y in
  let y_part := Bminus mode_NE sum x in
  let error := Bplus mode_NE (Bminus mode_NE x (Bminus mode_NE sum y_part)) (Bminus mode_NE y y_part) in
  is_finite error = true ->
  is_finite x = true /\ is_finite y = true /\ is_finite sum = true /\
  (B2R sum + B2R error = B2R x + B2R y)%R.
Proof.
  intros x y sum y_part error F.
  destruct (plus_finite _ _ F) as (F1 & F2 & E). fold error in E.
  destruct (minus_finite _ _ F1) as (Fx & F3 & E1).
  destruct (minus_finite _ _ F3) as (Fs & Fyp & E3).
  destruct (minus_finite _ _ Fyp) as (_ & _ & E4). fold y_part in E4.
  destruct (minus_finite _ _ F2) as (Fy & _ & E2).
  destruct (plus_finite _ _ Fs) as (_ & _ & E5). fold sum in E5.
  repeat split; trivial. rewrite E, E1, E2, E3, E4, E5.
  pose proof (prec_lt_emax prec emax) as Hlt.
  apply (TwoSum_correct emin prec (fun n => negb (Z.even n))); trivial; try apply format_float.
  - lia.
  - intros n. rewrite negb_involutive, Z.even_opp, Z.even_add. now destruct (Z.even n).
Qed.

(** error - error is 0 exactly if error is finite. *)
Lemma finite_test : forall e : float,
  Model.eq prec emax (Bminus mode_NE e e) zero = is_finite e.
Proof.
  intros e. destruct (is_finite e) eqn:F; [| now destruct e as [|[]| |]].
  pose proof (Bminus_correct _ _ _ _ mode_NE e e F F) as H. revert H.
  rewrite Rminus_diag_eq, round_0, Rabs_R0, Rlt_bool_true by (trivial || apply bpow_gt_0 || apply valid_rnd_N).
  intros (E & Fe & _). unfold Model.eq. rewrite Beqb_correct, E by trivial. now apply Req_bool_true.
Qed.

(** `add_up` is RU(x + y), bit for bit, for every x and y. *)
Theorem add_up_correct : forall slow : float -> float -> float,
  (forall x y, slow x y = Bplus mode_UP x y) -> forall x y, add_up slow x y = Bplus mode_UP x y.
Proof.
  intros slow Hslow x y. unfold add_up. rewrite finite_test.
  set (sum := Bplus mode_NE x y). set (y_part := Bminus mode_NE sum x). set (error := Bplus mode_NE _ _).
  destruct (is_finite error) eqn:F; simpl; [| apply Hslow].
  destruct (two_sum x y F) as (Fx & Fy & Fs & E). fold sum y_part in E. fold error in E. fold sum in Fs.
  pose proof (plus_result mode_NE x y (or_introl eq_refl) Fx Fy) as HN. fold sum in HN.
  pose proof (plus_result mode_UP x y (or_intror eq_refl) Fx Fy) as HU.
  destruct (zero <? error) eqn:L; simpl; symmetry.
  - apply lt_finite in L; trivial. simpl in L.
    assert (Z : B2R sum <> 0%R).
    { destruct (plus_finite x y Fs) as (_ & _ & Es). fold sum in Es. rewrite Es.
      apply round_plus_neq_0; auto using format_float, monotone_exp_not_FTZ.
      intros K. rewrite K in E.
      assert (B2R sum = 0)%R by (rewrite Es, K; apply round_0; auto). lra. }
    replace (match sum with B754_zero true | B754_infinity false => B754_nan | _ => Bsucc sum end) with (Bsucc sum).
    + apply (neighbour_next sum _ _ _ HN HU Fs); trivial. lra.
    + destruct sum as [[]|[]| |]; trivial; try discriminate. now elim Z.
  - apply (neighbour_same sum _ _ _ HN HU Fs).
    assert (~ (0 < B2R error)%R).
    { intros K. assert (zero <? error = true) by now apply lt_finite. congruence. }
    lra.
Qed.

(** ** The product *)

(** The product's result in any mode, for factors that are finite and not 0. *)
Lemma mult_result : forall m (x y : float), is_finite_strict x = true -> is_finite_strict y = true ->
  result m (Bmult m x y) (B2R x * B2R y) (xorb (Bsign x) (Bsign y)).
Proof.
  intros m x y Fx Fy. unfold result.
  pose proof (sign_of_value _ _ x) as Sx. pose proof (sign_of_value _ _ y) as Sy.
  split.
  - destruct (Bsign x), (Bsign y); simpl; nra.
  - generalize (Bmult_correct _ _ _ _ m x y). case Rlt_bool; trivial.
    intros (E & F & S).
    assert (G : is_finite (Bmult m x y) = true) by (rewrite F; now destruct x, y).
    repeat split; trivial. apply S. now destruct (Bmult m x y).
Qed.

(** A product with a zero, an infinity or NaN does not depend on the mode. *)
Lemma mult_special : forall m m' (x y : float),
  is_finite_strict x && is_finite_strict y = false -> Bmult m x y = Bmult m' x y.
Proof. intros m m' [|[]| |] [|[]| |]; trivial; discriminate. Qed.

(** What the fused x y + z to nearest tells of the exact one's sign. *)
Lemma fma_sign : forall x y z : float,
  is_finite x = true -> is_finite y = true -> is_finite z = true ->
  let exact := (B2R x * B2R y + B2R z)%R in
  let e := Bfma mode_NE x y z in
  (zero <? e = true -> (0 < exact)%R /\ RN exact <> 0%R) /\
  (zero <? e = false -> (exact <= 0)%R \/ (Model.eq prec emax e zero = true /\ RN exact = 0%R)).
Proof.
  intros x y z Fx Fy Fz exact e.
  assert (M : forall r r', (r <= r')%R -> (RN r <= RN r')%R) by (intros; apply round_le; auto).
  assert (N0 : RN 0 = 0%R) by (apply round_0; auto).
  generalize (Bfma_correct _ _ _ _ mode_NE x y z Fx Fy Fz). cbv zeta. fold exact e. simpl round_mode.
  case Rlt_bool_spec; intros B.
  - intros (E & F & _).
    assert (L : (zero <? e) = Rlt_bool 0 (B2R e)) by now apply Bltb_correct.
    assert (Q : Model.eq prec emax e zero = Req_bool (B2R e) 0) by now apply Beqb_correct.
    rewrite L, Q, E. split.
    + case Rlt_bool_spec; try discriminate. intros P _. split; [| lra].
      apply Rnot_le_lt. intros K. apply M in K. lra.
    + case Rlt_bool_spec; try discriminate. intros P _.
      destruct (Rle_or_lt exact 0) as [K | K]; [now left | right].
      assert (Z : RN exact = 0%R) by (apply Rlt_le, M in K; lra).
      now rewrite Z, Req_bool_true.
  - intros E. pose proof (bpow_gt_0 radix2 emax) as P.
    assert (Z : RN exact <> 0%R) by (intros Z; rewrite Z, Rabs_R0 in B; lra).
    assert (Ee : e = B754_infinity (Rlt_bool exact 0)) by now apply B2SF_inj.
    rewrite Ee. case Rlt_bool_spec; intros K; split; intros C; try discriminate.
    + left. lra.
    + split; trivial. destruct K as [K | K]; trivial. rewrite <- K in Z. contradiction.
Qed.

(** Below this product the error may be lost: 2^-968 for double. *)
Definition is_threshold (t : float) : Prop :=
  is_finite t = true /\ B2R t = bpow radix2 (emin + 2 * prec).

Definition mul_up_fma (threshold : float) (slow : float -> float -> float) (x y : float) : float :=
  let product := Bmult mode_NE x y in
  let error := Bfma mode_NE x y (Bopp product) in
  if Model.eq prec emax error zero && (Babs product <? threshold) then slow x y
  else up_if (zero <? error) product.

(** Where the product is not tiny, its error is a number of the format. *)
Lemma product_error_format : forall x y : float,
  (bpow radix2 (emin + 2 * prec) <= Rabs (RN (B2R x * B2R y)))%R ->
  generic_format radix2 fexp (RN (B2R x * B2R y) - B2R x * B2R y).
Proof.
  intros x y H. apply (mult_error_FLT radix2 emin prec ZnearestE); try apply format_float.
  intros _. apply Rnot_lt_le. intros K.
  assert (RN' : (Rabs (RN (B2R x * B2R y)) <= bpow radix2 (emin + 2 * prec - 1))%R).
  { apply abs_round_le_generic; auto.
    - apply generic_format_bpow. unfold SpecFloat.fexp, SpecFloat.emin.
      pose proof (prec_gt_0 prec). lia.
    - now apply Rlt_le. }
  assert (bpow radix2 (emin + 2 * prec - 1) < bpow radix2 (emin + 2 * prec))%R by (apply bpow_lt; lia).
  lra.
Qed.

(** `mul_up` with a fused multiply-add is RU(x y), bit for bit, for every x and y. *)
Theorem mul_up_fma_correct : forall (threshold : float) (slow : float -> float -> float),
  is_threshold threshold ->
  (forall x y, slow x y = Bmult mode_UP x y) ->
  forall x y, mul_up_fma threshold slow x y = Bmult mode_UP x y.
Proof.
  intros t slow [Ft Et] Hslow x y. unfold mul_up_fma.
  assert (T0 : forall s, Babs (B754_zero s) <? t = true).
  { intros s. apply lt_finite; trivial. simpl. rewrite Et. apply bpow_gt_0. }
  destruct (is_finite_strict x && is_finite_strict y) eqn:F.
  2: { rewrite (mult_special mode_UP mode_NE x y F).
       destruct x as [sx|sx| |sx mx ex Hx], y as [sy|sy| |sy my ey Hy]; try discriminate F;
         cbn -[Babs]; rewrite ?T0; simpl; rewrite ?Hslow; trivial;
         destruct sx, sy; trivial. }
  apply andb_prop in F as [Fx Fy].
  pose proof (mult_result mode_NE x y Fx Fy) as HN. pose proof (mult_result mode_UP x y Fx Fy) as HU.
  set (product := Bmult mode_NE x y) in *. set (error := Bfma mode_NE x y (Bopp product)).
  destruct (is_finite product) eqn:Fp.
  - assert (Gx : is_finite x = true) by now destruct x.
    assert (Gy : is_finite y = true) by now destruct y.
    assert (Gp : is_finite (Bopp product) = true) by now rewrite is_finite_Bopp.
    assert (Ep : B2R product = RN (B2R x * B2R y)).
    { destruct HN as [_ HN]. revert HN. simpl round_mode. case Rlt_bool; [tauto |].
      intros E. destruct product; discriminate. }
    destruct (fma_sign x y (Bopp product) Gx Gy Gp) as [Pos Neg]. fold error in Pos, Neg.
    rewrite B2R_Bopp in Pos, Neg.
    destruct (zero <? error) eqn:L.
    + destruct (Pos eq_refl) as [P NZ].
      assert (Z : B2R product <> 0%R).
      { intros Z. rewrite Z, Ropp_0, Rplus_0_r, <- Ep in NZ. contradiction. }
      assert (Ne : Model.eq prec emax error zero = false) by now destruct error as [|[]| |[]].
      rewrite Ne. simpl.
      replace (match product with B754_zero true | B754_infinity false => B754_nan | _ => Bsucc product end)
        with (Bsucc product).
      * symmetry. apply (neighbour_next product _ _ _ HN HU Fp); trivial. lra.
      * destruct product as [[]|[]| |]; trivial; try discriminate. now elim Z.
    + destruct (Neg eq_refl) as [P | [Eq Z]].
      * destruct (_ && _); [apply Hslow |].
        symmetry. apply (neighbour_same product _ _ _ HN HU Fp). lra.
      * rewrite Eq. destruct (Babs product <? t) eqn:Tiny; simpl; [apply Hslow |].
        symmetry. apply (neighbour_same product _ _ _ HN HU Fp).
        assert (Big : (bpow radix2 (emin + 2 * prec) <= Rabs (B2R product))%R).
        { rewrite <- Et, <- B2R_Babs. apply Rnot_lt_le. intros K.
          assert (Babs product <? t = true).
          { apply lt_finite; trivial. now rewrite is_finite_Babs. }
          congruence. }
        rewrite Ep in Big. apply product_error_format in Big.
        rewrite round_generic in Z; auto; [lra |].
        rewrite Ep. replace (B2R x * B2R y + - RN (B2R x * B2R y))%R
          with (- (RN (B2R x * B2R y) - B2R x * B2R y))%R by ring.
        now apply generic_format_opp.
  - destruct (neighbour_overflow product _ _ _ HN HU Fp) as [Ep Ew].
    set (s := xorb (Bsign x) (Bsign y)) in *.
    assert (Ee : error = B754_infinity (negb s)).
    { unfold error. rewrite Ep. destruct x, y; try discriminate. reflexivity. }
    rewrite Ee, Ew, Ep. now destruct s.
Qed.

(** The width of the integers: 64. *)
Variable word : Z.
Hypothesis word_enough : (prec + 1 < word)%Z.

(** A number modulo 2^word, as a signed integer. *)
Definition wrap (n : Z) : Z := ((n + 2 ^ (word - 1)) mod 2 ^ word - 2 ^ (word - 1))%Z.

Lemma wrap_small : forall n, (- 2 ^ (word - 1) <= n < 2 ^ (word - 1))%Z -> wrap n = n.
Proof.
  intros n H. unfold wrap. pose proof (prec_gt_0 prec).
  assert (E : (2 ^ word = 2 * 2 ^ (word - 1))%Z).
  { rewrite <- Z.pow_succ_r by lia. f_equal. lia. }
  rewrite Z.mod_small; lia.
Qed.

(** A significand with the hidden bit. *)
Definition normal (m : positive) : bool := (2 ^ (prec - 1) <=? Z.pos m)%Z.

Definition mul_up_integer (slow : float -> float -> float) (x y : float) : float :=
  let product := Bmult mode_NE x y in
  match x, y, product with
  | B754_finite _ ma ea _, B754_finite _ mb eb _, B754_finite negative mp ep _ =>
      if normal ma && normal mb && normal mp then
        let shift := (ep - ea - eb)%Z in
        let error := wrap (Z.pos ma * Z.pos mb - Z.shiftl (Z.pos mp) shift) in
        up_if (0 <? (if negative then - error else error))%Z product
      else slow x y
  | _, _, _ => slow x y
  end.

(** The bounds of a significand. *)
Lemma significand_below : forall m e, SpecFloat.bounded prec emax m e = true -> (Z.pos m < 2 ^ prec)%Z.
Proof.
  intros m e H. pose proof (canonical_bounded prec emax false m e H) as C.
  unfold SpecFloat.bounded in H. apply andb_prop in H as [H _].
  unfold SpecFloat.canonical_mantissa in H. apply Zeq_bool_eq in H.
  rewrite Zpos_digits2_pos in H. unfold SpecFloat.fexp in H.
  apply (Zpower_gt_Zdigits radix2 prec (Z.pos m)). lia.
Qed.

(** The error of a normal product in units of the last bit of the exact one, and the shift that
    gets there: what the machine's integers hold. *)
Lemma integer_error : forall (ma mb mp : positive) (ea eb ep : Z),
  (2 ^ (prec - 1) <= Z.pos ma < 2 ^ prec)%Z -> (2 ^ (prec - 1) <= Z.pos mb < 2 ^ prec)%Z ->
  (2 ^ (prec - 1) <= Z.pos mp < 2 ^ prec)%Z ->
  (Rabs (IZR (Z.pos mp) * bpow radix2 ep - IZR (Z.pos ma * Z.pos mb) * bpow radix2 (ea + eb))
    <= / 2 * bpow radix2 ep)%R ->
  (0 <= ep - ea - eb < word)%Z /\
  (Z.abs (Z.pos ma * Z.pos mb - Z.shiftl (Z.pos mp) (ep - ea - eb)) <= 2 ^ prec)%Z.
Proof.
  intros ma mb mp ea eb ep [A1 A2] [B1 B2] [P1 P2] H.
  set (shift := (ep - ea - eb)%Z).
  assert (Scale : bpow radix2 ep = (bpow radix2 shift * bpow radix2 (ea + eb))%R).
  { rewrite <- bpow_plus. f_equal. unfold shift. lia. }
  pose proof (bpow_gt_0 radix2 (ea + eb)) as U0.
  rewrite Scale in H.
  replace (IZR (Z.pos mp) * (bpow radix2 shift * bpow radix2 (ea + eb)) -
           IZR (Z.pos ma * Z.pos mb) * bpow radix2 (ea + eb))%R
    with ((IZR (Z.pos mp) * bpow radix2 shift - IZR (Z.pos ma * Z.pos mb)) * bpow radix2 (ea + eb))%R
    in H by ring.
  rewrite Rabs_mult, (Rabs_pos_eq (bpow _ _)), <- Rmult_assoc in H by now apply Rlt_le.
  apply Rmult_le_reg_r in H; trivial. apply Rabs_le_inv in H.
  assert (Pw : forall n, (0 <= n)%Z -> IZR (2 ^ n) = bpow radix2 n)
    by (intros; now apply (IZR_Zpower radix2)).
  assert (Prod : (2 ^ (2 * prec - 2) <= Z.pos ma * Z.pos mb < 2 ^ (2 * prec))%Z).
  { replace (2 * prec - 2)%Z with ((prec - 1) + (prec - 1))%Z by lia.
    replace (2 * prec)%Z with (prec + prec)%Z by lia.
    rewrite !Z.pow_add_r by lia.
    pose proof (Z.pow_pos_nonneg 2 (prec - 1)). nia. }
  destruct Prod as [M1 M2]. apply IZR_le in M1, P1. apply IZR_lt in M2, P2.
  rewrite Pw in M1, M2, P1, P2 by lia.
  pose proof (bpow_gt_0 radix2 shift) as S0.
  (* shift >= prec - 2 *)
  assert (L : (prec - 2 <= shift)%Z).
  { apply Znot_gt_le. intros K.
    assert (K1 : (bpow radix2 shift <= bpow radix2 (prec - 3))%R) by (apply bpow_le; lia).
    assert (K2 : (bpow radix2 (2 * prec - 2) = 2 * (bpow radix2 prec * bpow radix2 (prec - 3)))%R).
    { rewrite <- bpow_plus. change 2%R with (bpow radix2 1). rewrite <- bpow_plus. f_equal. lia. }
    assert (K3 : (1 <= bpow radix2 prec)%R) by (apply (bpow_le radix2 0); lia).
    nra. }
  (* shift <= prec + 1 *)
  assert (G : (shift <= prec + 1)%Z).
  { apply Znot_gt_le. intros K.
    assert (K1 : (bpow radix2 (prec + 2) <= bpow radix2 shift)%R) by (apply bpow_le; lia).
    assert (K2 : (bpow radix2 (2 * prec) = / 2 * (bpow radix2 (prec - 1) * bpow radix2 (prec + 2)))%R).
    { change (/ 2)%R with (bpow radix2 (-1)). rewrite <- !bpow_plus. f_equal. lia. }
    assert (K3 : (1 <= bpow radix2 (prec - 1))%R) by (apply (bpow_le radix2 0); lia).
    nra. }
  split; [lia |].
  rewrite Z.shiftl_mul_pow2 by lia.
  apply le_IZR. rewrite abs_IZR, minus_IZR, (mult_IZR _ (2 ^ shift)), !Pw by lia.
  assert (K1 : (/ 2 * bpow radix2 shift <= bpow radix2 prec)%R).
  { change (/ 2)%R with (bpow radix2 (-1)). rewrite <- bpow_plus. apply bpow_le. lia. }
  apply Rabs_le. lra.
Qed.

(** `mul_up` without a fused multiply-add is RU(x y), bit for bit, for every x and y; its shifts are
    defined (0 <= shift < word). *)
Theorem mul_up_integer_correct : forall (slow : float -> float -> float),
  (forall x y, slow x y = Bmult mode_UP x y) ->
  forall x y, mul_up_integer slow x y = Bmult mode_UP x y.
Proof.
  intros slow Hslow x y. unfold mul_up_integer.
  destruct x as [sx|sx| |sx ma ea Ha]; try apply Hslow.
  destruct y as [sy|sy| |sy mb eb Hb]; try apply Hslow.
  set (x := B754_finite sx ma ea Ha). set (y := B754_finite sy mb eb Hb).
  destruct (Bmult mode_NE x y) as [s|s| |s mp ep Hp] eqn:Ep; try apply Hslow.
  destruct (normal ma && normal mb && normal mp) eqn:N; [| apply Hslow].
  apply andb_prop in N as [N Np]. apply andb_prop in N as [Na Nb].
  apply Zle_bool_imp_le in Na, Nb, Np.
  pose proof (mult_result mode_NE x y eq_refl eq_refl) as HN.
  pose proof (mult_result mode_UP x y eq_refl eq_refl) as HU.
  rewrite Ep in HN. set (product := B754_finite s mp ep Hp) in *.
  assert (P : B2R product = RN (B2R x * B2R y) /\ s = xorb sx sy).
  { destruct HN as [_ HN]. revert HN. simpl round_mode. case Rlt_bool; [simpl; tauto |].
    intros E. unfold product in E. simpl in E. discriminate. }
  destruct P as [Er Es].
  (* both sides as multiples of the signs *)
  set (sign := if s then (-1)%R else 1%R).
  assert (Vp : B2R product = (sign * (IZR (Z.pos mp) * bpow radix2 ep))%R).
  { unfold product, sign, B2R, F2R. simpl. destruct s; simpl;
      rewrite ?(opp_IZR (Z.pos mp)); change (Z.neg mp) with (- Z.pos mp)%Z; rewrite ?opp_IZR; ring. }
  assert (Vr : (B2R x * B2R y = sign * (IZR (Z.pos ma * Z.pos mb) * bpow radix2 (ea + eb)))%R).
  { unfold x, y, sign, B2R, F2R. rewrite Es, mult_IZR, bpow_plus.
    destruct sx, sy; simpl; change (Z.neg ma) with (- Z.pos ma)%Z;
      change (Z.neg mb) with (- Z.pos mb)%Z; rewrite ?opp_IZR; ring. }
  assert (Half : (Rabs (B2R product - B2R x * B2R y) <= / 2 * bpow radix2 ep)%R).
  { rewrite Er. eapply Rle_trans; [apply error_le_half_ulp_round; auto |].
    rewrite <- Er. apply Rmult_le_compat_l; [lra |]. apply Req_le.
    apply ulp_canonical.
    - now destruct s.
    - now apply canonical_bounded. }
  assert (Half' : (Rabs (IZR (Z.pos mp) * bpow radix2 ep -
      IZR (Z.pos ma * Z.pos mb) * bpow radix2 (ea + eb)) <= / 2 * bpow radix2 ep)%R).
  { rewrite Vp, Vr, <- Rmult_minus_distr_l, Rabs_mult in Half.
    replace (Rabs sign) with 1%R in Half; [lra |].
    unfold sign. destruct s; [rewrite Rabs_left; lra | rewrite Rabs_pos_eq; lra]. }
  destruct (integer_error ma mb mp ea eb ep) as [Shift Small]; trivial;
    try (split; trivial; eapply significand_below; eassumption).
  set (E := (Z.pos ma * Z.pos mb - Z.shiftl (Z.pos mp) (ep - ea - eb))%Z) in *.
  rewrite wrap_small.
  2: { assert (2 ^ prec < 2 ^ (word - 1))%Z by (apply Z.pow_lt_mono_r; lia). lia. }
  assert (Diff : (B2R x * B2R y - B2R product = sign * (IZR E * bpow radix2 (ea + eb)))%R).
  { rewrite Vp, Vr. unfold E. rewrite Z.shiftl_mul_pow2 by lia.
    rewrite minus_IZR, (mult_IZR _ (2 ^ _)).
    change (2 ^ (ep - ea - eb))%Z with (radix2 ^ (ep - ea - eb))%Z.
    rewrite (IZR_Zpower radix2) by lia.
    replace (bpow radix2 ep) with (bpow radix2 (ep - ea - eb) * bpow radix2 (ea + eb))%R; [ring |].
    rewrite <- bpow_plus. f_equal. lia. }
  pose proof (bpow_gt_0 radix2 (ea + eb)) as U0.
  destruct (0 <? (if s then - E else E))%Z eqn:L; cbn [up_if]; symmetry.
  - apply Z.ltb_lt, IZR_lt in L.
    replace (match product with B754_zero true | B754_infinity false => B754_nan | _ => Bsucc product end)
      with (Bsucc product) by trivial.
    apply (neighbour_next product _ _ _ HN HU eq_refl).
    + unfold sign in Diff. destruct s; rewrite ?opp_IZR in L; nra.
    + rewrite Vp. unfold sign. pose proof (bpow_gt_0 radix2 ep).
      assert (0 < IZR (Z.pos mp))%R by now apply IZR_lt. destruct s; nra.
  - apply Z.ltb_ge, IZR_le in L.
    apply (neighbour_same product _ _ _ HN HU eq_refl).
    unfold sign in Diff. destruct s; rewrite ?opp_IZR in L; nra.
Qed.

(** ** The backend *)

(** x - y is x + (-y), bit for bit. *)
Lemma minus_is_plus : forall m (x y : float), Bplus m x (Bopp y) = Bminus m x y.
Proof. intros m [sx|sx| |sx mx ex Hx] [sy|sy| |sy my ey Hy]; trivial. Qed.

(** The sum does not mind the order of its terms. *)
Lemma plus_commutes : forall m (x y : float), Bplus m x y = Bplus m y x.
Proof.
  intros m [[]|[]| |sx mx ex Hx] [[]|[]| |sy my ey Hy]; trivial.
  simpl. unfold Fplus_naive. now rewrite Z.min_comm, Z.add_comm.
Qed.

(** Subtraction and the lower bounds by negation, as nearest.hpp has them. *)
Definition nearest (add_up mul_up : float -> float -> float) : backend prec emax := {|
  sub_down := fun x y => Bopp (add_up (Bopp x) y);
  sub_up := fun x y => add_up x (Bopp y);
  mul_down := fun x y => Bopp (mul_up (Bopp x) y);
  mul_up := mul_up |}.

(** Over a sum and a product rounded upwards it is the directed backend. *)
Theorem nearest_is_directed : forall add_up mul_up : float -> float -> float,
  (forall x y, add_up x y = Bplus mode_UP x y) -> (forall x y, mul_up x y = Bmult mode_UP x y) ->
  nearest add_up mul_up = directed prec emax.
Proof.
  intros a m Ha Hm. unfold nearest, directed.
  f_equal; do 2 (apply functional_extensionality; intro); rewrite ?Ha, ?Hm; trivial.
  - now rewrite sub_down_by_negation, plus_commutes, minus_is_plus.
  - apply minus_is_plus.
  - symmetry. apply mul_down_by_negation.
Qed.

End Nearest.

(** Binary64. 2^-968, the product below which the fused error may be lost. *)
Definition threshold_binary64 : float 53 1024 :=
  @B754_finite 53 1024 false 4503599627370496 (-1020) eq_refl.

Lemma threshold_binary64_exact : is_threshold 53 1024 threshold_binary64.
Proof.
  split; trivial. change (B2R threshold_binary64) with (F2R (Float radix2 (Zpower radix2 52) (-1020))).
  unfold F2R. cbn [Fnum Fexp]. rewrite IZR_Zpower, <- bpow_plus by discriminate. reflexivity.
Qed.

(** `nearest` as nearest.hpp has it without and with a fused multiply-add, over slow paths. *)
Definition nearest_binary64 (slow_add slow_mul : float 53 1024 -> float 53 1024 -> float 53 1024) :=
  nearest 53 1024 (add_up 53 1024 slow_add) (mul_up_integer 53 1024 64 slow_mul).
Definition nearest_fma_binary64 (slow_add slow_mul : float 53 1024 -> float 53 1024 -> float 53 1024) :=
  nearest 53 1024 (add_up 53 1024 slow_add) (mul_up_fma 53 1024 threshold_binary64 slow_mul).

(** Both are the directed operations if the slow paths are. *)
Theorem nearest_is_directed_binary64 : forall slow_add slow_mul,
  (forall x y, slow_add x y = Bplus mode_UP x y) -> (forall x y, slow_mul x y = Bmult mode_UP x y) ->
  nearest_binary64 slow_add slow_mul = directed 53 1024 /\
  nearest_fma_binary64 slow_add slow_mul = directed 53 1024.
Proof.
  intros a m Ha Hm. split; apply nearest_is_directed; intros.
  - now apply add_up_correct.
  - now apply mul_up_integer_correct.
  - now apply add_up_correct.
  - now apply mul_up_fma_correct; [| exact threshold_binary64_exact |].
Qed.
