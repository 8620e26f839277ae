(** The floating-point descent of octree/tree/include/graze/octree/{descent,sound}.hpp reports what the
    ray meets, in order, end to end: Model_descent.v's [descend] from a root cube whose octants are
    exact (Coordinates.v), for every finite ray and any tree.

    A backend enters by [bounds_enclose] alone: lowb and uppb of a prepared axis are no NaN and
    enclose C (p - q), the theorems of Never_miss.v.

    - [closed_reports]: in `closed`, every octant of the last level that the ray touches at some real
      t >= 0, and whose ancestors the tree keeps, is in the list.
    - [owned_reports]: in `owned` (and in `closed`), every octant that owns a point of the ray.
    - [owned_in_order]: in `owned`, of two octants the one that owns the earlier point comes first.
    - [visited_once]: no octant comes twice; [visited_exact]: each cell in the list has the exact
      corners of the octant that its path names, which is of the last level and kept. *)
From Coq Require Import ZArith NArith Reals Bool List Sorted Lia Lra.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model Model_descent Bounds Never_miss Negation Coordinates Order.
Import ListNotations.
Open Scope R_scope.

Local Arguments below {prec emax}.
Local Arguments above {prec emax}.
Local Arguments encloses {prec emax}.
Local Arguments finite3 {prec emax}.
Local Arguments below_trans {prec emax}.
Local Arguments lowb {prec emax}.
Local Arguments uppb {prec emax}.
Local Arguments enter_at {prec emax}.
Local Arguments leave_at {prec emax}.
Local Arguments within {prec emax}.
Local Arguments common {prec emax}.
Local Arguments passes2 {prec emax}.
Local Arguments passes {prec emax}.
Local Arguments half {prec emax}.
Local Arguments prepare_axis {prec emax Hprec Hmax}.
Local Arguments prepare {prec emax Hprec Hmax}.
Local Arguments enter {prec emax}.
Local Arguments leave {prec emax}.
Local Arguments origin {prec emax}.
Local Arguments direction {prec emax}.
Local Arguments lt {prec emax}.
Local Arguments le {prec emax}.
Local Arguments zero {prec emax}.
Local Arguments lo {prec emax}.
Local Arguments size {prec emax}.
Local Arguments mid_at {prec emax Hprec Hmax}.
Local Arguments hi_at {prec emax Hprec Hmax}.
Local Arguments child {prec emax Hprec Hmax}.
Local Arguments child_state {prec emax Hprec Hmax}.
Local Arguments split {prec emax Hprec Hmax}.
Local Arguments visits {prec emax Hprec Hmax}.
Local Arguments descend {prec emax Hprec Hmax}.
Local Arguments enter_root {prec emax Hprec Hmax}.
Local Arguments origin_sides {prec emax Hprec Hmax}.
Local Arguments origin_side {prec emax}.
Local Arguments passed {prec emax}.
Local Arguments on_grid {prec emax}.

Section Descent.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.

Notation float := (float prec emax).
Notation interval := (interval prec emax).
Notation axis := (axis prec emax).
Notation cube := (cube prec emax).
Notation backend := (backend prec emax).

(** ** Bounds that hold *)

(** What is asked of a backend. *)
Definition bounds_enclose (b : backend) : Prop :=
  forall o d d1 d2 p q : float,
  is_finite o = true -> is_finite d = true -> is_finite d1 = true -> is_finite d2 = true ->
  is_finite p = true -> is_finite q = true ->
  below (lowb b (prepare_axis b o d d1 d2) p q) (magnitude (B2R d1) * magnitude (B2R d2) * (B2R p - B2R q)) /\
  above (uppb b (prepare_axis b o d d1 d2) p q) (magnitude (B2R d1) * magnitude (B2R d2) * (B2R p - B2R q)).

Lemma above_trans : forall (f : float) r r', above f r -> r' <= r -> above f r'.
Proof. intros [z|z| |z n e H] r r'; simpl; trivial; intros; lra. Qed.

(** ** The planes of one axis *)

Section Axis.
Variable b : backend.
Hypothesis enclose : bounds_enclose b.
Variables o d d1 d2 : float.
Hypothesis (Fo : is_finite o = true) (Fd : is_finite d = true) (F1 : is_finite d1 = true) (F2 : is_finite d2 = true).

Let x : axis := prepare_axis b o d d1 d2.
(** The factor of the scaled t, and where the ray is on this axis at t. *)
Let C : R := magnitude (B2R d1) * magnitude (B2R d2).
Let K : R := C * magnitude (B2R d).
Let at_ (t : R) : R := B2R o + t * B2R d.

Lemma C_pos : 0 < C.
Proof. apply Rmult_lt_0_compat; apply magnitude_positive. Qed.

