(** What the voxelizer discards holds no zero (octree/surface/include/graze/octree/inclusion.hpp and
    voxelizer.hpp).

    First over the reals, for any f: an enclosure without 0; equal signs at the eight corners and
    partial derivatives of known sign; the mean value form. Then for formulas: [formula] is what a
    scene's operator() is made of; evaluated over intervals ([value_I]) and over dual intervals
    ([partial_I], the rules of dual.hpp), with the floating-point operations of Interval_arith.v. The
    conclusions are about [has_no_zero] and [leaf_content], which are the C++ functions. Elementary
    functions enter as [elementary]: a real function with its derivative and enclosures of both. *)
From Coq Require Import ZArith Bool List Reals Lia Lra Psatz FunctionalExtensionality Ranalysis5.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model Interval_arith.
Import ListNotations.
Open Scope R_scope.

(** * Over the reals *)
Inductive direction3 := along_x | along_y | along_z.
Definition same (a b : direction3) : bool :=
  match a, b with
  | along_x, along_x | along_y, along_y | along_z, along_z => true
  | _, _ => false
  end.
Lemma same_spec a b : reflect (a = b) (same a b).
Proof. destruct a, b; constructor; congruence. Qed.

Definition point := direction3 -> R.
(** p with its coordinate i replaced by s. *)
Definition moved (p : point) (i : direction3) (s : R) : point := fun a => if same a i then s else p a.
Lemma moved_same p i : moved p i (p i) = p.
Proof.
  apply functional_extensionality. intros a. unfold moved.
  destruct (same_spec a i); congruence.
Qed.
Lemma moved_twice p i s t : moved (moved p i s) i t = moved p i t.
Proof.
  apply functional_extensionality. intros a. unfold moved.
  destruct (same_spec a i); congruence.
Qed.
Lemma moved_at p i s : moved p i s i = s.
Proof. unfold moved. destruct (same_spec i i); congruence. Qed.

Section Reals.
Variables lo hi : point.
Definition in_box (p : point) : Prop := forall a, lo a <= p a <= hi a.
Definition corner (p : point) : Prop := forall a, p a = lo a \/ p a = hi a.

Lemma moved_in_box p i s : in_box p -> lo i <= s <= hi i -> in_box (moved p i s).
Proof.
  intros H S a. unfold moved. destruct (same_spec a i) as [->|]; [exact S|apply H].
Qed.

Variable f : point -> R.
Variable slope : direction3 -> point -> R.
Hypothesis differentiable : forall i p, in_box p ->
  derivable_pt_lim (fun s => f (moved p i s)) (p i) (slope i p).

(** The mean value theorem along one axis. *)
Lemma mean_value_along p i s : in_box p -> lo i <= s <= hi i ->
  exists q, in_box q /\ f (moved p i s) - f p = slope i q * (s - p i).
Proof.
  intros P S. set (g := fun t => f (moved p i t)).
  assert (D : forall t, lo i <= t <= hi i -> derivable_pt_lim g t (slope i (moved p i t))).
  { intros t T. pose proof (differentiable i (moved p i t) (moved_in_box p i t P T)) as D.
    rewrite moved_at in D. unfold g.
    replace (fun s0 => f (moved p i s0)) with (fun s0 => f (moved (moved p i t) i s0)); [exact D|].
    apply functional_extensionality. intros u. rewrite moved_twice. reflexivity. }
  replace (f p) with (g (p i)) by (unfold g; rewrite moved_same; reflexivity).
  change (f (moved p i s)) with (g s). pose proof (P i) as Pi.
  destruct (Rtotal_order s (p i)) as [H|[H|H]].
  - destruct (MVT_cor2 g (fun t => slope i (moved p i t)) s (p i) H) as (t & E & T).
    { intros t T. apply D. lra. }
    exists (moved p i t). split; [apply moved_in_box; [exact P|lra]|]. lra.
  - exists p. split; [exact P|]. rewrite H. ring.
  - destruct (MVT_cor2 g (fun t => slope i (moved p i t)) (p i) s H) as (t & E & T).
    { intros t T. apply D. lra. }
    exists (moved p i t). split; [apply moved_in_box; [exact P|lra]|]. lra.
Qed.

(** f - f(c) is a sum of partial derivatives at points of the box times distances. *)
Theorem mean_value c p : in_box c -> in_box p ->
  exists qx qy qz, in_box qx /\ in_box qy /\ in_box qz /\
  f p = f c + slope along_x qx * (p along_x - c along_x)
            + slope along_y qy * (p along_y - c along_y)
            + slope along_z qz * (p along_z - c along_z).
