(** What passes the test nearly touches: if `touches_box` (ray_bounds.hpp) is true, the ray meets the
    box whose planes p are each moved outward by at most k |p - o|, o the origin's coordinate and
    k = (1 + eps)^3 - 1 with eps = 2^(1 - prec): each bound is the product of three roundings of
    relative error eps. In binary64 k < 2^-50, that is 8 units of 2^-53 (a little more than 6).

    Assumed, since relative errors say nothing where numbers underflow or overflow: the components of
    the direction and the distances p - o are 0 or between 2^-E and 2^E, 3 E <= emax - 2 (E = 340 in
    binary64). An axis along which the ray does not move is decided exactly; its planes are not
    restricted, and some component of the direction is not 0. For `directed` and `upward`. *)
From Coq Require Import ZArith Bool List Reals Lia Lra Psatz.
From Flocq Require Import Core BinarySingleNaN Relative Plus_error.
From Graze Require Import Model Interval_arith.
Open Scope R_scope.

Section Tightness.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.
Notation num := (float prec emax).
Notation zero := (Model.zero prec emax).
Notation inf := (Model.infinity prec emax).
Notation minf := (Model.minus_infinity prec emax).
Notation lt := (Model.lt prec emax).
Notation le := (Model.le prec emax).
Notation fexp := (SpecFloat.fexp prec emax).
Notation emin := (3 - emax - prec)%Z.
Notation below := (below prec emax).
Notation above := (above prec emax).

Definition eps : R := bpow radix2 (1 - prec).

