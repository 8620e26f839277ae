(** What a float says about a real: it is below it, or above it, with the infinities as IEEE 754
    orders them and NaN saying nothing. And what directed rounding is in these words: RD(x - y) and
    RD(x y) are the greatest floats below the exact results, overflow and underflow included.

    Used by Never_miss.v and Monotone.v. *)
From Coq Require Import ZArith Bool Reals Lra Lia SpecFloat.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model Negation.

Section Bounds.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.

Notation float := (float prec emax).
Notation fexp := (SpecFloat.fexp prec emax).
Notation "x <=? y" := (Model.le prec emax x y).
Notation "x <? y" := (Model.lt prec emax x y).
Notation zero := (zero prec emax).

(** f is a lower bound of r that says something: not NaN, not +inf. *)
Definition below (f : float) (r : R) : Prop :=
  match f with
  | B754_nan => False
  | B754_infinity s => s = true
  | _ => (B2R f <= r)%R
  end.

(** f is an upper bound of r: not NaN, not -inf. *)
Definition above (f : float) (r : R) : Prop :=
  match f with
  | B754_nan => False
  | B754_infinity s => s = false
  | _ => (r <= B2R f)%R
  end.

(** A float among the reals, an infinity as 2^emax, which is beyond every finite one. *)
Definition extended (f : float) : R :=
  match f with
  | B754_infinity true => - bpow radix2 emax
  | B754_infinity false => bpow radix2 emax
  | _ => B2R f
  end.

(** Every finite float is between the infinities. *)
Lemma B2R_between : forall f : float, (- bpow radix2 emax < B2R f < bpow radix2 emax)%R.
Proof. intros f. apply Rabs_lt_inv, abs_B2R_lt_emax. Qed.

