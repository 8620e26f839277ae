(** Corners and mid-planes of octants are floating-point numbers, and the sums that
    octree/geometry/include/graze/octree/cube.hpp forms are exact: no rounding takes place in a descent.

    - [corner_format]: on [0, 2^E], every coordinate k * 2^(E-NL) of level NL <= prec (53) is a number;
      [corners_exact_iff]: and for no deeper level are all of them; [corner_54]: (2^54-1) * 2^(E-54)
      is none in binary64.
    - [symmetric_format], [symmetric_exact_iff], [symmetric_55]: on [-2^E, 2^E] the same with one
      level more, since the side is 2^(E+1).
    - [mid_exact], [hi_exact]: the IEEE lo + size / 2 and lo + size of cube.hpp, in every rounding
      mode, on every cube [on_grid], which is what root_cube::make checks; [child_on_grid]: children
      are on the grid of their root. [unit_root_on_grid], [symmetric_root_on_grid]: both roots are. *)
From Coq Require Import ZArith NArith Reals Bool List Lia Lra.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model Model_descent.
Open Scope R_scope.

Section Coordinates.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.

Notation emin := (SpecFloat.emin prec emax).
Notation fexp := (SpecFloat.fexp prec emax).
Notation format := (generic_format radix2 fexp).
Notation bpow := (bpow radix2).
Notation float := (float prec emax).

Let prec_pos : (0 < prec)%Z := Hprec.
Let prec_emax : (prec < emax)%Z := Hmax.

Local Instance fexp_valid : Valid_exp fexp := FLT_exp_valid emin prec.

(** ** Numbers of the format *)

(** A multiple k * 2^g of a power that the format has, of at most 2^prec in k, is a number. *)
Lemma grid_format : forall k g, (emin <= g)%Z -> (Z.abs k <= 2 ^ prec)%Z -> format (IZR k * bpow g).
Proof.
  intros k g Hg Hk.
  assert (P : forall s e, (emin <= e)%Z -> (Z.abs s < 2 ^ prec)%Z -> format (IZR s * bpow e)).
  { intros s e He Hs. apply generic_format_FLT with (1 := FLT_spec radix2 emin prec _ (Float radix2 s e) eq_refl Hs He). }
  destruct (Z.eq_dec (Z.abs k) (2 ^ prec)) as [E|E]; [| apply P; lia].
  assert (One : (1 < 2 ^ prec)%Z) by (apply Z.pow_gt_1; lia).
  assert (H2 : bpow prec = IZR (2 ^ prec)) by (symmetry; apply (IZR_Zpower radix2); lia).
  replace (IZR k * bpow g) with (IZR (Z.sgn k) * bpow (prec + g)).
  - apply P; [lia|]. destruct k; simpl in *; lia.
  - rewrite bpow_plus, H2, <- E, <- Rmult_assoc, <- mult_IZR.
    f_equal. f_equal. destruct k; simpl in *; lia.
Qed.

(** An odd multiple of a power of two that needs more than prec bits is not a number. *)
Lemma odd_not_format : forall k g, Z.odd k = true -> (2 ^ prec < Z.abs k)%Z -> ~ format (IZR k * bpow g).
Proof.
  intros k g Odd Large F.
  destruct (FLT_format_generic radix2 emin prec _ F) as [[n e] Hx Hn He]. simpl in Hx, Hn, He.
  unfold F2R in Hx. simpl in Hx.
  destruct (Z_le_gt_dec e g) as [L|G].
  - (* the significand n would be at least as large as k *)
    assert (H : IZR n = IZR (k * 2 ^ (g - e))).
    { rewrite mult_IZR, (IZR_Zpower radix2) by lia.
      apply Rmult_eq_reg_r with (bpow e); [| apply Rgt_not_eq, bpow_gt_0].
      rewrite Rmult_assoc, <- bpow_plus. replace (g - e + e)%Z with g by ring. now rewrite Hx. }
    apply eq_IZR in H. subst n. rewrite Z.abs_mul in Hn.
    assert (0 < 2 ^ (g - e))%Z by (apply Z.pow_pos_nonneg; lia).
    assert (Z.abs k <= Z.abs k * Z.abs (2 ^ (g - e)))%Z by nia.
    simpl in Hn. lia.
  - (* k would be even *)
    assert (H : IZR k = IZR (n * 2 ^ (e - g))).
    { rewrite mult_IZR, (IZR_Zpower radix2) by lia.
      apply Rmult_eq_reg_r with (bpow g); [| apply Rgt_not_eq, bpow_gt_0].
      rewrite Rmult_assoc, <- bpow_plus. replace (e - g + g)%Z with e by ring. exact Hx. }
    apply eq_IZR in H. subst k.
    replace (e - g)%Z with (1 + (e - g - 1))%Z in Odd by ring.
    rewrite Z.pow_add_r, Z.odd_mul, Z.odd_mul in Odd by lia. simpl in Odd.
    now rewrite andb_false_r in Odd.
