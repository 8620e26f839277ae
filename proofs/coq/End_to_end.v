(** The descent of octree/tree over double, joined: coordinates (Coordinates.v), the
    test (Never_miss.v), order (Order.v) and the descent (Descent.v), for every backend whose bounds
    enclose, in any rounding mode of its scope, for every finite ray and every tree.

    - [bounds_enclose_directed], [bounds_enclose_upward]: two backends' bounds do, at any format;
      [bounds_enclose_backend]: and those of each whose operations are IEEE 754's directed ones.
    - [closed_binary64], [owned_binary64], [order_binary64]: what a descent reports and in which order,
      from a root whose octants are exact at its level.
    - [closed_unit_root], [owned_unit_root], [order_unit_root]: the same on [0, 2^E]^3 with NL <= 53,
      and [closed_symmetric_root], [owned_symmetric_root], [order_symmetric_root] on [-2^E, 2^E]^3
      with NL <= 54; the code's max_level is 53 for both.
    - [closed_list], [owned_list]: what the two conventions visit for the ray in the mid-plane, by
      computation over double: `closed` has child 6 before child 0, which the ray touches first. *)
From Coq Require Import ZArith NArith Reals Bool List Lia Lra.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model Model_descent Negation Bounds Never_miss Coordinates Order Descent.
Import ListNotations.
Open Scope R_scope.

Section Backends.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.

Theorem bounds_enclose_directed : bounds_enclose prec emax (directed prec emax).
Proof.
  intros o d d1 d2 p q Fo Fd F1 F2 Fp Fq.
  pose proof (prepare_axis_encloses prec emax o d d1 d2 F1 F2) as H.
  split; [now apply lowb_encloses | now apply uppb_encloses].
Qed.

Theorem bounds_enclose_upward : bounds_enclose prec emax (upward prec emax).
Proof. rewrite upward_is_directed. exact bounds_enclose_directed. Qed.

Theorem bounds_enclose_backend : forall b : backend prec emax,
  (forall x y, sub_down _ _ b x y = Bminus mode_DN x y) ->
  (forall x y, sub_up _ _ b x y = Bminus mode_UP x y) ->
  (forall x y, mul_down _ _ b x y = Bmult mode_DN x y) ->
  (forall x y, mul_up _ _ b x y = Bmult mode_UP x y) -> bounds_enclose prec emax b.
Proof.
  intros b SD SU MD MU o d d1 d2 p q Fo Fd F1 F2 Fp Fq.
  pose proof (bounds_enclose_directed o d d1 d2 p q Fo Fd F1 F2 Fp Fq) as H.
  unfold lowb, uppb, prepare_axis in *. cbn -[Bmult Bminus below above] in *.
  now rewrite !SD, !SU, !MD, !MU.
Qed.

End Backends.

Local Instance prec53 : Prec_gt_0 53 := eq_refl.
Local Instance emax1024 : Prec_lt_emax 53 1024 := eq_refl.

Notation binary64 := (float 53 1024).
Notation cube64 := (cube 53 1024).
Notation backend64 := (backend 53 1024).

(** ** Double *)

Section Binary64.
Variable m : mode.
Variable b : backend64.
Hypothesis encloses64 : bounds_enclose 53 1024 b.
Variables o d : three binary64.
Hypothesis (Fo : finite3 53 1024 o) (Fd : finite3 53 1024 d).
Variable kept : path -> bool.

Notation point t := (point_at (real_three 53 1024 o) (real_three 53 1024 d) t).
Notation exact c := (real_cell 53 1024 c).
Notation reported cv root level :=
  (map fst (Model_descent.descend 53 1024 m b cv (prepare 53 1024 b o d) kept root level)).
(** A path to an octant of that level which the tree keeps with all its ancestors. *)
Definition octant_path (level : nat) (q : path) : Prop :=
  length q = level /\ Forall (fun i => (i < 8)%N) q /\ all_kept kept [] q.

(** `closed`: every octant of the last level that the ray touches at a real t >= 0, whose ancestors
    are kept, is reported. *)
