(** Interval arithmetic as interval/include/graze/interval.hpp and, for products and squares, the
    operators of Boost.Interval that it lists do it: the same cases over Flocq's floats with directed
    roundings, of any precision. Each operation's result contains every real result of members,
    whatever overflows or underflows, for unbounded operands too.

    [contains I r] says that the real r is in I: a bound may be an infinity, which is an end and no
    member; a NaN bound contains nothing. The C++ names: add_down is [Bplus mode_DN], and so on. *)
From Coq Require Import ZArith Bool Reals Lia Lra Psatz.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model.
Open Scope R_scope.

Section Interval_arith.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.
Notation num := (float prec emax).
Notation fexp := (SpecFloat.fexp prec emax).
Notation zero := (zero prec emax).
Notation inf := (infinity prec emax).
Notation minf := (minus_infinity prec emax).
Notation lt := (lt prec emax).
Notation le := (le prec emax).
Notation eq := (eq prec emax).

Record bounds := { lower : num; upper : num }.

(** l is a lower bound of r, u an upper one. *)
Definition below (l : num) (r : R) : Prop :=
  match l with B754_infinity s => s = true | B754_nan => False | _ => B2R l <= r end.
Definition above (u : num) (r : R) : Prop :=
  match u with B754_infinity s => s = false | B754_nan => False | _ => r <= B2R u end.
Definition contains (I : bounds) (r : R) : Prop := below (lower I) r /\ above (upper I) r.

(** checking::is_empty *)
Definition is_empty (I : bounds) : bool :=
  negb (le (lower I) (upper I) && lt (lower I) inf && lt minf (upper I)).
Definition empty_set : bounds := {| lower := B754_nan; upper := B754_nan |}.
Definition whole_line : bounds := {| lower := minf; upper := inf |}.
Definition only_zero : bounds := {| lower := zero; upper := zero |}.

(** * The operations, as the code has them *)
Definition add (x y : bounds) : bounds :=
  {| lower := Bplus mode_DN (lower x) (lower y); upper := Bplus mode_UP (upper x) (upper y) |}.
Definition sub (x y : bounds) : bounds :=
  {| lower := Bminus mode_DN (lower x) (upper y); upper := Bminus mode_UP (upper x) (lower y) |}.

Definition down (a b : num) : num := Bmult mode_DN a b.
Definition up (a b : num) : num := Bmult mode_UP a b.
(** std::min and std::max *)
Definition min2 (a b : num) : num := if lt b a then b else a.
Definition max2 (a b : num) : num := if lt a b then b else a.
Definition is_neg (a : num) : bool := lt a zero.
Definition is_pos (a : num) : bool := lt zero a.

(** boost::numeric::operator*: nine cases by the signs of the bounds. *)
Definition mul (x y : bounds) : bounds :=
  if is_empty x || is_empty y then empty_set else
  let xl := lower x in let xu := upper x in let yl := lower y in let yu := upper y in
  if is_neg xl then
    if is_pos xu then
      if is_neg yl then
        if is_pos yu
        then {| lower := min2 (down xl yu) (down xu yl); upper := max2 (up xl yl) (up xu yu) |}
        else {| lower := down xu yl; upper := up xl yl |}
      else if is_pos yu then {| lower := down xl yu; upper := up xu yu |} else only_zero
    else
      if is_neg yl then
        if is_pos yu then {| lower := down xl yu; upper := up xl yl |}
        else {| lower := down xu yu; upper := up xl yl |}
      else if is_pos yu then {| lower := down xl yu; upper := up xu yl |} else only_zero
  else
    if is_pos xu then
      if is_neg yl then
        if is_pos yu then {| lower := down xu yl; upper := up xu yu |}
        else {| lower := down xu yl; upper := up xl yu |}
      else if is_pos yu then {| lower := down xl yl; upper := up xu yu |} else only_zero
    else only_zero.

(** boost::numeric::square *)
Definition square (x : bounds) : bounds :=
  if is_empty x then empty_set else
  let xl := lower x in let xu := upper x in
  if is_neg xu then {| lower := down xu xu; upper := up xl xl |}
  else if is_pos xl then {| lower := down xl xl; upper := up xu xu |}
  else {| lower := zero; upper := if lt xu (Bopp xl) then up xl xl else up xu xu |}.

(** detail::divide *)
Definition quotient_down (a b : num) : num := Bdiv mode_DN a b.
Definition quotient_up (a b : num) : num := Bdiv mode_UP a b.
Definition div (x y : bounds) : bounds :=
  if is_empty x || is_empty y then empty_set else
  let a := lower x in let b := upper x in let c := lower y in let d := upper y in
  if eq c zero && eq d zero then empty_set else
  if eq a zero && eq b zero then only_zero else
  if lt c zero && lt zero d then whole_line else
  if le zero c then
    if le zero a then
      {| lower := quotient_down a d; upper := if eq c zero then inf else quotient_up b c |}
    else if le b zero then
      {| lower := if eq c zero then minf else quotient_down a c; upper := quotient_up b d |}
    else if eq c zero then whole_line
    else {| lower := quotient_down a c; upper := quotient_up b c |}
  else
    if le zero a then
      {| lower := if eq d zero then minf else quotient_down b d; upper := quotient_up a c |}
    else if le b zero then
      {| lower := quotient_down b c; upper := if eq d zero then inf else quotient_up a d |}
    else if eq d zero then whole_line
    else {| lower := quotient_down b d; upper := quotient_up a d |}.