Qed.

(** A number divided by a power of two is a number if it stays a multiple of the least one. *)
Lemma scaled_format : forall x j, format x -> (0 <= j)%Z ->
  (exists s, x * bpow (- j) = IZR s * bpow emin) -> format (x * bpow (- j)).
Proof.
  intros x j F Hj [s Hs].
  destruct (FLT_format_generic radix2 emin prec _ F) as [[n e] Hx Hn He]. simpl in Hx, Hn, He.
  unfold F2R in Hx. simpl in Hx.
  assert (X : x * bpow (- j) = IZR n * bpow (e - j)).
  { rewrite Hx, Rmult_assoc, <- bpow_plus. reflexivity. }
  destruct (Z_le_gt_dec emin (e - j)) as [L|G].
  - rewrite X. apply grid_format; [exact L|]. simpl in Hn. lia.
  - rewrite Hs. apply grid_format; [lia|].
    assert (H : IZR n = IZR (s * 2 ^ (emin - (e - j)))).
    { rewrite mult_IZR, (IZR_Zpower radix2) by lia.
      apply Rmult_eq_reg_r with (bpow (e - j)); [| apply Rgt_not_eq, bpow_gt_0].
      rewrite Rmult_assoc, <- bpow_plus. replace (emin - (e - j) + (e - j))%Z with emin by ring.
      now rewrite <- Hs, X. }
    apply eq_IZR in H. subst n. rewrite Z.abs_mul in Hn. simpl in Hn.
    assert (0 < 2 ^ (emin - (e - j)))%Z by (apply Z.pow_pos_nonneg; lia). nia.
Qed.

(** ** The root [0, 2^E] *)

(** Every coordinate of level NL <= prec is a number. *)
Theorem corner_format : forall E NL k, (0 <= NL <= prec)%Z -> (emin <= E - NL)%Z ->
  (0 <= k <= 2 ^ NL)%Z -> format (IZR k * bpow (E - NL)).
Proof.
  intros E NL k HN HE Hk. apply grid_format; [exact HE|].
  assert (2 ^ NL <= 2 ^ prec)%Z by (apply Z.pow_le_mono_r; lia). lia.
Qed.

(** Of the levels whose least step the format has, those up to prec are exact and no other. *)
Theorem corners_exact_iff : forall E NL, (0 <= NL)%Z -> (emin <= E - NL)%Z ->
  (forall k, (0 <= k <= 2 ^ NL)%Z -> format (IZR k * bpow (E - NL))) <-> (NL <= prec)%Z.
Proof.
  intros E NL HN HE. split; [| intros; now apply corner_format].
  intros H. destruct (Z_le_gt_dec NL prec) as [L|G]; [exact L|exfalso].
  assert (2 ^ (prec + 1) <= 2 ^ NL)%Z by (apply Z.pow_le_mono_r; lia).
  assert (A : (2 ^ (prec + 1) = 2 * 2 ^ prec)%Z) by (rewrite Z.pow_add_r by lia; lia).
  assert (B : (1 < 2 ^ prec)%Z) by (apply Z.pow_gt_1; lia).
  refine (odd_not_format (2 ^ (prec + 1) - 1) (E - NL) _ _ (H _ _)); try lia.
  rewrite A, Z.odd_sub, Z.odd_mul. reflexivity.
Qed.

(** ** The root [-2^E, 2^E], of side 2^(E+1): its steps at level NL are 2^(E+1-NL) *)

Lemma symmetric_coordinate : forall E NL k, (1 <= NL)%Z ->
  - bpow E + IZR k * bpow (E + 1 - NL) = IZR (k - 2 ^ (NL - 1)) * bpow (E + 1 - NL).
Proof.
  intros E NL k HN. rewrite minus_IZR, (IZR_Zpower radix2) by lia.
  rewrite Rmult_minus_distr_r, <- bpow_plus. replace (NL - 1 + (E + 1 - NL))%Z with E by ring. ring.