Proof.
  intros C P.
  destruct (mean_value_along c along_x (p along_x) C (P _)) as (qx & Qx & Ex).
  set (c1 := moved c along_x (p along_x)) in *.
  assert (C1 : in_box c1) by (apply moved_in_box; [exact C|apply P]).
  destruct (mean_value_along c1 along_y (p along_y) C1 (P _)) as (qy & Qy & Ey).
  set (c2 := moved c1 along_y (p along_y)) in *.
  assert (C2 : in_box c2) by (apply moved_in_box; [exact C1|apply P]).
  destruct (mean_value_along c2 along_z (p along_z) C2 (P _)) as (qz & Qz & Ez).
  exists qx, qy, qz. repeat (split; [assumption|]).
  replace (moved c2 along_z (p along_z)) with p in Ez.
  - change (c1 along_y) with (c along_y) in Ey. change (c2 along_z) with (c along_z) in Ez. lra.
  - apply functional_extensionality. intros []; reflexivity.
Qed.

(** The derivative along each axis has one sign in the box. *)
Definition monotone : Prop :=
  forall i, (forall p, in_box p -> 0 < slope i p) \/ (forall p, in_box p -> slope i p < 0).

Lemma lower_face p i : monotone -> in_box p ->
  exists e, (e = lo i \/ e = hi i) /\ f (moved p i e) <= f p.