(** * Directed operations bound the real result, overflow included *)
Lemma sign_of_real (x : num) : if Bsign x then B2R x <= 0 else 0 <= B2R x.
Proof.
  destruct x as [s|s| |s m e H]; simpl; try (destruct s; lra); try lra.
  destruct s; simpl.
  - apply F2R_le_0. simpl. lia.
  - apply F2R_ge_0. simpl. lia.
Qed.

Lemma below_finite (z : num) r : is_finite z = true -> B2R z <= r -> below z r.
Proof. destruct z; simpl; easy. Qed.
Lemma above_finite (z : num) r : is_finite z = true -> r <= B2R z -> above z r.
Proof. destruct z; simpl; easy. Qed.

(** What a correct operation with rounding down gives for the exact value v <= r. *)
Lemma rounded_down (z : num) (v r : R) :
  (if Rlt_bool (Rabs (round radix2 fexp (round_mode mode_DN) v)) (bpow radix2 emax)
   then B2R z = round radix2 fexp (round_mode mode_DN) v /\ is_finite z = true
   else exists s, B2SF z = binary_overflow prec emax mode_DN s /\ (s = false -> 0 <= v)) ->
  v <= r -> below z r.
Proof.
  intros H Hv. destruct (Rlt_bool_spec (Rabs (round radix2 fexp (round_mode mode_DN) v))
    (bpow radix2 emax)) as [Hl|Hl].
  - destruct H as [H F]. apply below_finite; [exact F|]. rewrite H.
    apply Rle_trans with v; [|exact Hv].
    apply round_DN_pt. apply fexp_correct. exact Hprec.
  - destruct H as (s & H & Hs). unfold binary_overflow in H. destruct s; simpl in H.
    + destruct z; try discriminate. simpl in *. congruence.
    + assert (F : is_finite z = true) by (destruct z; try discriminate; reflexivity).
      apply below_finite; [exact F|].
      pose proof (abs_B2R_lt_emax prec emax z) as A. apply Rabs_lt_inv in A.
      assert (R0 : 0 <= round radix2 fexp (round_mode mode_DN) v).
      { apply round_ge_generic; [apply fexp_correct; exact Hprec|auto with typeclass_instances| |].
        apply generic_format_0. apply Hs; reflexivity. }
      rewrite Rabs_pos_eq in Hl by exact R0.
      assert (round radix2 fexp (round_mode mode_DN) v <= v).
      { apply round_DN_pt. apply fexp_correct. exact Hprec. }
      lra.
Qed.

Lemma rounded_up (z : num) (v r : R) :
  (if Rlt_bool (Rabs (round radix2 fexp (round_mode mode_UP) v)) (bpow radix2 emax)
   then B2R z = round radix2 fexp (round_mode mode_UP) v /\ is_finite z = true
   else exists s, B2SF z = binary_overflow prec emax mode_UP s /\ (s = true -> v <= 0)) ->
  r <= v -> above z r.
Proof.
  intros H Hv. destruct (Rlt_bool_spec (Rabs (round radix2 fexp (round_mode mode_UP) v))
    (bpow radix2 emax)) as [Hl|Hl].
  - destruct H as [H F]. apply above_finite; [exact F|]. rewrite H.
    apply Rle_trans with v; [exact Hv|].
    apply round_UP_pt. apply fexp_correct. exact Hprec.
  - destruct H as (s & H & Hs). unfold binary_overflow in H. destruct s; simpl in H.
    + assert (F : is_finite z = true) by (destruct z; try discriminate; reflexivity).
      apply above_finite; [exact F|].
      pose proof (abs_B2R_lt_emax prec emax z) as A. apply Rabs_lt_inv in A.
      assert (R0 : round radix2 fexp (round_mode mode_UP) v <= 0).
      { apply round_le_generic; [apply fexp_correct; exact Hprec|auto with typeclass_instances| |].
        apply generic_format_0. apply Hs; reflexivity. }
      rewrite Rabs_left1 in Hl by exact R0.
      assert (v <= round radix2 fexp (round_mode mode_UP) v).
      { apply round_UP_pt. apply fexp_correct. exact Hprec. }
      lra.
    + destruct z; try discriminate. simpl in *. congruence.
Qed.


Ltac both_signs a b :=
  let A := fresh in let B := fresh in
  pose proof (sign_of_real a) as A; pose proof (sign_of_real b) as B;
  destruct (Bsign a), (Bsign b); simpl in *; try discriminate.

Lemma add_down_finite (a b : num) r :
  is_finite a = true -> is_finite b = true -> B2R a + B2R b <= r -> below (Bplus mode_DN a b) r.
Proof.
  intros Fa Fb H. apply rounded_down with (B2R a + B2R b); [|exact H].
  pose proof (Bplus_correct prec emax _ _ mode_DN a b Fa Fb) as C.
  destruct Rlt_bool; [easy|]. exists (Bsign a). destruct C as [C S]. split; [exact C|].
  intros P. both_signs a b; lra.