Qed.

(** Every coordinate of level NL <= prec + 1 is a number: level 53 of binary64, and one more. *)
Theorem symmetric_format : forall E NL k, (1 <= NL <= prec + 1)%Z -> (emin <= E + 1 - NL)%Z ->
  (0 <= k <= 2 ^ NL)%Z -> format (- bpow E + IZR k * bpow (E + 1 - NL)).
Proof.
  intros E NL k HN HE Hk. rewrite symmetric_coordinate by lia. apply grid_format; [exact HE|].
  assert (2 ^ (NL - 1) <= 2 ^ prec)%Z by (apply Z.pow_le_mono_r; lia).
  assert (2 ^ NL = 2 * 2 ^ (NL - 1))%Z
    by (replace NL with (1 + (NL - 1))%Z at 1 by ring; rewrite Z.pow_add_r by lia; reflexivity).
  lia.
Qed.

(** And no deeper level is exact. *)
Theorem symmetric_exact_iff : forall E NL, (1 <= NL)%Z -> (emin <= E + 1 - NL)%Z ->
  (forall k, (0 <= k <= 2 ^ NL)%Z -> format (- bpow E + IZR k * bpow (E + 1 - NL))) <-> (NL <= prec + 1)%Z.
Proof.
  intros E NL HN HE. split; [| intros; now apply symmetric_format].
  intros H. destruct (Z_le_gt_dec NL (prec + 1)) as [L|G]; [exact L|exfalso].
  assert (C : (2 ^ (NL - 1) = 2 * 2 ^ (NL - 2))%Z)
    by (replace (NL - 1)%Z with (1 + (NL - 2))%Z by ring; rewrite Z.pow_add_r by lia; reflexivity).
  assert (D : (2 ^ NL = 2 * 2 ^ (NL - 1))%Z)
    by (replace NL with (1 + (NL - 1))%Z at 1 by ring; rewrite Z.pow_add_r by lia; reflexivity).
  assert (2 ^ prec <= 2 ^ (NL - 2))%Z by (apply Z.pow_le_mono_r; lia).
  assert (B : (1 < 2 ^ prec)%Z) by (apply Z.pow_gt_1; lia).
  assert (F := H 1%Z ltac:(lia)). rewrite symmetric_coordinate in F by lia.
  revert F. apply odd_not_format; [| lia].
  rewrite C, Z.odd_sub, Z.odd_mul. reflexivity.
Qed.

(** ** The sums of cube.hpp *)

(** Where the exact result is a number, the rounded operation returns it, in every mode. *)
Lemma plus_exact : forall m (x y : float), is_finite x = true -> is_finite y = true ->
  format (B2R x + B2R y) -> Rabs (B2R x + B2R y) < bpow emax ->
  is_finite (Bplus m x y) = true /\ B2R (Bplus m x y) = B2R x + B2R y.
Proof.
  intros m x y Fx Fy F L. generalize (Bplus_correct prec emax _ _ m x y Fx Fy).
  rewrite round_generic by (auto with typeclass_instances).
  rewrite Rlt_bool_true by exact L. tauto.
Qed.

Lemma two_correct : is_finite (two prec emax) = true /\ B2R (two prec emax) = 2.
Proof.
  assert (O : B2R (one prec emax) = 1) by apply Bone_correct.
  assert (FO : is_finite (one prec emax) = true) by apply is_finite_Bone.
  assert (T : 1 + 1 = bpow 1) by (simpl; lra).
  destruct (plus_exact mode_NE (one prec emax) (one prec emax) FO FO) as [F B].
  - rewrite O, T. apply generic_format_FLT_bpow; [exact Hprec|]. unfold emin. lia.
  - rewrite O, T, Rabs_pos_eq by apply bpow_ge_0. apply bpow_lt. lia.
  - split; [exact F|]. unfold two. rewrite B, O. lra.
Qed.

Lemma halved_exact : forall m (x : float), is_finite x = true -> format (B2R x / 2) ->
  is_finite (halved prec emax m x) = true /\ B2R (halved prec emax m x) = B2R x / 2.
Proof.
  intros m x Fx F. destruct two_correct as [_ T].
  generalize (Bdiv_correct prec emax _ _ m x (two prec emax)).
  rewrite T, round_generic by (auto with typeclass_instances).
  rewrite Rlt_bool_true.
  - intros H. destruct H as [H1 [H2 _]]; [lra|]. unfold halved. now rewrite H1, H2.
  - apply Rle_lt_trans with (2 := abs_B2R_lt_emax _ _ x).
    unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ 2)) by lra. generalize (Rabs_pos (B2R x)). lra.
