(** The ray/octant test of octree/geometry/include/graze/octree/ray_bounds.hpp, one definition a line and with
    its names, over IEEE 754 numbers of any precision (Flocq's, with one NaN).

    Reading: [float] is the type of numbers; a [backend] is what graze::rounding::Backend asks for;
    the test is a function of a backend, as the C++ template is. Comparisons are IEEE 754's: false
    where a NaN is involved. *)
From Coq Require Import ZArith Bool List.
From Flocq Require Import Core BinarySingleNaN.

Section Model.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.

Definition float := binary_float prec emax.

(** Comparisons and constants. *)
Definition lt (x y : float) : bool := Bltb x y.
Definition le (x y : float) : bool := Bleb x y.
Definition eq (x y : float) : bool := Beqb x y.
Definition zero : float := B754_zero false.
Definition infinity : float := B754_infinity false.
Definition minus_infinity : float := B754_infinity true.
Definition one : float := Bone.

(** The operations that the test needs of a backend. *)
Record backend := {
  sub_down : float -> float -> float;
  sub_up : float -> float -> float;
  mul_down : float -> float -> float;
  mul_up : float -> float -> float }.

(** Rounded in the direction asked for, by the definition of IEEE 754: `switching`, `split` and the
    instructions of AVX-512. *)
Definition directed : backend := {|
  sub_down := Bminus mode_DN;
  sub_up := Bminus mode_UP;
  mul_down := Bmult mode_DN;
  mul_up := Bmult mode_UP |}.

(** Upward rounding alone; lower bounds by negation: `upward`. *)
Definition upward : backend := {|
  sub_down := fun x y => Bopp (Bminus mode_UP y x);
  sub_up := Bminus mode_UP;
  mul_down := fun x y => Bopp (Bmult mode_UP (Bopp x) y);
  mul_up := Bmult mode_UP |}.

(** What "touches" means on an axis along which the ray does not move. *)
Inductive convention := closed | owned.
Inductive heading := backward | across | forward.

(** One axis of a prepared ray. *)
Record axis := {
  origin : float;
  c_down : float;
  c_up : float;
  direction : heading }.

(** The interval of scaled t in which the ray is between two planes. *)
Record interval := { enter : float; leave : float }.

Definition mag (x : float) : float := if eq x zero then one else if lt x zero then Bopp x else x.

Section Test.
Variable b : backend.

Definition prepare_axis (o d other1 other2 : float) : axis := {|
  origin := o;
  c_down := mul_down b (mag other1) (mag other2);
  c_up := mul_up b (mag other1) (mag other2);
  direction := if lt d zero then backward else if lt zero d then forward else across |}.

Definition lowb (a : axis) (p q : float) : float :=
  let u := sub_down b p q in mul_down b (if lt u zero then c_up a else c_down a) u.

Definition uppb (a : axis) (p q : float) : float :=
  let u := sub_up b p q in mul_up b (if lt zero u then c_up a else c_down a) u.

Definition enter_at (a : axis) (p : float) : float :=
  match direction a with
  | forward => lowb a p (origin a)
  | backward => lowb a (origin a) p
  | across => if le p (origin a) then minus_infinity else infinity
  end.

Definition leave_at (c : convention) (a : axis) (p : float) : float :=
  match direction a with
  | forward => uppb a p (origin a)
  | backward => uppb a (origin a) p
  | across =>
      if match c with closed => le (origin a) p | owned => lt (origin a) p end
      then infinity else minus_infinity
  end.

Definition within (c : convention) (a : axis) (lo hi : float) : interval :=
  match direction a with
  | backward => {| enter := enter_at a hi; leave := leave_at c a lo |}
  | _ => {| enter := enter_at a lo; leave := leave_at c a hi |}
  end.

Definition common (x y : interval) : interval := {|
  enter := if lt (enter x) (enter y) then enter y else enter x;
  leave := if lt (leave y) (leave x) then leave y else leave x |}.

Definition passes2 (x y : interval) : bool :=
  let both := common x y in negb (lt (leave both) (enter both) || lt (leave both) zero).

Definition passes (x y z : interval) : bool := passes2 (common x y) z.

(** A ray's three axes, and a box's corners. *)
Record three (T : Type) := triple { at_x : T; at_y : T; at_z : T }.
Arguments triple {T}. Arguments at_x {T}. Arguments at_y {T}. Arguments at_z {T}.

Definition prepare (o d : three float) : three axis :=
  triple (prepare_axis (at_x o) (at_x d) (at_y d) (at_z d))
         (prepare_axis (at_y o) (at_y d) (at_z d) (at_x d))
         (prepare_axis (at_z o) (at_z d) (at_x d) (at_y d)).

Definition touches_box (r : three axis) (lo hi : three float) : bool :=
  passes (within closed (at_x r) (at_x lo) (at_x hi)) (within closed (at_y r) (at_y lo) (at_y hi))
         (within closed (at_z r) (at_z lo) (at_z hi)).

(** The split of sound.hpp: the interval of one axis on the lower (false) or upper (true) side of the
    mid-plane, from the parent's. *)
Definition half (c : convention) (a : axis) (at_ : interval) (mid : float) (upper : bool) : interval :=
  let entry_side := match direction a with backward => true | _ => false end in
  if Bool.eqb upper entry_side
  then {| enter := enter at_; leave := leave_at c a mid |}
  else {| enter := enter_at a mid; leave := leave at_ |}.

(** The bit of the origin's side: the children are visited in the order of index XOR these bits. *)
Definition origin_side (a : axis) (mid : float) : bool := le mid (origin a).

End Test.
End Model.

Arguments triple {T}. Arguments at_x {T}. Arguments at_y {T}. Arguments at_z {T}.