Inductive going : heading -> Prop :=
  | going_backward : B2R d < 0 -> K = - (C * B2R d) -> going backward
  | going_across : B2R d = 0 -> going across
  | going_forward : 0 < B2R d -> K = C * B2R d -> going forward.

Lemma direction_correct : going (direction x).
Proof.
  unfold x, prepare_axis. simpl. unfold lt.
  rewrite (Bltb_correct _ _ d zero Fd eq_refl), (Bltb_correct _ _ zero d eq_refl Fd). simpl.
  case Rlt_bool_spec; intros A.
  - apply going_backward; [exact A|]. unfold K, magnitude. rewrite Req_bool_false by lra.
    rewrite Rabs_left by exact A. ring.
  - case Rlt_bool_spec; intros B.
    + apply going_forward; [exact B|]. unfold K, magnitude. rewrite Req_bool_false by lra.
      rewrite Rabs_pos_eq by lra. ring.
    + apply going_across. lra.
Qed.

(** The ray is past the plane p, seen along its way... *)
Definition past (t p : R) : Prop :=
  match direction x with backward => at_ t <= p | _ => p <= at_ t end.
(** ... or not yet past it; on an axis across which it does not move, `owned` excludes the plane. *)
Definition not_past (cv : convention) (t p : R) : Prop :=
  match direction x with
  | backward => p <= at_ t
  | forward => at_ t <= p
  | across => match cv with closed => at_ t <= p | owned => at_ t < p end
  end.

Lemma enter_at_holds : forall (p : float) t, is_finite p = true -> past t (B2R p) ->
  below (enter_at b x p) (K * t).
Proof.
  intros p t Fp. unfold past, enter_at. assert (PC := C_pos).
  destruct direction_correct as [D E|D|D E]; unfold at_; intros H.
  - apply below_trans with (1 := proj1 (enclose o d d1 d2 o p Fo Fd F1 F2 Fo Fp)).
    fold C. rewrite E. nra.
  - change (origin x) with o. unfold le. rewrite Bleb_correct by assumption.
    rewrite Rle_bool_true by (rewrite D in H; lra). reflexivity.
  - apply below_trans with (1 := proj1 (enclose o d d1 d2 p o Fo Fd F1 F2 Fp Fo)).
    fold C. rewrite E. nra.
Qed.

Lemma leave_at_holds : forall cv (p : float) t, is_finite p = true -> not_past cv t (B2R p) ->
  above (leave_at b cv x p) (K * t).
Proof.
  intros cv p t Fp. unfold not_past, leave_at. assert (PC := C_pos).
  destruct direction_correct as [D E|D|D E]; unfold at_; intros H.
  - apply above_trans with (1 := proj2 (enclose o d d1 d2 o p Fo Fd F1 F2 Fo Fp)).
    fold C. rewrite E. nra.
  - change (origin x) with o. rewrite D in H. destruct cv.
    + unfold le. rewrite Bleb_correct, Rle_bool_true by (assumption || lra). reflexivity.
    + unfold lt. rewrite Bltb_correct, Rlt_bool_true by (assumption || lra). reflexivity.
  - apply above_trans with (1 := proj2 (enclose o d d1 d2 p o Fo Fd F1 F2 Fp Fo)).
    fold C. rewrite E. nra.
Qed.

(** Between two planes: the root. *)
Lemma within_holds : forall (l h : float) t, is_finite l = true -> is_finite h = true ->
  B2R l <= at_ t <= B2R h -> encloses (within b closed x l h) (K * t).
Proof.
  intros l h t Fl Fh H.
  assert (P := fun p => enter_at_holds p t). assert (Q := fun p => leave_at_holds closed p t).
  unfold past, not_past in P, Q. unfold encloses, within.
  destruct (direction x); simpl; split; try apply P; try apply Q; tauto.
Qed.

(** On the side of a mid-plane that a child takes. *)
Definition on_side (cv : convention) (upper : bool) (p mid : R) : Prop :=
  if upper then mid <= p else match cv with closed => p <= mid | owned => p < mid end.

Lemma half_holds : forall cv i (mid : float) upper t, is_finite mid = true ->
  encloses i (K * t) -> on_side cv upper (at_ t) (B2R mid) -> encloses (half b cv x i mid upper) (K * t).
Proof.
  intros cv i mid upper t Fm [A B] H.
  assert (P := fun p => enter_at_holds p t). assert (Q := fun p => leave_at_holds cv p t).
  unfold past, not_past in P, Q. unfold encloses, half, on_side in *.
  destruct (direction x), upper; simpl; (split; [try exact A; apply P; try exact Fm
    | try exact B; apply Q; try exact Fm]); destruct cv; lra.
Qed.

End Axis.

