(** Front to back: in the order of octree/tree/include/graze/octree/sound.hpp (index XOR the bits of
    origin >= mid), half-open octants come in the order in which a ray passes them. On reals;
    Descent.v carries it to the floating-point descent, whose mid-planes are exact (Coordinates.v).

    - [owner_unique], [owner_owns]: every point of a cell is owned by exactly one child, the one whose
      bit a says whether the point is at or above mid-plane a; the root's far faces are closed.
    - [children_front_to_back]: a ray's points at t1 <= t2 are owned by children whose positions in the
      visiting order are in that order, for every origin and direction, zero components included.
    - [owned_front_to_back]: the same for the octants of any depth: paths in lexicographic order of
      positions, which is the order of the descent (Descent.v, [reported_sorted]).
    - [closed_no_order]: for closed octants and the ray o = (1/4, 0, 1/2), d = (0, 1, 0) no order
      "index XOR side", with any side, is front to back. [closed_counterexample_strict]: with the
      bits origin > mid child 2 comes before child 4, which the ray reaches first;
      [closed_counterexample]: with the rule of sound.hpp child 6 comes before child 0. *)
From Coq Require Import ZArith NArith Reals Bool List Lia Lra.
From Flocq Require Import Core.
From Graze Require Import Model Model_descent.
Import ListNotations.
Open Scope R_scope.

(** ** Cells and rays on reals *)

Record cell := { corner : three R; edge : R }.

Definition mid_plane (l s : R) : R := l + s / 2.

Definition real_child (c : cell) (index : N) : cell := {|
  corner := triple (if N.testbit index 0 then mid_plane (at_x (corner c)) (edge c) else at_x (corner c))
                   (if N.testbit index 1 then mid_plane (at_y (corner c)) (edge c) else at_y (corner c))
                   (if N.testbit index 2 then mid_plane (at_z (corner c)) (edge c) else at_z (corner c));
  edge := edge c / 2 |}.

(** The cell at a path. *)
Definition cell_at (c : cell) (p : path) : cell := fold_left real_child p c.

Definition point_at (o d : three R) (t : R) : three R :=
  triple (at_x o + t * at_x d) (at_y o + t * at_y d) (at_z o + t * at_z d).

(** The child that owns a point: bit a is set iff the point is at or above mid-plane a. For the ray's
    origin these are the bits of [origin_sides]. *)
Definition owner (c : cell) (p : three R) : N :=
  index_of (Rle_bool (mid_plane (at_x (corner c)) (edge c)) (at_x p))
           (Rle_bool (mid_plane (at_y (corner c)) (edge c)) (at_y p))
           (Rle_bool (mid_plane (at_z (corner c)) (edge c)) (at_z p)).

(** The path, n levels deep, of the octant that owns a point. *)
Fixpoint owner_path (n : nat) (c : cell) (p : three R) : path :=
  match n with
  | O => []
  | S n => owner c p :: owner_path n (real_child c (owner c p)) p
  end.

