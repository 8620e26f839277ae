(** The ray/octant test never misses (octree/geometry/include/graze/octree/ray_bounds.hpp, `touches_box`).

    If a point o + t d of the ray, t >= 0 a real, lies in a box with finite corners, the test over
    IEEE 754 numbers is true. Nothing is asked of the magnitudes: differences and products may
    overflow or underflow, components of d may be zero, all of them even.

    The argument: let s = t |dx| |dy| |dz|, zero components counted as 1, and C the product of the
    other two axes' components. On an axis with d > 0, C (lo - o) <= s <= C (hi - o). `lowb` is below
    the exact C (p - q), `uppb` above it, and neither is NaN; so s lies in the interval of each axis,
    and intervals with a common s >= 0 pass.

    - [lowb_encloses], [uppb_encloses], [bounds_enclose]: each bound encloses the exact one;
    - [lowb_never_nan], [uppb_never_nan], [within_never_nan]: and is never NaN;
    - [half_encloses]: the same of the split of octree/tree/include/graze/octree/sound.hpp;
    - [never_miss_scaled]: also where the ray is prepared by another direction of the same points;
    - [never_miss], [never_miss_upward], [never_miss_owned] for every format; [never_miss_backend] for
      any backend that is correctly rounded; [never_miss_binary64], [never_miss_upward_binary64] for
      double. *)
From Coq Require Import ZArith Bool Reals Lra FunctionalExtensionality SpecFloat.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model Negation Bounds.

Section Never_miss.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.

Notation float := (float prec emax).
Notation axis := (axis prec emax).
Notation interval := (interval prec emax).
Notation directed := (directed prec emax).
Notation upward := (upward prec emax).
Notation "x <=? y" := (Model.le prec emax x y).
Notation "x <? y" := (Model.lt prec emax x y).
Notation zero := (Model.zero prec emax).
Notation below := (below prec emax).
Notation above := (above prec emax).
Notation c_down := (c_down prec emax).
Notation c_up := (c_up prec emax).
Notation origin := (origin prec emax).
Notation direction := (direction prec emax).
Notation enter := (enter prec emax).
Notation leave := (leave prec emax).
Notation lowb := (lowb prec emax directed).
Notation uppb := (uppb prec emax directed).
Notation enter_at := (enter_at prec emax directed).
Notation leave_at := (leave_at prec emax directed).
Notation within := (within prec emax directed).
Notation half := (half prec emax directed).
Notation prepare_axis := (prepare_axis prec emax directed).
Notation prepare := (prepare prec emax directed).

(** The constants of an axis enclose the positive real C, from a finite lower one on. *)
Record factor (a : axis) (C : R) : Prop := {
  factor_positive : (0 < C)%R;
  factor_down_finite : is_finite (c_down a) = true;
  factor_down : (0 <= B2R (c_down a) <= C)%R;
  factor_up : above (c_up a) C }.

(** +inf or a positive number times something below 0 is below what C times it is. *)
Lemma mul_up_factor : forall (c u : float) (C r : R),
  (0 < C)%R -> above c C -> below u r -> u <? zero = true -> (r < 0)%R ->
  below (Bmult mode_DN c u) (C * r).
Proof.
  intros c u C r HC Hc Hu Neg Hr.
  destruct (is_finite c && is_finite u) eqn:F.
  - apply andb_prop in F as [Fc Fu].
    apply lt_finite in Neg; trivial. simpl in Neg.
    apply above_finite in Hc; trivial. apply below_finite in Hu; trivial.
    apply below_trans with (B2R c * B2R u)%R.
    + now apply greatest_is_below, mul_down_greatest.
    + nra.
  - destruct c as [sc|[]| |[] mc ec Bc]; try discriminate; try contradiction;
      destruct u as [su|[]| |[] mu eu Bu]; try discriminate; try contradiction;
      try reflexivity; simpl in Hc; try lra.
    assert (B2R (B754_finite true mc ec Bc) < 0)%R by now apply F2R_lt_0.
    simpl in *. lra.
Qed.

(** Each lower bound is below the exact one: lowb(p, q) <= C (p - q), and it is not NaN. *)
Theorem lowb_encloses : forall (a : axis) (C : R) (p q : float),
  factor a C -> is_finite p = true -> is_finite q = true ->
  below (lowb a p q) (C * (B2R p - B2R q)).
