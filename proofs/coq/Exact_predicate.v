(** The exact ray/octant test of octree/geometry/include/graze/octree/exact_touch.hpp decides exactly.

    First the geometry over the reals: a ray is in a box at some t >= 0 if and only if the origin is
    not beyond it and no entry lies after another axis's exit; for closed faces and for open ones.
    Then floats: [determinant_sign] (the two paths of determinant_sign.hpp, Determinant_sign.v and
    Sum_sign.v) is the sign of the real determinant for all finite doubles, and [meets], the C++
    function without its filter, is true if and only if the ray has a point in the box. The filter is
    Exact_filter.v. *)
From Coq Require Import ZArith Bool List Reals Lia Lra Psatz Permutation.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model Determinant_sign Sum_sign.
Import ListNotations.
Open Scope R_scope.

(** * Intervals that meet in pairs have a common point *)
Record limit := { place : R; included : bool }.
Definition after (l : limit) (t : R) : Prop := if included l then place l <= t else place l < t.
Definition before (u : limit) (t : R) : Prop := if included u then t <= place u else t < place u.
Definition compatible (l u : limit) : Prop :=
  place l < place u \/ (place l = place u /\ included l = true /\ included u = true).

Lemma strongest_after (ls : list limit) : ls <> [] ->
  exists m, In m ls /\ forall t, after m t -> forall l, In l ls -> after l t.
