(** What octree/geometry/include/graze/octree/cube.hpp accepts as a root, and its octants by index.

    - [make_on_grid]: what root_cube::make checks on an axis is what Coordinates.v asks of it.
    - [octant_from_lo]: root_cube::octant's lo + index * size is exact where the product is a number:
      on [0, 2^E] and on [-2^E, 2^E] to level prec ([unit_octant], [symmetric_octant]).
    - [octant_rounds]: on [-3, 3] at level 52, which make accepts ([rounding_root_accepted]), it is not:
      3 (2^52 - 1) has 54 bits. The descent, which halves, is exact there like anywhere.
    - [octant_from_middle]: mid + (index - 2^(level-1)) * size is exact on every root that make accepts. *)
From Coq Require Import ZArith NArith Reals Bool List Lia Lra.
From Flocq Require Import Core BinarySingleNaN.
From Graze Require Import Model Model_descent Coordinates.
Open Scope R_scope.

Section Root.
Context (prec emax : Z) {Hprec : Prec_gt_0 prec} {Hmax : Prec_lt_emax prec emax}.

Notation emin := (SpecFloat.emin prec emax).
Notation fexp := (SpecFloat.fexp prec emax).
Notation format := (generic_format radix2 fexp).
Notation bpow := (bpow radix2).
Notation float := (float prec emax).

Let prec_pos : (0 < prec)%Z := Hprec.
Local Instance fexp_valid : Valid_exp fexp := FLT_exp_valid emin prec.

(** ** Acceptance *)

(** e is lowest_bit_exponent(x). *)
Definition lowest_bit (x : float) (e : Z) : Prop := exists k, Z.odd k = true /\ B2R x = IZR k * bpow e.

(** The check on one axis, of the exact far corner lo + size: `grid` is at most the lowest bit of the
    size after n halvings and that of lo, at least the format's, and the corners are at most
    2^min(grid + prec, emax - 1). *)
Record accepted (grid : Z) (n : nat) (l s : float) : Prop := {
  accepted_lo : is_finite l = true;
  accepted_size : is_finite s = true;
  accepted_positive : 0 < B2R s;
  accepted_size_bits : exists e, lowest_bit s e /\ (grid <= e - Z.of_nat n)%Z;
  accepted_lo_bits : B2R l = 0 \/ exists e, lowest_bit l e /\ (grid <= e)%Z;
  accepted_grid : (emin <= grid)%Z;
  accepted_low : Rabs (B2R l) <= bpow (Z.min (grid + prec) (emax - 1));
  accepted_high : Rabs (B2R l + B2R s) <= bpow (Z.min (grid + prec) (emax - 1)) }.

Lemma coarser : forall k e g, (g <= e)%Z -> IZR k * bpow e = IZR (k * 2 ^ (e - g)) * bpow g.
Proof.
  intros k e g H. rewrite mult_IZR, (IZR_Zpower radix2), Rmult_assoc, <- bpow_plus by lia.
  do 2 f_equal. ring.
Qed.

Theorem make_on_grid : forall grid n l s, accepted grid n l s -> axis_on_grid prec emax grid n l s.
Proof.
  intros grid n l s A. constructor; try apply A.
  - destruct (accepted_lo_bits _ _ _ _ A) as [Z|[e [[k [_ E]] H]]].
    + exists 0%Z. rewrite Z. ring.
    + rewrite E. eexists. now apply coarser.
  - destruct (accepted_size_bits _ _ _ _ A) as [e [[k [_ E]] H]].
    exists (k * 2 ^ (e - (grid + Z.of_nat n)))%Z. split; [| rewrite E; apply coarser; lia].
    apply Z.mul_pos_pos; [| apply Z.pow_pos_nonneg; lia].
    apply lt_IZR. apply Rmult_lt_reg_r with (bpow e); [apply bpow_gt_0|].
    rewrite <- E, Rmult_0_l. apply A.
  - generalize (accepted_low _ _ _ _ A). intros H. apply Rabs_le_inv in H. apply H.
  - generalize (accepted_high _ _ _ _ A). intros H. apply Rabs_le_inv in H. apply H.
Qed.

(** ** Octants by index *)

(** lo + index * size, rounded twice. *)
Definition from_plane (m : mode) (plane index size : float) : float := Bplus m plane (Bmult m index size).

Lemma mult_exact : forall m (x y : float), is_finite x = true -> is_finite y = true ->
  format (B2R x * B2R y) -> Rabs (B2R x * B2R y) < bpow emax ->
  is_finite (Bmult m x y) = true /\ B2R (Bmult m x y) = B2R x * B2R y.