(** The positions of a path's octants among their siblings, in the order for a ray from o. *)
Fixpoint positions (c : cell) (o : three R) (p : path) : list N :=
  match p with
  | [] => []
  | index :: rest => position (owner c o) index :: positions (real_child c index) o rest
  end.

Fixpoint lexicographic (x y : list N) : Prop :=
  match x, y with
  | [], _ => True
  | _ :: _, [] => False
  | i :: x, j :: y => (i < j)%N \/ i = j /\ lexicographic x y
  end.

(** ** Ownership *)

(** Closed on one axis, and half-open with the root's far plane F closed. *)
Definition within_closed (l s p : R) : Prop := l <= p <= l + s.
Definition within_owned (F l s p : R) : Prop := l <= p /\ (p < l + s \/ p = l + s /\ p = F).

Definition inside (c : cell) (p : three R) : Prop :=
  within_closed (at_x (corner c)) (edge c) (at_x p) /\ within_closed (at_y (corner c)) (edge c) (at_y p) /\
  within_closed (at_z (corner c)) (edge c) (at_z p).

(** [far]: the root's far planes. *)
Definition owns (far : three R) (c : cell) (p : three R) : Prop :=
  within_owned (at_x far) (at_x (corner c)) (edge c) (at_x p) /\
  within_owned (at_y far) (at_y (corner c)) (edge c) (at_y p) /\
  within_owned (at_z far) (at_z (corner c)) (edge c) (at_z p).

Definition far_planes (c : cell) : three R :=
  triple (at_x (corner c) + edge c) (at_y (corner c) + edge c) (at_z (corner c) + edge c).

(** A cell that lies before the far planes. *)
Definition before_far (far : three R) (c : cell) : Prop :=
  0 < edge c /\ at_x (corner c) + edge c <= at_x far /\ at_y (corner c) + edge c <= at_y far /\
  at_z (corner c) + edge c <= at_z far.

Lemma testbit_index_of : forall x y z, N.testbit (index_of x y z) 0 = x /\
  N.testbit (index_of x y z) 1 = y /\ N.testbit (index_of x y z) 2 = z.
Proof. intros [|] [|] [|]; repeat split. Qed.

Lemma index_of_below_8 : forall x y z, (index_of x y z < 8)%N.
Proof. intros [|] [|] [|]; reflexivity. Qed.

(** The eight indices, for proofs by cases. *)
Lemma below_8 : forall i, (i < 8)%N ->
  i = 0%N \/ i = 1%N \/ i = 2%N \/ i = 3%N \/ i = 4%N \/ i = 5%N \/ i = 6%N \/ i = 7%N.
Proof. intros i H. lia. Qed.

(** An index below 8 is its three bits. *)
Lemma index_of_testbit : forall i, (i < 8)%N ->
  i = index_of (N.testbit i 0) (N.testbit i 1) (N.testbit i 2).
Proof.
  intros i H.
  destruct (below_8 i H) as [E|[E|[E|[E|[E|[E|[E|E]]]]]]]; subst i; reflexivity.
Qed.

Lemma axis_owner_inside : forall l s p, 0 < s -> within_closed l s p ->
  within_closed (if Rle_bool (mid_plane l s) p then mid_plane l s else l) (s / 2) p.
Proof.
  unfold within_closed, mid_plane. intros l s p Hs H. case Rle_bool_spec; intros; lra.
Qed.

Lemma axis_owner_owns : forall F l s p, 0 < s -> within_owned F l s p ->
  within_owned F (if Rle_bool (mid_plane l s) p then mid_plane l s else l) (s / 2) p.
Proof.
  unfold within_owned, mid_plane. intros F l s p Hs [H [G|[G K]]]; case Rle_bool_spec; intros; lra.
Qed.

Lemma axis_owner_unique : forall F l s p (upper : bool), 0 < s -> l + s <= F ->
  within_owned F (if upper then mid_plane l s else l) (s / 2) p -> upper = Rle_bool (mid_plane l s) p.
Proof.
  unfold within_owned, mid_plane. intros F l s p [|] Hs HF [H G]; case Rle_bool_spec; intros; lra || reflexivity.
Qed.

(** A point in a closed cell is in the closed child that owns it. *)
Theorem owner_inside : forall c p, 0 < edge c -> inside c p -> inside (real_child c (owner c p)) p.
Proof.
  intros c p Hs [X [Y Z]]. unfold inside, owner, real_child. simpl.
  destruct (testbit_index_of (Rle_bool (mid_plane (at_x (corner c)) (edge c)) (at_x p))
    (Rle_bool (mid_plane (at_y (corner c)) (edge c)) (at_y p))
    (Rle_bool (mid_plane (at_z (corner c)) (edge c)) (at_z p))) as [-> [-> ->]].
  split; [|split]; now apply axis_owner_inside.
Qed.

(** A point that a cell owns is owned by the child [owner] names... *)
Theorem owner_owns : forall far c p, 0 < edge c -> owns far c p -> owns far (real_child c (owner c p)) p.
Proof.
  intros far c p Hs [X [Y Z]]. unfold owns, owner, real_child. simpl.
  destruct (testbit_index_of (Rle_bool (mid_plane (at_x (corner c)) (edge c)) (at_x p))
    (Rle_bool (mid_plane (at_y (corner c)) (edge c)) (at_y p))
    (Rle_bool (mid_plane (at_z (corner c)) (edge c)) (at_z p))) as [-> [-> ->]].
  split; [|split]; now apply axis_owner_owns.
Qed.

(** ... and by no other child. *)
Theorem owner_unique : forall far c p i, before_far far c -> (i < 8)%N ->
  owns far (real_child c i) p -> i = owner c p.
Proof.
  intros far c p i [Hs [FX [FY FZ]]] Hi [X [Y Z]]. simpl in X, Y, Z.
  rewrite (index_of_testbit i Hi). unfold owner.
  rewrite <- (axis_owner_unique _ _ _ _ _ Hs FX X), <- (axis_owner_unique _ _ _ _ _ Hs FY Y),
    <- (axis_owner_unique _ _ _ _ _ Hs FZ Z). reflexivity.
Qed.

Lemma child_before_far : forall far c i, before_far far c -> before_far far (real_child c i).
Proof.
  intros far c i [Hs [X [Y Z]]]. unfold before_far, real_child, mid_plane. simpl.
  repeat split; [lra | destruct (N.testbit i 0) | destruct (N.testbit i 1) | destruct (N.testbit i 2)]; lra.
Qed.

(** What a child owns, its parent owns. *)
Lemma child_owns : forall far c i p, before_far far c -> owns far (real_child c i) p -> owns far c p.
Proof.
  intros far c i p [Hs [FX [FY FZ]]] [X [Y Z]].
  unfold owns, within_owned, real_child, mid_plane in *. simpl in *.
  destruct (N.testbit i 0), (N.testbit i 1), (N.testbit i 2); lra.
Qed.

(** What a closed child holds, its closed parent holds. *)
Lemma child_inside : forall c i p, 0 < edge c -> inside (real_child c i) p -> inside c p.
Proof.
  intros c i p Hs [X [Y Z]]. unfold inside, within_closed, real_child, mid_plane in *. simpl in *.
  destruct (N.testbit i 0), (N.testbit i 1), (N.testbit i 2); lra.
Qed.

(** The octant at a path owns a point iff the path is the point's: at every depth, each point that the
    root owns is owned by exactly one octant. *)
Theorem owner_path_iff : forall far p q c, before_far far c -> owns far c p ->
  Forall (fun i => (i < 8)%N) q -> owns far (cell_at c q) p <-> q = owner_path (length q) c p.
Proof.
  intros far p q. induction q as [|i q IH]; intros c B O A.
  - split; [reflexivity | intros _; exact O].
  - inversion A as [|x y Hi A' E]; subst. simpl. split.
    + intros H. assert (P : owns far (real_child c i) p).
      { assert (G : forall q c, before_far far c -> owns far (cell_at c q) p -> owns far c p).
        { clear. intros q. induction q as [|i q IH]; intros c B H; [exact H|].
          apply child_owns with (i := i); [exact B|]. apply IH; [now apply child_before_far | exact H]. }
        apply (G q); [now apply child_before_far | exact H]. }
      assert (E := owner_unique _ _ _ _ B Hi P). subst i. f_equal.
      apply IH; auto. now apply child_before_far.
    + intros E. injection E as Ei Eq. subst i.
      apply (IH (real_child c (owner c p))); auto.
      * now apply child_before_far.
      * apply owner_owns; [apply B | exact O].
Qed.

Lemma inside_owns_root : forall c p, inside c p -> owns (far_planes c) c p.
Proof.
  unfold inside, owns, within_closed, within_owned, far_planes. simpl. intros c p H. intuition lra.
Qed.

Lemma root_before_far : forall c, 0 < edge c -> before_far (far_planes c) c.
Proof. unfold before_far, far_planes. simpl. intros. repeat split; lra. Qed.

(** ** The order of children *)

(** On one axis, the ray is on the origin's side first (bit XOR side = 0), and having left it never
    comes back. *)
Lemma axis_monotone : forall o d mid t1 t2, 0 <= t1 <= t2 ->
  xorb (Rle_bool mid (o + t1 * d)) (Rle_bool mid o) = true ->
  xorb (Rle_bool mid (o + t2 * d)) (Rle_bool mid o) = true.
Proof.
  intros o d mid t1 t2 H.
  destruct (Rle_lt_dec 0 d) as [D|D].
  - assert (0 <= t1 * d) by nra. assert (0 <= (t2 - t1) * d) by nra.
    repeat case Rle_bool_spec; intros; simpl in *; try reflexivity; try discriminate; exfalso; lra.
  - assert (t1 * d <= 0) by nra. assert ((t2 - t1) * d <= 0) by nra.
    repeat case Rle_bool_spec; intros; simpl in *; try reflexivity; try discriminate; exfalso; lra.
Qed.

(** XOR acts on the three bits apart. *)
Lemma position_index_of : forall x y z x' y' z',
  position (index_of x' y' z') (index_of x y z) = index_of (xorb x x') (xorb y y') (xorb z z').
Proof. intros [|] [|] [|] [|] [|] [|]; reflexivity. Qed.

Lemma index_of_monotone : forall x y z x' y' z', (x = true -> x' = true) -> (y = true -> y' = true) ->
  (z = true -> z' = true) -> (index_of x y z <= index_of x' y' z')%N.
Proof.
  intros [|] [|] [|] [|] [|] [|] X Y Z; try (specialize (X eq_refl); discriminate);
    try (specialize (Y eq_refl); discriminate); try (specialize (Z eq_refl); discriminate);
    unfold index_of; lia.
Qed.

(** The children that own the ray's points come in the visiting order, for every ray. *)
Theorem children_front_to_back : forall c o d t1 t2, 0 <= t1 <= t2 ->
  (position (owner c o) (owner c (point_at o d t1)) <= position (owner c o) (owner c (point_at o d t2)))%N.
Proof.
  intros c o d t1 t2 H. unfold owner. rewrite !position_index_of.
  apply index_of_monotone; simpl; now apply axis_monotone.
Qed.

(** [position] is where a child comes in [visiting_order]. *)
Theorem position_correct : forall side i, (side < 8)%N -> (i < 8)%N ->
  nth_error (visiting_order side) (N.to_nat (position side i)) = Some i.
Proof.
  intros side i Hs Hi.
  destruct (below_8 side Hs) as [E|[E|[E|[E|[E|[E|[E|E]]]]]]]; subst side;
  destruct (below_8 i Hi) as [E|[E|[E|[E|[E|[E|[E|E]]]]]]]; subst i; reflexivity.
Qed.

Lemma position_injective : forall side i j, position side i = position side j -> i = j.
Proof.
  unfold position. intros side i j H.
  rewrite <- (N.lxor_0_r i), <- (N.lxor_0_r j), <- (N.lxor_nilpotent side), <- !N.lxor_assoc.
  now rewrite H.
Qed.

(** ** The order of octants of any depth *)

(** A ray's points at t1 <= t2 are owned by octants whose paths are in the order of the descent. *)
Theorem owned_front_to_back : forall n c o d t1 t2, 0 <= t1 <= t2 ->
  lexicographic (positions c o (owner_path n c (point_at o d t1)))
                (positions c o (owner_path n c (point_at o d t2))).
Proof.
  induction n as [|n IH]; intros c o d t1 t2 H; simpl; [exact I|].
  destruct (N.lt_ge_cases (position (owner c o) (owner c (point_at o d t1)))
                          (position (owner c o) (owner c (point_at o d t2)))) as [L|G]; [now left|].
  right. assert (E : position (owner c o) (owner c (point_at o d t1)) =
                     position (owner c o) (owner c (point_at o d t2)))
    by (apply N.le_antisymm; [now apply children_front_to_back | exact G]).
  split; [exact E|]. apply position_injective in E. rewrite E. now apply IH.
Qed.

Lemma positions_injective : forall o p q c, positions c o p = positions c o q -> p = q.
Proof.
  intros o p. induction p as [|i p IH]; intros [|j q] c H; simpl in H; try discriminate; [reflexivity|].
  injection H as Hi Hp. apply position_injective in Hi. subst j. f_equal. now apply IH with (1 := Hp).
Qed.

Lemma lexicographic_antisymmetric : forall x y, length x = length y -> lexicographic x y ->
  lexicographic y x -> x = y.
Proof.
  induction x as [|i x IH]; intros [|j y] L A B; simpl in *; try discriminate; [reflexivity|].
  destruct A as [A|[A A']], B as [B|[B B']]; try lia. subst j. f_equal. apply IH; auto.
Qed.

(** ** Closed octants have no such order *)

(** The unit cube and the ray that runs in its mid-plane z = 1/2. *)
Definition unit_cell : cell := {| corner := triple 0 0 0; edge := 1 |}.
Definition mid_plane_origin : three R := triple (1 / 4) 0 (1 / 2).
Definition mid_plane_direction : three R := triple 0 1 0.

Definition touched_at (index : N) (t : R) : Prop :=
  inside (real_child unit_cell index) (point_at mid_plane_origin mid_plane_direction t).

(** [first] comes before [second] although the ray touches [second] at some t and [first] only later. *)
Definition out_of_order (side first second : N) : Prop :=
  (position side first < position side second)%N /\
  exists t t', 0 <= t < t' /\ touched_at second t /\ touched_at first t' /\
    forall u, 0 <= u -> touched_at first u -> t < u.

Ltac touched := unfold touched_at, inside, within_closed, real_child, mid_plane; simpl; lra.

(** With the bits origin > mid (none is set here), child 2 is visited before child 4. *)
Theorem closed_counterexample_strict : out_of_order (index_of false false false) 2 4.
Proof.
  split; [reflexivity|]. exists 0, (1 / 2). repeat split; try touched; try lra.
  intros u Hu. unfold touched_at, inside, within_closed, real_child, mid_plane. simpl. lra.
Qed.

(** With the bits of sound.hpp (origin >= mid), child 6 is visited before child 0. *)
Theorem closed_counterexample : out_of_order (owner unit_cell mid_plane_origin) 6 0.
Proof.
  assert (E : owner unit_cell mid_plane_origin = 4%N).
  { unfold owner, mid_plane. simpl. rewrite !Rle_bool_false by lra. rewrite Rle_bool_true by lra. reflexivity. }
  rewrite E. split; [reflexivity|]. exists 0, (1 / 2). repeat split; try touched; try lra.
  intros u Hu. unfold touched_at, inside, within_closed, real_child, mid_plane. simpl. lra.
Qed.

(** Nor with any other bits. *)
Theorem closed_no_order : forall side, (side < 8)%N -> exists first second, out_of_order side first second.
Proof.
  assert (A : forall side, (position side 2 < position side 4)%N -> out_of_order side 2 4).
  { intros side P. split; [exact P|]. apply closed_counterexample_strict. }
  assert (B : forall side, (position side 6 < position side 0)%N -> out_of_order side 6 0).
  { intros side P. split; [exact P|]. apply closed_counterexample. }
  intros side H. destruct (below_8 side H) as [E|[E|[E|[E|[E|[E|[E|E]]]]]]]; subst side;
    first [exists 2%N, 4%N; apply A; reflexivity | exists 6%N, 0%N; apply B; reflexivity].
Qed.