Proof.
  intros a C p q [HC Fd [Hd0 HdC] Hu] Fp Fq. unfold Model.lowb. cbn -[Bminus Bmult].
  pose proof (sub_down_greatest _ _ p q Fp Fq) as G. set (u := Bminus mode_DN p q) in *.
  pose proof (greatest_is_below _ _ _ _ G) as B.
  pose proof (greatest_sign _ _ _ _ G) as S.
  destruct (u <? zero) eqn:N.
  - apply mul_up_factor; trivial. revert S. now case Rlt_bool_spec.
  - assert (Hr : (0 <= B2R p - B2R q)%R) by (revert S; now case Rlt_bool_spec).
    assert (Fu : is_finite u = true).
    { destruct u as [|[]| |]; trivial; try discriminate; contradiction. }
    assert (Hu0 : (0 <= B2R u)%R).
    { assert (Z : zero <=? u = true) by now apply G.
      now apply le_finite in Z. }
    apply below_finite in B; trivial.
    apply below_trans with (B2R (c_down a) * B2R u)%R.
    + now apply greatest_is_below, mul_down_greatest.
    + now apply Rmult_le_compat.
Qed.

(** Each upper bound is above the exact one: uppb(p, q) >= C (p - q), and it is not NaN. *)
Theorem uppb_encloses : forall (a : axis) (C : R) (p q : float),
  factor a C -> is_finite p = true -> is_finite q = true ->
  above (uppb a p q) (C * (B2R p - B2R q)).
Proof.
  intros a C p q H Fp Fq. rewrite uppb_is_opposite_lowb. apply above_opposite.
  replace (- (C * (B2R p - B2R q)))%R with (C * (B2R q - B2R p))%R by ring.
  now apply lowb_encloses.
Qed.

(** mag(x) over the reals. *)
Definition magnitude (x : R) : R := if Req_bool x 0 then 1%R else Rabs x.

Lemma magnitude_positive : forall x, (0 < magnitude x)%R.
Proof.
  intros x. unfold magnitude. case Req_bool_spec; intros H; [lra | now apply Rabs_pos_lt].
Qed.

(** mag(x) is finite and what it should be. *)
Lemma mag_exact : forall x : float, is_finite x = true ->
  is_finite (mag _ _ x) = true /\ B2R (mag _ _ x) = magnitude (B2R x).
Proof.
  intros x F. unfold mag, Model.eq, magnitude.
  rewrite Beqb_correct by trivial. unfold Model.lt. rewrite Bltb_correct by trivial. simpl (B2R zero).
  case Req_bool_spec; intros E.
  - unfold one. split; [apply is_finite_Bone | apply Bone_correct].
  - case Rlt_bool_spec; intros L.
    + rewrite is_finite_Bopp, B2R_Bopp, Rabs_left; auto.
    + rewrite Rabs_pos_eq; auto.
Qed.