Theorem closed_binary64 : forall g (root : cube64) level q, on_grid 53 1024 g level root ->
  octant_path level q -> (exists t, 0 <= t /\ inside (cell_at (exact root) q) (point t)) ->
  In q (reported closed root level).
Proof.
  intros g root level q G (L & A & Kq) H.
  exact (closed_reports 53 1024 m b encloses64 o d Fo Fd kept g root level q G L A Kq H).
Qed.

(** `owned` (and `closed`): every octant of the last level that owns a point of the ray is reported. *)
Theorem owned_binary64 : forall cv g (root : cube64) level q, on_grid 53 1024 g level root ->
  octant_path level q ->
  (exists t, 0 <= t /\ inside (exact root) (point t) /\
             owns (far_planes (exact root)) (cell_at (exact root) q) (point t)) ->
  In q (reported cv root level).
Proof.
  intros cv g root level q G (L & A & Kq) H.
  exact (owned_reports 53 1024 m b encloses64 o d Fo Fd kept cv g root level q G L A Kq H).
Qed.

(** Front to back: of two octants that own points of the ray, the owner of the earlier comes first. *)
Theorem order_binary64 : forall cv g (root : cube64) level q1 q2 t1 t2, on_grid 53 1024 g level root ->
  octant_path level q1 -> octant_path level q2 -> q1 <> q2 -> 0 <= t1 <= t2 ->
  inside (exact root) (point t1) -> owns (far_planes (exact root)) (cell_at (exact root) q1) (point t1) ->
  inside (exact root) (point t2) -> owns (far_planes (exact root)) (cell_at (exact root) q2) (point t2) ->
  before (reported cv root level) q1 q2.
Proof.
  intros cv g root level q1 q2 t1 t2 G P1 P2 D Ht J1 O1 J2 O2.
  apply (owned_in_order 53 1024 m b o d Fo kept cv g root level q1 q2 t1 t2); auto.
  - apply owned_binary64 with g; auto. exists t1. split; [apply Ht | split; assumption].
  - apply owned_binary64 with g; auto. exists t2. split; [lra | split; assumption].
Qed.

(** ** The roots *)

(** The cube [0, 2^E]^3... *)
Definition unit_root (E : Z) (root : cube64) : Prop :=
  at_x (lo _ _ root) = zero 53 1024 /\ at_y (lo _ _ root) = zero 53 1024 /\
  at_z (lo _ _ root) = zero 53 1024 /\
  is_finite (size _ _ root) = true /\ B2R (size _ _ root) = bpow radix2 E.

(** ... and [-2^E, 2^E]^3. *)
Definition symmetric_root (E : Z) (root : cube64) : Prop :=
  exists l, lo _ _ root = triple l l l /\ is_finite l = true /\ B2R l = - bpow radix2 E /\
  is_finite (size _ _ root) = true /\ B2R (size _ _ root) = bpow radix2 (E + 1).

(** The levels at which they are exact, in the range of the exponents. *)
Definition unit_level (E : Z) (NL : nat) : Prop :=
  (Z.of_nat NL <= 53)%Z /\ (-1074 <= E - Z.of_nat NL)%Z /\ (E < 1024)%Z.
Definition symmetric_level (E : Z) (NL : nat) : Prop :=
  (1 <= Z.of_nat NL <= 54)%Z /\ (-1074 <= E + 1 - Z.of_nat NL)%Z /\ (E + 1 < 1024)%Z.

Lemma unit_grid : forall E NL root, unit_level E NL -> unit_root E root ->
  on_grid 53 1024 (E - Z.of_nat NL) NL root.
Proof.
  intros E NL root (A & B & C) (X & Y & Z & F & S). now apply unit_root_on_grid.
Qed.

Lemma symmetric_grid : forall E NL root, symmetric_level E NL -> symmetric_root E root ->
  on_grid 53 1024 (E + 1 - Z.of_nat NL) NL root.
Proof.
  intros E NL root (A & B & C) (l & L & Fl & Bl & F & S).
  apply symmetric_root_on_grid with (l := l); auto; lia.
Qed.

