(** A child that passes implies that its parent passes.

    For directed rounding `lowb` and `uppb` preserve order: where the exact difference grows, the
    bound does not fall ([lowb_monotone], [uppb_monotone]; together, [ordered]). So a box within
    another has the narrower intervals ([touches_box_monotone]), and in the split of
    octree/tree/include/graze/octree/sound.hpp, where a child takes one bound from its parent and
    evaluates the other at the mid-plane, the evaluated one tightens ([half_within_parent]). What is
    wider than a passing interval passes; hence [split_monotone]: a child that passes implies that its
    parent does, at each level of a descent.

    What is asked of the constants is 0 <= Cdn <= Cup, Cdn finite, Cup > 0 ([factor_of_floats]);
    [prepare_axis_encloses] shows that preparation delivers it. The part from [ordered] on holds over
    any backend whose bounds preserve order; Nextafter.v uses it for another. *)
From Coq Require Import ZArith Bool Reals Lra SpecFloat.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model Negation Bounds Never_miss.

Section Monotone.
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
Notation factor := (factor prec emax).
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

(** Constants with 0 <= Cdn <= Cup, Cdn finite and Cup > 0 enclose some positive real: all that the
    theorems below need of them. *)
Lemma factor_of_floats : forall a : axis,
  is_finite (c_down a) = true -> zero <=? c_down a = true -> c_down a <=? c_up a = true ->
  zero <? c_up a = true -> exists C, factor a C.
Proof.
  intros a F Z L P. apply le_finite in Z; trivial. simpl in Z.
  destruct (is_finite (c_up a)) eqn:Fu.
  - apply lt_finite in P; trivial. apply le_finite in L; trivial. simpl in P.
    exists (B2R (c_up a)). split; trivial. lra. apply above_finite; trivial. lra.
  - exists (B2R (c_down a) + 1)%R. split; trivial; try lra.
    destruct (c_up a) as [|[]| |]; try discriminate. reflexivity.
Qed.

(** The order of opposites. *)
Lemma le_opposite : forall f g : float, (Bopp f <=? Bopp g) = (g <=? f).
Proof.
  intros f g. destruct (is_nan f) eqn:Nf.
  { destruct f; try discriminate. now destruct g as [|[]| |[]]. }
  destruct (is_nan g) eqn:Ng.
  { destruct g; try discriminate. now destruct f as [|[]| |[]]. }
  rewrite !le_extended by now rewrite ?is_nan_Bopp.
  assert (E : forall h : float, extended _ _ (Bopp h) = (- extended _ _ h)%R).
  { intros h. destruct (is_finite h) eqn:F.
    - assert (X : forall k : float, is_finite k = true -> extended _ _ k = B2R k)
        by now intros [| | |].
      rewrite !X, B2R_Bopp; trivial. now rewrite is_finite_Bopp.
    - destruct h as [|[]| |]; try discriminate; simpl; lra. }
  rewrite !E. case Rle_bool_spec; case Rle_bool_spec; trivial; intros; lra.
Qed.

(** A positive number or +inf times what is below 0 preserves order. *)
Lemma mul_up_monotone : forall (c u v : float) (C : R),
  (0 < C)%R -> above c C -> u <=? v = true -> v <? zero = true ->
  Bmult mode_DN c u <=? Bmult mode_DN c v = true.