Qed.
Lemma add_up_finite (a b : num) r :
  is_finite a = true -> is_finite b = true -> r <= B2R a + B2R b -> above (Bplus mode_UP a b) r.
Proof.
  intros Fa Fb H. apply rounded_up with (B2R a + B2R b); [|exact H].
  pose proof (Bplus_correct prec emax _ _ mode_UP a b Fa Fb) as C.
  destruct Rlt_bool; [easy|]. exists (Bsign a). destruct C as [C S]. split; [exact C|].
  intros P. both_signs a b; lra.
Qed.
Lemma sub_down_finite (a b : num) r :
  is_finite a = true -> is_finite b = true -> B2R a - B2R b <= r -> below (Bminus mode_DN a b) r.
Proof.
  intros Fa Fb H. apply rounded_down with (B2R a - B2R b); [|exact H].
  pose proof (Bminus_correct prec emax _ _ mode_DN a b Fa Fb) as C.
  destruct Rlt_bool; [easy|]. exists (Bsign a). destruct C as [C S]. split; [exact C|].
  intros P. both_signs a b; lra.
Qed.
Lemma sub_up_finite (a b : num) r :
  is_finite a = true -> is_finite b = true -> r <= B2R a - B2R b -> above (Bminus mode_UP a b) r.
Proof.
  intros Fa Fb H. apply rounded_up with (B2R a - B2R b); [|exact H].
  pose proof (Bminus_correct prec emax _ _ mode_UP a b Fa Fb) as C.
  destruct Rlt_bool; [easy|]. exists (Bsign a). destruct C as [C S]. split; [exact C|].
  intros P. both_signs a b; lra.
Qed.
Lemma mul_down_finite (a b : num) r :
  is_finite a = true -> is_finite b = true -> B2R a * B2R b <= r -> below (down a b) r.
Proof.
  intros Fa Fb H. apply rounded_down with (B2R a * B2R b); [|exact H].
  pose proof (Bmult_correct prec emax _ _ mode_DN a b) as C. rewrite Fa, Fb in C.
  destruct Rlt_bool; [easy|]. eexists. split; [exact C|].
  intros P. both_signs a b; nra.
Qed.
Lemma mul_up_finite (a b : num) r :
  is_finite a = true -> is_finite b = true -> r <= B2R a * B2R b -> above (up a b) r.
Proof.
  intros Fa Fb H. apply rounded_up with (B2R a * B2R b); [|exact H].
  pose proof (Bmult_correct prec emax _ _ mode_UP a b) as C. rewrite Fa, Fb in C.
  destruct Rlt_bool; [easy|]. eexists. split; [exact C|].
  intros P. both_signs a b; nra.
Qed.

Lemma sign_of_quotient (a b : num) : B2R b <> 0 ->
  if xorb (Bsign a) (Bsign b) then B2R a / B2R b <= 0 else 0 <= B2R a / B2R b.
Proof.
  intros Z. both_signs a b.
  - assert (/ B2R b < 0) by (apply Rinv_lt_0_compat; lra). unfold Rdiv. nra.
  - assert (0 < / B2R b) by (apply Rinv_0_lt_compat; lra). unfold Rdiv. nra.
  - assert (/ B2R b < 0) by (apply Rinv_lt_0_compat; lra). unfold Rdiv. nra.
  - assert (0 < / B2R b) by (apply Rinv_0_lt_compat; lra). unfold Rdiv. nra.
Qed.
Lemma div_down_finite (a b : num) r :
  is_finite a = true -> B2R b <> 0 -> B2R a / B2R b <= r -> below (quotient_down a b) r.
Proof.
  intros Fa Zb H. apply rounded_down with (B2R a / B2R b); [|exact H].
  pose proof (Bdiv_correct prec emax _ _ mode_DN a b Zb) as C. rewrite Fa in C.
  destruct Rlt_bool; [easy|]. eexists. split; [exact C|].
  intros P. pose proof (sign_of_quotient a b Zb) as Q. rewrite P in Q. exact Q.
Qed.
Lemma div_up_finite (a b : num) r :
  is_finite a = true -> B2R b <> 0 -> r <= B2R a / B2R b -> above (quotient_up a b) r.
Proof.
  intros Fa Zb H. apply rounded_up with (B2R a / B2R b); [|exact H].
  pose proof (Bdiv_correct prec emax _ _ mode_UP a b Zb) as C. rewrite Fa in C.
  destruct Rlt_bool; [easy|]. eexists. split; [exact C|].
  intros P. pose proof (sign_of_quotient a b Zb) as Q. rewrite P in Q. exact Q.
Qed.

(** * Infinite bounds *)
Lemma infinity_times m s (b : num) : is_finite b = true -> B2R b <> 0 ->
  Bmult m (B754_infinity s) b = B754_infinity (if Rlt_bool (B2R b) 0 then negb s else s).