Proof.
  induction ls as [|a ls IH]; [easy|]. intros _. destruct ls as [|b ls'].
  - exists a. split; [left; reflexivity|]. intros t H l [<-|[]]. exact H.
  - destruct IH as (m & M & H); [discriminate|].
    assert (C : (forall t, after a t -> after m t) \/ (forall t, after m t -> after a t)).
    { unfold after. destruct (included a), (included m), (Rtotal_order (place a) (place m)) as [?|[?|?]];
        first [left; intros; lra | right; intros; lra]. }
    destruct C as [C|C].
    + exists a. split; [left; reflexivity|]. intros t A l [<-|L]; [exact A|apply H; auto].
    + exists m. split; [right; exact M|]. intros t A l [<-|L]; [auto|apply H; auto].
Qed.
Lemma strongest_before (us : list limit) : us <> [] ->
  exists m, In m us /\ forall t, before m t -> forall u, In u us -> before u t.
Proof.
  induction us as [|a us IH]; [easy|]. intros _. destruct us as [|b us'].
  - exists a. split; [left; reflexivity|]. intros t H l [<-|[]]. exact H.
  - destruct IH as (m & M & H); [discriminate|].
    assert (C : (forall t, before a t -> before m t) \/ (forall t, before m t -> before a t)).
    { unfold before. destruct (included a), (included m), (Rtotal_order (place a) (place m)) as [?|[?|?]];
        first [left; intros; lra | right; intros; lra]. }
    destruct C as [C|C].
    + exists a. split; [left; reflexivity|]. intros t A l [<-|L]; [exact A|apply H; auto].
    + exists m. split; [right; exact M|]. intros t A l [<-|L]; [auto|apply H; auto].
Qed.

Theorem common_time (ls us : list limit) : ls <> [] ->
  (forall l u, In l ls -> In u us -> compatible l u) ->
  exists t, (forall l, In l ls -> after l t) /\ (forall u, In u us -> before u t).
Proof.
  intros N C. destruct (strongest_after ls N) as (l & L & Hl).
  destruct us as [|u0 us'] eqn:E.
  - exists (place l + 1). split; [|intros u []]. apply Hl. unfold after. destruct (included l); lra.
  - destruct (strongest_before us) as (u & U & Hu); [rewrite E; discriminate|]. rewrite <- E in *.
    destruct (C l u L U) as [H|(H & I & J)].
    + exists ((place l + place u) / 2). split; [apply Hl|apply Hu].
      * unfold after. destruct (included l); lra.
      * unfold before. destruct (included u); lra.
    + exists (place l). split; [apply Hl|apply Hu].
      * unfold after. rewrite I. lra.
      * unfold before. rewrite J. lra.
Qed.

(** * One ray, one box, reflected so that every axis goes forward *)
Inductive index := i0 | i1 | i2.
Record slab := {
  start : R; speed : R;                   (** the origin, and |direction| *)
  near : R; far : R;                      (** the plane that it enters by, and leaves by *)
  near_closed : bool; far_closed : bool }.
Definition past_near (s : slab) (x : R) : Prop := if near_closed s then near s <= x else near s < x.
Definition short_of_far (s : slab) (x : R) : Prop := if far_closed s then x <= far s else x < far s.
Definition within (s : slab) (x : R) : Prop := past_near s x /\ short_of_far s x.

(** t of entry on a minus t of exit on b, times both speeds. *)
Definition lateness (a b : slab) : R := (near a - start a) * speed b - (far b - start b) * speed a.
Definition outside (s : slab) : Prop :=
  ~ short_of_far s (start s) \/ (speed s = 0 /\ ~ past_near s (start s)).
Definition too_late (a b : slab) : Prop :=
  ~ past_near a (start a) /\ speed b <> 0 /\
  (0 < lateness a b \/ (lateness a b = 0 /\ near_closed a && far_closed b = false)).

Section Geometry.
Variable axes : index -> slab.
Hypothesis forward : forall i, 0 <= speed (axes i).
Hypothesis solid : forall i, near (axes i) < far (axes i).

Definition ray_meets : Prop :=
  exists t, 0 <= t /\ forall i, within (axes i) (start (axes i) + t * speed (axes i)).
Definition test : Prop :=
  (forall i, ~ outside (axes i)) /\ (forall i j, i <> j -> ~ too_late (axes i) (axes j)).

Lemma past_near_dec s x : past_near s x \/ ~ past_near s x.
Proof. unfold past_near. destruct (near_closed s); [destruct (Rle_dec (near s) x)|destruct (Rlt_dec (near s) x)]; tauto. Qed.

(** The pairwise test is exact. *)
Theorem test_exact : ray_meets <-> test.
Proof.
  split.
  - intros (t & T & W). split.
    + intros i. destruct (W i) as [W1 W2]. pose proof (forward i).
      unfold outside, past_near, short_of_far in *. intros [O|[Z O]].
      * apply O. destruct (far_closed (axes i)); nra.
      * apply O. rewrite Z in W1. destruct (near_closed (axes i)); lra.
    + intros i j _ (N & Z & L). destruct (W i) as [Wi _], (W j) as [_ Wj].
      pose proof (forward i) as Si. pose proof (forward j) as Sj.
      set (a := axes i) in *. set (b := axes j) in *. clearbody a b.
      assert (Pj : 0 < speed b) by lra.
      unfold past_near, short_of_far in *. unfold lateness in L.
      assert (Wi' : near a - start a <= t * speed a) by (destruct (near_closed a); lra).
      assert (Wj' : t * speed b <= far b - start b) by (destruct (far_closed b); lra).
      assert (Pi : 0 < speed a) by (destruct (near_closed a); nra).
      assert (X1 : (near a - start a) * speed b <= t * speed a * speed b) by (apply Rmult_le_compat_r; lra).
      assert (X2 : t * speed b * speed a <= (far b - start b) * speed a) by (apply Rmult_le_compat_r; lra).
      destruct L as [L|[L K]]; [lra|].
      destruct (near_closed a), (far_closed b); try discriminate.
      * assert (t * speed b * speed a < (far b - start b) * speed a) by (apply Rmult_lt_compat_r; lra). lra.
      * assert ((near a - start a) * speed b < t * speed a * speed b) by (apply Rmult_lt_compat_r; lra). lra.
      * assert ((near a - start a) * speed b < t * speed a * speed b) by (apply Rmult_lt_compat_r; lra). lra.
  - intros [O L].
    set (entry := fun i => {| place := (near (axes i) - start (axes i)) / speed (axes i);
                              included := near_closed (axes i) |}).
    set (exit := fun i => {| place := (far (axes i) - start (axes i)) / speed (axes i);
                             included := far_closed (axes i) |}).
    assert (M : forall i, ~ past_near (axes i) (start (axes i)) -> 0 < speed (axes i)).
    { intros i N. destruct (forward i) as [P|P]; [exact P|]. exfalso. apply (O i). right. auto. }
    assert (F : forall i, short_of_far (axes i) (start (axes i))).
    { intros i. unfold short_of_far. pose proof (O i) as Oi. unfold outside, short_of_far in Oi.
      destruct (far_closed (axes i)).
      - destruct (Rle_dec (start (axes i)) (far (axes i))); [assumption|]. exfalso. apply Oi. left. assumption.
      - destruct (Rlt_dec (start (axes i)) (far (axes i))); [assumption|]. exfalso. apply Oi. left. assumption. }
    assert (Ls : exists ls, forall l, In l ls <->
      (exists i, ~ past_near (axes i) (start (axes i)) /\ l = entry i) \/ l = {| place := 0; included := true |}).
    { destruct (past_near_dec (axes i0) (start (axes i0))) as [D0|D0],
        (past_near_dec (axes i1) (start (axes i1))) as [D1|D1],
        (past_near_dec (axes i2) (start (axes i2))) as [D2|D2].
      all: match goal with
      | A : ~ past_near (axes i0) _, B : ~ past_near (axes i1) _, C : ~ past_near (axes i2) _ |- _ =>
          exists [{| place := 0; included := true |}; entry i0; entry i1; entry i2]
      | A : ~ past_near (axes i0) _, B : ~ past_near (axes i1) _ |- _ =>
          exists [{| place := 0; included := true |}; entry i0; entry i1]
      | A : ~ past_near (axes i0) _, B : ~ past_near (axes i2) _ |- _ =>
          exists [{| place := 0; included := true |}; entry i0; entry i2]
      | A : ~ past_near (axes i1) _, B : ~ past_near (axes i2) _ |- _ =>
          exists [{| place := 0; included := true |}; entry i1; entry i2]
      | A : ~ past_near (axes i0) _ |- _ => exists [{| place := 0; included := true |}; entry i0]
      | A : ~ past_near (axes i1) _ |- _ => exists [{| place := 0; included := true |}; entry i1]
      | A : ~ past_near (axes i2) _ |- _ => exists [{| place := 0; included := true |}; entry i2]
      | _ => exists [{| place := 0; included := true |}]
      end.
      all: intros l; split;
        [ intros H; repeat (destruct H as [<-|H]; [first [right; reflexivity|left; eexists; split; [|reflexivity]; assumption]|]); destruct H
        | intros [(i & N & ->)| ->]; [destruct i; try contradiction; simpl; tauto|left; reflexivity] ]. }
    assert (Us : exists us, forall u, In u us <-> exists i, speed (axes i) <> 0 /\ u = exit i).
    { destruct (Req_dec (speed (axes i0)) 0) as [D0|D0], (Req_dec (speed (axes i1)) 0) as [D1|D1],
        (Req_dec (speed (axes i2)) 0) as [D2|D2].
      all: match goal with
      | A : speed (axes i0) <> 0, B : speed (axes i1) <> 0, C : speed (axes i2) <> 0 |- _ => exists [exit i0; exit i1; exit i2]
      | A : speed (axes i0) <> 0, B : speed (axes i1) <> 0 |- _ => exists [exit i0; exit i1]
      | A : speed (axes i0) <> 0, B : speed (axes i2) <> 0 |- _ => exists [exit i0; exit i2]
      | A : speed (axes i1) <> 0, B : speed (axes i2) <> 0 |- _ => exists [exit i1; exit i2]
      | A : speed (axes i0) <> 0 |- _ => exists [exit i0]
      | A : speed (axes i1) <> 0 |- _ => exists [exit i1]
      | A : speed (axes i2) <> 0 |- _ => exists [exit i2]
      | _ => exists (@nil limit)
      end.
      all: intros u; split;
        [ intros H; repeat (destruct H as [<-|H]; [eexists; split; [|reflexivity]; assumption|]); destruct H
        | intros (i & N & ->); destruct i; try contradiction; simpl; tauto ]. }
    destruct Ls as [ls Ls], Us as [us Us].
    destruct (common_time ls us) as (t & Tl & Tu).
    + intros ->. destruct (proj2 (Ls {| place := 0; included := true |})). right. reflexivity.
    + intros l u Hl Hu. apply Ls in Hl. apply Us in Hu. destruct Hu as (j & Zj & ->).
      pose proof (forward j) as Fj. assert (Pj : 0 < speed (axes j)) by lra.
      assert (Ij : 0 < / speed (axes j)) by (apply Rinv_0_lt_compat; exact Pj).
      destruct Hl as [(i & N & ->)| ->]; unfold compatible; cbn [place included entry exit].
      * pose proof (M i N) as Pi.
        assert (Dv : (near (axes i) - start (axes i)) / speed (axes i) -
                (far (axes j) - start (axes j)) / speed (axes j) =
                lateness (axes i) (axes j) * (/ speed (axes i) * / speed (axes j)))
          by (unfold lateness; field; lra).
        assert (Ii : 0 < / speed (axes i) * / speed (axes j))
          by (apply Rmult_lt_0_compat; [apply Rinv_0_lt_compat|]; assumption).
        assert (Eq : i = j \/ i <> j) by (destruct i, j; auto; right; discriminate).
        destruct Eq as [->|Ne].
        -- left. apply Rmult_lt_compat_r; [exact Ij|]. pose proof (solid j). lra.
        -- pose proof (L i j Ne) as NL.
           destruct (Rtotal_order (lateness (axes i) (axes j)) 0) as [H|[H|H]].
           ++ left. nra.
           ++ right. split; [rewrite H in Dv; lra|].
              destruct (near_closed (axes i)) eqn:E1, (far_closed (axes j)) eqn:E2; auto;
                exfalso; apply NL; unfold too_late; rewrite E1, E2; auto.
           ++ exfalso. apply NL. unfold too_late. auto.
      * pose proof (F j) as Fj'. unfold short_of_far in Fj'. unfold Rdiv.
        destruct (far_closed (axes j)); [|left; apply Rmult_lt_0_compat; lra].
        destruct Fj' as [H|H]; [left; apply Rmult_lt_0_compat; lra|right].
        rewrite H, Rminus_diag_eq by reflexivity. split; [ring|auto].
    + assert (T0 : 0 <= t) by (apply (Tl {| place := 0; included := true |}), Ls; right; reflexivity).
      exists t. split; [exact T0|]. intros i. specialize (F i).
      destruct (Req_dec (speed (axes i)) 0) as [Z|Z].
      * rewrite Z, Rmult_0_r, Rplus_0_r. split; [|exact F].
        destruct (past_near_dec (axes i) (start (axes i))) as [P|P]; [exact P|].
        pose proof (M i P). lra.
      * pose proof (forward i) as Fi. assert (Pi : 0 < speed (axes i)) by lra.
        assert (R1 : forall x, x / speed (axes i) <= t -> x <= t * speed (axes i)).
        { intros x X. replace x with (x / speed (axes i) * speed (axes i)) by (field; lra).
          apply Rmult_le_compat_r; lra. }
        assert (R2 : forall x, x / speed (axes i) < t -> x < t * speed (axes i)).
        { intros x X. replace x with (x / speed (axes i) * speed (axes i)) by (field; lra).
          apply Rmult_lt_compat_r; lra. }
        assert (R3 : forall x, t <= x / speed (axes i) -> t * speed (axes i) <= x).
        { intros x X. replace x with (x / speed (axes i) * speed (axes i)) by (field; lra).
          apply Rmult_le_compat_r; lra. }
        assert (R4 : forall x, t < x / speed (axes i) -> t * speed (axes i) < x).
        { intros x X. replace x with (x / speed (axes i) * speed (axes i)) by (field; lra).
          apply Rmult_lt_compat_r; lra. }
        split.
        -- destruct (past_near_dec (axes i) (start (axes i))) as [P|P].
           ++ unfold past_near in *. destruct (near_closed (axes i)); nra.
           ++ assert (A : after (entry i) t) by (apply Tl, Ls; left; exists i; auto).
              unfold after in A. cbn [entry place included] in A. unfold past_near.
              destruct (near_closed (axes i)); [apply R1 in A|apply R2 in A]; lra.
        -- assert (B : before (exit i) t) by (apply Tu, Us; exists i; auto).
           unfold before in B. cbn [exit place included] in B. unfold short_of_far.
           destruct (far_closed (axes i)); [apply R3 in B|apply R4 in B]; lra.
Qed.
End Geometry.