Proof.
  intros c u v C HC Hc L N.
  assert (M : u <? zero = true).
  { destruct (le_not_nan _ _ _ _ L) as [Nu Nv]. apply le_iff in L as (_ & _ & L).
    rewrite lt_extended in * by trivial. revert N. case Rlt_bool_spec; try discriminate. intros.
    apply Rlt_bool_true. lra. }
  assert (P : forall w, w <? zero = true -> is_nan (Bmult mode_DN c w) = false).
  { intros w W. destruct c as [sc|[]| |[] mc ec Bc]; try contradiction; try discriminate;
      simpl in Hc; try lra.
    - now destruct w as [|[]| |[]].
    - assert (B2R (B754_finite true mc ec Bc) < 0)%R by now apply F2R_lt_0. simpl in *. lra.
    - destruct (is_finite w) eqn:F; [| now destruct w as [|[]| |]].
      now apply (greatest_not_nan _ _ _ _ (mul_down_greatest _ _ (B754_finite false mc ec Bc) w eq_refl F)). }
  specialize (P v N) as Pv.
  assert (Low : B754_infinity true <=? Bmult mode_DN c v = true).
  { apply le_iff. repeat split; trivial. pose proof (B2R_between _ _ (Bmult mode_DN c v)).
    destruct (Bmult mode_DN c v) as [|[]| |]; try discriminate; cbn -[B2R bpow];
      pose proof (bpow_gt_0 radix2 emax); lra. }
  destruct (is_finite c && is_finite u) eqn:F.
  - apply andb_prop in F as [Fc Fu].
    assert (Fv : is_finite v = true) by (destruct u, v as [|[]| |]; trivial; discriminate).
    apply greatest_monotone with (B2R c * B2R u)%R (B2R c * B2R v)%R;
      try now apply mul_down_greatest.
    apply le_finite in L; trivial. apply above_finite in Hc; trivial. nra.
  - replace (Bmult mode_DN c u) with (@B754_infinity prec emax true); trivial.
    destruct c as [sc|[]| |[] mc ec Bc]; try contradiction; try discriminate; simpl in Hc; try lra.
    + now destruct u as [|[]| |[]].
    + assert (B2R (B754_finite true mc ec Bc) < 0)%R by now apply F2R_lt_0. simpl in *. lra.
    + now destruct u as [|[]| |[]].
Qed.

(** lowb preserves order: where p - q does not fall, neither does the bound. *)
Theorem lowb_monotone : forall (a : axis) (C : R) (p q p' q' : float),
  factor a C ->
  is_finite p = true -> is_finite q = true -> is_finite p' = true -> is_finite q' = true ->
  (B2R p - B2R q <= B2R p' - B2R q')%R -> lowb a p q <=? lowb a p' q' = true.