Qed.

(** The coordinates of one axis of a cube with n levels below it: lower plane and size are finite
    multiples of the grid 2^g, whose n-th halving of the size is still on the grid, and between the
    planes all multiples are numbers. It is what root_cube::make checks (g >= -1074, |coordinate| <=
    2^min(g + 53, 1023)). *)
Record axis_on_grid (g : Z) (n : nat) (l s : float) : Prop := {
  grid_exponent : (emin <= g)%Z;
  finite_lo : is_finite l = true;
  finite_size : is_finite s = true;
  grid_lo : exists k, B2R l = IZR k * bpow g;
  grid_size : exists k, (0 < k)%Z /\ B2R s = IZR k * bpow (g + Z.of_nat n);
  low_enough : - bpow (Z.min (g + prec) (emax - 1)) <= B2R l;
  high_enough : B2R l + B2R s <= bpow (Z.min (g + prec) (emax - 1)) }.

(** A multiple of the grid between the planes is a number, far from overflow. *)
Lemma on_grid_number : forall g x, (emin <= g)%Z -> (exists k, x = IZR k * bpow g) ->
  Rabs x <= bpow (Z.min (g + prec) (emax - 1)) -> format x /\ Rabs x < bpow emax.
Proof.
  intros g x Hg [k ->] L. split.
  - apply grid_format; [exact Hg|]. apply le_IZR. rewrite abs_IZR, (IZR_Zpower radix2) by lia.
    apply Rmult_le_reg_r with (bpow g); [apply bpow_gt_0|].
    rewrite <- bpow_plus, <- (Rabs_pos_eq (bpow g)) at 1 by apply bpow_ge_0.
    rewrite <- Rabs_mult. apply Rle_trans with (1 := L). apply bpow_le. lia.
  - apply Rle_lt_trans with (1 := L). apply bpow_lt. lia.
Qed.

Lemma size_positive : forall g n l s, axis_on_grid g n l s -> 0 < B2R s.
Proof.
  intros g n l s H. destruct (grid_size _ _ _ _ H) as [k [Hk ->]].
  apply Rmult_lt_0_compat; [now apply IZR_lt | apply bpow_gt_0].
Qed.

Lemma half_power : forall g n, bpow (g + Z.of_nat (S n)) / 2 = bpow (g + Z.of_nat n).
Proof.
  intros g n. replace (g + Z.of_nat (S n))%Z with (1 + (g + Z.of_nat n))%Z by lia.
  rewrite bpow_plus. simpl. lra.
Qed.

(** size / 2 is exact while there are levels below. *)
Theorem size_exact : forall m g n l s, axis_on_grid g (S n) l s ->
  is_finite (halved prec emax m s) = true /\ B2R (halved prec emax m s) = B2R s / 2.
Proof.
  intros m g n l s H. apply halved_exact; [apply H|].
  destruct (grid_size _ _ _ _ H) as [k [Hk Hs]]. assert (Hg := grid_exponent _ _ _ _ H).
  replace (B2R s / 2) with (B2R s * bpow (- (1))) by (simpl; lra).
  apply scaled_format; [apply generic_format_B2R | lia |].
  exists (k * 2 ^ (g + Z.of_nat n - emin))%Z.
  rewrite mult_IZR, (IZR_Zpower radix2), Rmult_assoc, <- bpow_plus by lia.
  replace (g + Z.of_nat n - emin + emin)%Z with (g + Z.of_nat n)%Z by ring.
  rewrite Hs, <- (half_power g n). simpl. lra.
Qed.

(** lo + size / 2 is exact while there are levels below. *)
Theorem mid_exact : forall m g n l s, axis_on_grid g (S n) l s ->
  is_finite (mid_at prec emax m l s) = true /\ B2R (mid_at prec emax m l s) = B2R l + B2R s / 2.