(** ** Cubes and their octants *)

Definition real_three (v : three float) : three R := triple (B2R (at_x v)) (B2R (at_y v)) (B2R (at_z v)).
Definition real_cell (c : cube) : cell := {| corner := real_three (lo c); edge := B2R (size c) |}.

Variable m : mode.

Lemma if_B2R : forall (u : bool) (x y : float), B2R (if u then x else y) = if u then B2R x else B2R y.
Proof. intros [|]; reflexivity. Qed.

(** The child's corners are the exact ones. *)
Theorem child_exact : forall g n c i, on_grid g (S n) c ->
  real_cell (child m c i) = real_child (real_cell c) i.
Proof.
  intros g n c i [X [Y Z]].
  destruct (mid_exact prec emax m _ _ _ _ X) as [_ MX], (mid_exact prec emax m _ _ _ _ Y) as [_ MY],
    (mid_exact prec emax m _ _ _ _ Z) as [_ MZ], (size_exact prec emax m _ _ _ _ X) as [_ S].
  unfold real_cell, real_child, real_three, mid_plane, child. simpl. rewrite !if_B2R, MX, MY, MZ, S. reflexivity.
Qed.

Lemma edge_positive : forall g n c, on_grid g n c -> 0 < edge (real_cell c).
Proof. intros g n c [X _]. exact (size_positive prec emax _ _ _ _ X). Qed.

(** ** The ray *)

Section Ray.
Variable b : backend.
Hypothesis enclose : bounds_enclose b.
Variables o d : three float.
Hypothesis (Fo : finite3 o) (Fd : finite3 d).
Variable kept : path -> bool.

Notation ray := (prepare b o d).
Notation point t := (point_at (real_three o) (real_three d) t).
Notation visits := (visits m b).

(** The factor of the scaled t, common to the axes. *)
Definition scale : R := magnitude (B2R (at_x d)) * magnitude (B2R (at_y d)) * magnitude (B2R (at_z d)).

Lemma scale_pos : 0 < scale.
Proof. repeat apply Rmult_lt_0_compat; apply magnitude_positive. Qed.

Definition state_encloses (s : state prec emax) (T : R) : Prop :=
  encloses (at_x s) T /\ encloses (at_y s) T /\ encloses (at_z s) T.

Lemma passed_encloses : forall s T, 0 <= T -> state_encloses s T -> passed s = true.
Proof. intros s T HT [X [Y Z]]. now apply (passes_if_common prec emax) with T. Qed.

(** The point is on the child's side of the three mid-planes. *)
Definition in_child (cv : convention) (c : cell) (i : N) (p : three R) : Prop :=
  on_side cv (N.testbit i 0) (at_x p) (mid_plane (at_x (corner c)) (edge c)) /\
  on_side cv (N.testbit i 1) (at_y p) (mid_plane (at_y (corner c)) (edge c)) /\
  on_side cv (N.testbit i 2) (at_z p) (mid_plane (at_z (corner c)) (edge c)).

(** The path leads to the point all the way down. *)
Fixpoint follows (cv : convention) (c : cell) (q : path) (p : three R) : Prop :=
  match q with
  | [] => True
  | i :: q => (i < 8)%N /\ in_child cv c i p /\ follows cv (real_child c i) q p
  end.

Lemma root_holds : forall g n root t, on_grid g n root -> inside (real_cell root) (point t) ->
  state_encloses (enter_root m b ray root) (scale * t).
Proof.
  intros g n root t [X [Y Z]] [IX [IY IZ]].
  destruct Fo as [Fox [Foy Foz]], Fd as [Fdx [Fdy Fdz]].
  destruct (hi_exact prec emax m _ _ _ _ X) as [FX HX], (hi_exact prec emax m _ _ _ _ Y) as [FY HY],
    (hi_exact prec emax m _ _ _ _ Z) as [FZ HZ].
  unfold inside, within_closed in IX, IY, IZ. simpl in IX, IY, IZ.
  unfold state_encloses, enter_root, prepare. simpl. unfold scale. split; [|split].
  - replace (_ * t) with (magnitude (B2R (at_y d)) * magnitude (B2R (at_z d)) * magnitude (B2R (at_x d)) * t) by ring.
    apply within_holds; auto; [apply X | rewrite HX; lra].
  - replace (_ * t) with (magnitude (B2R (at_z d)) * magnitude (B2R (at_x d)) * magnitude (B2R (at_y d)) * t) by ring.
    apply within_holds; auto; [apply Y | rewrite HY; lra].
  - replace (_ * t) with (magnitude (B2R (at_x d)) * magnitude (B2R (at_y d)) * magnitude (B2R (at_z d)) * t) by ring.
    apply within_holds; auto; [apply Z | rewrite HZ; lra].
Qed.

(** A child's state encloses the t of the points on its side, if its parent's does. *)
Lemma child_state_holds : forall cv g n c s i t, on_grid g (S n) c -> state_encloses s (scale * t) ->
  in_child cv (real_cell c) i (point t) -> state_encloses (child_state m b cv ray c s i) (scale * t).
Proof.
  intros cv g n c s i t [X [Y Z]] [SX [SY SZ]] [IX [IY IZ]].
  destruct Fo as [Fox [Foy Foz]], Fd as [Fdx [Fdy Fdz]].
  destruct (mid_exact prec emax m _ _ _ _ X) as [FX HX], (mid_exact prec emax m _ _ _ _ Y) as [FY HY],
    (mid_exact prec emax m _ _ _ _ Z) as [FZ HZ].
  unfold mid_plane in IX, IY, IZ. simpl in IX, IY, IZ. rewrite <- HX in IX. rewrite <- HY in IY. rewrite <- HZ in IZ.
  unfold state_encloses, child_state, prepare. simpl.
  assert (EX : scale * t = magnitude (B2R (at_y d)) * magnitude (B2R (at_z d)) * magnitude (B2R (at_x d)) * t)
    by (unfold scale; ring).
  assert (EY : scale * t = magnitude (B2R (at_z d)) * magnitude (B2R (at_x d)) * magnitude (B2R (at_y d)) * t)
    by (unfold scale; ring).
  assert (EZ : scale * t = magnitude (B2R (at_x d)) * magnitude (B2R (at_y d)) * magnitude (B2R (at_z d)) * t)
    by (unfold scale; ring).
  split; [|split]; [rewrite EX in * | rewrite EY in * | rewrite EZ in *]; apply half_holds; auto.
Qed.

Lemma in_visiting_order : forall side i, (side < 8)%N -> (i < 8)%N -> In i (visiting_order side).
Proof. intros side i Hs Hi. eapply nth_error_In. now apply position_correct. Qed.

Lemma origin_sides_below_8 : forall r c, (origin_sides m r c < 8)%N.
Proof. intros r c. apply index_of_below_8. Qed.

(** What [split] is, and no more, is used of it. *)
Lemma in_split : forall cv c s i T, (i < 8)%N -> 0 <= T -> state_encloses (child_state m b cv ray c s i) T ->
  In i (split m b cv ray c s).
Proof.
  intros cv c s i T Hi HT S. unfold split. apply filter_In. split.
  - apply in_visiting_order; [apply origin_sides_below_8 | exact Hi].
  - now apply passed_encloses with (2 := S).
Qed.

Lemma split_below_8 : forall cv c s i, In i (split m b cv ray c s) -> (i < 8)%N.
Proof.
  intros cv c s i H. unfold split in H. apply filter_In in H. destruct H as [H _].
  generalize (origin_sides_below_8 ray c) H. generalize (origin_sides m ray c). clear. intros side Hs H.
  destruct (below_8 side Hs) as [E|[E|[E|[E|[E|[E|[E|E]]]]]]]; subst side;
    simpl in H; intuition (subst i; reflexivity).
Qed.

Lemma sorted_filter : forall (A : Type) (R : A -> A -> Prop) (f : A -> bool) l,
  StronglySorted R l -> StronglySorted R (filter f l).
Proof.
  intros A R f l S. induction S as [|x l S IH F]; simpl; [constructor|].
  destruct (f x); [|exact IH]. constructor; [exact IH|].
  apply Forall_forall. intros y Hy. apply filter_In in Hy. rewrite Forall_forall in F. now apply F.
Qed.

Lemma visiting_order_sorted : forall side, (side < 8)%N ->
  StronglySorted (fun i j => (position side i < position side j)%N) (visiting_order side).
Proof.
  intros side H. destruct (below_8 side H) as [E|[E|[E|[E|[E|[E|[E|E]]]]]]]; subst side;
    unfold visiting_order, position; simpl; repeat (constructor; try reflexivity).
Qed.

Lemma split_sorted : forall cv c s, StronglySorted
  (fun i j => (position (origin_sides m ray c) i < position (origin_sides m ray c) j)%N) (split m b cv ray c s).
Proof. intros. apply sorted_filter, visiting_order_sorted, origin_sides_below_8. Qed.

(** All octants on a path below [here] are kept. *)
Definition all_kept (here q : path) : Prop :=
  forall p s, q = p ++ s -> p <> [] -> kept (here ++ p) = true.

Lemma all_kept_cons : forall here i q, all_kept here (i :: q) ->
  kept (here ++ [i]) = true /\ all_kept (here ++ [i]) q.
Proof.
  intros here i q H. split.
  - apply (H [i] q); [reflexivity | discriminate].
  - intros p s E Hp. rewrite <- app_assoc. apply (H (i :: p) s); [simpl; now rewrite E | discriminate].
Qed.

Local Opaque Model_descent.split Model_descent.child Model_descent.child_state
  Model_descent.enter_root Model_descent.passed.

(** The descent reports every path that follows a point of the ray. *)
Lemma visits_follows : forall cv g q n here c s t, length q = n -> on_grid g n c -> 0 <= t ->
  state_encloses s (scale * t) -> follows cv (real_cell c) q (point t) -> all_kept here q ->
  In (here ++ q) (map fst (visits cv ray kept n here c s)).
Proof.
  intros cv g. induction q as [|i q IH]; intros n here c s t L G Ht S F A; subst n; simpl.
  - left. now rewrite app_nil_r.
  - destruct F as [Hi [I F]]. destruct (all_kept_cons _ _ _ A) as [A1 A2].
    assert (S' := child_state_holds _ _ _ _ _ _ _ G S I).
    apply in_map_iff.
    assert (H : In (here ++ i :: q)
      (map fst (visits cv ray kept (length q) (here ++ [i]) (child m c i) (child_state m b cv ray c s i)))).
    { replace (here ++ i :: q) with ((here ++ [i]) ++ q) by (now rewrite <- app_assoc).
      apply IH with (t := t); auto.
      - now apply child_on_grid.
      - now rewrite (child_exact g (length q)). }
    apply in_map_iff in H. destruct H as [[r k] [E H]]. exists (r, k). split; [exact E|].
    apply in_flat_map. exists i. split.
    + apply in_split with (3 := S'); [exact Hi | apply Rmult_le_pos; [apply Rlt_le, scale_pos | exact Ht]].
    + now rewrite A1.
Qed.

Notation reported cv root level := (map fst (descend m b cv ray kept root level)).

Lemma descend_follows : forall cv g q root level t, length q = level -> on_grid g level root -> 0 <= t ->
  inside (real_cell root) (point t) -> follows cv (real_cell root) q (point t) -> all_kept [] q ->
  In q (reported cv root level).
Proof.
  intros cv g q root level t L G Ht I F A. unfold descend.
  assert (S := root_holds _ _ _ _ G I).
  rewrite (passed_encloses _ (scale * t)); [| apply Rmult_le_pos; [apply Rlt_le, scale_pos | exact Ht] | exact S].
  exact (visits_follows cv g q level [] root _ t L G Ht S F A).
Qed.

(** Points of a closed octant follow its path. *)
Lemma inside_follows : forall q c p, 0 < edge c -> Forall (fun i => (i < 8)%N) q ->
  inside (cell_at c q) p -> inside c p /\ follows closed c q p.
Proof.
  induction q as [|i q IH]; intros c p Hs A H; [split; [exact H | exact I]|].
  inversion A as [|x y Hi A' E]; subst. simpl in H.
  assert (Hs' : 0 < edge (real_child c i)) by (simpl; lra).
  destruct (IH _ _ Hs' A' H) as [J F].
  split; [now apply child_inside with i|]. simpl. split; [exact Hi|]. split; [|exact F].
  destruct J as [X [Y Z]]. unfold within_closed, in_child, on_side, mid_plane, real_child in *. simpl in *.
  unfold mid_plane in *. destruct (N.testbit i 0), (N.testbit i 1), (N.testbit i 2); lra.
Qed.

(** A point follows the path of its owner, in both conventions. *)
Lemma owner_path_follows : forall cv n c p, follows cv c (owner_path n c p) p.
Proof.
  intros cv. induction n as [|n IH]; intros c p; [exact I|]. simpl. split; [apply index_of_below_8|].
  split; [|apply IH]. unfold in_child, owner.
  destruct (testbit_index_of (Rle_bool (mid_plane (at_x (corner c)) (edge c)) (at_x p))
    (Rle_bool (mid_plane (at_y (corner c)) (edge c)) (at_y p))
    (Rle_bool (mid_plane (at_z (corner c)) (edge c)) (at_z p))) as [-> [-> ->]].
  unfold on_side. repeat split; case Rle_bool_spec; intros; try destruct cv; lra.
Qed.

Lemma owner_path_length : forall n c p, length (owner_path n c p) = n.
Proof. induction n as [|n IH]; intros c p; simpl; [reflexivity | now rewrite IH]. Qed.

(** ** What is reported *)

(** `closed`: every octant of the last level that the ray touches, whose ancestors are kept. *)
Theorem closed_reports : forall g root level q, on_grid g level root ->
  length q = level -> Forall (fun i => (i < 8)%N) q -> all_kept [] q ->
  (exists t, 0 <= t /\ inside (cell_at (real_cell root) q) (point t)) ->
  In q (reported closed root level).
Proof.
  intros g root level q G L A Kq [t [Ht H]].
  destruct (inside_follows _ _ _ (edge_positive _ _ _ G) A H) as [J F].
  exact (descend_follows closed g q root level t L G Ht J F Kq).
Qed.

(** `owned` (and `closed` too): every octant of the last level that owns a point of the ray. *)
Theorem owned_reports : forall cv g root level q, on_grid g level root ->
  length q = level -> Forall (fun i => (i < 8)%N) q -> all_kept [] q ->
  (exists t, 0 <= t /\ inside (real_cell root) (point t) /\
             owns (far_planes (real_cell root)) (cell_at (real_cell root) q) (point t)) ->
  In q (reported cv root level).
Proof.
  intros cv g root level q G L A Kq [t [Ht [J H]]].
  apply owner_path_iff in H; [| apply root_before_far; exact (edge_positive _ _ _ G)
    | now apply inside_owns_root | exact A].
  apply (descend_follows cv g q root level t); auto.
  rewrite H. apply owner_path_follows.
Qed.

(** No point of the ray in the root is lost: the octant that owns it is reported if it is kept. *)
Corollary no_gap : forall cv g root level t, on_grid g level root -> 0 <= t ->
  inside (real_cell root) (point t) -> all_kept [] (owner_path level (real_cell root) (point t)) ->
  In (owner_path level (real_cell root) (point t)) (reported cv root level).
Proof.
  intros cv g root level t G Ht J Kq. apply (descend_follows cv g _ root level t); auto.
  - apply owner_path_length.
  - apply owner_path_follows.
Qed.

(** ** The order of the list *)

(** Strictly before in the lexicographic order. *)
Fixpoint earlier (x y : list N) : Prop :=
  match x, y with
  | i :: x, j :: y => (i < j)%N \/ i = j /\ earlier x y
  | _, _ => False
  end.

Lemma earlier_not_after : forall x y, earlier x y -> lexicographic y x -> False.
Proof.
  induction x as [|i x IH]; intros [|j y] A B; simpl in *; try contradiction.
  destruct A as [A|[A A']], B as [B|[B B']]; try lia. eauto.
Qed.

Lemma lexicographic_refl : forall x, lexicographic x x.
Proof. induction x as [|i x IH]; simpl; auto. Qed.

(** a comes before b in l. *)
Definition before {A : Type} (l : list A) (a b : A) : Prop :=
  exists l1 l2, l = l1 ++ l2 /\ In a l1 /\ In b l2.

Lemma sorted_before : forall (A : Type) (R : A -> A -> Prop) (l : list A) a a', StronglySorted R l ->
  In a l -> In a' l -> a <> a' -> ~ R a' a -> before l a a'.
Proof.
  intros A R l a e S. induction S as [|x l S IH F]; intros Ia Ib D NR; [destruct Ia|].
  destruct Ia as [Ea|Ia].
  - subst x. destruct Ib as [Eb|Ib]; [contradiction|].
    exists [a], l. repeat split; [now left | exact Ib].
  - destruct Ib as [Eb|Ib].
    + subst x. exfalso. apply NR. rewrite Forall_forall in F. now apply F.
    + destruct (IH Ia Ib D NR) as [l1 [l2 [E [H1 H2]]]].
      exists (x :: l1), l2. subst l. repeat split; [now right | exact H2].
Qed.

Lemma sorted_app : forall (A : Type) (R : A -> A -> Prop) l1 l2, StronglySorted R l1 -> StronglySorted R l2 ->
  (forall a b, In a l1 -> In b l2 -> R a b) -> StronglySorted R (l1 ++ l2).
Proof.
  intros A R l1 l2 S1 S2 H. induction S1 as [|x l S IH F]; [exact S2|]. simpl. constructor.
  - apply IH. intros a c Ha Hc. apply H; [now right | exact Hc].
  - apply Forall_app. split; [exact F|]. apply Forall_forall. intros y Hy. apply H; [now left | exact Hy].
Qed.

Lemma sorted_flat_map : forall (A B : Type) (R : A -> A -> Prop) (Q : B -> B -> Prop) (f : A -> list B) l,
  StronglySorted R l -> (forall a, In a l -> StronglySorted Q (f a)) ->
  (forall a b, R a b -> forall u v, In u (f a) -> In v (f b) -> Q u v) -> StronglySorted Q (flat_map f l).
Proof.
  intros A B R Q f l S. induction S as [|x l S IH F]; intros H K; simpl; [constructor|].
  apply sorted_app.
  - apply H. now left.
  - apply IH; [intros a Ha; apply H; now right | exact K].
  - intros u v Hu Hv. apply in_flat_map in Hv. destruct Hv as [a [Ia Iv]].
    rewrite Forall_forall in F. exact (K x a (F a Ia) u v Hu Iv).
Qed.

(** The origin's bits are those of the half-open rule on reals. *)
Lemma origin_sides_exact : forall g n c, on_grid g (S n) c ->
  origin_sides m ray c = owner (real_cell c) (real_three o).
Proof.
  intros g n c [X [Y Z]]. destruct Fo as [Fox [Foy Foz]].
  destruct (mid_exact prec emax m _ _ _ _ X) as [FX HX], (mid_exact prec emax m _ _ _ _ Y) as [FY HY],
    (mid_exact prec emax m _ _ _ _ Z) as [FZ HZ].
  unfold origin_sides, owner, origin_side, le, prepare. simpl.
  rewrite !Bleb_correct by assumption. rewrite HX, HY, HZ. reflexivity.
Qed.

Definition path_earlier (c : cell) (p q : path) : Prop :=
  earlier (positions c (real_three o) p) (positions c (real_three o) q).

(** The paths of [visits] without what they all begin with. *)
Fixpoint suffixes (cv : convention) (n : nat) (here : path) (c : cube) (s : state prec emax) : list path :=
  match n with
  | O => [[]]
  | S n =>
      flat_map (fun i =>
                  if kept (here ++ [i])
                  then map (cons i) (suffixes cv n (here ++ [i]) (child m c i) (child_state m b cv ray c s i))
                  else [])
               (split m b cv ray c s)
  end.

Lemma map_flat_map : forall (A B E : Type) (f : B -> E) (h : A -> list B) l,
  map f (flat_map h l) = flat_map (fun x => map f (h x)) l.
Proof.
  intros A B E f h l. induction l as [|x l IH]; simpl; [reflexivity|]. now rewrite map_app, IH.
Qed.

Lemma visits_suffixes : forall cv n here c s,
  map fst (visits cv ray kept n here c s) = map (app here) (suffixes cv n here c s).
Proof.
  intros cv. induction n as [|n IH]; intros here c s; simpl.
  - now rewrite app_nil_r.
  - rewrite !map_flat_map. apply flat_map_ext. intros i. destruct (kept (here ++ [i])); [|reflexivity].
    rewrite IH, map_map. apply map_ext. intros q. now rewrite <- app_assoc.
Qed.

(** Every path in the list is of the last level and kept. *)
Lemma suffixes_kept : forall cv n here c s q, In q (suffixes cv n here c s) ->
  length q = n /\ Forall (fun i => (i < 8)%N) q /\ all_kept here q.
Proof.
  intros cv. induction n as [|n IH]; intros here c s q H; simpl in H.
  - destruct H as [<-|[]]. repeat split; [constructor|].
    intros p r E Hp. destruct p; [now elim Hp | discriminate].
  - apply in_flat_map in H. destruct H as [i [Hi H]].
    destruct (kept (here ++ [i])) eqn:Ek; [|destruct H].
    apply in_map_iff in H. destruct H as [r [<- H]]. destruct (IH _ _ _ _ H) as [L [F A]].
    split; [simpl; now rewrite L|]. split; [constructor; [now apply split_below_8 in Hi | exact F]|].
    intros p u E Hp. destruct p as [|j p]; [now elim Hp|]. injection E as <- E.
    destruct p as [|j p]; [exact Ek|].
    replace (here ++ i :: j :: p) with ((here ++ [i]) ++ j :: p) by (now rewrite <- app_assoc).
    apply (A (j :: p) u E). discriminate.
Qed.

Lemma suffixes_sorted : forall cv g n here c s, on_grid g n c ->
  StronglySorted (path_earlier (real_cell c)) (suffixes cv n here c s).
Proof.
  intros cv g. induction n as [|n IH]; intros here c s G; simpl; [repeat constructor|].
  apply sorted_flat_map with (R := fun i j =>
    (position (origin_sides m ray c) i < position (origin_sides m ray c) j)%N).
  - apply split_sorted.
  - intros i _. destruct (kept (here ++ [i])); [|constructor].
    assert (S := IH (here ++ [i]) (child m c i) (child_state m b cv ray c s i) (child_on_grid _ _ m g n c i G)).
    rewrite (child_exact g n _ _ G) in S.
    induction S as [|q l S IHS F]; simpl; constructor; [exact IHS|].
    apply Forall_forall. intros r Hr. apply in_map_iff in Hr. destruct Hr as [u [<- Hu]].
    rewrite Forall_forall in F. right. split; [reflexivity | exact (F u Hu)].
  - intros i j H u v Hu Hv. rewrite (origin_sides_exact g n c G) in H.
    destruct (kept (here ++ [i])); [|destruct Hu]. destruct (kept (here ++ [j])); [|destruct Hv].
    apply in_map_iff in Hu, Hv. destruct Hu as [u' [<- _]], Hv as [v' [<- _]]. left. exact H.
Qed.

Lemma reported_sorted : forall cv g root level, on_grid g level root ->
  StronglySorted (path_earlier (real_cell root)) (reported cv root level).
Proof.
  intros cv g root level G. unfold descend. destruct (passed _); [|constructor].
  rewrite visits_suffixes.
  replace (map (app []) _) with (suffixes cv level [] root (enter_root m b ray root))
    by (symmetry; apply map_id).
  now apply suffixes_sorted with g.
Qed.

(** Front to back: in the list, the octant that owns the earlier point of the ray comes first. *)
Theorem owned_in_order : forall cv g root level q1 q2 t1 t2, on_grid g level root -> q1 <> q2 ->
  In q1 (reported cv root level) -> In q2 (reported cv root level) -> 0 <= t1 <= t2 ->
  inside (real_cell root) (point t1) -> inside (real_cell root) (point t2) ->
  owns (far_planes (real_cell root)) (cell_at (real_cell root) q1) (point t1) ->
  owns (far_planes (real_cell root)) (cell_at (real_cell root) q2) (point t2) ->
  before (reported cv root level) q1 q2.
Proof.
  intros cv g root level q1 q2 t1 t2 G D I1 I2 Ht J1 J2 O1 O2.
  assert (P : forall q, In q (reported cv root level) -> length q = level /\ Forall (fun i => (i < 8)%N) q).
  { intros q. unfold descend. destruct (passed _); [|intros []]. rewrite visits_suffixes.
    intros H. apply in_map_iff in H. destruct H as [r [<- H]]. apply suffixes_kept in H. tauto. }
  destruct (P _ I1) as [L1 A1], (P _ I2) as [L2 A2].
  assert (E := edge_positive _ _ _ G).
  apply owner_path_iff in O1; [| now apply root_before_far | now apply inside_owns_root | exact A1].
  apply owner_path_iff in O2; [| now apply root_before_far | now apply inside_owns_root | exact A2].
  apply sorted_before with (1 := reported_sorted cv g root level G); try assumption.
  intros H. apply earlier_not_after with (1 := H). rewrite O1, O2, L1, L2.
  now apply owned_front_to_back.
Qed.

(** No octant is visited twice. *)
Theorem visited_once : forall cv g root level, on_grid g level root -> NoDup (reported cv root level).
Proof.
  intros cv g root level G. assert (S := reported_sorted cv g root level G).
  induction S as [|q l S IH F]; constructor; [|exact IH].
  intros H. rewrite Forall_forall in F. apply (earlier_not_after _ _ (F q H)), lexicographic_refl.
Qed.

(** Each visited cell is the octant, of the last level and kept, that its path names: its corners and
    size are exact. *)
Theorem visited_exact : forall cv g root level q c, on_grid g level root ->
  In (q, c) (descend m b cv ray kept root level) ->
  length q = level /\ Forall (fun i => (i < 8)%N) q /\ all_kept [] q /\
  real_cell c = cell_at (real_cell root) q.
Proof.
  intros cv g root level q c G H.
  assert (H1 : length q = level /\ Forall (fun i => (i < 8)%N) q /\ all_kept [] q).
  { assert (I := in_map fst _ _ H). revert I. unfold descend. destruct (passed _); [|intros []].
    rewrite visits_suffixes. intros I. apply in_map_iff in I. destruct I as [r [E I]]. simpl in E. subst r.
    now apply suffixes_kept in I. }
  repeat (split; [apply H1|]). clear H1. unfold descend in H. destruct (passed _); [|destruct H].
  assert (V : forall n here c0 s q c, on_grid g n c0 -> In (q, c) (visits cv ray kept n here c0 s) ->
    exists r, q = here ++ r /\ real_cell c = cell_at (real_cell c0) r).
  { clear - Fo. induction n as [|n IH]; intros here c0 s q c G H; simpl in H.
    - destruct H as [H|[]]. injection H as <- <-. exists []. now rewrite app_nil_r.
    - apply in_flat_map in H. destruct H as [i [_ H]]. destruct (kept (here ++ [i])); [|destruct H].
      destruct (IH _ _ _ _ _ (child_on_grid _ _ m g n c0 i G) H) as [r [-> E]].
      exists (i :: r). rewrite <- app_assoc. split; [reflexivity|].
      now rewrite E, (child_exact g n _ _ G). }
  destruct (V _ _ _ _ _ _ G H) as [r [-> E]]. exact E.
Qed.

End Ray.
End Descent.