Proof.
  intros a C p q p' q' [HC Fd [Hd0 HdC] Hu] Fp Fq Fp' Fq' L. unfold Model.lowb. cbn -[Bminus Bmult].
  pose proof (sub_down_greatest _ _ p q Fp Fq) as G. set (u := Bminus mode_DN p q) in *.
  pose proof (sub_down_greatest _ _ p' q' Fp' Fq') as G'. set (u' := Bminus mode_DN p' q') in *.
  pose proof (greatest_monotone _ _ _ _ _ _ G G' L) as Lu.
  pose proof (greatest_sign _ _ _ _ G) as S. pose proof (greatest_sign _ _ _ _ G') as S'.
  (* where it is not below 0, the difference is finite, and so is the product *)
  assert (NN : forall (v : float) r, greatest_below _ _ v r -> (0 <= r)%R -> is_finite v = true /\ (0 <= B2R v)%R).
  { intros v r Gv Hr.
    assert (Z : zero <=? v = true) by now apply Gv.
    assert (F : is_finite v = true).
    { apply greatest_is_below in Gv. destruct v as [|[]| |]; trivial; try discriminate; contradiction. }
    split; trivial. now apply le_finite in Z. }
  destruct (u <? zero) eqn:N; destruct (u' <? zero) eqn:N'.
  - now apply mul_up_monotone with C.
  - assert (Hr : (B2R p - B2R q < 0)%R) by (revert S; now case Rlt_bool_spec).
    assert (Hr' : (0 <= B2R p' - B2R q')%R) by (revert S'; now case Rlt_bool_spec).
    destruct (NN _ _ G' Hr') as [Fu' Hu'].
    apply le_trans with zero.
    + apply below_above with 0%R; [| simpl; lra].
      apply below_trans with (C * (B2R p - B2R q))%R; [| nra].
      apply mul_up_factor; trivial. now apply greatest_is_below.
    + apply mul_down_greatest; trivial. simpl. now apply Rmult_le_pos.
  - assert (Hr : (0 <= B2R p - B2R q)%R) by (revert S; now case Rlt_bool_spec).
    assert (Hr' : (B2R p' - B2R q' < 0)%R) by (revert S'; now case Rlt_bool_spec).
    lra.
  - assert (Hr : (0 <= B2R p - B2R q)%R) by (revert S; now case Rlt_bool_spec).
    assert (Hr' : (0 <= B2R p' - B2R q')%R) by (revert S'; now case Rlt_bool_spec).
    destruct (NN _ _ G Hr) as [Fu _]. destruct (NN _ _ G' Hr') as [Fu' _].
    apply greatest_monotone with (B2R (c_down a) * B2R u)%R (B2R (c_down a) * B2R u')%R;
      try now apply mul_down_greatest.
    apply le_finite in Lu; trivial. now apply Rmult_le_compat_l.
Qed.

(** uppb preserves order. *)
Theorem uppb_monotone : forall (a : axis) (C : R) (p q p' q' : float),
  factor a C ->
  is_finite p = true -> is_finite q = true -> is_finite p' = true -> is_finite q' = true ->
  (B2R p - B2R q <= B2R p' - B2R q')%R -> uppb a p q <=? uppb a p' q' = true.
Proof.
  intros a C p q p' q' H Fp Fq Fp' Fq' L. rewrite !uppb_is_opposite_lowb, le_opposite.
  apply lowb_monotone with C; trivial. lra.
Qed.

(** Both bounds of the axis preserve order over the backend b, and hence are not NaN. *)
Definition ordered (b : backend prec emax) (a : axis) : Prop := forall p q p' q' : float,
  is_finite p = true -> is_finite q = true -> is_finite p' = true -> is_finite q' = true ->
  (B2R p - B2R q <= B2R p' - B2R q')%R ->
  Model.lowb _ _ b a p q <=? Model.lowb _ _ b a p' q' = true /\
  Model.uppb _ _ b a p q <=? Model.uppb _ _ b a p' q' = true.

(** Over the directed operations they do. *)
Theorem directed_ordered : forall (a : axis) (C : R), factor a C -> ordered directed a.
Proof.
  intros a C H p q p' q' Fp Fq Fp' Fq' L.
  split; [now apply lowb_monotone with C | now apply uppb_monotone with C].
Qed.

(** A prepared ray's origin and constants meet what is asked. *)
Lemma prepare_ordered : forall o d : three float, finite3 _ _ o -> finite3 _ _ d ->
  all3 (ordered directed) (prepare o d) /\ all3 (fun a => is_finite (origin a) = true) (prepare o d).
Proof.
  intros [ox oy oz] [dx dy dz] (Fox & Foy & Foz) (Fdx & Fdy & Fdz).
  repeat apply conj; trivial; eapply directed_ordered; now apply prepare_axis_encloses.
Qed.

(** ** Over any backend whose bounds preserve order *)

Section Ordered.
Variable b : backend prec emax.
Notation enter_at := (Model.enter_at prec emax b).
Notation leave_at := (Model.leave_at prec emax b).
Notation within := (Model.within prec emax b).
Notation half := (Model.half prec emax b).
Notation ordered := (ordered b).

(** The planes by which the ray enters and leaves [lo, hi]. *)
Definition entry (a : axis) (lo hi : float) : float :=
  match direction a with backward => hi | _ => lo end.
Definition exit (a : axis) (lo hi : float) : float :=
  match direction a with backward => lo | _ => hi end.

(** p' is no nearer than p along the ray's heading. *)
Definition along (a : axis) (p p' : float) : Prop :=
  match direction a with backward => (B2R p' <= B2R p)%R | _ => (B2R p <= B2R p')%R end.

(** A later plane is entered later. *)
Lemma enter_at_monotone : forall (a : axis) (p p' : float),
  ordered a -> is_finite (origin a) = true -> is_finite p = true -> is_finite p' = true ->
  along a p p' -> enter_at a p <=? enter_at a p' = true.
Proof.
  intros a p p' H Fo Fp Fp' L. unfold along in L. unfold Model.enter_at.
  destruct (direction a); try (apply H; trivial; lra).
  destruct (p' <=? origin a) eqn:E'.
  - assert (E : p <=? origin a = true).
    { apply le_finite; trivial. apply le_finite in E'; trivial. lra. }
    now rewrite E.
  - now destruct (p <=? origin a).
Qed.

(** A later plane is left later; a closed face is left no earlier than the same face half-open. *)
Lemma leave_at_monotone : forall (c c' : convention) (a : axis) (p p' : float),
  ordered a -> is_finite (origin a) = true -> is_finite p = true -> is_finite p' = true ->
  (c' = closed \/ c' = c) -> along a p p' -> leave_at c a p <=? leave_at c' a p' = true.
Proof.
  intros c c' a p p' H Fo Fp Fp' Conv L. unfold along in L. unfold Model.leave_at.
  destruct (direction a); try (apply H; trivial; lra).
  set (x := match c with closed => _ | owned => _ end).
  set (x' := match c' with closed => _ | owned => _ end).
  assert (I : x = true -> x' = true).
  { unfold x, x'. destruct c, c'; intros E;
      try (destruct Conv; discriminate);
      (apply le_finite in E || apply lt_finite in E); trivial;
      (apply le_finite || apply lt_finite); trivial; lra. }
  destruct x; [now rewrite I | now destruct x'].
Qed.

(** The child's interval is within the parent's; no NaN is involved. *)
Definition narrower (child parent : interval) : Prop :=
  enter parent <=? enter child = true /\ leave child <=? leave parent = true.

Lemma narrower_trans : forall x y z, narrower x y -> narrower y z -> narrower x z.
Proof.
  intros x y z [E L] [E' L']. split.
  - now apply le_trans with (enter y).
  - now apply le_trans with (leave y).
Qed.

(** Intersections of narrower intervals are narrower. *)
Lemma common_narrower : forall x y x' y' : interval,
  narrower x x' -> narrower y y' -> narrower (common _ _ x y) (common _ _ x' y').
Proof.
  intros x y x' y' [Ex Lx] [Ey Ly]. apply le_iff in Ex, Lx, Ey, Ly.
  destruct Ex as (N1 & N2 & Ex), Lx as (N3 & N4 & Lx), Ey as (N5 & N6 & Ey), Ly as (N7 & N8 & Ly).
  unfold narrower, common. simpl. rewrite !lt_extended by trivial.
  split; do 2 (case Rlt_bool_spec; intros); apply le_iff; repeat split; trivial; lra.
Qed.

(** If narrower intervals pass, so do the wider. *)
Theorem passes_monotone : forall x y z x' y' z' : interval,
  narrower x x' -> narrower y y' -> narrower z z' ->
  passes _ _ x y z = true -> passes _ _ x' y' z' = true.
Proof.
  intros x y z x' y' z' Hx Hy Hz.
  pose proof (common_narrower _ _ _ _ (common_narrower _ _ _ _ Hx Hy) Hz) as [E L].
  unfold passes, passes2.
  set (i := common _ _ _ z) in *. set (i' := common _ _ _ z') in *.
  apply le_iff in E, L. destruct E as (N1 & N2 & E), L as (N3 & N4 & L).
  rewrite !lt_extended by trivial.
  repeat (case Rlt_bool_spec; simpl; intro); intros; trivial; try discriminate; simpl in *; exfalso; lra.
Qed.

(** The interval of an axis within [lo, hi]: entered by the plane on the side of entry, left by that
    on the side of exit, which is closed (the root's far face) or as the convention has it. *)
Definition of_cell (c : convention) (a : axis) (lo hi : float) (i : interval) : Prop :=
  enter i = enter_at a (entry a lo hi) /\
  exists c', (c' = closed \/ c' = c) /\ leave i = leave_at c' a (exit a lo hi).

(** The root's interval, with closed faces whatever the convention, is of that form. *)
Lemma of_cell_root : forall (c : convention) (a : axis) (lo hi : float),
  of_cell c a lo hi (within closed a lo hi).
Proof.
  intros c a lo hi. unfold of_cell, entry, exit, Model.within.
  destruct (direction a); split; trivial; exists closed; auto.
Qed.

(** Both halves of an interval of that form are of that form, each in its half of the cell. *)
Lemma of_cell_half : forall (c : convention) (a : axis) (lo hi mid : float) (i : interval) (upper : bool),
  of_cell c a lo hi i ->
  of_cell c a (if upper then mid else lo) (if upper then hi else mid) (half c a i mid upper).
Proof.
  intros c a lo hi mid i upper [E (c' & Conv & V)].
  unfold of_cell, entry, exit, Model.half in *.
  destruct (direction a), upper; simpl; split; trivial;
    solve [exists c'; auto | exists c; auto].
Qed.

(** A half is narrower than its parent: it shares one bound and tightens the other. *)
Theorem half_within_parent : forall (c : convention) (a : axis) (lo hi mid : float)
    (i : interval) (upper : bool),
  ordered a -> is_finite (origin a) = true ->
  is_finite lo = true -> is_finite mid = true -> is_finite hi = true ->
  (B2R lo <= B2R mid <= B2R hi)%R ->
  of_cell c a lo hi i -> narrower (half c a i mid upper) i.
Proof.
  intros c a lo hi mid i upper H Fo Fl Fm Fh [L1 L2] [E (c' & Conv & V)].
  pose proof (fun p p' => enter_at_monotone a p p' H Fo) as Em.
  pose proof (fun p p' => leave_at_monotone c c' a p p' H Fo) as Lm.
  assert (Self : forall p, along a p p) by (intros p; unfold along; destruct (direction a); lra).
  pose proof (fun p F => Em p p F F (Self p)) as En.
  pose proof (fun p F => leave_at_monotone c' c' a p p H Fo F F (or_intror eq_refl) (Self p)) as Ln.
  clear Self.
  unfold narrower, entry, exit, along, Model.half in *.
  destruct (direction a), upper; simpl; rewrite E, V; split;
    solve [apply En; trivial | apply Ln; trivial | apply Em; trivial | apply Lm; trivial].
Qed.

(** A child of the split that passes implies that its parent passes. Each axis may be split or, by
    [narrower], be any narrower interval. *)
Theorem split_monotone : forall (c : convention) (r : three axis) (lo mid hi : three float)
    (at_ : three interval) (ux uy uz : bool),
  all3 ordered r -> all3 (fun a => is_finite (origin a) = true) r ->
  finite3 _ _ lo -> finite3 _ _ mid -> finite3 _ _ hi ->
  (B2R (at_x lo) <= B2R (at_x mid) <= B2R (at_x hi))%R ->
  (B2R (at_y lo) <= B2R (at_y mid) <= B2R (at_y hi))%R ->
  (B2R (at_z lo) <= B2R (at_z mid) <= B2R (at_z hi))%R ->
  of_cell c (at_x r) (at_x lo) (at_x hi) (at_x at_) ->
  of_cell c (at_y r) (at_y lo) (at_y hi) (at_y at_) ->
  of_cell c (at_z r) (at_z lo) (at_z hi) (at_z at_) ->
  passes _ _ (half c (at_x r) (at_x at_) (at_x mid) ux) (half c (at_y r) (at_y at_) (at_y mid) uy)
    (half c (at_z r) (at_z at_) (at_z mid) uz) = true ->
  passes _ _ (at_x at_) (at_y at_) (at_z at_) = true.
Proof.
  intros c r lo mid hi at_ ux uy uz (Hx & Hy & Hz) (Ox & Oy & Oz) (Flx & Fly & Flz)
    (Fmx & Fmy & Fmz) (Fhx & Fhy & Fhz) Lx Ly Lz Sx Sy Sz.
  apply passes_monotone.
  - now apply (half_within_parent c _ (at_x lo) (at_x hi)).
  - now apply (half_within_parent c _ (at_y lo) (at_y hi)).
  - now apply (half_within_parent c _ (at_z lo) (at_z hi)).
Qed.

(** The interval of a smaller range of the axis is narrower. *)
Theorem within_monotone : forall (c : convention) (a : axis) (lo hi lo' hi' : float),
  ordered a -> is_finite (origin a) = true ->
  is_finite lo = true -> is_finite hi = true -> is_finite lo' = true -> is_finite hi' = true ->
  (B2R lo' <= B2R lo)%R -> (B2R hi <= B2R hi')%R ->
  narrower (within c a lo hi) (within c a lo' hi').
Proof.
  intros c a lo hi lo' hi' H Fo Fl Fh Fl' Fh' L U.
  pose proof (fun p p' => enter_at_monotone a p p' H Fo) as Em.
  pose proof (fun p p' => leave_at_monotone c c a p p' H Fo) as Lm.
  unfold narrower, along, Model.within in *.
  destruct (direction a); simpl; split; (apply Em || apply Lm); auto.
Qed.

(** If the inner of two boxes passes, so does the outer. *)
Theorem touches_box_ordered : forall (r : three axis) (lo hi lo' hi' : three float),
  all3 ordered r -> all3 (fun a => is_finite (origin a) = true) r ->
  finite3 _ _ lo -> finite3 _ _ hi -> finite3 _ _ lo' -> finite3 _ _ hi' ->
  (B2R (at_x lo') <= B2R (at_x lo))%R -> (B2R (at_x hi) <= B2R (at_x hi'))%R ->
  (B2R (at_y lo') <= B2R (at_y lo))%R -> (B2R (at_y hi) <= B2R (at_y hi'))%R ->
  (B2R (at_z lo') <= B2R (at_z lo))%R -> (B2R (at_z hi) <= B2R (at_z hi'))%R ->
  touches_box _ _ b r lo hi = true -> touches_box _ _ b r lo' hi' = true.
Proof.
  intros r lo hi lo' hi' (Hx & Hy & Hz) (Ox & Oy & Oz) (? & ? & ?) (? & ? & ?) (? & ? & ?) (? & ? & ?)
    Lx Ux Ly Uy Lz Uz.
  apply passes_monotone; now apply within_monotone.
Qed.

End Ordered.

(** A box that passes lies in no box that does not: directed operations, a prepared ray. *)
Theorem touches_box_monotone : forall (o d lo hi lo' hi' : three float),
  finite3 _ _ o -> finite3 _ _ d ->
  finite3 _ _ lo -> finite3 _ _ hi -> finite3 _ _ lo' -> finite3 _ _ hi' ->
  (B2R (at_x lo') <= B2R (at_x lo))%R -> (B2R (at_x hi) <= B2R (at_x hi'))%R ->
  (B2R (at_y lo') <= B2R (at_y lo))%R -> (B2R (at_y hi) <= B2R (at_y hi'))%R ->
  (B2R (at_z lo') <= B2R (at_z lo))%R -> (B2R (at_z hi) <= B2R (at_z hi'))%R ->
  touches_box _ _ directed (prepare o d) lo hi = true ->
  touches_box _ _ directed (prepare o d) lo' hi' = true.
Proof.
  intros o d lo hi lo' hi' Fo Fd. destruct (prepare_ordered o d Fo Fd) as [H O].
  now apply touches_box_ordered.
Qed.

(** The split of a prepared ray, directed operations: if a child passes, its parent passes. *)
Theorem child_passes_parent_passes : forall (c : convention) (o d lo mid hi : three float)
    (at_ : three interval) (ux uy uz : bool),
  finite3 _ _ o -> finite3 _ _ d -> finite3 _ _ lo -> finite3 _ _ mid -> finite3 _ _ hi ->
  (B2R (at_x lo) <= B2R (at_x mid) <= B2R (at_x hi))%R ->
  (B2R (at_y lo) <= B2R (at_y mid) <= B2R (at_y hi))%R ->
  (B2R (at_z lo) <= B2R (at_z mid) <= B2R (at_z hi))%R ->
  let r := prepare o d in
  of_cell directed c (at_x r) (at_x lo) (at_x hi) (at_x at_) ->
  of_cell directed c (at_y r) (at_y lo) (at_y hi) (at_y at_) ->
  of_cell directed c (at_z r) (at_z lo) (at_z hi) (at_z at_) ->
  passes _ _ (half c (at_x r) (at_x at_) (at_x mid) ux) (half c (at_y r) (at_y at_) (at_y mid) uy)
    (half c (at_z r) (at_z at_) (at_z mid) uz) = true ->
  passes _ _ (at_x at_) (at_y at_) (at_z at_) = true.
Proof.
  intros c o d lo mid hi at_ ux uy uz Fo Fd Fl Fm Fh Lx Ly Lz r.
  destruct (prepare_ordered o d Fo Fd) as [H O].
  now apply (split_monotone directed c r lo mid hi at_ ux uy uz).
Qed.

End Monotone.

(** Binary64. *)
Definition lowb_monotone_binary64 := lowb_monotone 53 1024.
Definition uppb_monotone_binary64 := uppb_monotone 53 1024.
Definition half_within_parent_binary64 := half_within_parent 53 1024.
Definition split_monotone_binary64 := split_monotone 53 1024.
Definition child_passes_parent_passes_binary64 := child_passes_parent_passes 53 1024.
Definition touches_box_monotone_binary64 := touches_box_monotone 53 1024.