Proof.
  intros m x y Fx Fy F L. generalize (Bmult_correct prec emax _ _ m x y).
  rewrite round_generic by (auto with typeclass_instances).
  rewrite Rlt_bool_true by exact L. rewrite Fx, Fy. tauto.
Qed.

(** An octant of an axis on the grid: size is that of level j <= n, index and size are exact. *)
Lemma from_plane_exact : forall m g n l s (plane index size : float) k, axis_on_grid prec emax g n l s ->
  is_finite plane = true -> is_finite index = true -> is_finite size = true ->
  format (B2R index * B2R size) -> Rabs (B2R index * B2R size) < bpow emax ->
  B2R plane + B2R index * B2R size = IZR k * bpow g ->
  B2R l <= B2R plane + B2R index * B2R size <= B2R l + B2R s ->
  is_finite (from_plane m plane index size) = true /\
  B2R (from_plane m plane index size) = B2R plane + B2R index * B2R size.
Proof.
  intros m g n l s plane index size k G Fp Fi Fs F L E B.
  destruct (mult_exact m index size Fi Fs F L) as [FM BM].
  unfold from_plane. rewrite <- BM in *.
  destruct (on_grid_number prec emax g (B2R plane + B2R (Bmult m index size))) as [X Y].
  - apply G.
  - exists k. exact E.
  - generalize (low_enough _ _ _ _ _ _ G) (high_enough _ _ _ _ _ _ G). intros. apply Rabs_le. lra.
  - now apply plus_exact.
Qed.

