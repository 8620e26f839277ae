(** exact_touch.hpp over binary64: [meets], the C++ function (without its filter: Exact_filter.v), is
    true if and only if the ray has a point in the box, for all finite rays and boxes of positive
    size, closed or half-open; and [determinant_sign] is the sign of the real determinant.

    [parts_of] takes a number's significand and exponent as Flocq has them, which for a binary64 are
    those that `double_parts` reads from the bits. std::sort is any function that sorts. *)
From Coq Require Import ZArith Bool List Reals Lia Lra Psatz Permutation.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model Interval_arith Determinant_sign Sum_sign Exact_predicate.
Import ListNotations.
Open Scope R_scope.

Notation double := (float 53 1024).
#[global] Instance prec_positive : Prec_gt_0 53 := eq_refl.
#[global] Instance prec_below : Prec_lt_emax 53 1024 := eq_refl.
Notation zero := (Model.zero 53 1024).
Notation lt := (Model.lt 53 1024).
Notation eq := (Model.eq 53 1024).

Definition parts_of (x : double) : parts :=
  match x with
  | B754_finite s m e _ => {| significand := Zpos m; exponent := e; negative := s |}
  | B754_zero s => {| significand := 0; exponent := -1074; negative := s |}
  | _ => {| significand := 0; exponent := -1074; negative := false |}
  end.

(** 53 bits, and an exponent of at least -1074. *)
Lemma parts_proper x : proper (parts_of x) /\ (-1074 <= exponent (parts_of x))%Z.
Proof.
  destruct x as [s|s| |s m e H]; try (split; [split; simpl; lia|simpl; lia]).
  unfold proper. cbn [parts_of significand exponent].
  apply andb_true_iff in H. destruct H as [H _]. apply Zeq_bool_eq in H.
  unfold SpecFloat.fexp, SpecFloat.emin in H. rewrite Zpos_digits2_pos in H.
  assert (D : (Zdigits radix2 (Zpos m) <= 53)%Z) by lia.
  split; [|lia]. split; [lia|].
  pose proof (Zdigits_correct radix2 (Zpos m)) as C.
  apply Z.lt_le_trans with (radix2 ^ Zdigits radix2 (Zpos m))%Z; [simpl Z.abs in C; lia|].
  apply (Zpower_le radix2 _ 53). exact D.
Qed.

Lemma real_in_units (x : double) : is_finite x = true ->
  B2R x = IZR (in_units (-1074) (parts_of x)) * bpow radix2 (-1074).
Proof.
  intros F. pose proof (proj2 (parts_proper x)) as E.
  destruct x as [s|s| |s m e H]; try discriminate.
  - unfold in_units, signed. cbn [parts_of significand negative exponent]. simpl.
    destruct s; simpl; ring.
  - unfold in_units, signed. cbn [parts_of significand negative exponent] in *. unfold B2R, F2R, Fnum, Fexp.
    rewrite mult_IZR. change (2 ^ (e - -1074))%Z with (radix_val radix2 ^ (e - -1074))%Z.
    rewrite IZR_Zpower by lia. rewrite Rmult_assoc, <- bpow_plus.
    f_equal. f_equal. lia.
Qed.
Lemma real_size (x : double) : is_finite x = true ->
  Rabs (B2R x) = IZR (significand (parts_of x) * 2 ^ (exponent (parts_of x) - -1074)) * bpow radix2 (-1074).
Proof.
  intros F. rewrite (real_in_units x F), Rabs_mult, (Rabs_pos_eq (bpow _ _)) by apply bpow_ge_0.
  f_equal. rewrite <- abs_IZR. f_equal. unfold in_units. rewrite Z.abs_mul.
  destruct (parts_proper x) as [[P _] E].
  rewrite (Z.abs_eq (2 ^ _)) by (apply Z.lt_le_incl, pow2_pos; lia).
  f_equal. unfold signed. destruct (negative (parts_of x)); lia.
Qed.

Section Touch.
Variable sort : list term -> list term.
Hypothesis sort_permutes : forall l, Permutation l (sort l).
Hypothesis sort_sorts : forall l, descending (sort l).

(** determinant_sign({xg, xl}, xf, {yg, yl}, yf) *)
Definition determinant_sign (xg xl xf yg yl yf : double) : Z :=
  let p := parts_of in
  match fast_sign (wide_product (p xg) (p xl) (p xf)) (wide_product (p yg) (p yl) (p yf)) with
  | Some s => s
  | None => sign_of_sum 4 (sort (determinant_terms (p xg) (p xl) (p xf) (p yg) (p yl) (p yf)))
  end.