(** * Relative errors *)
(** x is y with n roundings' relative error. *)
Definition close (n : nat) (x y : R) : Prop := Rabs (x - y) <= ((1 + eps) ^ n - 1) * Rabs y.

Lemma eps_pos : 0 < eps. Proof. apply bpow_gt_0. Qed.
Lemma power_ge_1 n : 1 <= (1 + eps) ^ n.
Proof. apply pow_R1_Rle. pose proof eps_pos. lra. Qed.

Lemma close_exact x : close 1 x x.
Proof.
  unfold close. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. simpl.
  pose proof eps_pos. pose proof (Rabs_pos x). nra.
Qed.

Lemma close_size n x y : close n x y -> Rabs x <= (1 + eps) ^ n * Rabs y.
Proof.
  unfold close. intros H. pose proof (Rabs_triang (x - y) y) as T.
  replace (x - y + y) with x in T by ring. lra.
Qed.

Lemma close_trans n m x y z : close n x y -> close m y z -> close (n + m) x z.
Proof.
  intros A B. pose proof (close_size _ _ _ B) as S. unfold close in *.
  replace (x - z) with ((x - y) + (y - z)) by ring.
  pose proof (Rabs_triang (x - y) (y - z)). rewrite pow_add.
  pose proof (power_ge_1 n). pose proof (power_ge_1 m). pose proof (Rabs_pos z).
  assert (((1 + eps) ^ n - 1) * Rabs y <= ((1 + eps) ^ n - 1) * ((1 + eps) ^ m * Rabs z))
    by (apply Rmult_le_compat_l; lra).
  nra.
Qed.

Lemma close_scaled n x y c : close n x y -> close n (c * x) (c * y).
Proof.
  unfold close. intros H. rewrite <- Rmult_minus_distr_l, !Rabs_mult.
  pose proof (Rabs_pos c). nra.
Qed.

Lemma close_product n m x y x' y' : close n x y -> close m x' y' -> close (n + m) (x * x') (y * y').
Proof.
  intros A B. apply close_trans with (y * x').
  - rewrite (Rmult_comm x), (Rmult_comm y). apply close_scaled. exact A.
  - apply close_scaled. exact B.
Qed.

Lemma close_opp n x y : close n x y -> close n (- x) (- y).
Proof.
  unfold close. intros H. replace (- x - - y) with (- (x - y)) by ring. rewrite !Rabs_Ropp. exact H.
Qed.

(** Zero, or of a size far from underflow and overflow. *)
Definition tame (e : Z) (x : R) : Prop := x = 0 \/ bpow radix2 (- e) <= Rabs x <= bpow radix2 e.

Lemma tame_opp e x : tame e x -> tame e (- x).
Proof. unfold tame. rewrite Rabs_Ropp. intros [->|H]; [left; ring|right; exact H]. Qed.

Lemma tame_product i j x y : tame i x -> tame j y -> tame (i + j) (x * y).
Proof.
  intros [->|X] [->|Y]; try (left; ring). right. rewrite Rabs_mult.
  replace (- (i + j))%Z with (- i + - j)%Z by ring. rewrite !bpow_plus.
  pose proof (bpow_gt_0 radix2 (- i)). pose proof (bpow_gt_0 radix2 (- j)).
  split; apply Rmult_le_compat; lra.
Qed.

Variable E : Z.
Hypothesis E_positive : (0 <= E)%Z.
Hypothesis E_small : (3 * E <= emax - 2)%Z.

Lemma prec_positive : (0 < prec)%Z. Proof. exact Hprec. Qed.
Lemma prec_below_emax : (prec < emax)%Z. Proof. exact Hmax. Qed.

Lemma bpow_in_format e : (emin <= e)%Z -> generic_format radix2 fexp (bpow radix2 e).
Proof. intros H. apply generic_format_FLT_bpow; [exact Hprec|exact H]. Qed.

(** A tame number rounds to a tame one, with a relative error of eps, and without overflow. *)
Lemma round_tame m e x : (0 <= e <= 3 * E)%Z -> tame e x ->
  let r := round radix2 fexp (round_mode m) x in
  tame e r /\ close 1 r x /\ Rabs r < bpow radix2 emax.
Proof.
  intros He T. pose proof prec_positive as P. pose proof prec_below_emax as Q.
  assert (V : Valid_exp fexp) by (apply fexp_correct; exact Hprec).
  destruct T as [->|[T1 T2]]; cbv zeta.
  - rewrite round_0 by auto with typeclass_instances.
    split; [left; reflexivity|]. split; [apply close_exact|]. rewrite Rabs_R0. apply bpow_gt_0.
  - assert (U : Rabs (round radix2 fexp (round_mode m) x) <= bpow radix2 e).
    { apply abs_round_le_generic; auto with typeclass_instances. apply bpow_in_format. lia. }
    split; [right; split|split].
    + apply abs_round_ge_generic; auto with typeclass_instances. apply bpow_in_format. lia.
    + exact U.
    + unfold close. simpl. rewrite Rmult_1_r. replace (1 + eps - 1) with eps by ring.
      apply Rlt_le. unfold eps. replace (1 - prec)%Z with (- prec + 1)%Z by ring.
      apply (relative_error_FLT radix2 emin prec Hprec (round_mode m) x).
      apply Rle_trans with (2 := T1). apply bpow_le. lia.
    + apply Rle_lt_trans with (1 := U). apply bpow_lt. lia.
Qed.

(** * Backends that are accurate in this range *)
Definition good_sub (op : num -> num -> num) : Prop := forall x y,
  is_finite x = true -> is_finite y = true -> tame E (B2R x - B2R y) ->
  is_finite (op x y) = true /\ tame E (B2R (op x y)) /\ close 1 (B2R (op x y)) (B2R x - B2R y).
Definition good_mul (op : num -> num -> num) : Prop := forall x y i j,
  is_finite x = true -> is_finite y = true -> tame i (B2R x) -> tame j (B2R y) ->
  (0 <= i + j <= 3 * E)%Z ->
  is_finite (op x y) = true /\ tame (i + j) (B2R (op x y)) /\
  close 1 (B2R (op x y)) (B2R x * B2R y).
Definition accurate (b : backend prec emax) : Prop :=
  good_sub (sub_down _ _ b) /\ good_sub (sub_up _ _ b) /\
  good_mul (mul_down _ _ b) /\ good_mul (mul_up _ _ b).

Lemma Bminus_good m : good_sub (Bminus m).
Proof.
  intros x y Fx Fy T. destruct (round_tame m E _ ltac:(lia) T) as (T' & C & B).
  pose proof (Bminus_correct prec emax _ _ m x y Fx Fy) as S.
  rewrite Rlt_bool_true in S by exact B. destruct S as (-> & F & _). auto.
Qed.
Lemma Bmult_good m : good_mul (Bmult m).
Proof.
  intros x y i j Fx Fy Tx Ty L.
  destruct (round_tame m (i + j) _ L (tame_product _ _ _ _ Tx Ty)) as (T' & C & B).
  pose proof (Bmult_correct prec emax _ _ m x y) as S.
  rewrite Rlt_bool_true in S by exact B. destruct S as (-> & F & _).
  rewrite Fx, Fy in F. auto.
Qed.

Theorem directed_accurate : accurate (directed prec emax).
Proof. split; [|split; [|split]]; simpl; first [apply Bminus_good|apply Bmult_good]. Qed.

Theorem upward_accurate : accurate (upward prec emax).
Proof.
  split; [|split; [|split]]; simpl; try apply Bminus_good; try apply Bmult_good.
  - intros x y Fx Fy T.
    assert (T' : tame E (B2R y - B2R x))
      by (replace (B2R y - B2R x) with (- (B2R x - B2R y)) by ring; apply tame_opp; exact T).
    destruct (Bminus_good mode_UP y x Fy Fx T') as (F & G & C).
    rewrite is_finite_Bopp, B2R_Bopp. split; [exact F|]. split; [apply tame_opp; exact G|].
    replace (B2R x - B2R y) with (- (B2R y - B2R x)) by ring. apply close_opp. exact C.
  - intros x y i j Fx Fy Tx Ty L.
    assert (Fo : is_finite (Bopp x) = true) by (rewrite is_finite_Bopp; exact Fx).
    assert (To : tame i (B2R (Bopp x))) by (rewrite B2R_Bopp; apply tame_opp; exact Tx).
    destruct (Bmult_good mode_UP (Bopp x) y i j Fo Fy To Ty L) as (F & G & C).
    rewrite is_finite_Bopp, B2R_Bopp. split; [exact F|]. split; [apply tame_opp; exact G|].
    rewrite B2R_Bopp in C. replace (B2R x * B2R y) with (- (- B2R x * B2R y)) by ring.
    apply close_opp. exact C.
Qed.

(** * The bounds *)
Definition size (x : R) : R := if Req_bool x 0 then 1 else Rabs x.
Lemma size_positive x : 0 < size x.
Proof.
  unfold size. case Req_bool_spec; intros H; [lra|]. apply Rabs_pos_lt. exact H.
Qed.
Lemma size_tame x : tame E x -> tame E (size x).
Proof.
  intros T. unfold size. case Req_bool_spec; intros Z.
  - right. rewrite Rabs_R1. split; [apply (bpow_le radix2 (- E) 0); lia|apply (bpow_le radix2 0 E); lia].
  - destruct T as [T|T]; [contradiction|]. right. rewrite Rabs_Rabsolu. exact T.
Qed.

Notation mag := (Model.mag prec emax).
Lemma mag_correct (x : num) : is_finite x = true ->
  is_finite (mag x) = true /\ B2R (mag x) = size (B2R x).
Proof.
  intros F. unfold Model.mag, size. unfold eq.
  rewrite Beqb_correct by (assumption || reflexivity). change (B2R zero) with 0.
  case Req_bool_spec; intros Z.
  - split; [apply is_finite_Bone|apply Bone_correct].
  - rewrite lt_zero_finite by assumption. case Rlt_bool_spec; intros S.
    + rewrite is_finite_Bopp, B2R_Bopp. split; [exact F|]. rewrite Rabs_left by exact S. reflexivity.
    + split; [exact F|]. rewrite Rabs_pos_eq by exact S. reflexivity.
Qed.

Section Test.
Variable b : backend prec emax.
Hypothesis b_accurate : accurate b.

Notation lowb := (Model.lowb prec emax b).
Notation uppb := (Model.uppb prec emax b).

(** A prepared axis: c_down and c_up are within one rounding of C. *)
Definition prepared (a : axis prec emax) (C : R) : Prop :=
  is_finite (origin _ _ a) = true /\
  (is_finite (c_down _ _ a) = true /\ tame (2 * E) (B2R (c_down _ _ a)) /\ close 1 (B2R (c_down _ _ a)) C) /\
  (is_finite (c_up _ _ a) = true /\ tame (2 * E) (B2R (c_up _ _ a)) /\ close 1 (B2R (c_up _ _ a)) C).

Lemma prepare_axis_prepared o d d1 d2 :
  is_finite o = true -> is_finite d1 = true -> is_finite d2 = true ->
  tame E (B2R d1) -> tame E (B2R d2) ->
  prepared (prepare_axis prec emax b o d d1 d2) (size (B2R d1) * size (B2R d2)).
Proof.
  intros Fo F1 F2 T1 T2. destruct b_accurate as (_ & _ & Md & Mu).
  destruct (mag_correct d1 F1) as [G1 E1], (mag_correct d2 F2) as [G2 E2].
  apply size_tame in T1. apply size_tame in T2. rewrite <- E1 in T1. rewrite <- E2 in T2.
  split; [exact Fo|]. cbn [prepare_axis c_down c_up]. rewrite <- E1, <- E2.
  replace (2 * E)%Z with (E + E)%Z by ring.
  split; [apply (Md _ _ E E)|apply (Mu _ _ E E)]; auto; lia.
Qed.

(** A lower bound is within three roundings of C (p - q); an upper one too. *)
Lemma lowb_close a C p q : prepared a C -> is_finite p = true -> is_finite q = true ->
  tame E (B2R p - B2R q) ->
  is_finite (lowb a p q) = true /\ close 3 (B2R (lowb a p q)) (C * (B2R p - B2R q)).
Proof.
  intros (_ & (Fd & Td & Cd) & (Fu & Tu & Cu)) Fp Fq T.
  destruct b_accurate as (Sd & _ & Md & _). destruct (Sd p q Fp Fq T) as (Fs & Ts & Cs).
  unfold Model.lowb. cbv zeta. set (u := sub_down _ _ b p q) in *.
  assert (G : forall c : num, is_finite c = true -> tame (2 * E) (B2R c) -> close 1 (B2R c) C ->
    is_finite (mul_down _ _ b c u) = true /\ close 3 (B2R (mul_down _ _ b c u)) (C * (B2R p - B2R q))).
  { intros c Fc Tc Cc. destruct (Md c u (2 * E)%Z E Fc Fs Tc Ts ltac:(lia)) as (F & _ & CC).
    split; [exact F|]. apply (close_trans 1 2 _ _ _ CC). apply (close_product 1 1); assumption. }
  destruct (lt u zero); apply G; assumption.
Qed.
Lemma uppb_close a C p q : prepared a C -> is_finite p = true -> is_finite q = true ->
  tame E (B2R p - B2R q) ->
  is_finite (uppb a p q) = true /\ close 3 (B2R (uppb a p q)) (C * (B2R p - B2R q)).
Proof.
  intros (_ & (Fd & Td & Cd) & (Fu & Tu & Cu)) Fp Fq T.
  destruct b_accurate as (_ & Su & _ & Mu). destruct (Su p q Fp Fq T) as (Fs & Ts & Cs).
  unfold Model.uppb. cbv zeta. set (u := sub_up _ _ b p q) in *.
  assert (G : forall c : num, is_finite c = true -> tame (2 * E) (B2R c) -> close 1 (B2R c) C ->
    is_finite (mul_up _ _ b c u) = true /\ close 3 (B2R (mul_up _ _ b c u)) (C * (B2R p - B2R q))).
  { intros c Fc Tc Cc. destruct (Mu c u (2 * E)%Z E Fc Fs Tc Ts ltac:(lia)) as (F & _ & CC).
    split; [exact F|]. apply (close_trans 1 2 _ _ _ CC). apply (close_product 1 1); assumption. }
  destruct (lt zero u); apply G; assumption.
Qed.

(** * One axis *)
Definition k : R := (1 + eps) ^ 3 - 1.

(** x is between the planes after each is moved outward by k times its distance from the origin. *)
Definition between_moved (o lo hi x : R) : Prop :=
  lo - k * Rabs (lo - o) <= x <= hi + k * Rabs (hi - o).

Lemma k_positive : 0 < k.
Proof. unfold k. pose proof eps_pos. simpl. nra. Qed.

Lemma quotient_of_close C x y T : 0 < C -> close 3 x (C * y) -> x <= T -> y - k * Rabs y <= T / C.
Proof.
  intros HC H L. unfold close in H. fold k in H. rewrite Rabs_mult, (Rabs_pos_eq C) in H by lra.
  apply Rabs_le_inv in H. apply Rmult_le_reg_r with C; [exact HC|].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.
Lemma quotient_of_close' C x y T : 0 < C -> close 3 x (C * y) -> T <= x -> T / C <= y + k * Rabs y.
Proof.
  intros HC H L. unfold close in H. fold k in H. rewrite Rabs_mult, (Rabs_pos_eq C) in H by lra.
  apply Rabs_le_inv in H. apply Rmult_le_reg_r with C; [exact HC|].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.

Definition axis_ordinary (o d lo hi : num) : Prop :=
  is_finite o = true /\ is_finite d = true /\ is_finite lo = true /\ is_finite hi = true /\
  tame E (B2R d) /\
  (B2R d <> 0 -> tame E (B2R lo - B2R o) /\ tame E (B2R hi - B2R o)).

Notation within := (Model.within prec emax b closed).
Notation prepare_axis := (Model.prepare_axis prec emax b).

Lemma heading_correct o d d1 d2 : is_finite d = true ->
  Model.direction _ _ (prepare_axis o d d1 d2) =
  if Rlt_bool (B2R d) 0 then backward else if Rlt_bool 0 (B2R d) then forward else across.
Proof.
  intros F. simpl. rewrite lt_zero_finite, zero_lt_finite by exact F. reflexivity.
Qed.

(** A scaled time between enter and leave puts the ray between the moved planes. *)
Lemma axis_tight o d d1 d2 lo hi T :
  axis_ordinary o d lo hi -> is_finite d1 = true -> is_finite d2 = true ->
  tame E (B2R d1) -> tame E (B2R d2) ->
  let w := within (prepare_axis o d d1 d2) lo hi in
  is_nan (enter _ _ w) = false /\ is_nan (leave _ _ w) = false /\
  (B2R d <> 0 -> is_finite (leave _ _ w) = true) /\
  (below (enter _ _ w) T -> above (leave _ _ w) T ->
   between_moved (B2R o) (B2R lo) (B2R hi)
     (B2R o + T / (size (B2R d) * (size (B2R d1) * size (B2R d2))) * B2R d)).
Proof.
  intros (Fo & Fd & Fl & Fh & Td & Tp) F1 F2 T1 T2. cbv zeta.
  pose proof (prepare_axis_prepared o d d1 d2 Fo F1 F2 T1 T2) as P.
  pose proof (heading_correct o d d1 d2 Fd) as H.
  assert (O : origin _ _ (prepare_axis o d d1 d2) = o) by reflexivity.
  set (a := prepare_axis o d d1 d2) in *. clearbody a.
  pose proof (Rmult_lt_0_compat _ _ (size_positive (B2R d1)) (size_positive (B2R d2))) as HC.
  set (C := size (B2R d1) * size (B2R d2)) in *. clearbody C.
  assert (N : forall x : num, is_finite x = true -> is_nan x = false) by (intros []; easy).
  unfold Model.within, enter_at, leave_at. rewrite H, O. clear H.
  case Rlt_bool_spec; intros S; [|case Rlt_bool_spec; intros S'].
  - destruct Tp as [Tl Th]; [lra|]. cbn [enter leave].
    assert (Tl' : tame E (B2R o - B2R lo))
      by (replace (B2R o - B2R lo) with (- (B2R lo - B2R o)) by ring; apply tame_opp; exact Tl).
    assert (Th' : tame E (B2R o - B2R hi))
      by (replace (B2R o - B2R hi) with (- (B2R hi - B2R o)) by ring; apply tame_opp; exact Th).
    destruct (lowb_close a C o hi P Fo Fh Th') as [FL CL].
    destruct (uppb_close a C o lo P Fo Fl Tl') as [FU CU].
    repeat split; auto.
    all: apply below_is in H; [|exact FL]; apply above_is in H0; [|exact FU].
    all: pose proof (quotient_of_close _ _ _ _ HC CL H) as Q1.
    all: pose proof (quotient_of_close' _ _ _ _ HC CU H0) as Q2.
    all: replace (T / (size (B2R d) * C) * B2R d) with (- (T / C))
      by (unfold size; rewrite Req_bool_false by lra; rewrite Rabs_left by exact S; field; lra).
    all: rewrite Rabs_minus_sym in Q1; rewrite Rabs_minus_sym in Q2; lra.
  - destruct Tp as [Tl Th]; [lra|]. cbn [enter leave].
    destruct (lowb_close a C lo o P Fl Fo Tl) as [FL CL].
    destruct (uppb_close a C hi o P Fh Fo Th) as [FU CU].
    repeat split; auto.
    all: apply below_is in H; [|exact FL]; apply above_is in H0; [|exact FU].
    all: pose proof (quotient_of_close _ _ _ _ HC CL H) as Q1.
    all: pose proof (quotient_of_close' _ _ _ _ HC CU H0) as Q2.
    all: replace (T / (size (B2R d) * C) * B2R d) with (T / C)
      by (unfold size; rewrite Req_bool_false by lra; rewrite Rabs_pos_eq by lra; field; lra).
    all: lra.
  - assert (Z : B2R d = 0) by lra. cbn [enter leave].
    rewrite le_finite, le_finite by assumption. rewrite Z.
    case Rle_bool_spec; intros L; case Rle_bool_spec; intros U; repeat split; try easy.
    all: try (intros; exfalso; lra).
    all: pose proof k_positive; pose proof (Rabs_pos (B2R lo - B2R o)); pose proof (Rabs_pos (B2R hi - B2R o)).
    all: nra.
Qed.

(** * Three axes *)
Lemma later_enter (x y : num) T : is_nan x = false -> is_nan y = false ->
  below (if lt x y then y else x) T -> below x T /\ below y T.
Proof.
  intros Nx Ny.
  destruct (number_cases _ _ x Nx) as [->|[->|Fx]], (number_cases _ _ y Ny) as [->|[->|Fy]];
    rewrite ?lt_finite_inf, ?lt_minf_finite, ?finite_lt_minf, ?inf_lt_finite by assumption;
    try (simpl; intros; split; (easy || reflexivity)).
  rewrite lt_finite by assumption. case Rlt_bool_spec; intros L H; split; try exact H;
    apply below_is in H; try assumption; apply below_finite; try assumption; lra.
Qed.
Lemma earlier_leave (x y : num) T : is_nan x = false -> is_nan y = false ->
  above (if lt y x then y else x) T -> above x T /\ above y T.
Proof.
  intros Nx Ny.
  destruct (number_cases _ _ x Nx) as [->|[->|Fx]], (number_cases _ _ y Ny) as [->|[->|Fy]];
    rewrite ?lt_finite_inf, ?lt_minf_finite, ?finite_lt_minf, ?inf_lt_finite by assumption;
    try (simpl; intros; split; (easy || reflexivity)).
  rewrite lt_finite by assumption. case Rlt_bool_spec; intros L H; split; try exact H;
    apply above_is in H; try assumption; apply above_finite; try assumption; lra.
Qed.

Definition bounded_above (x : num) : Prop := x = minf \/ is_finite x = true.
Lemma earlier_bounded (x y : num) : is_nan x = false -> is_nan y = false ->
  bounded_above x \/ bounded_above y -> bounded_above (if lt y x then y else x).
Proof.
  intros Nx Ny B. unfold bounded_above in *.
  destruct (number_cases _ _ x Nx) as [->|[->|Fx]], (number_cases _ _ y Ny) as [->|[->|Fy]];
    rewrite ?lt_finite_inf, ?lt_minf_finite, ?finite_lt_minf, ?inf_lt_finite by assumption;
    simpl; auto; try (destruct B as [[B|B]|[B|B]]; discriminate).
  destruct (lt y x); auto.
Qed.

(** What passes has a common time. *)
Lemma passes2_time (x y : Model.interval prec emax) :
  is_nan (enter _ _ x) = false -> is_nan (leave _ _ x) = false ->
  is_nan (enter _ _ y) = false -> is_nan (leave _ _ y) = false ->
  bounded_above (leave _ _ x) \/ bounded_above (leave _ _ y) ->
  passes2 prec emax x y = true ->
  exists T, 0 <= T /\ (below (enter _ _ x) T /\ below (enter _ _ y) T) /\
                      (above (leave _ _ x) T /\ above (leave _ _ y) T).
Proof.
  intros N1 N2 N3 N4 B P. unfold passes2 in P. cbv zeta in P. cbn [common enter leave] in P.
  pose proof (later_enter (enter _ _ x) (enter _ _ y)) as LE.
  pose proof (earlier_leave (leave _ _ x) (leave _ _ y)) as EL.
  apply (earlier_bounded _ _ N2 N4) in B.
  set (e := if lt (enter _ _ x) (enter _ _ y) then enter _ _ y else enter _ _ x) in *.
  set (l := if lt (leave _ _ y) (leave _ _ x) then leave _ _ y else leave _ _ x) in *.
  assert (Ne : is_nan e = false) by (unfold e; case (lt _ _); assumption).
  clearbody e l. apply negb_true_iff, orb_false_iff in P. destruct P as [P Q].
  assert (G : exists T, 0 <= T /\ below e T /\ above l T).
  { destruct B as [->|Fl]; [discriminate Q|].
    rewrite lt_zero_finite in Q by exact Fl.
    assert (L0 : 0 <= B2R l) by (revert Q; case Rlt_bool_spec; [discriminate|auto]).
    destruct (number_cases _ _ e Ne) as [->|[->|Fe]].
    - exists 0. split; [lra|]. split; [reflexivity|apply above_finite; assumption].
    - rewrite lt_finite_inf in P by exact Fl. discriminate P.
    - rewrite lt_finite in P by assumption.
      assert (EL' : B2R e <= B2R l) by (revert P; case Rlt_bool_spec; [discriminate|auto]).
      exists (Rmax 0 (B2R e)). split; [apply Rmax_l|].
      split; [apply below_finite; [exact Fe|apply Rmax_r]|].
      apply above_finite; [exact Fl|]. apply Rmax_lub; assumption. }
  destruct G as (T & T0 & Be & Al). exists T. split; [exact T0|]. split; auto.
Qed.

Notation vector := (three num).
(** Ray and box for which relative errors are meaningful. *)
Definition ordinary (o d lo hi : vector) : Prop :=
  axis_ordinary (at_x o) (at_x d) (at_x lo) (at_x hi) /\
  axis_ordinary (at_y o) (at_y d) (at_y lo) (at_y hi) /\
  axis_ordinary (at_z o) (at_z d) (at_z lo) (at_z hi) /\
  (B2R (at_x d) <> 0 \/ B2R (at_y d) <> 0 \/ B2R (at_z d) <> 0).

(** At t the ray is in the box with moved planes. *)
Definition nearly_inside (o d lo hi : vector) (t : R) : Prop :=
  between_moved (B2R (at_x o)) (B2R (at_x lo)) (B2R (at_x hi)) (B2R (at_x o) + t * B2R (at_x d)) /\
  between_moved (B2R (at_y o)) (B2R (at_y lo)) (B2R (at_y hi)) (B2R (at_y o) + t * B2R (at_y d)) /\
  between_moved (B2R (at_z o)) (B2R (at_z lo)) (B2R (at_z hi)) (B2R (at_z o) + t * B2R (at_z d)).

(** Tightness: a box that passes is met by the ray after each plane p is moved by k |p - o|. *)
Theorem what_passes_nearly_touches o d lo hi :
  ordinary o d lo hi ->
  touches_box prec emax b (prepare prec emax b o d) lo hi = true ->
  exists t, 0 <= t /\ nearly_inside o d lo hi t.
Proof.
  intros (X & Y & Z & M) P.
  pose proof X as (_ & Fx & _ & _ & Tx & _). pose proof Y as (_ & Fy & _ & _ & Ty & _).
  pose proof Z as (_ & Fz & _ & _ & Tz & _).
  unfold touches_box, passes, prepare in P. cbn [at_x at_y at_z] in P.
  pose proof (fun T => axis_tight _ _ _ _ _ _ T X Fy Fz Ty Tz) as AX.
  pose proof (fun T => axis_tight _ _ _ _ _ _ T Y Fz Fx Tz Tx) as AY.
  pose proof (fun T => axis_tight _ _ _ _ _ _ T Z Fx Fy Tx Ty) as AZ.
  cbv zeta in AX, AY, AZ.
  set (wx := within (prepare_axis (at_x o) (at_x d) (at_y d) (at_z d)) (at_x lo) (at_x hi)) in *.
  set (wy := within (prepare_axis (at_y o) (at_y d) (at_z d) (at_x d)) (at_y lo) (at_y hi)) in *.
  set (wz := within (prepare_axis (at_z o) (at_z d) (at_x d) (at_y d)) (at_z lo) (at_z hi)) in *.
  destruct (AX 0) as (Nx & Nx' & Bx & _), (AY 0) as (Ny & Ny' & By & _), (AZ 0) as (Nz & Nz' & Bz & _).
  assert (Nc : is_nan (enter _ _ (common prec emax wx wy)) = false)
    by (cbn [common enter]; case (lt _ _); assumption).
  assert (Nc' : is_nan (leave _ _ (common prec emax wx wy)) = false)
    by (cbn [common leave]; case (lt _ _); assumption).
  apply passes2_time in P; try assumption.
  - destruct P as (T & T0 & [Bc Bz'] & [Ac Az']). cbn [common enter leave] in Bc, Ac.
    apply later_enter in Bc; try assumption. apply earlier_leave in Ac; try assumption.
    destruct (AX T) as (_ & _ & _ & RX), (AY T) as (_ & _ & _ & RY), (AZ T) as (_ & _ & _ & RZ).
    specialize (RX (proj1 Bc) (proj1 Ac)). specialize (RY (proj2 Bc) (proj2 Ac)).
    specialize (RZ Bz' Az').
    exists (T / (size (B2R (at_x d)) * (size (B2R (at_y d)) * size (B2R (at_z d))))).
    pose proof (size_positive (B2R (at_x d))). pose proof (size_positive (B2R (at_y d))).
    pose proof (size_positive (B2R (at_z d))).
    split.
    + unfold Rdiv. apply Rmult_le_pos; [exact T0|]. apply Rlt_le, Rinv_0_lt_compat.
      repeat apply Rmult_lt_0_compat; assumption.
    + split; [exact RX|]. split.
      * replace (size (B2R (at_x d)) * (size (B2R (at_y d)) * size (B2R (at_z d))))
          with (size (B2R (at_y d)) * (size (B2R (at_z d)) * size (B2R (at_x d)))) by ring. exact RY.
      * replace (size (B2R (at_x d)) * (size (B2R (at_y d)) * size (B2R (at_z d))))
          with (size (B2R (at_z d)) * (size (B2R (at_x d)) * size (B2R (at_y d)))) by ring. exact RZ.
  - destruct M as [M|[M|M]]; [left|left|right].
    + cbn [common leave]. apply (earlier_bounded _ _ Nx' Ny'). left. right. auto.
    + cbn [common leave]. apply (earlier_bounded _ _ Nx' Ny'). right. right. auto.
    + right. auto.
Qed.
End Test.
End Tightness.

(** * binary64 *)
(** k of binary64 is below 2^-50, eight units of 2^-53. *)
Lemma k_binary64 : k 53 < 8 * bpow radix2 (-53).
Proof.
  unfold k, eps. change (1 - 53)%Z with (-52)%Z.
  replace (bpow radix2 (-53)) with (bpow radix2 (-52) * / 2)
    by (change (-53)%Z with (-52 + -1)%Z; rewrite bpow_plus; reflexivity).
  assert (0 < bpow radix2 (-52)) by apply bpow_gt_0.
  assert (bpow radix2 (-52) <= / 4) by (apply (bpow_le radix2 (-52) (-2)); lia).
  set (e := bpow radix2 (-52)) in *. clearbody e.
  assert (e * e <= e * / 4) by nra. assert (e * e * e <= e * / 4 * / 4) by nra.
  replace ((1 + e) ^ 3 - 1) with (3 * e + 3 * (e * e) + e * e * e) by ring. lra.
Qed.

(** In binary64, `directed`: a box that passes is met after its planes are moved by 8 units of 2^-53
    of their distance from the origin. *)
Theorem tight_binary64_directed (o d lo hi : three (float 53 1024)) :
  let b := @directed 53 1024 eq_refl eq_refl in
  ordinary 53 1024 340 o d lo hi ->
  @touches_box 53 1024 b (@prepare 53 1024 eq_refl eq_refl b o d) lo hi = true ->
  exists t, 0 <= t /\ nearly_inside 53 1024 o d lo hi t.
Proof.
  intros b H. apply what_passes_nearly_touches with (E := 340%Z); try lia; try exact H.
  apply directed_accurate; lia.
Qed.
(** The same of `upward`. *)
Theorem tight_binary64_upward (o d lo hi : three (float 53 1024)) :
  let b := @upward 53 1024 eq_refl eq_refl in
  ordinary 53 1024 340 o d lo hi ->
  @touches_box 53 1024 b (@prepare 53 1024 eq_refl eq_refl b o d) lo hi = true ->
  exists t, 0 <= t /\ nearly_inside 53 1024 o d lo hi t.
Proof.
  intros b H. apply what_passes_nearly_touches with (E := 340%Z); try lia; try exact H.
  apply upward_accurate; lia.
Qed.