(** The octant's lower plane lo + k * size / 2^j is on the grid and in the root. *)
Lemma octant_plane : forall g n l s j k, axis_on_grid prec emax g n l s -> (j <= n)%nat ->
  (0 <= k <= 2 ^ Z.of_nat j)%Z ->
  (exists i, B2R l + IZR k * (B2R s * bpow (- Z.of_nat j)) = IZR i * bpow g) /\
  B2R l <= B2R l + IZR k * (B2R s * bpow (- Z.of_nat j)) <= B2R l + B2R s.
Proof.
  intros g n l s j k G Hj Hk. assert (P := size_positive prec emax _ _ _ _ G). split.
  - destruct (grid_lo _ _ _ _ _ _ G) as [a Ha]. destruct (grid_size _ _ _ _ _ _ G) as [c [_ Hc]].
    exists (a + k * c * 2 ^ (Z.of_nat n - Z.of_nat j))%Z.
    rewrite Ha, Hc, plus_IZR, !mult_IZR, (IZR_Zpower radix2) by lia.
    rewrite (Rmult_assoc (IZR c)), <- bpow_plus.
    replace (g + Z.of_nat n + - Z.of_nat j)%Z with (Z.of_nat n - Z.of_nat j + g)%Z by ring.
    rewrite bpow_plus. ring.
  - assert (0 <= IZR k) by (apply IZR_le; lia).
    assert (U : IZR k * bpow (- Z.of_nat j) <= 1).
    { apply Rmult_le_reg_r with (bpow (Z.of_nat j)); [apply bpow_gt_0|].
      rewrite Rmult_assoc, <- bpow_plus, Rmult_1_l. replace (- Z.of_nat j + Z.of_nat j)%Z with 0%Z by ring.
      simpl. rewrite Rmult_1_r, <- (IZR_Zpower radix2) by lia. apply IZR_le. apply Hk. }
    assert (0 <= IZR k * bpow (- Z.of_nat j)) by (apply Rmult_le_pos; [assumption | apply bpow_ge_0]).
    nra.
Qed.

(** lo + index * size: exact where the product is a number. *)
Theorem octant_from_lo : forall m g n l s (index size : float) j k, axis_on_grid prec emax g n l s ->
  (j <= n)%nat -> (0 <= k <= 2 ^ Z.of_nat j)%Z -> is_finite index = true -> is_finite size = true ->
  B2R index = IZR k -> B2R size = B2R s * bpow (- Z.of_nat j) ->
  format (IZR k * B2R size) -> Rabs (IZR k * B2R size) < bpow emax ->
  is_finite (from_plane m l index size) = true /\
  B2R (from_plane m l index size) = B2R l + IZR k * (B2R s * bpow (- Z.of_nat j)).
Proof.
  intros m g n l s index size j k G Hj Hk Fi Fs Bi Bs F L.
  destruct (octant_plane g n l s j k G Hj Hk) as [[i Hi] B].
  rewrite <- Bs, <- Bi in *. apply from_plane_exact with g n l s i; auto. apply G.
Qed.

(** mid + (index - 2^(level-1)) * size: exact on every axis on the grid, since the product is at most
    half the root, and that at most the greater of its ends. *)
Theorem octant_from_middle : forall m g n l s (index size : float) j k, axis_on_grid prec emax g n l s ->
  (1 <= j <= n)%nat -> (0 <= k <= 2 ^ Z.of_nat j)%Z -> is_finite index = true -> is_finite size = true ->
  B2R index = IZR (k - 2 ^ (Z.of_nat j - 1)) -> B2R size = B2R s * bpow (- Z.of_nat j) ->
  is_finite (from_plane m (mid_at prec emax m l s) index size) = true /\
  B2R (from_plane m (mid_at prec emax m l s) index size) = B2R l + IZR k * (B2R s * bpow (- Z.of_nat j)).
Proof.
  intros m g n l s index size j k G Hj Hk Fi Fs Bi Bs.
  destruct (octant_plane g n l s j k G ltac:(lia) Hk) as [[i Hi] B].
  assert (P := size_positive prec emax _ _ _ _ G).
  destruct n as [|n]; [lia|]. destruct (mid_exact prec emax m _ _ _ _ G) as [FM BM].
  assert (H2 : bpow (Z.of_nat j - 1) * bpow (- Z.of_nat j) = / 2).
  { rewrite <- bpow_plus. replace (Z.of_nat j - 1 + - Z.of_nat j)%Z with (-1)%Z by ring. reflexivity. }
  (* the product: index * size = k * size_j - size / 2 *)
  assert (X : B2R index * B2R size = IZR k * (B2R s * bpow (- Z.of_nat j)) - B2R s / 2).
  { rewrite Bi, Bs, minus_IZR, (IZR_Zpower radix2) by lia.
    replace (B2R s / 2) with (B2R s * (bpow (Z.of_nat j - 1) * bpow (- Z.of_nat j))) by (rewrite H2; lra). ring. }
  generalize (low_enough _ _ _ _ _ _ G) (high_enough _ _ _ _ _ _ G). intros LE HE.
  destruct (on_grid_number prec emax g (B2R index * B2R size)) as [F L].
  - apply G.
  - destruct (octant_plane g (S n) l s 1 1 G ltac:(lia) ltac:(simpl; lia)) as [[h Hh] _].
    exists (i - h)%Z. rewrite minus_IZR, Rmult_minus_distr_r, <- Hi, <- Hh, X. simpl. lra.
  - rewrite X. apply Rabs_le. lra.
  - assert (E : B2R (mid_at prec emax m l s) + B2R index * B2R size =
                B2R l + IZR k * (B2R s * bpow (- Z.of_nat j))) by (rewrite BM, X; lra).
    rewrite <- E. apply from_plane_exact with g (S n) l s i; auto; rewrite E; assumption.
Qed.

(** [0, 2^E] and [-2^E, 2^E]: the size is a power of two, the product exact to level prec. *)
Lemma power_product : forall e k, (emin <= e)%Z -> (0 <= k <= 2 ^ prec)%Z -> IZR k * bpow e < bpow emax ->
  format (IZR k * bpow e) /\ Rabs (IZR k * bpow e) < bpow emax.
Proof.
  intros e k He Hk L. split; [apply grid_format; [exact Hprec | exact He | lia]|].
  rewrite Rabs_pos_eq; [exact L|]. apply Rmult_le_pos; [apply IZR_le; lia | apply bpow_ge_0].
Qed.

Lemma power_bound : forall e j k, (0 <= j)%Z -> (0 <= k <= 2 ^ j)%Z -> (e < emax)%Z ->
  IZR k * bpow (e - j) < bpow emax.
Proof.
  intros e j k Hj Hk He. apply Rle_lt_trans with (bpow e); [| now apply bpow_lt].
  replace e with (j + (e - j))%Z at 2 by ring. rewrite bpow_plus.
  apply Rmult_le_compat_r; [apply bpow_ge_0|]. rewrite <- (IZR_Zpower radix2) by lia. apply IZR_le. apply Hk.
Qed.

Theorem unit_octant : forall m E (n : nat) (l s index size : float) j k,
  (Z.of_nat n <= prec)%Z -> (emin <= E - Z.of_nat n)%Z -> (E < emax)%Z ->
  is_finite l = true -> is_finite s = true -> B2R l = 0 -> B2R s = bpow E ->
  (j <= n)%nat -> (0 <= k <= 2 ^ Z.of_nat j)%Z -> is_finite index = true -> is_finite size = true ->
  B2R index = IZR k -> B2R size = bpow (E - Z.of_nat j) ->
  is_finite (from_plane m l index size) = true /\
  B2R (from_plane m l index size) = IZR k * bpow (E - Z.of_nat j).
Proof.
  intros m E n l s index size j k HN HE HM Fl Fs Bl Bs Hj Hk Fi Fz Bi Bz.
  assert (2 ^ Z.of_nat j <= 2 ^ prec)%Z by (apply Z.pow_le_mono_r; lia).
  destruct (power_product (E - Z.of_nat j) k) as [F L]; [lia | lia | apply power_bound; lia |].
  destruct (octant_from_lo m _ n l s index size j k
    (unit_axis_on_grid prec emax E n l s HN HE HM Fl Fs Bl Bs)) as [A B];
    rewrite ?Bz; auto; [now rewrite Bs, <- bpow_plus|].
  split; [exact A|]. now rewrite B, Bl, Bs, <- bpow_plus, Rplus_0_l.
Qed.

Theorem symmetric_octant : forall m E (n : nat) (l s index size : float) j k,
  (1 <= n)%nat -> (Z.of_nat n <= prec)%Z -> (emin <= E + 1 - Z.of_nat n)%Z -> (E + 1 < emax)%Z ->
  is_finite l = true -> is_finite s = true -> B2R l = - bpow E -> B2R s = bpow (E + 1) ->
  (j <= n)%nat -> (0 <= k <= 2 ^ Z.of_nat j)%Z -> is_finite index = true -> is_finite size = true ->
  B2R index = IZR k -> B2R size = bpow (E + 1 - Z.of_nat j) ->
  is_finite (from_plane m l index size) = true /\
  B2R (from_plane m l index size) = - bpow E + IZR k * bpow (E + 1 - Z.of_nat j).
Proof.
  intros m E n l s index size j k H1 HN HE HM Fl Fs Bl Bs Hj Hk Fi Fz Bi Bz.
  assert (2 ^ Z.of_nat j <= 2 ^ prec)%Z by (apply Z.pow_le_mono_r; lia).
  destruct (power_product (E + 1 - Z.of_nat j) k) as [F L]; [lia | lia | apply power_bound; lia |].
  destruct (octant_from_lo m _ n l s index size j k
    (symmetric_axis_on_grid prec emax E n l s ltac:(lia) HE HM Fl Fs H1 Bl Bs)) as [A B];
    rewrite ?Bz; auto; [now rewrite Bs, <- bpow_plus|].
  split; [exact A|]. now rewrite B, Bl, Bs, <- bpow_plus.
Qed.

End Root.

(** ** A root on which lo + index * size rounds *)

Local Instance prec53 : Prec_gt_0 53 := eq_refl.
Local Instance emax1024 : Prec_lt_emax 53 1024 := eq_refl.

Definition number64 (k e : Z) : float 53 1024 := binary_normalize 53 1024 prec53 emax1024 mode_NE k e false.

(** [-3, 3], its last octant at level 52. *)
Definition minus_three : float 53 1024 := number64 (-3) 0.
Definition six : float 53 1024 := number64 3 1.
Definition last_index : float 53 1024 := number64 (2 ^ 52 - 1) 0.
Definition last_size : float 53 1024 := number64 3 (-51).

Lemma value64 : forall (x : float 53 1024) r, B2SF x = r -> B2R x = SF2R radix2 r.
Proof. intros x r <-. symmetry. apply SF2R_B2SF. Qed.

Ltac value := erewrite value64 by (vm_compute; reflexivity); unfold SF2R, F2R; simpl; lra.

Lemma minus_three_value : B2R minus_three = -3. Proof. value. Qed.
Lemma six_value : B2R six = 6. Proof. value. Qed.

Theorem rounding_root_accepted : accepted 53 1024 (-51) 52 minus_three six.
Proof.
  constructor; rewrite ?minus_three_value, ?six_value; try reflexivity; try (vm_compute; congruence).
  - lra.
  - exists 1%Z. split; [| vm_compute; congruence]. exists 3%Z. split; [reflexivity|].
    rewrite six_value. simpl. lra.
  - right. exists 0%Z. split; [| vm_compute; congruence]. exists (-3)%Z. split; [reflexivity|].
    rewrite minus_three_value. simpl. lra.
  - rewrite Rabs_left by lra. simpl. lra.
  - rewrite Rabs_pos_eq by lra. simpl. lra.
Qed.

(** The exact plane -3 + (2^52 - 1) * 6 * 2^-52 is a number; the formula gives the one below it. *)
Theorem octant_rounds :
  B2R last_index = IZR (2 ^ 52 - 1) /\ B2R last_size = B2R six * bpow radix2 (- 52) /\
  B2R (from_plane 53 1024 mode_NE minus_three last_index last_size) =
  B2R minus_three + B2R last_index * B2R last_size - bpow radix2 (-51).
Proof.
  assert (I : B2R last_index = IZR (2 ^ 52 - 1)) by value.
  assert (S : B2R last_size = B2R six * bpow radix2 (- 52)) by (rewrite six_value; value).
  split; [exact I|]. split; [exact S|]. rewrite I, S, minus_three_value, six_value. value.
Qed.
