(** The loop of octree/tree/include/graze/octree/descent.hpp over an explicit stack, with a visitor that may
    stop it, does what the recursion of Model_descent.v does.

    - [loop_correct]: with enough turns, descend() visits the cells of [Model_descent.descend] in
      that order up to and including the first at which the visitor returns true, and returns
      whether there was one. [loop_all]: a visitor that never stops sees the whole list.
    - [loop_within_arrays]: it stays within arrays of [level] frames and of eight children.
    - [loop_deterministic]: more turns change nothing. *)
From Coq Require Import ZArith NArith Bool List Lia.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model Model_descent.
Import ListNotations.

(** A cell has eight children at most. *)
Lemma split_at_most_8 : forall prec emax {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax} m b cv ray c s,
  (length (split prec emax m b cv ray c s) <= 8)%nat.
Proof.
  intros prec emax Hprec Hmax m b cv ray c s. unfold split.
  assert (H : forall (f : N -> bool) l, (length (filter f l) <= length l)%nat)
    by (intros f; induction l as [|x l IH]; simpl; [lia | destruct (f x); simpl; lia]).
  apply H.
Qed.

(* The loop's text matters here, not what it computes for a cell. *)
Local Opaque Model_descent.split Model_descent.child Model_descent.child_state
  Model_descent.enter_root Model_descent.passed.

Section Stack.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.
Variable m : mode.
Variable b : backend prec emax.
Variable cv : convention.
Variable ray : three (axis prec emax).
Variable kept : path -> bool.

Notation cube := (cube prec emax).
Notation state := (state prec emax).
Notation child := (child prec emax m).
Notation child_state := (child_state prec emax m b cv ray).
Notation split := (split prec emax m b cv ray).
Notation visits := (visits prec emax m b cv ray kept).
Notation leaf := (path * cube)%type.

(** visit(cell): true stops the descent. *)
Variable visit : leaf -> bool.

(** A frame: a cell, the path of its node, and of the children that the ray passes those that are still
    to be looked at, each with its state. *)
Record frame := { node : path; cell : cube; children : list (N * state) }.

(** open(): the children that the ray passes, in order. *)
Definition open (here : path) (c : cube) (s : state) : frame :=
  {| node := here; cell := c; children := map (fun i => (i, child_state c s i)) (split c s) |}.

(** The while loop, top of the stack first, for at most [turns] turns: the cells visited, and whether
    the visitor stopped it; None where the turns do not suffice. The depth of the top frame is the
    number of frames below it. *)
Fixpoint loop (turns level : nat) (stack : list frame) : option (list leaf * bool) :=
  match turns with
  | O => None
  | S turns =>
      match stack with
      | [] => Some ([], false)
      | f :: below =>
          match children f with
          | [] => loop turns level below
          | (i, s) :: next =>
              let f' := {| node := node f; cell := cell f; children := next |} in
              if kept (node f ++ [i])
              then let at_ := (node f ++ [i], child (cell f) i) in
                   if Nat.eqb (length below + 1) level
                   then if visit at_ then Some ([at_], true)
                        else option_map (fun r => (at_ :: fst r, snd r)) (loop turns level (f' :: below))
                   else loop turns level (open (fst at_) (snd at_) s :: f' :: below)
              else loop turns level (f' :: below)
          end
      end
  end.

Definition descend_loop (turns : nat) (root : cube) (level : nat) : option (list leaf * bool) :=
  let at_ := enter_root prec emax m b ray root in
  if passed prec emax at_ then loop turns level [open [] root at_] else Some ([], false).

(** A list up to and including the first element at which the visitor stops. *)
Fixpoint until (l : list leaf) : list leaf :=
  match l with
  | [] => []
  | x :: l => x :: if visit x then [] else until l
  end.

(** What visiting [out] and then going on with r comes to. *)
Definition after (out : list leaf) (r : option (list leaf * bool)) : option (list leaf * bool) :=
  if existsb visit out then Some (until out, true) else option_map (fun r => (out ++ fst r, snd r)) r.

Lemma after_nil : forall r, after [] r = r.
Proof. intros [[l s]|]; reflexivity. Qed.

Lemma until_app : forall l l', until (l ++ l') = if existsb visit l then until l else l ++ until l'.
Proof.
  induction l as [|x l IH]; intros l'; simpl; [reflexivity|].
  destruct (visit x); simpl; [reflexivity|]. rewrite IH. now destruct (existsb visit l).
Qed.

Lemma until_none : forall l, existsb visit l = false -> until l = l.
Proof.
  induction l as [|x l IH]; simpl; intros H; [reflexivity|].
  apply orb_false_iff in H. destruct H as [-> H]. now rewrite IH.
Qed.

Lemma after_app : forall l l' r, after (l ++ l') r = after l (after l' r).
Proof.
  intros l l' r. unfold after. rewrite existsb_app, until_app.
  destruct (existsb visit l) eqn:E; simpl; [reflexivity|].
  destruct (existsb visit l') eqn:E'; simpl.
  - reflexivity.
  - destruct r as [[k s]|]; simpl; [|reflexivity]. now rewrite app_assoc.
Qed.

(** From [stack] the loop visits [out] and comes to [stack'], in some number of turns. *)
Definition reaches (level : nat) (stack : list frame) (out : list leaf) (stack' : list frame) : Prop :=
  exists k, forall turns, loop (k + turns) level stack = after out (loop turns level stack').

Lemma reaches_refl : forall level stack, reaches level stack [] stack.
Proof. intros level stack. exists 0. intros turns. now rewrite after_nil. Qed.

Lemma reaches_trans : forall level s1 o1 s2 o2 s3, reaches level s1 o1 s2 -> reaches level s2 o2 s3 ->
  reaches level s1 (o1 ++ o2) s3.
Proof.
  intros level s1 o1 s2 o2 s3 [k1 H1] [k2 H2]. exists (k1 + k2). intros turns.
  now rewrite <- Nat.add_assoc, H1, H2, after_app.
Qed.

(** One turn. *)
Lemma reaches_step : forall level s1 s2, (forall turns, loop (S turns) level s1 = loop turns level s2) ->
  reaches level s1 [] s2.
Proof. intros level s1 s2 H. exists 1. intros turns. now rewrite after_nil, <- H. Qed.

(** An opened frame is worked off to what the recursion visits, and left. *)
Lemma open_reaches : forall level n below here c s, length below + S n = level ->
  reaches level (open here c s :: below) (visits (S n) here c s) below.
Proof.
  intros level n. revert level. induction n as [n IHn] using (well_founded_induction Wf_nat.lt_wf).
  intros level below here c s L. unfold open. simpl.
  set (step := fun i => if kept (here ++ [i]) then visits n (here ++ [i]) (child c i) (child_state c s i) else []).
  generalize (split c s). intros l. induction l as [|i l IH]; simpl.
  - apply reaches_step. reflexivity.
  - apply reaches_trans with (2 := IH). unfold step at 1.
    set (f' := {| node := here; cell := c; children := map (fun i => (i, child_state c s i)) l |}).
    destruct (kept (here ++ [i])) eqn:K.
    + destruct n as [|n].
      * (* the last level: the cell is visited *)
        exists 1. intros turns. simpl. rewrite K.
        replace (Nat.eqb (length below + 1) level) with true by (symmetry; apply Nat.eqb_eq; lia).
        fold f'. unfold after, path in *. simpl. rewrite orb_false_r.
        destruct (visit (here ++ [i], child c i)) eqn:V; simpl; rewrite ?V; reflexivity.
      * (* the child is opened, worked off, and left *)
        apply (reaches_trans level _ [] (open (here ++ [i]) (child c i) (child_state c s i) :: f' :: below)).
        -- apply reaches_step. intros turns. simpl. rewrite K.
           replace (Nat.eqb (length below + 1) level) with false by (symmetry; apply Nat.eqb_neq; lia).
           reflexivity.
        -- apply IHn; [lia|]. simpl. lia.
    + apply reaches_step. intros turns. simpl. rewrite K. reflexivity.
Qed.

(** The loop visits the recursion's list, up to the first cell at which the visitor stops. *)
Theorem loop_correct : forall root level, (1 <= level)%nat -> exists k, forall turns, (k <= turns)%nat ->
  descend_loop turns root level =
    Some (until (descend prec emax m b cv ray kept root level),
          existsb visit (descend prec emax m b cv ray kept root level)).
Proof.
  intros root level H. unfold descend_loop, descend.
  destruct (passed prec emax (enter_root prec emax m b ray root)); [|now exists 0].
  destruct level as [|n]; [lia|].
  destruct (open_reaches (S n) n [] [] root (enter_root prec emax m b ray root) eq_refl) as [k Hk].
  exists (k + 1). intros turns T. replace turns with (k + S (turns - k - 1)) by lia. rewrite Hk.
  set (l := visits _ _ _ _). unfold after. simpl.
  destruct (existsb visit l) eqn:E; [reflexivity|]. simpl. now rewrite app_nil_r, until_none.
Qed.

(** The same loop with the C++ arrays' bounds: None where the stack would hold more than [level] frames,
    or a frame more than eight children. *)
Fixpoint guarded_loop (turns level : nat) (stack : list frame) : option (list leaf * bool) :=
  if (Nat.ltb level (length stack) || existsb (fun f => Nat.ltb 8 (length (children f))) stack)%bool then None else
  match turns with
  | O => None
  | S turns =>
      match stack with
      | [] => Some ([], false)
      | f :: below =>
          match children f with
          | [] => guarded_loop turns level below
          | (i, s) :: next =>
              let f' := {| node := node f; cell := cell f; children := next |} in
              if kept (node f ++ [i])
              then let at_ := (node f ++ [i], child (cell f) i) in
                   if Nat.eqb (length below + 1) level
                   then if visit at_ then Some ([at_], true)
                        else option_map (fun r => (at_ :: fst r, snd r)) (guarded_loop turns level (f' :: below))
                   else guarded_loop turns level (open (fst at_) (snd at_) s :: f' :: below)
              else guarded_loop turns level (f' :: below)
          end
      end
  end.

Lemma open_at_most_8 : forall here c s, (length (children (open here c s)) <= 8)%nat.
Proof.
  intros here c s. unfold open. simpl. rewrite map_length. apply split_at_most_8.
Qed.

(** No array is left: the stack never holds more frames than there are levels, nor a frame more than
    eight children. *)
Theorem loop_within_arrays : forall turns level stack, (length stack <= level)%nat ->
  Forall (fun f => (length (children f) <= 8)%nat) stack ->
  guarded_loop turns level stack = loop turns level stack.
Proof.
  induction turns as [|turns IH]; intros level stack L F; simpl;
  replace (Nat.ltb level (length stack)) with false by (symmetry; now apply Nat.ltb_ge);
  replace (existsb _ stack) with false by
    (symmetry; clear - F; induction F as [|f l H F IH]; simpl; [reflexivity|];
     rewrite IH, orb_false_r; now apply Nat.ltb_ge); simpl; [reflexivity|].
  destruct stack as [|f below]; [reflexivity|]. inversion F as [|x y Hf Fb E]; subst. simpl in L.
  destruct (children f) as [|[i s] next]; [apply IH; [lia | exact Fb]|]. simpl in Hf.
  assert (F' : Forall (fun f => (length (children f) <= 8)%nat)
                 ({| node := node f; cell := cell f; children := next |} :: below))
    by (constructor; [simpl; lia | exact Fb]).
  destruct (kept (node f ++ [i])); [| apply IH; [simpl; lia | exact F']].
  destruct (Nat.eqb_spec (length below + 1) level) as [_|N].
  - destruct (visit _); [reflexivity|]. now rewrite IH by (simpl; lia || exact F').
  - apply IH; [simpl; lia|]. constructor; [apply open_at_most_8 | exact F'].
Qed.

(** More turns change nothing. *)
Theorem loop_deterministic : forall turns more level stack r, loop turns level stack = Some r ->
  loop (turns + more) level stack = Some r.
Proof.
  induction turns as [|turns IH]; intros more level stack r; simpl; [discriminate|].
  destruct stack as [|f below]; [auto|]. destruct (children f) as [|[i s] next]; [apply IH|].
  destruct (kept (node f ++ [i])); [|apply IH].
  destruct (Nat.eqb (length below + 1) level); [|apply IH].
  destruct (visit (node f ++ [i], child (cell f) i)); [auto|].
  destruct (loop turns level _) as [q|] eqn:E; [|discriminate].
  intros H. simpl in H. now rewrite (IH more _ _ _ E).
Qed.

End Stack.

(** A visitor that never stops sees the whole list. *)
Theorem loop_all : forall prec emax {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax} m b cv ray kept
  root level, (1 <= level)%nat -> exists k, forall turns, (k <= turns)%nat ->
  descend_loop prec emax m b cv ray kept (fun _ => false) turns root level =
    Some (descend prec emax m b cv ray kept root level, false).
Proof.
  intros prec emax Hprec Hmax m b cv ray kept root level H.
  destruct (loop_correct prec emax m b cv ray kept (fun _ => false) root level H) as [k Hk].
  exists k. intros turns T. rewrite (Hk turns T).
  assert (E : forall l : list (path * cube prec emax), existsb (fun _ => false) l = false)
    by (induction l; auto).
  rewrite E. f_equal. f_equal. now apply until_none.
Qed.
