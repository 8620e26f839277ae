(** The backend `nearest` (interval/include/graze/rounding/nearest.hpp) rounds as the directed ones
    do, bit for bit, for every input: rounding to nearest, then a step to the neighbour where the
    sign of the error says so.

    - [add_up_correct]: the sum, whose error is Knuth's TwoSum; an overflow anywhere reaches the
      error and is detected there;
    - [mul_up_fma_correct]: the product with a fused multiply-add, exact in sign where the product is
      not tiny;
    - [mul_up_integer_correct]: the product without one, whose error is an integer modulo 2^64;
    - [nearest_is_directed], [never_miss_nearest_binary64]: hence the test over it never misses.

    The slow paths (exact.hpp: integer arithmetic for what those leave over) are a parameter here,
    with the hypothesis that they are correctly rounded, which Exact_slow.v discharges if present and
    the test interval.backends compares with MPFR. *)
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
  unfold Bmax_float. rewrite B2SF_SF2B. unfold binary_overflow. cbn [overflow_to_inf]. f_equal.
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

End Nearest.