(** IEEE 754's < is that of the reals, unless a NaN is involved. *)
Lemma lt_extended : forall f g : float, is_nan f = false -> is_nan g = false ->
  (f <? g) = Rlt_bool (extended f) (extended g).
Proof.
  intros f g Nf Ng. pose proof (B2R_between f) as Hf. pose proof (B2R_between g) as Hg.
  pose proof (bpow_gt_0 radix2 emax) as H0.
  destruct (is_finite f && is_finite g) eqn:F.
  - apply andb_prop in F as [Ff Fg]. unfold Model.lt. rewrite Bltb_correct by trivial.
    now destruct f, g.
  - destruct f as [sf|[]| |[] mf ef Bf], g as [sg|[]| |[] mg eg Bg]; try discriminate;
      cbn -[B2R bpow];
      symmetry; (apply Rlt_bool_true || apply Rlt_bool_false); lra.
Qed.

(** The same for <=. *)
Lemma le_extended : forall f g : float, is_nan f = false -> is_nan g = false ->
  (f <=? g) = Rle_bool (extended f) (extended g).
Proof.
  intros f g Nf Ng. pose proof (B2R_between f) as Hf. pose proof (B2R_between g) as Hg.
  pose proof (bpow_gt_0 radix2 emax) as H0.
  destruct (is_finite f && is_finite g) eqn:F.
  - apply andb_prop in F as [Ff Fg]. unfold Model.le. rewrite Bleb_correct by trivial.
    now destruct f, g.
  - destruct f as [sf|[]| |[] mf ef Bf], g as [sg|[]| |[] mg eg Bg]; try discriminate;
      cbn -[B2R bpow];
      symmetry; (apply Rle_bool_true || apply Rle_bool_false); lra.
Qed.

(** f <= g says that neither is NaN. *)
Lemma le_not_nan : forall f g : float, f <=? g = true -> is_nan f = false /\ is_nan g = false.
Proof. now intros [sf|[]| |[] mf ef Bf] [sg|[]| |[] mg eg Bg]. Qed.

(** f <= g in the reals' words. *)
Lemma le_iff : forall f g : float, f <=? g = true <->
  is_nan f = false /\ is_nan g = false /\ (extended f <= extended g)%R.
Proof.
  intros f g. split.
  - intros H. destruct (le_not_nan f g H) as [Nf Ng]. repeat split; trivial.
    rewrite le_extended in H by trivial. revert H. now case Rle_bool_spec.
  - intros (Nf & Ng & H). rewrite le_extended by trivial. now apply Rle_bool_true.
Qed.

Lemma le_trans : forall f g h : float, f <=? g = true -> g <=? h = true -> f <=? h = true.
Proof.
  intros f g h. rewrite !le_iff. intros (Nf & Ng & H) (_ & Nh & H'). repeat split; trivial. lra.
Qed.

Lemma le_refl : forall f : float, is_nan f = false -> f <=? f = true.
Proof. intros f N. apply le_iff. repeat split; trivial. lra. Qed.

(** Where there is no NaN, not < is >=. *)
Lemma lt_negb_le : forall f g : float, is_nan f = false -> is_nan g = false ->
  (f <? g) = negb (g <=? f).
Proof.
  intros f g Nf Ng. rewrite lt_extended, le_extended by trivial.
  case Rlt_bool_spec; case Rle_bool_spec; trivial; intros; lra.
Qed.

(** f <= g for finite floats. *)
Lemma le_finite : forall f g : float, is_finite f = true -> is_finite g = true ->
  f <=? g = true <-> (B2R f <= B2R g)%R.
Proof.
  intros f g Ff Fg. unfold Model.le. rewrite Bleb_correct by trivial.
  case Rle_bool_spec; intuition (try discriminate; lra).
Qed.

Lemma lt_finite : forall f g : float, is_finite f = true -> is_finite g = true ->
  f <? g = true <-> (B2R f < B2R g)%R.
Proof.
  intros f g Ff Fg. unfold Model.lt. rewrite Bltb_correct by trivial.
  case Rlt_bool_spec; intuition (try discriminate; lra).
Qed.

Lemma below_not_nan : forall f r, below f r -> is_nan f = false.
Proof. now intros [| | |]. Qed.

Lemma above_not_nan : forall f r, above f r -> is_nan f = false.
Proof. now intros [| | |]. Qed.

Lemma below_finite : forall f r, is_finite f = true -> below f r <-> (B2R f <= r)%R.
Proof. now intros [| | |]. Qed.

Lemma above_finite : forall f r, is_finite f = true -> above f r <-> (r <= B2R f)%R.
Proof. now intros [| | |]. Qed.

(** A lower bound of r is one of whatever exceeds r. *)
Lemma below_trans : forall f r r', below f r -> (r <= r')%R -> below f r'.
Proof. intros [| | |] r r'; simpl; trivial; intros; lra. Qed.

(** What is less than a lower bound is a lower bound. *)
Lemma le_below : forall f g r, f <=? g = true -> below g r -> below f r.
Proof.
  intros f g r H Hg. apply le_iff in H as (Nf & Ng & H).
  pose proof (B2R_between f) as Bf. pose proof (B2R_between g) as Bg.
  pose proof (bpow_gt_0 radix2 emax) as H0.
  destruct f as [sf|[]| |sf mf ef Hf], g as [sg|[]| |sg mg eg Hg']; try discriminate;
    cbn -[B2R bpow] in *; trivial; lra.
Qed.

(** A lower bound and an upper bound of one real are in order. *)
Lemma below_above : forall f g r, below f r -> above g r -> f <=? g = true.
Proof.
  intros f g r Hf Hg. apply le_iff.
  pose proof (B2R_between f) as Bf. pose proof (B2R_between g) as Bg.
  pose proof (bpow_gt_0 radix2 emax) as H0.
  destruct f as [sf|[]| |sf mf ef Hf'], g as [sg|[]| |sg mg eg Hg']; try discriminate;
    try contradiction; cbn -[B2R bpow] in *; repeat split; trivial; lra.
Qed.

(** Bounds change sides with the sign. *)
Lemma above_opposite : forall f r, above (Bopp f) r <-> below f (- r).
Proof.
  intros f r. destruct (is_finite f) eqn:F.
  - rewrite above_finite, below_finite, B2R_Bopp by now rewrite ?is_finite_Bopp. lra.
  - destruct f as [|[]| |]; try discriminate; simpl; intuition.
Qed.

(** z is r rounded downwards: the greatest float below r. *)
Definition greatest_below (z : float) (r : R) : Prop := forall f : float, f <=? z = true <-> below f r.

Lemma greatest_not_nan : forall z r, greatest_below z r -> is_nan z = false.
Proof.
  intros z r H. assert (L : B754_infinity true <=? z = true) by now apply H.
  now apply le_not_nan in L.
Qed.

Lemma greatest_is_below : forall z r, greatest_below z r -> below z r.
Proof. intros z r H. apply H, le_refl. now apply greatest_not_nan in H. Qed.

(** Rounding downwards preserves order. *)
Lemma greatest_monotone : forall z r z' r', greatest_below z r -> greatest_below z' r' ->
  (r <= r')%R -> z <=? z' = true.
Proof.
  intros z r z' r' H H' L. apply H'. apply below_trans with r; trivial. now apply greatest_is_below.
Qed.

(** The sign of what is rounded downwards is told by the result. *)
Lemma greatest_sign : forall z r, greatest_below z r -> (z <? zero) = Rlt_bool r 0.
Proof.
  intros z r H. rewrite lt_negb_le by (trivial; now apply greatest_not_nan in H).
  specialize (H zero). simpl in H. case Rlt_bool_spec; intros L; [apply negb_true_iff | apply negb_false_iff].
  - destruct (zero <=? z); trivial. exfalso. destruct H as [H _]. specialize (H eq_refl). lra.
  - now apply H.
Qed.

(** No finite float exceeds the one that overflow downwards yields. *)
Lemma overflow_down_largest : forall z f : float,
  B2SF z = binary_overflow prec emax mode_DN false -> is_finite f = true ->
  is_finite z = true /\ (B2R f <= B2R z)%R.
Proof.
  intros z f E F.
  assert (B : B2R z = (bpow radix2 emax - bpow radix2 (emax - prec))%R).
  { rewrite <- SF2R_B2SF, E. simpl. unfold F2R. simpl.
    pose proof (prec_gt_0 prec).
    assert (1 < 2 ^ prec)%Z by (apply (Zpower_gt_1 radix2); trivial).
    rewrite Z2Pos.id by (unfold Zpower in *; lia).
    change (Z.pow 2 prec) with (Zpower radix2 prec).
    rewrite minus_IZR, IZR_Zpower by lia.
    replace emax with (prec + (emax - prec))%Z at 2 by lia. rewrite bpow_plus. ring. }
  split.
  - now destruct z.
  - rewrite B. apply Rle_trans with (1 := Rle_abs _). now apply abs_B2R_le_emax_minus_prec.
Qed.

(** What Flocq's theorems of correctness say of a result rounded downwards makes it the greatest
    float below the exact one. *)
Lemma rounded_down_greatest : forall (z : float) (r : R) (s : bool),
  (if Rlt_bool (Rabs (round radix2 fexp Zfloor r)) (bpow radix2 emax)
   then B2R z = round radix2 fexp Zfloor r /\ is_finite z = true
   else B2SF z = binary_overflow prec emax mode_DN s /\ (if s then r <= 0 else 0 <= r)%R) ->
  greatest_below z r.
Proof.
  intros z r s.
  assert (V : Valid_exp fexp) by now apply fexp_correct.
  assert (G : forall f : float, round radix2 fexp Zfloor (B2R f) = B2R f)
    by (intros f; apply round_generic; [apply valid_rnd_DN | apply generic_format_B2R]).
  assert (L : (round radix2 fexp Zfloor r <= r)%R)
    by (apply (round_DN_pt radix2 fexp)).
  assert (M : forall x y, (x <= y)%R -> (round radix2 fexp Zfloor x <= round radix2 fexp Zfloor y)%R)
    by (intros x y; apply round_le; [trivial | apply valid_rnd_DN]).
  pose proof (bpow_gt_0 radix2 emax) as H0.
  case Rlt_bool_spec; intros Small H f.
  - destruct H as [Z F]. destruct (is_finite f) eqn:Ff.
    + rewrite le_finite, below_finite by trivial. rewrite Z. split; intros H.
      * lra.
      * rewrite <- (G f). now apply M.
    + assert (N : is_nan z = false) by now destruct z.
      pose proof (B2R_between z) as Bz.
      destruct f as [|[]| |]; try discriminate.
      * split; intros _; [reflexivity | apply le_iff]. repeat split; trivial.
        destruct z; try discriminate; cbn -[B2R bpow] in *; lra.
      * split; try discriminate. intros C. apply le_iff in C as (_ & _ & C).
        destruct z; try discriminate; cbn -[B2R bpow] in *; lra.
      * now split; try discriminate; destruct z.
  - destruct H as [E S]. destruct s.
    + assert (Ez : z = B754_infinity true) by (destruct z; now inversion E).
      subst z. clear E.
      assert (N : (round radix2 fexp Zfloor r <= - bpow radix2 emax)%R).
      { assert (round radix2 fexp Zfloor r <= 0)%R.
        { rewrite <- (round_0 radix2 fexp Zfloor). now apply M. }
        rewrite Rabs_left1 in Small by trivial. lra. }
      pose proof (B2R_between f) as Bf.
      assert (Ff : (B2R f <= r)%R -> False) by (intros K; apply M in K; rewrite G in K; lra).
      split; intros K.
      * apply le_iff in K as (Nf & _ & K).
        destruct f as [|[]| |]; try discriminate; cbn -[B2R bpow] in *; trivial; lra.
      * destruct f as [|[]| |]; try contradiction; try discriminate; trivial; now elim Ff.
    + assert (P : (bpow radix2 emax <= r)%R).
      { assert (0 <= round radix2 fexp Zfloor r)%R.
        { rewrite <- (round_0 radix2 fexp Zfloor). now apply M. }
        rewrite Rabs_pos_eq in Small by trivial. lra. }
      pose proof (B2R_between f) as Bf.
      destruct (overflow_down_largest z zero E eq_refl) as [Fz _].
      destruct (is_finite f) eqn:Ff.
      * rewrite le_finite, below_finite by trivial.
        destruct (overflow_down_largest z f E Ff). split; intros; lra.
      * pose proof (B2R_between z) as Bz.
        destruct f as [|[]| |]; try discriminate.
        -- split; intros _; [reflexivity |].
           apply below_above with (B2R z); [reflexivity | apply above_finite; trivial; lra].
        -- split; try discriminate. intros C. apply le_iff in C as (_ & _ & C).
           destruct z; try discriminate; cbn -[B2R bpow] in *; lra.
        -- now split; try discriminate; destruct z.
Qed.

(** The sign of a float is that of its value. *)
Lemma sign_of_value : forall x : float,
  if Bsign x then (B2R x <= 0)%R else (0 <= B2R x)%R.
Proof.
  intros [s|s| |[] m e H]; simpl; try (case s; lra); try lra.
  - now apply F2R_le_0.
  - now apply F2R_ge_0.
Qed.

(** RD(x - y) is the greatest float below x - y. *)
Theorem sub_down_greatest : forall x y : float, is_finite x = true -> is_finite y = true ->
  greatest_below (Bminus mode_DN x y) (B2R x - B2R y).
Proof.
  intros x y Fx Fy. apply rounded_down_greatest with (Bsign x).
  generalize (Bminus_correct _ _ _ _ mode_DN x y Fx Fy). simpl round_mode.
  case Rlt_bool.
  - now intros (E & F & _).
  - intros (E & S). split; trivial.
    pose proof (sign_of_value x) as Sx. pose proof (sign_of_value y) as Sy.
    rewrite S in *. destruct (Bsign y); simpl in *; lra.
Qed.

(** RD(x y) is the greatest float below x y. *)
Theorem mul_down_greatest : forall x y : float, is_finite x = true -> is_finite y = true ->
  greatest_below (Bmult mode_DN x y) (B2R x * B2R y).
Proof.
  intros x y Fx Fy. apply rounded_down_greatest with (xorb (Bsign x) (Bsign y)).
  generalize (Bmult_correct _ _ _ _ mode_DN x y). simpl round_mode. rewrite Fx, Fy.
  case Rlt_bool.
  - now intros (E & F & _).
  - intros E. split; trivial.
    pose proof (sign_of_value x) as Sx. pose proof (sign_of_value y) as Sy.
    destruct (Bsign x), (Bsign y); simpl.
    + nra.
    + nra.
    + nra.
    + nra.
Qed.

End Bounds.