(** Preparation encloses the product of the other two axes' magnitudes, whatever they are. *)
Theorem prepare_axis_encloses : forall o d other1 other2 : float,
  is_finite other1 = true -> is_finite other2 = true ->
  factor (prepare_axis o d other1 other2) (magnitude (B2R other1) * magnitude (B2R other2)).
Proof.
  intros o d x y Fx Fy.
  destruct (mag_exact x Fx) as [Mx Ex]. destruct (mag_exact y Fy) as [My Ey].
  pose proof (magnitude_positive (B2R x)) as Px. pose proof (magnitude_positive (B2R y)) as Py.
  assert (P : (0 < magnitude (B2R x) * magnitude (B2R y))%R) by now apply Rmult_lt_0_compat.
  pose proof (mul_down_greatest _ _ _ _ Mx My) as G. rewrite Ex, Ey in G.
  assert (Z : zero <=? Bmult mode_DN (mag _ _ x) (mag _ _ y) = true) by (apply G; simpl; lra).
  pose proof (greatest_is_below _ _ _ _ G) as B.
  assert (F : is_finite (Bmult mode_DN (mag _ _ x) (mag _ _ y)) = true).
  { destruct Bmult as [|[]| |]; trivial; try discriminate; contradiction. }
  split; cbn -[Bmult]; trivial.
  - split.
    + now apply le_finite in Z.
    + now apply below_finite in B.
  - rewrite mul_up_by_negation. apply above_opposite.
    rewrite <- Ex, <- Ey, Ropp_mult_distr_l, <- B2R_Bopp.
    apply greatest_is_below, mul_down_greatest; trivial. now rewrite is_finite_Bopp.
Qed.

(** Both bounds of a prepared axis enclose C (p - q), with C the exact product of the other two
    components' magnitudes, and neither is NaN: for every finite input. *)
Theorem bounds_enclose : forall o d other1 other2 p q : float,
  is_finite other1 = true -> is_finite other2 = true -> is_finite p = true -> is_finite q = true ->
  let a := prepare_axis o d other1 other2 in
  let exact := (magnitude (B2R other1) * magnitude (B2R other2) * (B2R p - B2R q))%R in
  below (lowb a p q) exact /\ above (uppb a p q) exact /\
  is_nan (lowb a p q) = false /\ is_nan (uppb a p q) = false.
Proof.
  intros o d x y p q Fx Fy Fp Fq a exact.
  pose proof (prepare_axis_encloses o d x y Fx Fy) as H. fold a in H.
  pose proof (lowb_encloses a _ p q H Fp Fq) as L. pose proof (uppb_encloses a _ p q H Fp Fq) as U.
  repeat split; trivial; [now apply below_not_nan in L | now apply above_not_nan in U].
Qed.

(** s is within the interval, as far as the interval's bounds say; both say something. *)
Definition encloses (i : interval) (s : R) : Prop := below (enter i) s /\ above (leave i) s.

(** An axis prepared for the ray x = o + t d, with its constant C, at the scaled parameter s. *)
Record ray_axis (a : axis) (o d : float) (t s : R) : Prop := {
  ray_origin : origin a = o;
  ray_origin_finite : is_finite o = true;
  ray_direction : match direction a with
                  | backward => (B2R d < 0)%R
                  | across => B2R d = 0%R
                  | forward => (0 < B2R d)%R
                  end;
  ray_factor : exists C, factor a C /\ s = (t * (magnitude (B2R d) * C))%R }.

(** Before the plane p on the side of entry: the ray at t has not passed it, so that s is not below
    what enter_at says. *)
Lemma enter_at_encloses : forall (a : axis) (o d p : float) (t s : R),
  ray_axis a o d t s -> is_finite p = true ->
  match direction a with
  | backward => (B2R o + t * B2R d <= B2R p)%R
  | _ => (B2R p <= B2R o + t * B2R d)%R
  end -> below (enter_at a p) s.
Proof.
  intros a o d p t s [Eo Fo Hd (C & HC & Es)] Fp Side. unfold Model.enter_at. rewrite Eo.
  pose proof (factor_positive _ _ HC) as PC. unfold magnitude in Es.
  destruct (direction a).
  - rewrite Req_bool_false, Rabs_left in Es by lra.
    apply below_trans with (1 := lowb_encloses _ _ _ _ HC Fo Fp). rewrite Es. nra.
  - assert (L : p <=? o = true) by (apply le_finite; trivial; rewrite Hd in Side; lra).
    now rewrite L.
  - rewrite Req_bool_false, Rabs_pos_eq in Es by lra.
    apply below_trans with (1 := lowb_encloses _ _ _ _ HC Fp Fo). rewrite Es. nra.
Qed.

(** Not beyond the plane p on the side of exit, as the convention has it: s is not above what
    leave_at says. *)
Lemma leave_at_encloses : forall (c : convention) (a : axis) (o d p : float) (t s : R),
  ray_axis a o d t s -> is_finite p = true ->
  match direction a, c with
  | backward, _ => (B2R p <= B2R o + t * B2R d)%R
  | across, owned => (B2R o + t * B2R d < B2R p)%R
  | _, _ => (B2R o + t * B2R d <= B2R p)%R
  end -> above (leave_at c a p) s.
Proof.
  intros c a o d p t s [Eo Fo Hd (C & HC & Es)] Fp Side. unfold Model.leave_at. rewrite Eo.
  pose proof (factor_positive _ _ HC) as PC. unfold magnitude in Es.
  destruct (direction a).
  - rewrite Req_bool_false, Rabs_left in Es by lra.
    pose proof (uppb_encloses _ _ _ _ HC Fo Fp) as U. rewrite <- (Ropp_involutive s).
    rewrite <- (Bopp_involutive _ _ (uppb a o p)). apply above_opposite.
    rewrite <- (Bopp_involutive _ _ (uppb a o p)) in U. apply (proj1 (above_opposite _ _ _ _)) in U.
    apply below_trans with (1 := U). rewrite Es. nra.
  - rewrite Hd in Side.
    assert (L : match c with closed => o <=? p | owned => o <? p end = true)
      by (destruct c; [apply le_finite | apply lt_finite]; trivial; lra).
    now rewrite L.
  - rewrite Req_bool_false, Rabs_pos_eq in Es by lra.
    pose proof (uppb_encloses _ _ _ _ HC Fp Fo) as U. rewrite <- (Ropp_involutive s).
    rewrite <- (Bopp_involutive _ _ (uppb a p o)). apply above_opposite.
    rewrite <- (Bopp_involutive _ _ (uppb a p o)) in U. apply (proj1 (above_opposite _ _ _ _)) in U.
    apply below_trans with (1 := U). destruct c; rewrite Es; nra.
Qed.

(** x is between lo and hi: the closed interval, or the half-open one that owns its lower end. *)
Definition between (c : convention) (lo hi x : R) : Prop :=
  (lo <= x)%R /\ match c with closed => (x <= hi)%R | owned => (x < hi)%R end.

(** s is in the interval of the axis. *)
Theorem within_encloses : forall (c : convention) (a : axis) (o d lo hi : float) (t s : R),
  ray_axis a o d t s -> is_finite lo = true -> is_finite hi = true ->
  between c (B2R lo) (B2R hi) (B2R o + t * B2R d) -> encloses (within c a lo hi) s.
Proof.
  intros c a o d lo hi t s H Fl Fh [L U].
  pose proof (fun p => enter_at_encloses a o d p t s H) as E.
  pose proof (fun p => leave_at_encloses c a o d p t s H) as V.
  unfold encloses, Model.within.
  destruct (direction a); split; simpl; (apply E || apply V); trivial; destruct c; lra.
Qed.

(** The split of sound.hpp: if s is in the parent's interval, and the ray at t is on that side of the
    mid-plane, s is in the half's interval. In `owned` the mid-plane belongs to the upper half. *)
Theorem half_encloses : forall (c : convention) (a : axis) (o d mid : float) (t s : R)
    (parent : interval) (upper : bool),
  ray_axis a o d t s -> is_finite mid = true -> encloses parent s ->
  (if upper then (B2R mid <= B2R o + t * B2R d)%R
   else match c with
        | closed => (B2R o + t * B2R d <= B2R mid)%R
        | owned => (B2R o + t * B2R d < B2R mid)%R
        end) ->
  encloses (half c a parent mid upper) s.
Proof.
  intros c a o d mid t s parent upper H F [E V] Side.
  pose proof (enter_at_encloses a o d mid t s H F) as Em.
  pose proof (leave_at_encloses c a o d mid t s H F) as Vm.
  unfold encloses, Model.half.
  destruct (direction a), upper; simpl; split; trivial; (apply Em || apply Vm); trivial;
    destruct c; lra.
Qed.

(** What is in two intervals is in their intersection. *)
Lemma common_encloses : forall (x y : interval) (s : R),
  encloses x s -> encloses y s -> encloses (common _ _ x y) s.
Proof.
  intros x y s [Ex Lx] [Ey Ly]. unfold encloses, common. simpl.
  now destruct (enter x <? enter y), (leave y <? leave x).
Qed.

(** Intervals with a common s >= 0 pass. *)
Theorem passes_if_common : forall (x y z : interval) (s : R),
  encloses x s -> encloses y s -> encloses z s -> (0 <= s)%R -> passes _ _ x y z = true.
Proof.
  intros x y z s Hx Hy Hz Hs. unfold passes, passes2.
  destruct (common_encloses _ _ _ (common_encloses _ _ _ Hx Hy) Hz) as [E L].
  set (both := common _ _ _ z) in *. apply negb_true_iff, orb_false_iff. split.
  - rewrite lt_negb_le, (below_above _ _ _ _ _ E L); trivial.
    + now apply above_not_nan in L.
    + now apply below_not_nan in E.
  - rewrite lt_negb_le; trivial; [| now apply above_not_nan in L].
    apply negb_false_iff, (below_above _ _ _ _ s); trivial.
Qed.

(** An axis as [prepare_axis] makes it is one of the ray. *)
Lemma prepare_axis_ray : forall (o d other1 other2 : float) (t : R),
  is_finite o = true -> is_finite d = true -> is_finite other1 = true -> is_finite other2 = true ->
  ray_axis (prepare_axis o d other1 other2) o d t
    (t * (magnitude (B2R d) * (magnitude (B2R other1) * magnitude (B2R other2)))).
Proof.
  intros o d x y t Fo Fd Fx Fy. split; trivial.
  - unfold Model.prepare_axis. cbn -[Bmult]. unfold Model.lt.
    rewrite !Bltb_correct by trivial. simpl (B2R zero).
    case Rlt_bool_spec; trivial. case Rlt_bool_spec; trivial. intros. lra.
  - exists (magnitude (B2R x) * magnitude (B2R y))%R. split; trivial.
    now apply prepare_axis_encloses.
Qed.

(** All three components. *)
Definition all3 {T : Type} (P : T -> Prop) (v : three T) : Prop := P (at_x v) /\ P (at_y v) /\ P (at_z v).
Definition finite3 : three float -> Prop := all3 (fun f => is_finite f = true).

(** The point o + t d is in the box from lo to hi. *)
Definition ray_in (c : convention) (o d lo hi : three float) (t : R) : Prop :=
  between c (B2R (at_x lo)) (B2R (at_x hi)) (B2R (at_x o) + t * B2R (at_x d)) /\
  between c (B2R (at_y lo)) (B2R (at_y hi)) (B2R (at_y o) + t * B2R (at_y d)) /\
  between c (B2R (at_z lo)) (B2R (at_z hi)) (B2R (at_z o) + t * B2R (at_z d)).

(** The scaled parameter. *)
Definition scaled (d : three float) (t : R) : R :=
  (t * (magnitude (B2R (at_x d)) * (magnitude (B2R (at_y d)) * magnitude (B2R (at_z d)))))%R.

Lemma scaled_positive : forall d t, (0 <= t)%R -> (0 <= scaled d t)%R.
Proof.
  intros d t H. unfold scaled.
  apply Rmult_le_pos; trivial; repeat apply Rmult_le_pos; apply Rlt_le, magnitude_positive.
Qed.

(** The three axes of a prepared ray, at one scaled parameter. *)
Theorem prepare_ray : forall (o d : three float) (t : R), finite3 o -> finite3 d ->
  ray_axis (at_x (prepare o d)) (at_x o) (at_x d) t (scaled d t) /\
  ray_axis (at_y (prepare o d)) (at_y o) (at_y d) t (scaled d t) /\
  ray_axis (at_z (prepare o d)) (at_z o) (at_z d) t (scaled d t).
Proof.
  intros [ox oy oz] [dx dy dz] t (Fox & Foy & Foz) (Fdx & Fdy & Fdz). unfold Model.prepare, scaled.
  cbn [at_x at_y at_z] in *. repeat apply conj.
  - now apply prepare_axis_ray.
  - rewrite (Rmult_comm (magnitude (B2R dx))), Rmult_assoc. now apply prepare_axis_ray.
  - rewrite <- (Rmult_assoc (magnitude (B2R dx))), (Rmult_comm _ (magnitude (B2R dz))).
    now apply prepare_axis_ray.
Qed.

(** Whatever the convention: a box that holds a point of the ray by the convention's rule passes. *)
Theorem never_miss_within : forall (c : convention) (o d lo hi : three float) (t : R),
  finite3 o -> finite3 d -> finite3 lo -> finite3 hi -> (0 <= t)%R -> ray_in c o d lo hi t ->
  let r := prepare o d in
  passes _ _ (within c (at_x r) (at_x lo) (at_x hi)) (within c (at_y r) (at_y lo) (at_y hi))
    (within c (at_z r) (at_z lo) (at_z hi)) = true.
Proof.
  intros c o d lo hi t Fo Fd (Flx & Fly & Flz) (Fhx & Fhy & Fhz) Ht (Bx & By & Bz) r.
  destruct (prepare_ray o d t Fo Fd) as (Rx & Ry & Rz).
  apply passes_if_common with (scaled d t); [ | | | now apply scaled_positive].
  - now apply within_encloses with (1 := Rx).
  - now apply within_encloses with (1 := Ry).
  - now apply within_encloses with (1 := Rz).
Qed.

(** The test never misses: directed operations, every format. *)
Theorem never_miss : forall (o d lo hi : three float),
  finite3 o -> finite3 d -> finite3 lo -> finite3 hi ->
  (exists t, (0 <= t)%R /\ ray_in closed o d lo hi t) ->
  touches_box _ _ directed (prepare o d) lo hi = true.
Proof. intros o d lo hi Fo Fd Fl Fh (t & Ht & B). now apply never_miss_within with t. Qed.

(** The half-open test never misses an octant that owns a point of the ray. *)
Theorem never_miss_owned : forall (o d lo hi : three float),
  finite3 o -> finite3 d -> finite3 lo -> finite3 hi ->
  (exists t, (0 <= t)%R /\ ray_in owned o d lo hi t) ->
  let r := prepare o d in
  passes _ _ (within owned (at_x r) (at_x lo) (at_x hi)) (within owned (at_y r) (at_y lo) (at_y hi))
    (within owned (at_z r) (at_z lo) (at_z hi)) = true.
Proof. intros o d lo hi Fo Fd Fl Fh (t & Ht & B). now apply never_miss_within with t. Qed.

(** s is the direction d times k, exactly. *)
Definition times (k : R) (d s : three float) : Prop :=
  B2R (at_x s) = (k * B2R (at_x d))%R /\ B2R (at_y s) = (k * B2R (at_y d))%R /\
  B2R (at_z s) = (k * B2R (at_z d))%R.

(** It is the direction of the same points, at the k-th part of the parameter. *)
Lemma same_points : forall (c : convention) (o d s lo hi : three float) (k t : R),
  (0 < k)%R -> times k d s -> ray_in c o d lo hi t -> ray_in c o s lo hi (t / k).
Proof.
  intros c o d s lo hi k t Hk (Ex & Ey & Ez) H. unfold ray_in. rewrite Ex, Ey, Ez.
  assert (E : forall x, (t / k * (k * x) = t * x)%R) by (intros; field; lra).
  now rewrite !E.
Qed.

(** So a ray may be prepared by its direction times any k > 0
    (octree/geometry/include/graze/octree/scaled_direction.hpp), in both conventions. *)
Theorem never_miss_scaled : forall (c : convention) (o d s lo hi : three float) (k : R),
  finite3 o -> finite3 s -> finite3 lo -> finite3 hi -> (0 < k)%R -> times k d s ->
  (exists t, (0 <= t)%R /\ ray_in c o d lo hi t) ->
  let r := prepare o s in
  passes _ _ (within c (at_x r) (at_x lo) (at_x hi)) (within c (at_y r) (at_y lo) (at_y hi))
    (within c (at_z r) (at_z lo) (at_z hi)) = true.
Proof.
  intros c o d s lo hi k Fo Fs Fl Fh Hk T (t & Ht & B).
  apply never_miss_within with (t / k)%R; trivial.
  - apply Rmult_le_pos; trivial. now apply Rlt_le, Rinv_0_lt_compat.
  - now apply same_points with d.
Qed.

(** The test never misses over upward rounding and negation either. *)
Theorem never_miss_upward : forall (o d lo hi : three float),
  finite3 o -> finite3 d -> finite3 lo -> finite3 hi ->
  (exists t, (0 <= t)%R /\ ray_in closed o d lo hi t) ->
  touches_box _ _ upward (Model.prepare _ _ upward o d) lo hi = true.
Proof. rewrite upward_is_directed. exact never_miss. Qed.

(** Nor over any backend whose operations are the directed ones, on every input. *)
Theorem never_miss_backend : forall b : backend prec emax,
  (forall x y, sub_down _ _ b x y = Bminus mode_DN x y) ->
  (forall x y, sub_up _ _ b x y = Bminus mode_UP x y) ->
  (forall x y, mul_down _ _ b x y = Bmult mode_DN x y) ->
  (forall x y, mul_up _ _ b x y = Bmult mode_UP x y) ->
  forall o d lo hi : three float,
  finite3 o -> finite3 d -> finite3 lo -> finite3 hi ->
  (exists t, (0 <= t)%R /\ ray_in closed o d lo hi t) ->
  touches_box _ _ b (Model.prepare _ _ b o d) lo hi = true.
Proof.
  intros b Sd Su Md Mu. replace b with directed; [exact never_miss |].
  destruct b as [sd su md mu]. unfold Model.directed. simpl in *.
  f_equal; do 2 (apply functional_extensionality; intro); auto.
Qed.

(** No bound is NaN: with constants as preparation makes them and finite planes. *)
Theorem lowb_never_nan : forall (a : axis) (C : R) (p q : float),
  factor a C -> is_finite p = true -> is_finite q = true -> is_nan (lowb a p q) = false.
Proof. intros a C p q H Fp Fq. eapply below_not_nan. now apply lowb_encloses with (1 := H). Qed.

Theorem uppb_never_nan : forall (a : axis) (C : R) (p q : float),
  factor a C -> is_finite p = true -> is_finite q = true -> is_nan (uppb a p q) = false.
Proof. intros a C p q H Fp Fq. eapply above_not_nan. now apply uppb_encloses with (1 := H). Qed.

(** No bound of enter_at or leave_at is NaN, in any direction. *)
Lemma enter_at_never_nan : forall (a : axis) (C : R) (p : float),
  factor a C -> is_finite (origin a) = true -> is_finite p = true -> is_nan (enter_at a p) = false.
Proof.
  intros a C p H Fo Fp. unfold Model.enter_at. destruct (direction a).
  - now apply lowb_never_nan with C.
  - now destruct (p <=? origin a).
  - now apply lowb_never_nan with C.
Qed.

Lemma leave_at_never_nan : forall (c : convention) (a : axis) (C : R) (p : float),
  factor a C -> is_finite (origin a) = true -> is_finite p = true -> is_nan (leave_at c a p) = false.
Proof.
  intros c a C p H Fo Fp. unfold Model.leave_at. destruct (direction a).
  - now apply uppb_never_nan with C.
  - now destruct (match c with closed => _ | owned => _ end).
  - now apply uppb_never_nan with C.
Qed.

(** Hence no interval of a prepared ray holds a NaN, for every finite ray and plane. *)
Theorem within_never_nan : forall (c : convention) (o d other1 other2 lo hi : float),
  is_finite o = true -> is_finite other1 = true -> is_finite other2 = true ->
  is_finite lo = true -> is_finite hi = true ->
  let i := within c (prepare_axis o d other1 other2) lo hi in
  is_nan (enter i) = false /\ is_nan (leave i) = false.
Proof.
  intros c o d x y lo hi Fo Fx Fy Fl Fh i.
  pose proof (prepare_axis_encloses o d x y Fx Fy) as H.
  unfold i, Model.within. destruct (direction _); simpl; split;
    solve [now apply enter_at_never_nan with (1 := H) | now apply leave_at_never_nan with (1 := H)].
Qed.

End Never_miss.

(** Binary64. For finite o, d, lo, hi, if o + t d is in the closed box for some real t >= 0, the test
    over IEEE 754's double is true. *)
Theorem never_miss_binary64 : forall o d lo hi : three (float 53 1024),
  finite3 _ _ o -> finite3 _ _ d -> finite3 _ _ lo -> finite3 _ _ hi ->
  (exists t, (0 <= t)%R /\ ray_in _ _ closed o d lo hi t) ->
  touches_box 53 1024 (directed 53 1024) (prepare 53 1024 (directed 53 1024) o d) lo hi = true.
Proof. exact (never_miss 53 1024). Qed.

Theorem never_miss_upward_binary64 : forall o d lo hi : three (float 53 1024),
  finite3 _ _ o -> finite3 _ _ d -> finite3 _ _ lo -> finite3 _ _ hi ->
  (exists t, (0 <= t)%R /\ ray_in _ _ closed o d lo hi t) ->
  touches_box 53 1024 (upward 53 1024) (prepare 53 1024 (upward 53 1024) o d) lo hi = true.
Proof. exact (never_miss_upward 53 1024). Qed.

Definition never_miss_owned_binary64 := never_miss_owned 53 1024.
Definition never_miss_scaled_binary64 := never_miss_scaled 53 1024.
Definition bounds_enclose_binary64 := bounds_enclose 53 1024.
Definition lowb_encloses_binary64 := lowb_encloses 53 1024.
Definition uppb_encloses_binary64 := uppb_encloses 53 1024.
Definition within_never_nan_binary64 := within_never_nan 53 1024.