Proof.
  intros m g n l s H. destruct (size_exact m _ _ _ _ H) as [F B].
  unfold mid_at. rewrite <- B. assert (P := size_positive _ _ _ _ H).
  destruct (on_grid_number g (B2R l + B2R (halved prec emax m s))) as [X Y].
  - apply H.
  - destruct (grid_lo _ _ _ _ H) as [k Hk]. destruct (grid_size _ _ _ _ H) as [j [_ Hj]].
    exists (k + j * 2 ^ Z.of_nat n)%Z.
    rewrite B, Hk, Hj, plus_IZR, mult_IZR, (IZR_Zpower radix2) by lia.
    unfold Rdiv. rewrite Rmult_assoc. fold (bpow (g + Z.of_nat (S n)) / 2).
    rewrite half_power, bpow_plus. ring.
  - rewrite B. generalize (low_enough _ _ _ _ H) (high_enough _ _ _ _ H). intros.
    apply Rabs_le. lra.
  - apply plus_exact; try assumption. apply H.
Qed.

(** lo + size is exact at every level. *)
Theorem hi_exact : forall m g n l s, axis_on_grid g n l s ->
  is_finite (hi_at prec emax m l s) = true /\ B2R (hi_at prec emax m l s) = B2R l + B2R s.
Proof.
  intros m g n l s H. assert (P := size_positive _ _ _ _ H).
  destruct (on_grid_number g (B2R l + B2R s)) as [X Y].
  - apply H.
  - destruct (grid_lo _ _ _ _ H) as [k Hk]. destruct (grid_size _ _ _ _ H) as [j [_ Hj]].
    exists (k + j * 2 ^ Z.of_nat n)%Z.
    rewrite Hk, Hj, plus_IZR, mult_IZR, (IZR_Zpower radix2), bpow_plus by lia. ring.
  - generalize (low_enough _ _ _ _ H) (high_enough _ _ _ _ H). intros. apply Rabs_le. lra.
  - apply plus_exact; try assumption; apply H.
Qed.

(** The halves of an axis on the grid are on the grid. *)
Lemma half_on_grid : forall m g n l s upper, axis_on_grid g (S n) l s ->
  axis_on_grid g n (if upper : bool then mid_at prec emax m l s else l) (halved prec emax m s).
Proof.
  intros m g n l s upper H. destruct (mid_exact m _ _ _ _ H) as [Fm Bm].
  destruct (size_exact m _ _ _ _ H) as [Fs Bs]. assert (P := size_positive _ _ _ _ H).
  destruct (grid_lo _ _ _ _ H) as [k Hk]. destruct (grid_size _ _ _ _ H) as [j [Pj Hj]].
  assert (Hs2 : B2R s / 2 = IZR j * bpow (g + Z.of_nat n)).
  { rewrite Hj. unfold Rdiv. rewrite Rmult_assoc. fold (bpow (g + Z.of_nat (S n)) / 2).
    now rewrite half_power. }
  generalize (low_enough _ _ _ _ H) (high_enough _ _ _ _ H). intros L U.
  constructor.
  - apply H.
  - destruct upper; [exact Fm | apply H].
  - exact Fs.
  - destruct upper; [| exists k; exact Hk].
    exists (k + j * 2 ^ Z.of_nat n)%Z.
    rewrite Bm, Hs2, Hk, plus_IZR, mult_IZR, (IZR_Zpower radix2), bpow_plus by lia. ring.
  - exists j. split; [exact Pj|]. now rewrite Bs.
  - destruct upper; [rewrite Bm|]; lra.
  - rewrite Bs. destruct upper; [rewrite Bm|]; lra.
Qed.

(** A cube with n levels below it whose octants all have exact corners and mid-planes. *)
Definition on_grid (g : Z) (n : nat) (c : cube prec emax) : Prop :=
  axis_on_grid g n (at_x (lo _ _ c)) (size _ _ c) /\ axis_on_grid g n (at_y (lo _ _ c)) (size _ _ c) /\
  axis_on_grid g n (at_z (lo _ _ c)) (size _ _ c).

Theorem child_on_grid : forall m g n c index, on_grid g (S n) c -> on_grid g n (child prec emax m c index).
Proof.
  intros m g n c index [X [Y Z]]. split; [|split]; simpl; now apply half_on_grid.
Qed.

(** The axis [0, 2^E] with NL levels. *)
Lemma unit_axis_on_grid : forall E (NL : nat) (l s : float), (Z.of_nat NL <= prec)%Z ->
  (emin <= E - Z.of_nat NL)%Z -> (E < emax)%Z -> is_finite l = true -> is_finite s = true ->
  B2R l = 0 -> B2R s = bpow E -> axis_on_grid (E - Z.of_nat NL) NL l s.
