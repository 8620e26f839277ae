(** The octants of octree/geometry/include/graze/octree/cube.hpp, the split of sound.hpp and the descent of
    descent.hpp, with their names, over the numbers and the ray/octant test of Model.v. Definitions
    only.

    Differences from the C++ text: the loop over an explicit stack is written as the recursion that
    it unrolls (Stack.v proves that the loop visits the same cells in the same order); the tree is a predicate
    on paths, since for one ray all that a tree answers is a function of the path that leads to the
    cell; the visitor never stops the descent, so that a descent that is stopped visits a prefix of
    the list given here. *)
From Coq Require Import ZArith NArith Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model.
Import ListNotations.

(** Children are numbered 0..7: bit a of the index is set on the upper side of axis a's mid-plane. *)
Definition index_of (x y z : bool) : N :=
  ((if x then 1 else 0) + (if y then 2 else 0) + (if z then 4 else 0))%N.

(** Front to back: the i-th child looked at is i XOR the bits of the origin's side. *)
Definition visiting_order (side : N) : list N :=
  map (fun i => N.lxor i side) [0; 1; 2; 3; 4; 5; 6; 7]%N.

(** Where in that order a child comes. *)
Definition position (side index : N) : N := N.lxor index side.

(** A path names an octant: the child indices from the root down. *)
Definition path := list N.

Section Descent.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.

(** The rounding mode in which the C++ code's own +, - and / run: that of the backend's scope. Every
    theorem holds for all five. *)
Variable m : mode.

Notation float := (float prec emax).
Notation interval := (interval prec emax).
Notation axis := (axis prec emax).

Definition two : float := Bplus mode_NE (one prec emax) (one prec emax).
Definition halved (size : float) : float := Bdiv m size two.

Record cube := { lo : three float; size : float }.

Definition hi_at (lo size : float) : float := Bplus m lo size.
Definition mid_at (lo size : float) : float := Bplus m lo (halved size).

Definition child (c : cube) (index : N) : cube := {|
  lo := triple (if N.testbit index 0 then mid_at (at_x (lo c)) (size c) else at_x (lo c))
               (if N.testbit index 1 then mid_at (at_y (lo c)) (size c) else at_y (lo c))
               (if N.testbit index 2 then mid_at (at_z (lo c)) (size c) else at_z (lo c));
  size := halved (size c) |}.

(** The intervals of scaled t on the three axes: what is carried down. *)
Definition state := three interval.

Definition passed (at_ : state) : bool := passes prec emax (at_x at_) (at_y at_) (at_z at_).

Section Sound.
Variable b : backend prec emax.
Variable cv : convention.
Variable ray : three axis.

Definition enter_root (root : cube) : state :=
  triple (within prec emax b closed (at_x ray) (at_x (lo root)) (hi_at (at_x (lo root)) (size root)))
         (within prec emax b closed (at_y ray) (at_y (lo root)) (hi_at (at_y (lo root)) (size root)))
         (within prec emax b closed (at_z ray) (at_z (lo root)) (hi_at (at_z (lo root)) (size root))).

Definition origin_sides (c : cube) : N :=
  index_of (origin_side prec emax (at_x ray) (mid_at (at_x (lo c)) (size c)))
           (origin_side prec emax (at_y ray) (mid_at (at_y (lo c)) (size c)))
           (origin_side prec emax (at_z ray) (mid_at (at_z (lo c)) (size c))).

Definition child_state (c : cube) (at_ : state) (index : N) : state :=
  triple (half prec emax b cv (at_x ray) (at_x at_) (mid_at (at_x (lo c)) (size c)) (N.testbit index 0))
         (half prec emax b cv (at_y ray) (at_y at_) (mid_at (at_y (lo c)) (size c)) (N.testbit index 1))
         (half prec emax b cv (at_z ray) (at_z at_) (mid_at (at_z (lo c)) (size c)) (N.testbit index 2)).

Definition split (c : cube) (at_ : state) : list N :=
  filter (fun index => passed (child_state c at_ index)) (visiting_order (origin_sides c)).

(** The paths below [at_path] that the tree keeps: [kept p] for every octant p on the way. *)
Variable kept : path -> bool.

Fixpoint visits (levels : nat) (here : path) (c : cube) (at_ : state) : list (path * cube) :=
  match levels with
  | O => [(here, c)]
  | S levels =>
      flat_map (fun index =>
                  if kept (here ++ [index])
                  then visits levels (here ++ [index]) (child c index) (child_state c at_ index)
                  else [])
               (split c at_)
  end.

Definition descend (root : cube) (level : nat) : list (path * cube) :=
  let at_ := enter_root root in if passed at_ then visits level [] root at_ else [].

End Sound.
End Descent.