Proof.
  intros M P. pose proof (P i) as Pi. destruct (M i) as [M'|M'].
  - exists (lo i). split; [auto|].
    destruct (mean_value_along p i (lo i) P) as (q & Q & E); [lra|]. specialize (M' q Q). nra.
  - exists (hi i). split; [auto|].
    destruct (mean_value_along p i (hi i) P) as (q & Q & E); [lra|]. specialize (M' q Q). nra.
Qed.
Lemma upper_face p i : monotone -> in_box p ->
  exists e, (e = lo i \/ e = hi i) /\ f p <= f (moved p i e).
Proof.
  intros M P. pose proof (P i) as Pi. destruct (M i) as [M'|M'].
  - exists (hi i). split; [auto|].
    destruct (mean_value_along p i (hi i) P) as (q & Q & E); [lra|]. specialize (M' q Q). nra.
  - exists (lo i). split; [auto|].
    destruct (mean_value_along p i (lo i) P) as (q & Q & E); [lra|]. specialize (M' q Q). nra.
Qed.

(** Monotone in each variable, f lies between its values at two corners. *)
Theorem between_corners p : monotone -> in_box p ->
  exists c d, corner c /\ corner d /\ f c <= f p <= f d.
Proof.
  intros M P.
  assert (E : forall i e, e = lo i \/ e = hi i -> lo i <= e <= hi i).
  { intros i e [->| ->]; pose proof (P i); lra. }
  destruct (lower_face p along_x M P) as (x & X & Fx).
  assert (P1 := moved_in_box p along_x x P (E _ _ X)).
  destruct (lower_face _ along_y M P1) as (y & Y & Fy).
  assert (P2 := moved_in_box _ along_y y P1 (E _ _ Y)).
  destruct (lower_face _ along_z M P2) as (z & Z & Fz).
  destruct (upper_face p along_x M P) as (x' & X' & Fx').
  assert (P1' := moved_in_box p along_x x' P (E _ _ X')).
  destruct (upper_face _ along_y M P1') as (y' & Y' & Fy').
  assert (P2' := moved_in_box _ along_y y' P1' (E _ _ Y')).
  destruct (upper_face _ along_z M P2') as (z' & Z' & Fz').
  exists (moved (moved (moved p along_x x) along_y y) along_z z).
  exists (moved (moved (moved p along_x x') along_y y') along_z z').
  split; [|split; [|lra]]; intros []; unfold moved; simpl; assumption.
Qed.

(** Equal signs at all corners and monotone in each variable: no zero. *)
Theorem no_zero_of_equal_signs :
  monotone -> (forall c, corner c -> 0 < f c) \/ (forall c, corner c -> f c < 0) ->
  forall p, in_box p -> f p <> 0.
Proof.
  intros M S p P. destruct (between_corners p M P) as (c & d & C & D & B).
  destruct S as [S|S]; [specialize (S c C)|specialize (S d D)]; lra.
Qed.
End Reals.

(** * Formulas, evaluated in floating-point intervals *)
Section Formulas.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.
Notation num := (float prec emax).
Notation I := (bounds prec emax).
Notation zero := (Model.zero prec emax).
Notation lt := (Model.lt prec emax).
Notation contains := (contains prec emax).
Notation add := (add prec emax).
Notation sub := (sub prec emax).
Notation mul := (mul prec emax).
Notation div := (div prec emax).
Notation square := (square prec emax).
Notation neg := (neg prec emax).

(** A function of one variable with its derivative, and enclosures of both. *)
Record elementary := {
  value_of : R -> R;
  slope_of : R -> R;
  domain : R -> Prop;
  value_on : I -> I;
  slope_on : I -> I;
  value_on_encloses : forall X x, domain x -> contains X x -> contains (value_on X) (value_of x);
  slope_on_encloses : forall X x, domain x -> contains X x -> contains (slope_on X) (slope_of x);
  has_slope : forall x, domain x -> derivable_pt_lim value_of x (slope_of x) }.

Inductive formula :=
  | Coordinate (a : direction3)
  | Constant (enclosure : I) (c : R)
  | Neg (e : formula)
  | Add (e1 e2 : formula)
  | Sub (e1 e2 : formula)
  | Mul (e1 e2 : formula)
  | Div (e1 e2 : formula)
  | Sqr (e : formula)
  | Apply (g : elementary) (e : formula).

(** Constants are enclosed. *)
Fixpoint well_formed (e : formula) : Prop :=
  match e with
  | Coordinate _ => True
  | Constant C c => contains C c
  | Neg e | Sqr e | Apply _ e => well_formed e
  | Add a b | Sub a b | Mul a b | Div a b => well_formed a /\ well_formed b
  end.

Fixpoint value (e : formula) (p : point) : R :=
  match e with
  | Coordinate a => p a
  | Constant _ c => c
  | Neg e => - value e p
  | Add a b => value a p + value b p
  | Sub a b => value a p - value b p
  | Mul a b => value a p * value b p
  | Div a b => value a p / value b p
  | Sqr e => value e p * value e p
  | Apply g e => value_of g (value e p)
  end.

(** The formula has a value at p: no division by 0, each function within its domain. *)
Fixpoint defined (e : formula) (p : point) : Prop :=
  match e with
  | Coordinate _ | Constant _ _ => True
  | Neg e | Sqr e => defined e p
  | Add a b | Sub a b | Mul a b => defined a p /\ defined b p
  | Div a b => defined a p /\ defined b p /\ value b p <> 0
  | Apply g e => defined e p /\ domain g (value e p)
  end.

(** dual.hpp's rules, over the reals. *)
Fixpoint partial (e : formula) (i : direction3) (p : point) : R :=
  match e with
  | Coordinate a => if same a i then 1 else 0
  | Constant _ _ => 0
  | Neg e => - partial e i p
  | Add a b => partial a i p + partial b i p
  | Sub a b => partial a i p - partial b i p
  | Mul a b => partial a i p * value b p + value a p * partial b i p
  | Div a b => (partial a i p - value a p / value b p * partial b i p) / value b p
  | Sqr e => (value e p + value e p) * partial e i p
  | Apply g e => slope_of g (value e p) * partial e i p
  end.

Definition exact_point (x : num) : I := {| lower := x; upper := x |}.
Definition exactly_one : I := exact_point (Model.one prec emax).
Definition exactly_zero : I := exact_point zero.

(** The natural interval extension. *)
Fixpoint value_I (e : formula) (X : direction3 -> I) : I :=
  match e with
  | Coordinate a => X a
  | Constant C _ => C
  | Neg e => neg (value_I e X)
  | Add a b => add (value_I a X) (value_I b X)
  | Sub a b => sub (value_I a X) (value_I b X)
  | Mul a b => mul (value_I a X) (value_I b X)
  | Div a b => div (value_I a X) (value_I b X)
  | Sqr e => square (value_I e X)
  | Apply g e => value_on g (value_I e X)
  end.

(** The partial derivative along axis i, by dual.hpp's rules over intervals. *)
Fixpoint partial_I (e : formula) (i : direction3) (X : direction3 -> I) : I :=
  match e with
  | Coordinate a => if same a i then exactly_one else exactly_zero
  | Constant _ _ => exactly_zero
  | Neg e => neg (partial_I e i X)
  | Add a b => add (partial_I a i X) (partial_I b i X)
  | Sub a b => sub (partial_I a i X) (partial_I b i X)
  | Mul a b => add (mul (partial_I a i X) (value_I b X)) (mul (value_I a X) (partial_I b i X))
  | Div a b =>
      let ratio := div (value_I a X) (value_I b X) in
      div (sub (partial_I a i X) (mul ratio (partial_I b i X))) (value_I b X)
  | Sqr e => mul (add (value_I e X) (value_I e X)) (partial_I e i X)
  | Apply g e => mul (slope_on g (value_I e X)) (partial_I e i X)
  end.

Definition all_contain (X : direction3 -> I) (p : point) : Prop := forall a, contains (X a) (p a).

Lemma exact_point_contains (x : num) : is_finite x = true -> contains (exact_point x) (B2R x).
Proof.
  intros F. split; simpl.
  - apply below_finite; [exact F|lra].
  - apply above_finite; [exact F|lra].
Qed.
Lemma one_contains : contains exactly_one 1.
Proof.
  replace 1 with (B2R (Model.one prec emax)) by apply Bone_correct.
  apply exact_point_contains. apply is_finite_Bone.
Qed.
Lemma zero_contains : contains exactly_zero 0.
Proof. split; simpl; lra. Qed.

(** The natural extension encloses f. *)
Theorem value_I_encloses e X p :
  well_formed e -> defined e p -> all_contain X p -> contains (value_I e X) (value e p).
Proof.
  intros W D C. induction e; simpl in *.
  - apply C.
  - exact W.
  - apply neg_encloses. auto.
  - apply add_encloses; tauto.
  - apply sub_encloses; tauto.
  - apply mul_encloses; tauto.
  - apply div_encloses; tauto.
  - apply square_encloses; auto.
  - apply value_on_encloses; tauto.
Qed.

(** The interval partials enclose the partials. *)
Theorem partial_I_encloses e i X p :
  well_formed e -> defined e p -> all_contain X p -> contains (partial_I e i X) (partial e i p).
Proof.
  intros W D C. induction e; simpl in *;
    try pose proof (value_I_encloses e1 X p) as V1; try pose proof (value_I_encloses e2 X p) as V2;
    try pose proof (value_I_encloses e X p) as V.
  - destruct same; [apply one_contains|apply zero_contains].
  - apply zero_contains.
  - apply neg_encloses; auto.
  - apply add_encloses; tauto.
  - apply sub_encloses; tauto.
  - apply add_encloses; apply mul_encloses; tauto.
  - apply div_encloses; try tauto. apply sub_encloses; [tauto|].
    apply mul_encloses; [|tauto]. apply div_encloses; tauto.
  - apply mul_encloses; [apply add_encloses; auto|auto].
  - apply mul_encloses; [apply slope_on_encloses; tauto|tauto].
Qed.

(** The partials are the derivatives. *)
Theorem partial_is_derivative e i p :
  defined e p -> derivable_pt_lim (fun s => value e (moved p i s)) (p i) (partial e i p).
Proof.
  intros D. induction e; simpl in *.
  - unfold moved. destruct (same_spec a i) as [->|N].
    + apply derivable_pt_lim_id.
    + apply derivable_pt_lim_const.
  - apply derivable_pt_lim_const.
  - apply derivable_pt_lim_opp. auto.
  - apply derivable_pt_lim_plus; tauto.
  - apply derivable_pt_lim_minus; tauto.
  - destruct D as [D1 D2]. specialize (IHe1 D1). specialize (IHe2 D2).
    pose proof (derivable_pt_lim_mult _ _ _ _ _ IHe1 IHe2) as M. cbv beta in M. rewrite !moved_same in M. exact M.
  - destruct D as (D1 & D2 & Z). specialize (IHe1 D1). specialize (IHe2 D2).
    assert (Z' : value e2 (moved p i (p i)) <> 0) by (rewrite moved_same; exact Z).
    pose proof (derivable_pt_lim_div _ _ _ _ _ IHe1 IHe2 Z') as M. cbv beta in M. rewrite !moved_same in M.
    replace ((partial e1 i p - value e1 p / value e2 p * partial e2 i p) / value e2 p)
      with ((partial e1 i p * value e2 p - partial e2 i p * value e1 p) / (value e2 p)²);
      [exact M|]. unfold Rsqr. field. exact Z.
  - specialize (IHe D). pose proof (derivable_pt_lim_mult _ _ _ _ _ IHe IHe) as M.
    cbv beta in M. rewrite !moved_same in M.
    replace ((value e p + value e p) * partial e i p)
      with (partial e i p * value e p + value e p * partial e i p) by ring. exact M.
  - destruct D as [D1 D2]. specialize (IHe D1).
    assert (S : derivable_pt_lim (value_of g) (value e (moved p i (p i))) (slope_of g (value e p))).
    { rewrite moved_same. apply has_slope. exact D2. }
    exact (derivable_pt_lim_comp _ _ _ _ _ IHe S).
Qed.

(** * The C++ functions *)
(** excludes_zero, certified_sign *)
Definition excludes_zero (v : I) : bool := lt zero (lower _ _ v) || lt (upper _ _ v) zero.
Inductive sign := positive | negative | unknown.
Definition certified_sign (v : I) : sign :=
  if lt zero (lower _ _ v) then positive else if lt (upper _ _ v) zero then negative else unknown.

Lemma positive_lower v r : contains v r -> lt zero (lower _ _ v) = true -> 0 < r.
Proof.
  intros [L _] H. destruct (below_cases _ _ _ _ L) as [E|[F B]].
  - rewrite E in H. discriminate H.
  - rewrite zero_lt_finite in H by exact F.
    revert H. case Rlt_bool_spec; [lra|discriminate].
Qed.
Lemma negative_upper v r : contains v r -> lt (upper _ _ v) zero = true -> r < 0.
Proof.
  intros [_ U] H. destruct (above_cases _ _ _ _ U) as [E|[F B]].
  - rewrite E in H. discriminate H.
  - rewrite lt_zero_finite in H by exact F.
    revert H. case Rlt_bool_spec; [lra|discriminate].
Qed.

(** Discarded by an enclosure: no zero. For any f and any enclosure, however made. *)
Theorem discarded_by_enclosure (f : point -> R) (box : point -> Prop) (v : I) :
  (forall p, box p -> contains v (f p)) -> excludes_zero v = true ->
  forall p, box p -> f p <> 0.
Proof.
  intros E X p P. specialize (E p P). unfold excludes_zero in X. apply orb_true_iff in X.
  destruct X as [X|X]; [apply positive_lower with (1 := E) in X|apply negative_upper with (1 := E) in X];
    lra.
Qed.

Lemma certified_positive v r : contains v r -> certified_sign v = positive -> 0 < r.
Proof.
  intros C. unfold certified_sign. destruct (lt zero (lower _ _ v)) eqn:E.
  - intros _. exact (positive_lower _ _ C E).
  - destruct (lt (upper _ _ v) zero); discriminate.
Qed.
Lemma certified_negative v r : contains v r -> certified_sign v = negative -> r < 0.
Proof.
  intros C. unfold certified_sign. destruct (lt zero (lower _ _ v)) eqn:E; [discriminate|].
  destruct (lt (upper _ _ v) zero) eqn:E'; [|discriminate].
  intros _. exact (negative_upper _ _ C E').
Qed.

(** A box: its intervals, and its corners' coordinates as exact doubles. *)
Section Box.
Variables lo hi : direction3 -> num.
Hypothesis finite_box : forall a, is_finite (lo a) = true /\ is_finite (hi a) = true.
Definition intervals (a : direction3) : I := {| lower := lo a; upper := hi a |}.
Definition inside (p : point) : Prop := in_box (fun a => B2R (lo a)) (fun a => B2R (hi a)) p.

Lemma inside_contained p : inside p -> all_contain intervals p.
Proof.
  intros P a. destruct (finite_box a) as [L H], (P a) as [P1 P2]. split; simpl.
  - apply below_finite; assumption.
  - apply above_finite; assumption.
Qed.

(** Corner `index`, one bit an axis, in the order in which leaf_content takes them. *)
Definition corner_at (x y z : bool) (a : direction3) : num :=
  if match a with along_x => x | along_y => y | along_z => z end then hi a else lo a.
Definition corners : list (direction3 -> num) :=
  [corner_at false false false; corner_at true true true; corner_at true false false;
   corner_at false true true; corner_at false true false; corner_at true false true;
   corner_at true true false; corner_at false false true].
Definition certified_sign_at (e : formula) (c : direction3 -> num) : sign :=
  certified_sign (value_I e (fun a => exact_point (c a))).

Variable e : formula.
Variable centre : direction3 -> num.

(** mean_value_form, about the point `centre`. *)
Definition mean_value_form : I :=
  let term r a := add r (mul (partial_I e a intervals) (sub (intervals a) (exact_point (centre a)))) in
  term (term (term (value_I e (fun a => exact_point (centre a))) along_x) along_y) along_z.

(** has_no_zero; `tight` is has_tight_extension<F>(). *)
Definition has_no_zero (tight : bool) : bool :=
  excludes_zero (value_I e intervals) || (negb tight && excludes_zero mean_value_form).

Inductive content := none | possible | certified.
Definition is_positive s := match s with positive => true | _ => false end.
Definition is_negative s := match s with negative => true | _ => false end.
Definition is_known s := match s with unknown => false | _ => true end.

Definition leaf_content : content :=
  let signs := map (certified_sign_at e) corners in
  if existsb is_positive signs && existsb is_negative signs then certified
  else if negb (forallb is_positive signs) && negb (forallb is_negative signs) then possible
  else
    let partial_sign a := is_known (certified_sign (partial_I e a intervals)) in
    if (partial_sign along_x && partial_sign along_y && partial_sign along_z)
       || excludes_zero mean_value_form
    then none else possible.

Hypothesis formula_ok : well_formed e.
Hypothesis defined_in_box : forall p, inside p -> defined e p.

Definition real (c : direction3 -> num) : point := fun a => B2R (c a).

Lemma differentiable_in_box : forall i p, inside p ->
  derivable_pt_lim (fun s => value e (moved p i s)) (p i) (partial e i p).
Proof. intros i p P. apply partial_is_derivative. auto. Qed.

Lemma sign_at_correct c : (forall a, is_finite (c a) = true) -> inside (real c) ->
  contains (value_I e (fun a => exact_point (c a))) (value e (real c)).
Proof.
  intros F P. apply value_I_encloses; auto. intros a. apply exact_point_contains. apply F.
Qed.

Section Centre.
Hypothesis centre_finite : forall a, is_finite (centre a) = true.
Hypothesis centre_inside : inside (real centre).

(** The mean value form encloses f on the box. *)
Theorem mean_value_form_encloses p : inside p -> contains mean_value_form (value e p).
Proof.
  intros P.
  destruct (mean_value _ _ (value e) (partial e) differentiable_in_box (real centre) p centre_inside P)
    as (qx & qy & qz & Qx & Qy & Qz & ->).
  unfold mean_value_form.
  repeat apply add_encloses; [apply sign_at_correct; assumption|..];
    apply mul_encloses;
    try (apply partial_I_encloses; [assumption|auto|apply inside_contained; assumption]);
    apply sub_encloses; try (apply inside_contained; assumption);
    apply exact_point_contains; apply centre_finite.
Qed.

(** has_no_zero: what it says is true. *)
Theorem has_no_zero_sound tight :
  has_no_zero tight = true -> forall p, inside p -> value e p <> 0.
Proof.
  unfold has_no_zero. intros H. apply orb_true_iff in H. destruct H as [H|H].
  - apply discarded_by_enclosure with (2 := H). intros p P.
    apply value_I_encloses; auto. apply inside_contained. exact P.
  - apply andb_true_iff in H. apply discarded_by_enclosure with (2 := proj2 H).
    exact mean_value_form_encloses.
Qed.

Lemma corners_complete c : corner (fun a => B2R (lo a)) (fun a => B2R (hi a)) c ->
  exists k, In k corners /\ c = real k.
Proof.
  intros C.
  assert (E : forall a, exists b : bool, c a = B2R (if b then hi a else lo a)).
  { intros a. destruct (C a) as [E|E]; [exists false|exists true]; exact E. }
  destruct (E along_x) as [x X], (E along_y) as [y Y], (E along_z) as [z Z].
  exists (corner_at x y z). split.
  - destruct x, y, z; simpl; tauto.
  - apply functional_extensionality. intros []; assumption.
Qed.
Lemma corner_finite k : In k corners -> forall a, is_finite (k a) = true.
Proof.
  intros K a. destruct (finite_box a) as [L H].
  simpl in K. decompose [or] K; subst; try contradiction; destruct a; first [exact L|exact H].
Qed.
Lemma corner_inside k : (forall a, B2R (lo a) <= B2R (hi a)) -> In k corners -> inside (real k).
Proof.
  intros O K a. specialize (O a).
  simpl in K. decompose [or] K; subst; try contradiction; destruct a; unfold real, corner_at; cbv beta iota; lra.
Qed.

(** leaf_content = none: no zero in the box. *)
Theorem leaf_content_none_sound :
  leaf_content = none -> forall p, inside p -> value e p <> 0.
Proof.
  intros H p P.
  assert (O : forall a, B2R (lo a) <= B2R (hi a)) by (intros a; pose proof (P a); simpl in *; lra).
  unfold leaf_content in H. cbv zeta in H.
  destruct (existsb is_positive _ && existsb is_negative _); [discriminate|].
  destruct (negb (forallb is_positive (map (certified_sign_at e) corners)) &&
            negb (forallb is_negative (map (certified_sign_at e) corners))) eqn:S; [discriminate|].
  destruct (_ || excludes_zero mean_value_form) eqn:M; [|discriminate]. clear H.
  apply orb_true_iff in M. destruct M as [M|M].
  - apply no_zero_of_equal_signs with (4 := P) (slope := partial e).
    + exact differentiable_in_box.
    + intros i.
      assert (K : is_known (certified_sign (partial_I e i intervals)) = true).
      { apply andb_true_iff in M. destruct M as [M Mz]. apply andb_true_iff in M.
        destruct M as [Mx My]. destruct i; assumption. }
      assert (C : forall q, inside q -> contains (partial_I e i intervals) (partial e i q)).
      { intros q Q. apply partial_I_encloses; auto. apply inside_contained. exact Q. }
      destruct (certified_sign (partial_I e i intervals)) eqn:E; try discriminate.
      * left. intros q Q. exact (certified_positive _ _ (C q Q) E).
      * right. intros q Q. exact (certified_negative _ _ (C q Q) E).
    + apply andb_false_iff in S. rewrite !negb_false_iff in S.
      rewrite !forallb_forall in S.
      destruct S as [S|S]; [left|right]; intros c Hc;
        destruct (corners_complete c Hc) as (k & K & ->);
        specialize (S _ (in_map (certified_sign_at e) _ _ K));
        pose proof (sign_at_correct k (corner_finite k K) (corner_inside k O K)) as C;
        unfold certified_sign_at in S;
        destruct (certified_sign _) eqn:E in S; try discriminate;
        [exact (certified_positive _ _ C E)|exact (certified_negative _ _ C E)].
  - apply discarded_by_enclosure with (2 := M) (box := inside); [|exact P].
    exact mean_value_form_encloses.
Qed.

(** An octant that holds a zero is kept: neither test discards it. *)
Corollary octant_with_a_zero_is_kept p tight :
  inside p -> value e p = 0 -> has_no_zero tight = false /\ leaf_content <> none.
Proof.
  intros P Z. split.
  - destruct (has_no_zero tight) eqn:H; [|reflexivity].
    exfalso. exact (has_no_zero_sound tight H p P Z).
  - intros H. exact (leaf_content_none_sound H p P Z).
Qed.

(** f is continuous along a segment within the box. *)
Lemma continuous_on_segment (f : formula) c d s :
  (forall t, 0 <= t <= 1 -> defined f (fun a => c a + t * (d a - c a))) -> 0 <= s <= 1 ->
  continuity_pt (fun t => value f (fun a => c a + t * (d a - c a))) s.
Proof.
  intros D S. induction f; simpl in *.
  - apply derivable_continuous_pt. exists (0 + (1 * (d a - c a) + s * 0)).
    apply derivable_pt_lim_plus; [apply derivable_pt_lim_const|].
    apply (derivable_pt_lim_mult (fun t => t) (fun _ => d a - c a));
      [apply derivable_pt_lim_id|apply derivable_pt_lim_const].
  - apply continuity_pt_const. intros ? ?. reflexivity.
  - apply continuity_pt_opp. auto.
  - apply continuity_pt_plus; [apply IHf1|apply IHf2]; intros t T; apply (D t T).
  - apply continuity_pt_minus; [apply IHf1|apply IHf2]; intros t T; apply (D t T).
  - apply continuity_pt_mult; [apply IHf1|apply IHf2]; intros t T; apply (D t T).
  - apply continuity_pt_div; [apply IHf1|apply IHf2|]; try (intros t T; apply (D t T)).
    apply (D s S).
  - apply continuity_pt_mult; auto.
  - apply (continuity_pt_comp (fun t => value f (fun a => c a + t * (d a - c a))) (value_of g)).
    + apply IHf. intros t T. apply (D t T).
    + apply derivable_continuous_pt. exists (slope_of g (value f (fun a => c a + s * (d a - c a)))).
      apply has_slope. apply (D s S).
Qed.

(** Opposite signs at two points of the box: a zero between them. *)
Lemma zero_between c d : inside c -> inside d -> value e c < 0 -> 0 < value e d ->
  exists p, inside p /\ value e p = 0.
Proof.
  intros C D Vc Vd.
  assert (B : forall t, 0 <= t <= 1 -> inside (fun a => c a + t * (d a - c a))).
  { intros t T a. specialize (C a). specialize (D a). nra. }
  destruct (IVT_interv (fun t => value e (fun a => c a + t * (d a - c a))) 0 1) as (t & T & Z).
  - intros s S. apply continuous_on_segment; [|exact S]. intros t T. apply defined_in_box. auto.
  - lra.
  - replace (fun a => c a + 0 * (d a - c a)) with c; [exact Vc|].
    apply functional_extensionality. intros a. ring.
  - replace (fun a => c a + 1 * (d a - c a)) with d; [exact Vd|].
    apply functional_extensionality. intros a. ring.
  - exists (fun a => c a + t * (d a - c a)). split; [apply B; exact T|exact Z].
Qed.

(** leaf_content = certified: there is a zero in the box. *)
Theorem leaf_content_certified_sound :
  (forall a, B2R (lo a) <= B2R (hi a)) -> leaf_content = certified ->
  exists p, inside p /\ value e p = 0.
Proof.
  intros O H. unfold leaf_content in H. cbv zeta in H.
  destruct (existsb is_positive (map (certified_sign_at e) corners) &&
            existsb is_negative (map (certified_sign_at e) corners)) eqn:S.
  2: { destruct (negb _ && negb _); [discriminate|]. destruct (_ || _); discriminate. }
  apply andb_true_iff in S. rewrite !existsb_exists in S.
  destruct S as [(s1 & S1 & P1) (s2 & S2 & P2)].
  apply in_map_iff in S1. destruct S1 as (k1 & E1 & K1).
  apply in_map_iff in S2. destruct S2 as (k2 & E2 & K2).
  destruct s1; try discriminate. destruct s2; try discriminate.
  apply zero_between with (real k2) (real k1); try (apply corner_inside; assumption).
  - apply certified_negative with (2 := E2).
    apply sign_at_correct; [apply corner_finite; assumption|apply corner_inside; assumption].
  - apply certified_positive with (2 := E1).
    apply sign_at_correct; [apply corner_finite; assumption|apply corner_inside; assumption].
Qed.
End Centre.
End Box.

(** * The centre of the mean value form: lower / 2 + upper / 2, in any rounding mode *)
Definition halves_sum m (two l u : num) : num := Bplus m (Bdiv m l two) (Bdiv m u two).

(** It lies in the box where halving is exact (no odd multiple of the least subnormal). *)
Theorem centre_in_box m (two l u : num) :
  B2R two = 2 -> is_finite l = true -> is_finite u = true -> B2R l <= B2R u ->
  generic_format radix2 (SpecFloat.fexp prec emax) (B2R l / 2) ->
  generic_format radix2 (SpecFloat.fexp prec emax) (B2R u / 2) ->
  is_finite (halves_sum m two l u) = true /\ B2R l <= B2R (halves_sum m two l u) <= B2R u.
Proof.
  intros T Fl Fu O Gl Gu.
  assert (H : forall x : num, is_finite x = true ->
    generic_format radix2 (SpecFloat.fexp prec emax) (B2R x / 2) ->
    is_finite (Bdiv m x two) = true /\ B2R (Bdiv m x two) = B2R x / 2).
  { intros x F G. pose proof (Bdiv_correct prec emax _ _ m x two) as C. rewrite T in C.
    rewrite round_generic in C by (try exact G; auto with typeclass_instances).
    rewrite Rlt_bool_true in C.
    - destruct C as (E & F' & _); [lra|]. split; congruence.
    - pose proof (abs_B2R_lt_emax prec emax x) as A. apply Rabs_lt_inv in A.
      apply Rabs_lt. split; lra. }
  destruct (H l Fl Gl) as [F1 E1], (H u Fu Gu) as [F2 E2].
  pose proof (Bplus_correct prec emax _ _ m _ _ F1 F2) as C. rewrite E1, E2 in C.
  assert (B : B2R l <= round radix2 (SpecFloat.fexp prec emax) (round_mode m) (B2R l / 2 + B2R u / 2)
              <= B2R u).
  { split.
    - apply round_ge_generic; [apply fexp_correct; exact Hprec|auto with typeclass_instances| |lra].
      apply generic_format_B2R.
    - apply round_le_generic; [apply fexp_correct; exact Hprec|auto with typeclass_instances| |lra].
      apply generic_format_B2R. }
  rewrite Rlt_bool_true in C.
  - destruct C as (E & F & _). unfold halves_sum. rewrite E. auto.
  - pose proof (abs_B2R_lt_emax prec emax l) as A. apply Rabs_lt_inv in A.
    pose proof (abs_B2R_lt_emax prec emax u) as A'. apply Rabs_lt_inv in A'.
    apply Rabs_lt. split; lra.
Qed.
End Formulas.

(** Where it is not, the centre may leave the box: upward, the centre of [2^-1074, 2^-1074] is
    2^-1073. (Then leaf_content's `none` and has_no_zero by the mean value form are not covered by
    the theorems above: a domain that is flat at an odd multiple of the least subnormal.) *)
Example centre_outside_a_flat_subnormal_box :
  let num m e := binary_normalize 53 1024 eq_refl eq_refl mode_NE m e false in
  let tiny := num 1%Z (-1074)%Z in
  Bltb tiny (@halves_sum 53 1024 eq_refl eq_refl mode_UP (num 2%Z 0%Z) tiny tiny) = true.
Proof. vm_compute. reflexivity. Qed.

(** * The descent (voxelizer.hpp): every octant of the last level that holds a zero is kept *)
Section Descent.
Variable cell : Type.
Variable child : cell -> nat -> cell.
(** The cell's part within the domain holds a zero. *)
Variable holds : cell -> Prop.
Hypothesis held_by_parent : forall c i, holds (child c i) -> holds c.
(** has_no_zero (or an empty part), and leaf_content = none. *)
Variable discarded none_left : cell -> bool.
Hypothesis discarded_sound : forall c, discarded c = true -> ~ holds c.
Hypothesis none_left_sound : forall c, none_left c = true -> ~ holds c.

(** nodes_below and leaves_below: what is kept `levels` below c. *)
Fixpoint kept (levels : nat) (c : cell) : list cell :=
  match levels with
  | O => [c]
  | S n =>
      flat_map (fun i =>
        let k := child c i in
        if discarded k || (match n with O => none_left k | _ => false end) then [] else kept n k)
        [0; 1; 2; 3; 4; 5; 6; 7]%nat
  end.
Fixpoint descendant (c : cell) (path : list nat) : cell :=
  match path with [] => c | i :: r => descendant (child c i) r end.

Lemma held_by_ancestor c path : holds (descendant c path) -> holds c.
Proof. revert c. induction path as [|i r IH]; intros c H; [exact H|]. apply (held_by_parent c i), IH, H. Qed.

Theorem zeros_are_kept c path : Forall (fun i => (i < 8)%nat) path ->
  holds (descendant c path) -> In (descendant c path) (kept (length path) c).
Proof.
  revert c. induction path as [|i r IH]; intros c F H; [left; reflexivity|].
  inversion F as [|? ? Fi Fr]; subst. cbn [length kept descendant] in *.
  apply in_flat_map. exists i. split.
  - do 8 (destruct i as [|i]; [simpl; tauto|]). lia.
  - cbv zeta. destruct (discarded (child c i)) eqn:D.
    + exfalso. exact (discarded_sound _ D (held_by_ancestor _ _ H)).
    + destruct (match length r with O => none_left (child c i) | _ => false end) eqn:N.
      * exfalso. destruct r; [|discriminate N]. exact (none_left_sound _ N H).
      * cbn [orb]. apply IH; assumption.
Qed.
End Descent.