Proof.
  destruct b as [t|t| |t e f H]; simpl; try easy; try lra. intros _ _. f_equal.
  destruct t; simpl.
  - rewrite Rlt_bool_true; [destruct s; reflexivity|]. apply F2R_lt_0. simpl. lia.
  - rewrite Rlt_bool_false; [destruct s; reflexivity|]. apply F2R_ge_0. simpl. lia.
Qed.
Lemma times_infinity m s (b : num) : is_finite b = true -> B2R b <> 0 ->
  Bmult m b (B754_infinity s) = B754_infinity (if Rlt_bool (B2R b) 0 then negb s else s).
Proof.
  destruct b as [t|t| |t e f H]; simpl; try easy; try lra. intros _ _. f_equal.
  destruct t; simpl.
  - rewrite Rlt_bool_true; [destruct s; reflexivity|]. apply F2R_lt_0. simpl. lia.
  - rewrite Rlt_bool_false; [destruct s; reflexivity|]. apply F2R_ge_0. simpl. lia.
Qed.
Lemma infinity_over m s (b : num) : is_finite b = true -> B2R b <> 0 ->
  Bdiv m (B754_infinity s) b = B754_infinity (if Rlt_bool (B2R b) 0 then negb s else s).
Proof.
  destruct b as [t|t| |t e f H]; simpl; try easy; try lra. intros _ _. f_equal.
  destruct t; simpl.
  - rewrite Rlt_bool_true; [destruct s; reflexivity|]. apply F2R_lt_0. simpl. lia.
  - rewrite Rlt_bool_false; [destruct s; reflexivity|]. apply F2R_ge_0. simpl. lia.
Qed.
Lemma over_infinity m s (a : num) : is_finite a = true ->
  exists t, Bdiv m a (B754_infinity s) = B754_zero t.
Proof. destruct a; simpl; try discriminate; intros; eexists; reflexivity. Qed.

(** A lower bound is minus infinity or a finite number; an upper one likewise. *)
Lemma below_cases l r : below l r -> l = minf \/ (is_finite l = true /\ B2R l <= r).
Proof. destruct l as [| [] | |]; simpl; try easy; auto. Qed.
Lemma above_cases u r : above u r -> u = inf \/ (is_finite u = true /\ r <= B2R u).
Proof. destruct u as [| [] | |]; simpl; try easy; auto. Qed.

Lemma lt_finite_inf (a : num) : is_finite a = true -> lt a inf = true.
Proof. destruct a as [| | |[]]; easy. Qed.
Lemma lt_minf_finite (a : num) : is_finite a = true -> lt minf a = true.
Proof. destruct a as [| | |[]]; easy. Qed.
Lemma le_finite_inf (a : num) : is_finite a = true -> le a inf = true.
Proof. destruct a as [| | |[]]; easy. Qed.
Lemma le_minf_finite (a : num) : is_finite a = true -> le minf a = true.
Proof. destruct a as [| | |[]]; easy. Qed.

(** What holds a number is not empty. *)
Lemma contains_not_empty I r : contains I r -> is_empty I = false.
Proof.
  intros [L U]. unfold is_empty. apply negb_false_iff.
  destruct (below_cases _ _ L) as [->|[Fl Hl]], (above_cases _ _ U) as [->|[Fu Hu]].
  - reflexivity.
  - rewrite (le_minf_finite (upper I)), (lt_minf_finite (upper I)) by assumption. reflexivity.
  - rewrite (le_finite_inf (lower I)), (lt_finite_inf (lower I)) by assumption. reflexivity.
  - rewrite (lt_finite_inf (lower I)), (lt_minf_finite (upper I)) by assumption. unfold le.
    rewrite Bleb_correct by assumption. rewrite Rle_bool_true by lra. reflexivity.
Qed.