Definition real_determinant (xg xl xf yg yl yf : double) : R :=
  (B2R xg - B2R xl) * Rabs (B2R xf) - (B2R yg - B2R yl) * Rabs (B2R yf).

(** The sign of the determinant, exactly, for all finite doubles with differences >= 0. *)
Theorem determinant_sign_correct xg xl xf yg yl yf :
  is_finite xg = true -> is_finite xl = true -> is_finite xf = true ->
  is_finite yg = true -> is_finite yl = true -> is_finite yf = true ->
  B2R xl <= B2R xg -> B2R yl <= B2R yg ->
  let s := determinant_sign xg xl xf yg yl yf in
  let d := real_determinant xg xl xf yg yl yf in
  ((0 < s)%Z <-> 0 < d) /\ (s = 0%Z <-> d = 0).
Proof.
  intros F1 F2 F3 F4 F5 F6 Hx Hy. cbv zeta.
  set (D := determinant (-1074) (-1074) (parts_of xg) (parts_of xl) (parts_of xf)
              (parts_of yg) (parts_of yl) (parts_of yf)).
  pose proof (bpow_gt_0 radix2 (-1074)) as B.
  assert (E : real_determinant xg xl xf yg yl yf = IZR D * (bpow radix2 (-1074) * bpow radix2 (-1074))).
  { unfold real_determinant, D, determinant.
    rewrite (real_in_units xg), (real_in_units xl), (real_in_units yg), (real_in_units yl),
      (real_size xf), (real_size yf) by assumption.
    rewrite minus_IZR, !mult_IZR, !minus_IZR. ring. }
  assert (S : determinant_sign xg xl xf yg yl yf = Z.sgn D).
  { destruct (parts_proper xg) as [P1 E1], (parts_proper xl) as [P2 E2], (parts_proper xf) as [P3 E3],
      (parts_proper yg) as [P4 E4], (parts_proper yl) as [P5 E5], (parts_proper yf) as [P6 E6].
    unfold determinant_sign. cbv zeta. destruct (fast_sign _ _) as [s|] eqn:Fs.
    - apply fast_sign_correct with (base := (-1074)%Z) (fbase := (-1074)%Z) in Fs; try assumption.
      + apply le_IZR. rewrite minus_IZR. apply Rmult_le_reg_r with (1 := B).
        rewrite Rmult_minus_distr_r, <- !real_in_units by assumption. lra.
      + apply le_IZR. rewrite minus_IZR. apply Rmult_le_reg_r with (1 := B).
        rewrite Rmult_minus_distr_r, <- !real_in_units by assumption. lra.
    - apply determinant_sign_of_any_correct with (base := (-1074)%Z) (fbase := (-1074)%Z); try assumption.
      + apply sort_permutes.
      + apply sort_sorts. }
  rewrite S, E. set (bb := bpow radix2 (-1074) * bpow radix2 (-1074)).
  assert (BB : 0 < bb) by (apply Rmult_lt_0_compat; exact B). clearbody bb.
  destruct (Z.lt_trichotomy D 0) as [H|[H|H]].
  - rewrite Z.sgn_neg by exact H. apply IZR_lt in H. split; split; intros; try lia; nra.
  - rewrite H. simpl Z.sgn. split; split; intros; try lia; try lra.
  - rewrite Z.sgn_pos by exact H. apply IZR_lt in H. split; split; intros; try lia; nra.
Qed.

(** * meets *)
Record axis_of_box := { o : double; d : double; lo : double; hi : double; hi_closed : bool }.

Section One_axis.
Variable a : axis_of_box.
Definition backward : bool := lt (d a) zero.
Definition origin : double := if backward then Bopp (o a) else o a.
Definition near_plane : double := if backward then Bopp (hi a) else lo a.
Definition far_plane : double := if backward then Bopp (lo a) else hi a.
Definition near_is_closed : bool := hi_closed a || negb backward.
Definition far_is_closed : bool := hi_closed a || backward.
Definition still : bool := eq (d a) zero.
Definition after_near : bool := lt near_plane origin || (eq near_plane origin && near_is_closed).
Definition before_far : bool := lt origin far_plane || (eq origin far_plane && far_is_closed).
Definition is_outside : bool := negb before_far || (still && negb after_near).
End One_axis.

(** A pair (axis of the entry, axis of the exit) that rules the box out. *)
Definition fails (a b : axis_of_box) : bool :=
  let sign := determinant_sign (near_plane a) (origin a) (d b) (far_plane b) (origin b) (d a) in
  negb (after_near a) && negb (still b) &&
  ((0 <? sign)%Z || ((sign =? 0)%Z && negb (near_is_closed a && far_is_closed b))).