Theorem closed_unit_root : forall E NL root q, unit_level E NL -> unit_root E root -> octant_path NL q ->
  (exists t, 0 <= t /\ inside (cell_at (exact root) q) (point t)) -> In q (reported closed root NL).
Proof. intros E NL root q L H. eapply closed_binary64, unit_grid; eassumption. Qed.

Theorem owned_unit_root : forall cv E NL root q, unit_level E NL -> unit_root E root -> octant_path NL q ->
  (exists t, 0 <= t /\ inside (exact root) (point t) /\
             owns (far_planes (exact root)) (cell_at (exact root) q) (point t)) ->
  In q (reported cv root NL).
Proof. intros cv E NL root q L H. eapply owned_binary64, unit_grid; eassumption. Qed.

Theorem order_unit_root : forall cv E NL root q1 q2 t1 t2, unit_level E NL -> unit_root E root ->
  octant_path NL q1 -> octant_path NL q2 -> q1 <> q2 -> 0 <= t1 <= t2 ->
  inside (exact root) (point t1) -> owns (far_planes (exact root)) (cell_at (exact root) q1) (point t1) ->
  inside (exact root) (point t2) -> owns (far_planes (exact root)) (cell_at (exact root) q2) (point t2) ->
  before (reported cv root NL) q1 q2.
Proof. intros cv E NL root q1 q2 t1 t2 L H. eapply order_binary64, unit_grid; eassumption. Qed.

Theorem closed_symmetric_root : forall E NL root q, symmetric_level E NL -> symmetric_root E root ->
  octant_path NL q -> (exists t, 0 <= t /\ inside (cell_at (exact root) q) (point t)) ->
  In q (reported closed root NL).
Proof. intros E NL root q L H. eapply closed_binary64, symmetric_grid; eassumption. Qed.

Theorem owned_symmetric_root : forall cv E NL root q, symmetric_level E NL -> symmetric_root E root ->
  octant_path NL q ->
  (exists t, 0 <= t /\ inside (exact root) (point t) /\
             owns (far_planes (exact root)) (cell_at (exact root) q) (point t)) ->
  In q (reported cv root NL).
Proof. intros cv E NL root q L H. eapply owned_binary64, symmetric_grid; eassumption. Qed.

Theorem order_symmetric_root : forall cv E NL root q1 q2 t1 t2, symmetric_level E NL ->
  symmetric_root E root -> octant_path NL q1 -> octant_path NL q2 -> q1 <> q2 -> 0 <= t1 <= t2 ->
  inside (exact root) (point t1) -> owns (far_planes (exact root)) (cell_at (exact root) q1) (point t1) ->
  inside (exact root) (point t2) -> owns (far_planes (exact root)) (cell_at (exact root) q2) (point t2) ->
  before (reported cv root NL) q1 q2.
Proof. intros cv E NL root q1 q2 t1 t2 L H. eapply order_binary64, symmetric_grid; eassumption. Qed.

End Binary64.

(** ** The ray in the mid-plane, by computation *)

Definition one64 : binary64 := one 53 1024.
Definition half64 : binary64 := halved 53 1024 mode_NE one64.
Definition quarter64 : binary64 := halved 53 1024 mode_NE half64.
Definition zero64 : binary64 := zero 53 1024.

Definition mid_plane_list (cv : convention) : list path :=
  map fst (Model_descent.descend 53 1024 mode_NE (directed 53 1024) cv
    (prepare 53 1024 (directed 53 1024) (triple quarter64 zero64 half64) (triple zero64 one64 zero64))
    (fun _ => true) {| lo := triple zero64 zero64 zero64; size := one64 |} 1).

(** `closed` visits 4, 6, 0, 2: child 0, touched from t = 0 on, comes after 6, touched from t = 1/2 on. *)
Theorem closed_list : mid_plane_list closed = [[4]; [6]; [0]; [2]]%N.
Proof. vm_compute. reflexivity. Qed.

(** `owned` visits the two children that own the ray's points, in order. *)
Theorem owned_list : mid_plane_list owned = [[4]; [6]]%N.
Proof. vm_compute. reflexivity. Qed.