Proof.
  intros E NL l s HN HE HM Fl Fs Bl Bs. constructor; try assumption.
  - exists 0%Z. rewrite Bl. ring.
  - exists 1%Z. split; [lia|]. rewrite Bs, Rmult_1_l. f_equal. ring.
  - rewrite Bl. generalize (bpow_ge_0 radix2 (Z.min (E - Z.of_nat NL + prec) (emax - 1))). lra.
  - rewrite Bl, Bs, Rplus_0_l. apply bpow_le. lia.
Qed.

(** The axis [-2^E, 2^E] with NL levels, one more than the significand has bits. *)
Lemma symmetric_axis_on_grid : forall E (NL : nat) (l s : float), (Z.of_nat NL <= prec + 1)%Z ->
  (emin <= E + 1 - Z.of_nat NL)%Z -> (E + 1 < emax)%Z -> is_finite l = true -> is_finite s = true ->
  (1 <= NL)%nat -> B2R l = - bpow E -> B2R s = bpow (E + 1) -> axis_on_grid (E + 1 - Z.of_nat NL) NL l s.
Proof.
  intros E NL l s HN HE HM Fl Fs H1 Bl Bs.
  assert (D : bpow (E + 1) = 2 * bpow E) by (rewrite bpow_plus; simpl; lra).
  assert (L : bpow E <= bpow (Z.min (E + 1 - Z.of_nat NL + prec) (emax - 1))) by (apply bpow_le; lia).
  constructor; try assumption.
  - exists (- 2 ^ (Z.of_nat NL - 1))%Z. rewrite Bl, opp_IZR, (IZR_Zpower radix2) by lia.
    rewrite <- Ropp_mult_distr_l, <- bpow_plus. f_equal. f_equal. ring.
  - exists 1%Z. split; [lia|]. rewrite Bs, Rmult_1_l. f_equal. ring.
  - rewrite Bl. lra.
  - rewrite Bl, Bs, D. lra.
Qed.

(** The cube [0, 2^E]^3 with NL <= prec levels is on the grid. *)
Theorem unit_root_on_grid : forall E (NL : nat) c, (Z.of_nat NL <= prec)%Z ->
  (emin <= E - Z.of_nat NL)%Z -> (E < emax)%Z ->
  at_x (lo _ _ c) = zero prec emax -> at_y (lo _ _ c) = zero prec emax -> at_z (lo _ _ c) = zero prec emax ->
  is_finite (size _ _ c) = true -> B2R (size _ _ c) = bpow E -> on_grid (E - Z.of_nat NL) NL c.
Proof.
  intros E NL c HN HE HM X Y Z F B. unfold on_grid. rewrite X, Y, Z.
  split; [|split]; apply unit_axis_on_grid; auto.
Qed.

(** The cube [-2^E, 2^E]^3 with NL <= prec + 1 levels is on the grid. *)
Theorem symmetric_root_on_grid : forall E (NL : nat) c l, (1 <= NL)%nat -> (Z.of_nat NL <= prec + 1)%Z ->
  (emin <= E + 1 - Z.of_nat NL)%Z -> (E + 1 < emax)%Z ->
  lo _ _ c = triple l l l -> is_finite l = true -> B2R l = - bpow E ->
  is_finite (size _ _ c) = true -> B2R (size _ _ c) = bpow (E + 1) ->
  on_grid (E + 1 - Z.of_nat NL) NL c.
Proof.
  intros E NL c l H1 HN HE HM L Fl Bl F B. unfold on_grid. rewrite L.
  split; [|split]; apply symmetric_axis_on_grid; auto.
Qed.

End Coordinates.

(** ** Binary64 *)

(** At level 54, (2^54-1) * 2^(E-54) is a corner of [0, 2^E] and no binary64 number, for any E. *)
Theorem corner_54 : forall E,
  ~ generic_format radix2 (SpecFloat.fexp 53 1024) (IZR (2 ^ 54 - 1) * bpow radix2 (E - 54)).
Proof.
  intros E. apply (odd_not_format 53 1024 (Hprec := eq_refl)); reflexivity.
Qed.

(** At level 55, the least corner but one of [-2^E, 2^E] is no binary64 number, for any E. *)
Theorem symmetric_55 : forall E,
  ~ generic_format radix2 (SpecFloat.fexp 53 1024) (- bpow radix2 E + IZR 1 * bpow radix2 (E + 1 - 55)).
Proof.
  intros E. rewrite symmetric_coordinate by lia.
  apply (odd_not_format 53 1024 (Hprec := eq_refl)); reflexivity.
Qed.