Definition meets (x : index -> axis_of_box) : bool :=
  negb (is_outside (x i0) || is_outside (x i1) || is_outside (x i2)) &&
  negb (fails (x i0) (x i1) || fails (x i0) (x i2) || fails (x i1) (x i0) ||
        fails (x i1) (x i2) || fails (x i2) (x i0) || fails (x i2) (x i1)).

Definition finite_axis (a : axis_of_box) : Prop :=
  is_finite (o a) = true /\ is_finite (d a) = true /\ is_finite (lo a) = true /\
  is_finite (hi a) = true /\ B2R (lo a) < B2R (hi a).

Definition slab_of (a : axis_of_box) : slab := {|
  start := B2R (origin a); speed := Rabs (B2R (d a));
  near := B2R (near_plane a); far := B2R (far_plane a);
  near_closed := near_is_closed a; far_closed := far_is_closed a |}.

Lemma finite_parts a : finite_axis a ->
  is_finite (origin a) = true /\ is_finite (near_plane a) = true /\ is_finite (far_plane a) = true.
Proof.
  intros (F1 & F2 & F3 & F4 & _). unfold origin, near_plane, far_plane.
  destruct (backward a); rewrite ?is_finite_Bopp; auto.
Qed.
Lemma backward_real a : finite_axis a -> backward a = Rlt_bool (B2R (d a)) 0.
Proof. intros (_ & F & _). unfold backward. rewrite lt_zero_finite by exact F. reflexivity. Qed.

Lemma slab_solid a : finite_axis a -> near (slab_of a) < far (slab_of a).
Proof.
  intros (_ & _ & _ & _ & L). simpl. unfold near_plane, far_plane.
  destruct (backward a); rewrite ?B2R_Bopp; lra.
Qed.

(** The reflected axis says the same as the axis. *)
Lemma within_slab a t : finite_axis a ->
  within (slab_of a) (start (slab_of a) + t * speed (slab_of a)) <->
  B2R (lo a) <= B2R (o a) + t * B2R (d a) /\
  (if hi_closed a then B2R (o a) + t * B2R (d a) <= B2R (hi a)
   else B2R (o a) + t * B2R (d a) < B2R (hi a)).
Proof.
  intros F. pose proof (backward_real a F) as Bk.
  unfold within, past_near, short_of_far, slab_of.
  cbn [start speed near far near_closed far_closed].
  unfold near_is_closed, far_is_closed, near_plane, far_plane, origin.
  destruct (backward a); revert Bk; case Rlt_bool_spec; intros S Bk; try discriminate.
  - rewrite !B2R_Bopp, Rabs_left by exact S. destruct (hi_closed a); cbn [orb negb]; split; intros; lra.
  - rewrite Rabs_pos_eq by exact S. destruct (hi_closed a); cbn [orb negb]; split; intros; lra.
Qed.

Lemma after_near_correct a : finite_axis a ->
  after_near a = true <-> past_near (slab_of a) (start (slab_of a)).
Proof.
  intros F. destruct (finite_parts a F) as (F1 & F2 & F3). unfold after_near, past_near.
  rewrite lt_finite, eq_finite by assumption. cbn [slab_of near start near_closed].
  case Rlt_bool_spec; case Req_bool_spec; intros; destruct (near_is_closed a); cbn [orb andb];
    split; intros; try discriminate; try reflexivity; lra.
Qed.
Lemma before_far_correct a : finite_axis a ->
  before_far a = true <-> short_of_far (slab_of a) (start (slab_of a)).
Proof.
  intros F. destruct (finite_parts a F) as (F1 & F2 & F3). unfold before_far, short_of_far.
  rewrite lt_finite, eq_finite by assumption. cbn [slab_of far start far_closed].
  case Rlt_bool_spec; case Req_bool_spec; intros; destruct (far_is_closed a); cbn [orb andb];
    split; intros; try discriminate; try reflexivity; lra.
Qed.
Lemma still_correct a : finite_axis a -> still a = true <-> speed (slab_of a) = 0.
Proof.
  intros (_ & F & _). unfold still. rewrite eq_zero_finite by exact F. cbn [slab_of speed].
  case Req_bool_spec; intros H; split; intros; try discriminate; try reflexivity.
  - rewrite H. apply Rabs_R0.
  - exfalso. apply (Rabs_no_R0 _ H). assumption.
Qed.