(** * Sums *)
(** x + y encloses every sum of members. *)
Theorem add_encloses X Y x y : contains X x -> contains Y y -> contains (add X Y) (x + y).
Proof.
  intros [L U] [L' U']. split; simpl.
  - destruct (below_cases _ _ L) as [->|[F H]], (below_cases _ _ L') as [->|[F' H']];
      try reflexivity.
    + destruct (lower Y); try discriminate; reflexivity.
    + destruct (lower X); try discriminate; reflexivity.
    + apply add_down_finite; try assumption. lra.
  - destruct (above_cases _ _ U) as [->|[F H]], (above_cases _ _ U') as [->|[F' H']];
      try reflexivity.
    + destruct (upper Y); try discriminate; reflexivity.
    + destruct (upper X); try discriminate; reflexivity.
    + apply add_up_finite; try assumption. lra.
Qed.

(** x - y encloses every difference of members. *)
Theorem sub_encloses X Y x y : contains X x -> contains Y y -> contains (sub X Y) (x - y).
Proof.
  intros [L U] [L' U']. split; simpl.
  - destruct (below_cases _ _ L) as [->|[F H]], (above_cases _ _ U') as [->|[F' H']];
      try reflexivity.
    + destruct (upper Y); try discriminate; reflexivity.
    + destruct (lower X); try discriminate; reflexivity.
    + apply sub_down_finite; try assumption. lra.
  - destruct (above_cases _ _ U) as [->|[F H]], (below_cases _ _ L') as [->|[F' H']];
      try reflexivity.
    + destruct (lower Y); try discriminate; reflexivity.
    + destruct (upper X); try discriminate; reflexivity.
    + apply sub_up_finite; try assumption. lra.
Qed.

(** * Products *)
Lemma number_cases (a : num) : is_nan a = false -> a = minf \/ a = inf \/ is_finite a = true.
Proof. destruct a as [| [] | |]; simpl; auto; discriminate. Qed.
Lemma finite_lt_minf (a : num) : is_finite a = true -> lt a minf = false.
Proof. destruct a as [| | |[]]; easy. Qed.
Lemma inf_lt_finite (a : num) : is_finite a = true -> lt inf a = false.
Proof. destruct a as [| | |[]]; easy. Qed.
Lemma lt_finite (a b : num) : is_finite a = true -> is_finite b = true ->
  lt a b = Rlt_bool (B2R a) (B2R b).
Proof. apply Bltb_correct. Qed.
Lemma below_is (z : num) r : is_finite z = true -> below z r -> B2R z <= r.
Proof. destruct z; easy. Qed.
Lemma above_is (z : num) r : is_finite z = true -> above z r -> r <= B2R z.
Proof. destruct z; easy. Qed.

(** The lesser of two numbers is a lower bound where either is; the greater an upper one. *)
Lemma min2_below (a b : num) r :
  is_nan a = false -> is_nan b = false -> below a r \/ below b r -> below (min2 a b) r.
Proof.
  intros Na Nb H. unfold min2.
  destruct (number_cases a Na) as [->|[->|Fa]], (number_cases b Nb) as [->|[->|Fb]];
    rewrite ?lt_finite_inf, ?lt_minf_finite, ?finite_lt_minf, ?inf_lt_finite by assumption;
    try exact eq_refl; try (destruct H as [H|H]; first [exact H|discriminate H]).
  rewrite lt_finite by assumption.
  case Rlt_bool_spec; intros C; destruct H as [H|H]; apply below_is in H; try assumption;
    apply below_finite; try assumption; lra.
Qed.
Lemma max2_above (a b : num) r :
  is_nan a = false -> is_nan b = false -> above a r \/ above b r -> above (max2 a b) r.
Proof.
  intros Na Nb H. unfold max2.
  destruct (number_cases a Na) as [->|[->|Fa]], (number_cases b Nb) as [->|[->|Fb]];
    rewrite ?lt_finite_inf, ?lt_minf_finite, ?finite_lt_minf, ?inf_lt_finite by assumption;
    try exact eq_refl; try (destruct H as [H|H]; first [exact H|discriminate H]).
  rewrite lt_finite by assumption.
  case Rlt_bool_spec; intros C; destruct H as [H|H]; apply above_is in H; try assumption;
    apply above_finite; try assumption; lra.
Qed.

Lemma below_not_nan (a : num) r : below a r -> is_nan a = false.
Proof. destruct a; easy. Qed.
Lemma above_not_nan (a : num) r : above a r -> is_nan a = false.
Proof. destruct a; easy. Qed.
Lemma down_not_nan (a b : num) : is_finite a = true -> is_finite b = true ->
  is_nan (down a b) = false.
Proof.
  intros Fa Fb. apply below_not_nan with (B2R a * B2R b). apply mul_down_finite; auto. lra.
Qed.
Lemma up_not_nan (a b : num) : is_finite a = true -> is_finite b = true -> is_nan (up a b) = false.
Proof.
  intros Fa Fb. apply above_not_nan with (B2R a * B2R b). apply mul_up_finite; auto. lra.
Qed.

Lemma is_neg_finite (a : num) : is_finite a = true -> is_neg a = Rlt_bool (B2R a) 0.
Proof. intros F. unfold is_neg. rewrite lt_finite by easy. reflexivity. Qed.
Lemma is_pos_finite (a : num) : is_finite a = true -> is_pos a = Rlt_bool 0 (B2R a).
Proof. intros F. unfold is_pos. rewrite lt_finite by easy. reflexivity. Qed.

(** Infinite factors: the product is the infinity that the signs give. *)
Ltac infinite :=
  unfold down, up, minus_infinity, infinity;
  repeat first
    [ rewrite (infinity_times) by (assumption || lra)
    | rewrite times_infinity by (assumption || lra) ];
  try rewrite Rlt_bool_true by lra; try rewrite Rlt_bool_false by lra.

Ltac product_bound :=
  match goal with
  | |- below (down ?a ?b) _ =>
      first [ apply mul_down_finite; [assumption|assumption|nra] | infinite; reflexivity ]
  | |- above (up ?a ?b) _ =>
      first [ apply mul_up_finite; [assumption|assumption|nra] | infinite; reflexivity ]
  end.
Ltac not_nan :=
  first [ apply down_not_nan; assumption | apply up_not_nan; assumption | infinite; reflexivity ].

(** Both outcomes of every comparison with 0 in the goal. *)
Ltac by_signs :=
  repeat match goal with
  | |- context [is_neg minf] => change (is_neg minf) with true
  | |- context [is_pos inf] => change (is_pos inf) with true
  | |- context [is_neg inf] => change (is_neg inf) with false
  | |- context [is_pos minf] => change (is_pos minf) with false
  | F : is_finite ?a = true |- context [is_neg ?a] => rewrite (is_neg_finite a F)
  | F : is_finite ?a = true |- context [is_pos ?a] => rewrite (is_pos_finite a F)
  end; cbv iota;
  repeat (case Rlt_bool_spec; intros); cbv iota.

(** x * y encloses every product of members: the nine cases. *)
Theorem mul_encloses X Y x y : contains X x -> contains Y y -> contains (mul X Y) (x * y).
Proof.
  intros CX CY. unfold mul.
  rewrite (contains_not_empty _ _ CX), (contains_not_empty _ _ CY). simpl.
  destruct CX as [L U], CY as [L' U'].
  assert (Z : contains only_zero 0) by (split; simpl; lra).
  destruct X as [xl xu], Y as [yl yu]; cbn [lower upper] in *.
  destruct (below_cases _ _ L) as [->|[F1 H1]], (above_cases _ _ U) as [->|[F2 H2]],
    (below_cases _ _ L') as [->|[F3 H3]], (above_cases _ _ U') as [->|[F4 H4]];
    by_signs.
  all: try (replace (x * y) with 0 by (first [replace x with 0 by lra; ring | replace y with 0 by lra; ring]);
            exact Z).
  all: split; cbn [lower upper].
  all: try product_bound.
  all: try (apply min2_below; [not_nan|not_nan|]).
  all: try (apply max2_above; [not_nan|not_nan|]).
  all: destruct (Rle_dec 0 x), (Rle_dec 0 y);
    first [left; product_bound | right; product_bound].
Qed.

(** square(x) encloses every square of a member. *)
Theorem square_encloses X x : contains X x -> contains (square X) (x * x).
Proof.
  intros C. unfold square. rewrite (contains_not_empty _ _ C).
  destruct C as [L U], X as [xl xu]; cbn [lower upper] in *.
  destruct (below_cases _ _ L) as [->|[F1 H1]], (above_cases _ _ U) as [->|[F2 H2]].
  - split; [simpl; nra|reflexivity].
  - change (Bopp minf) with inf. rewrite (lt_finite_inf xu F2).
    by_signs; split; cbn [lower upper]; try product_bound; simpl; nra.
  - replace (lt inf (Bopp xl)) with false
      by (symmetry; apply inf_lt_finite; rewrite is_finite_Bopp; exact F1).
    by_signs; split; cbn [lower upper]; try product_bound; try (simpl; nra); try exact eq_refl.
  - rewrite lt_finite by (try rewrite is_finite_Bopp; assumption). rewrite B2R_Bopp.
    by_signs; split; cbn [lower upper]; try product_bound; simpl; nra.
Qed.

(** * Quotients *)
Lemma le_finite (a b : num) : is_finite a = true -> is_finite b = true ->
  le a b = Rle_bool (B2R a) (B2R b).
Proof. apply Bleb_correct. Qed.
Lemma eq_finite (a b : num) : is_finite a = true -> is_finite b = true ->
  eq a b = Req_bool (B2R a) (B2R b).
Proof. apply Beqb_correct. Qed.
Lemma lt_zero_finite (a : num) : is_finite a = true -> lt a zero = Rlt_bool (B2R a) 0.
Proof. intros F. apply lt_finite; easy. Qed.
Lemma zero_lt_finite (a : num) : is_finite a = true -> lt zero a = Rlt_bool 0 (B2R a).
Proof. intros F. apply lt_finite; easy. Qed.
Lemma le_zero_finite (a : num) : is_finite a = true -> le a zero = Rle_bool (B2R a) 0.
Proof. intros F. apply le_finite; easy. Qed.
Lemma zero_le_finite (a : num) : is_finite a = true -> le zero a = Rle_bool 0 (B2R a).
Proof. intros F. apply le_finite; easy. Qed.
Lemma eq_zero_finite (a : num) : is_finite a = true -> eq a zero = Req_bool (B2R a) 0.
Proof. intros F. apply eq_finite; easy. Qed.

Lemma quotient_le a b r : b <> 0 -> (0 < b -> a <= r * b) -> (b < 0 -> r * b <= a) -> a / b <= r.
Proof.
  intros Z P N. destruct (Rlt_dec 0 b) as [H|H].
  - apply Rmult_le_reg_r with b; [exact H|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra.
    rewrite Rmult_1_r. auto.
  - apply Rmult_le_reg_r with (- b); [lra|].
    replace (a / b * - b) with (- a) by (field; lra). assert (r * b <= a) by (apply N; lra). lra.
Qed.
Lemma le_quotient a b r : b <> 0 -> (0 < b -> r * b <= a) -> (b < 0 -> a <= r * b) -> r <= a / b.
Proof.
  intros Z P N. destruct (Rlt_dec 0 b) as [H|H].
  - apply Rmult_le_reg_r with b; [exact H|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra.
    rewrite Rmult_1_r. auto.
  - apply Rmult_le_reg_r with (- b); [lra|].
    replace (a / b * - b) with (- a) by (field; lra). assert (a <= r * b) by (apply N; lra). lra.
Qed.

Ltac quotient_bound :=
  match goal with
  | |- below (quotient_down minf _) _ =>
      unfold quotient_down, minus_infinity; rewrite infinity_over by (assumption || lra);
      first [rewrite Rlt_bool_true by lra | rewrite Rlt_bool_false by lra]; reflexivity
  | |- below (quotient_down inf _) _ =>
      unfold quotient_down, infinity; rewrite infinity_over by (assumption || lra);
      first [rewrite Rlt_bool_true by lra | rewrite Rlt_bool_false by lra]; reflexivity
  | |- above (quotient_up minf _) _ =>
      unfold quotient_up, minus_infinity; rewrite infinity_over by (assumption || lra);
      first [rewrite Rlt_bool_true by lra | rewrite Rlt_bool_false by lra]; reflexivity
  | |- above (quotient_up inf _) _ =>
      unfold quotient_up, infinity; rewrite infinity_over by (assumption || lra);
      first [rewrite Rlt_bool_true by lra | rewrite Rlt_bool_false by lra]; reflexivity
  | F : is_finite ?a = true |- below (quotient_down ?a (Model.infinity _ _)) _ =>
      let t := fresh in let E := fresh in
      destruct (over_infinity mode_DN false a F) as [t E]; unfold quotient_down, infinity;
      rewrite E; simpl; nra
  | F : is_finite ?a = true |- below (quotient_down ?a (Model.minus_infinity _ _)) _ =>
      let t := fresh in let E := fresh in
      destruct (over_infinity mode_DN true a F) as [t E]; unfold quotient_down, minus_infinity;
      rewrite E; simpl; nra
  | F : is_finite ?a = true |- above (quotient_up ?a (Model.infinity _ _)) _ =>
      let t := fresh in let E := fresh in
      destruct (over_infinity mode_UP false a F) as [t E]; unfold quotient_up, infinity;
      rewrite E; simpl; nra
  | F : is_finite ?a = true |- above (quotient_up ?a (Model.minus_infinity _ _)) _ =>
      let t := fresh in let E := fresh in
      destruct (over_infinity mode_UP true a F) as [t E]; unfold quotient_up, minus_infinity;
      rewrite E; simpl; nra
  | |- below (quotient_down ?a ?b) _ =>
      apply div_down_finite; [assumption|lra|apply quotient_le; [lra|intros; nra|intros; nra]]
  | |- above (quotient_up ?a ?b) _ =>
      apply div_up_finite; [assumption|lra|apply le_quotient; [lra|intros; nra|intros; nra]]
  end.

Ltac compare_with_zero :=
  change (lt minf zero) with true; change (eq minf zero) with false;
  change (eq inf zero) with false; change (lt zero inf) with true;
  change (le zero minf) with false; change (le inf zero) with false;
  change (le minf zero) with true; change (le zero inf) with true;
  repeat match goal with
  | F : is_finite ?a = true |- context [lt ?a zero] => rewrite (lt_zero_finite a F)
  | F : is_finite ?a = true |- context [lt zero ?a] => rewrite (zero_lt_finite a F)
  | F : is_finite ?a = true |- context [le ?a zero] => rewrite (le_zero_finite a F)
  | F : is_finite ?a = true |- context [le zero ?a] => rewrite (zero_le_finite a F)
  | F : is_finite ?a = true |- context [eq ?a zero] => rewrite (eq_zero_finite a F)
  end; cbn [andb].

(** x / y encloses x / y for members x and y <> 0. *)
Theorem div_encloses X Y x y :
  contains X x -> contains Y y -> y <> 0 -> contains (div X Y) (x / y).
Proof.
  intros CX CY Hy. unfold div.
  rewrite (contains_not_empty _ _ CX), (contains_not_empty _ _ CY). cbn [orb].
  destruct CX as [L U], CY as [L' U'].
  assert (S : exists s, s = x / y /\ x = s * y) by (exists (x / y); split; [reflexivity|field; exact Hy]).
  destruct S as (s & <- & ->).
  assert (W : contains whole_line s) by (split; reflexivity).
  assert (P : (0 < s \/ s < 0 \/ s = 0) /\ (0 < y \/ y < 0)) by lra.
  destruct X as [a b], Y as [c d]; cbn [lower upper] in *.
  destruct (below_cases _ _ L) as [->|[F1 H1]], (above_cases _ _ U) as [->|[F2 H2]],
    (below_cases _ _ L') as [->|[F3 H3]], (above_cases _ _ U') as [->|[F4 H4]];
    compare_with_zero;
    repeat (first [case Req_bool_spec | case Rlt_bool_spec | case Rle_bool_spec]; intros; cbn [andb]);
    cbv iota; try exact W; try lra.
  all: try (assert (s = 0) by nra; subst s; split; simpl; lra).
  all: split; cbn [lower upper]; try exact eq_refl.
  all: destruct P as [[P|[P|P]] [Q|Q]]; try nra.
  all: quotient_bound.
Qed.

(** * The operators without branches (packed_arithmetic.hpp), on bounded operands *)

(** Negation swaps the bounds, exactly. *)
Definition neg (x : bounds) : bounds := {| lower := Bopp (upper x); upper := Bopp (lower x) |}.
Theorem neg_encloses X x : contains X x -> contains (neg X) (- x).
Proof.
  intros [L U]. split; cbn [lower upper neg].
  - destruct (above_cases _ _ U) as [->|[F H]]; [reflexivity|].
    apply below_finite; [rewrite is_finite_Bopp; exact F|]. rewrite B2R_Bopp. lra.
  - destruct (below_cases _ _ L) as [->|[F H]]; [reflexivity|].
    apply above_finite; [rewrite is_finite_Bopp; exact F|]. rewrite B2R_Bopp. lra.
Qed.

(** maxpd: the second operand where they are equal (or one is NaN). *)
Definition max_packed (a b : num) : num := if lt b a then a else b.
Lemma max_packed_above (a b : num) r : is_nan a = false -> is_nan b = false ->
  above a r \/ above b r -> above (max_packed a b) r.
Proof.
  intros Na Nb H. unfold max_packed.
  destruct (number_cases a Na) as [->|[->|Fa]], (number_cases b Nb) as [->|[->|Fb]];
    rewrite ?lt_finite_inf, ?lt_minf_finite, ?finite_lt_minf, ?inf_lt_finite by assumption;
    try exact eq_refl; try (destruct H as [H|H]; first [exact H|discriminate H]).
  rewrite lt_finite by assumption.
  case Rlt_bool_spec; intros C; destruct H as [H|H]; apply above_is in H; try assumption;
    apply above_finite; try assumption; lra.
Qed.
Lemma max_packed_number (a b : num) : is_nan a = false -> is_nan b = false ->
  is_nan (max_packed a b) = false.
Proof. intros Na Nb. unfold max_packed. destruct (lt b a); assumption. Qed.

(** detail::packed::product: the greatest of four upward products, of each sign; the lower bound is
    kept negated, as the pair (-a, b). *)
Definition four_products (x y : bounds) : bounds :=
  let a := lower x in let b := upper x in let c := lower y in let d := upper y in
  {| lower := Bopp (max_packed (up (Bopp a) c) (max_packed (up (Bopp a) d)
                   (max_packed (up (Bopp b) c) (up (Bopp b) d))));
     upper := max_packed (up b d) (max_packed (up b c) (max_packed (up a d) (up a c))) |}.

Lemma opp_above_below (z : num) r : above z r -> below (Bopp z) (- r).
Proof.
  intros H. destruct (above_cases _ _ H) as [->|[F G]]; [reflexivity|].
  apply below_finite; [rewrite is_finite_Bopp; exact F|]. rewrite B2R_Bopp. lra.
Qed.

(** One of the four products is at least x y. *)
Lemma greatest_of_four a b c d x y : a <= x <= b -> c <= y <= d ->
  x * y <= a * c \/ x * y <= a * d \/ x * y <= b * c \/ x * y <= b * d.
Proof.
  intros Hx Hy. destruct (Rle_dec 0 y).
  - destruct (Rle_dec 0 b); [right; right; right|right; right; left]; nra.
  - destruct (Rle_dec 0 a); [right; left|left]; nra.
Qed.

(** The four products enclose every product of members of bounded intervals. *)
Theorem four_products_enclose X Y x y :
  is_finite (lower X) = true -> is_finite (upper X) = true ->
  is_finite (lower Y) = true -> is_finite (upper Y) = true ->
  contains X x -> contains Y y -> contains (four_products X Y) (x * y).
Proof.
  destruct X as [a b], Y as [c d]. cbn [lower upper]. intros Fa Fb Fc Fd [La Ub] [Lc Ud].
  cbn [lower upper] in *.
  apply below_is in La; [|assumption]. apply above_is in Ub; [|assumption].
  apply below_is in Lc; [|assumption]. apply above_is in Ud; [|assumption].
  split; cbn [lower upper four_products].
  - replace (x * y) with (- (- x * y)) by ring. apply opp_above_below.
    assert (Fna : is_finite (Bopp a) = true) by (rewrite is_finite_Bopp; exact Fa).
    assert (Fnb : is_finite (Bopp b) = true) by (rewrite is_finite_Bopp; exact Fb).
    destruct (greatest_of_four (- B2R b) (- B2R a) (B2R c) (B2R d) (- x) y) as [H|[H|[H|H]]];
      try lra;
      apply max_packed_above; repeat (first [apply up_not_nan; assumption|apply max_packed_number]).
    all: repeat first [left; apply mul_up_finite; rewrite ?B2R_Bopp; assumption
      | right; apply mul_up_finite; rewrite ?B2R_Bopp; assumption
      | right; apply max_packed_above; repeat (first [apply up_not_nan; assumption|apply max_packed_number])].
  - destruct (greatest_of_four (B2R a) (B2R b) (B2R c) (B2R d) x y) as [H|[H|[H|H]]]; try lra;
      apply max_packed_above; repeat (first [apply up_not_nan; assumption|apply max_packed_number]).
    all: repeat first [left; apply mul_up_finite; rewrite ?B2R_Bopp; assumption
      | right; apply mul_up_finite; rewrite ?B2R_Bopp; assumption
      | right; apply max_packed_above; repeat (first [apply up_not_nan; assumption|apply max_packed_number])].
Qed.

End Interval_arith.