Lemma is_outside_correct a : finite_axis a -> is_outside a = true <-> outside (slab_of a).
Proof.
  intros F. unfold is_outside, outside.
  rewrite orb_true_iff, andb_true_iff, !negb_true_iff.
  rewrite <- (before_far_correct a F), <- (after_near_correct a F), <- (still_correct a F).
  rewrite <- !not_true_iff_false. tauto.
Qed.

Lemma fails_correct a b : finite_axis a -> finite_axis b -> ~ outside (slab_of b) ->
  fails a b = true <-> too_late (slab_of a) (slab_of b).
Proof.
  intros Fa Fb Ob. unfold fails, too_late. cbv zeta.
  destruct (after_near a) eqn:A.
  - apply after_near_correct in A; [|exact Fa]. cbn [negb andb]. split; [discriminate|tauto].
  - assert (NA : ~ past_near (slab_of a) (start (slab_of a))).
    { intros H. apply after_near_correct in H; [|exact Fa]. congruence. }
    destruct (finite_parts a Fa) as (A1 & A2 & A3), (finite_parts b Fb) as (B1 & B2 & B3).
    pose proof Fa as (_ & Da & _). pose proof Fb as (_ & Db & _).
    assert (G1 : B2R (origin a) <= B2R (near_plane a)).
    { clear - NA. unfold past_near in NA. cbn [slab_of near start near_closed] in NA.
      destruct (near_is_closed a); lra. }
    assert (G2 : B2R (origin b) <= B2R (far_plane b)).
    { clear - Ob. unfold outside, short_of_far in Ob. cbn [slab_of far start far_closed] in Ob.
      destruct (Rle_dec (B2R (origin b)) (B2R (far_plane b))) as [H|H]; [exact H|].
      exfalso. apply Ob. left. destruct (far_is_closed b); lra. }
    destruct (determinant_sign_correct (near_plane a) (origin a) (d b) (far_plane b) (origin b) (d a)
      A2 A1 Db B3 B1 Da G1 G2) as [P N]. cbv zeta in P, N.
    change (real_determinant (near_plane a) (origin a) (d b) (far_plane b) (origin b) (d a))
      with (lateness (slab_of a) (slab_of b)) in P, N.
    rewrite <- P, <- N. rewrite <- (still_correct b Fb).
    cbn [negb andb]. rewrite andb_true_iff, orb_true_iff, andb_true_iff, !negb_true_iff.
    rewrite Z.ltb_lt, Z.eqb_eq, <- not_true_iff_false.
    cbn [slab_of near_closed far_closed]. tauto.
Qed.

(** meets() = true if and only if the ray has a point in the box. *)
Theorem meets_exact (x : index -> axis_of_box) : (forall i, finite_axis (x i)) ->
  meets x = true <->
  exists t, 0 <= t /\ forall i,
    B2R (lo (x i)) <= B2R (o (x i)) + t * B2R (d (x i)) /\
    (if hi_closed (x i) then B2R (o (x i)) + t * B2R (d (x i)) <= B2R (hi (x i))
     else B2R (o (x i)) + t * B2R (d (x i)) < B2R (hi (x i))).
Proof.
  intros F.
  assert (T : (exists t, 0 <= t /\ forall i,
      B2R (lo (x i)) <= B2R (o (x i)) + t * B2R (d (x i)) /\
      (if hi_closed (x i) then B2R (o (x i)) + t * B2R (d (x i)) <= B2R (hi (x i))
       else B2R (o (x i)) + t * B2R (d (x i)) < B2R (hi (x i)))) <->
    ray_meets (fun i => slab_of (x i))).
  { unfold ray_meets. split; intros (t & T0 & W); exists t; (split; [exact T0|]); intros i;
      apply (within_slab (x i) t (F i)); apply W. }
  rewrite T, test_exact.
  2: { intros i. apply Rabs_pos. }
  2: { intros i. apply slab_solid, F. }
  unfold meets, test. rewrite andb_true_iff, !negb_true_iff.
  rewrite !orb_false_iff. rewrite <- !not_true_iff_false.
  rewrite !is_outside_correct by apply F.
  split.
  - intros [[[O0 O1] O2] L].
    assert (O : forall i, ~ outside (slab_of (x i))) by (intros []; assumption).
    split; [exact O|]. intros i j N. rewrite <- fails_correct by (apply F || apply O).
    destruct i, j; try congruence; tauto.
  - intros [O L]. split; [repeat split; apply O|].
    repeat split; rewrite fails_correct by (apply F || apply O); apply L; discriminate.
Qed.
End Touch.
