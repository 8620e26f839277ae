(** An operation on floats is that of doubles, rounded to float once
    (interval/include/graze/rounding/narrow.hpp): rounding in one direction to a format, and then in
    the same direction to one that it contains, is rounding to the lesser format at once. No more is
    needed of the formats, so that subnormal numbers and the largest ones are no exceptions; where
    nothing of the lesser format is below t, nothing is below t's rounding either (the result is
    -infinity). At the end for binary32 and binary64 with their ranges. *)
From Coq Require Import ZArith Reals Lra Lia.
From Flocq Require Import Core.
Open Scope R_scope.

Section Formats.
Variables wide narrow : R -> Prop.
Hypothesis narrow_is_wide : forall x, narrow x -> wide x.

(** F(D(t)) = F(t): the greatest narrow number below the greatest wide one below t is the greatest
    below t. *)
Theorem narrow_down : forall t d f,
  Rnd_DN_pt wide t d -> Rnd_DN_pt narrow d f -> Rnd_DN_pt narrow t f.
Proof.
  intros t d f (_ & d_le_t & d_greatest) (f_narrow & f_le_d & f_greatest).
  repeat split.
  - exact f_narrow.
  - now apply Rle_trans with d.
  - intros g g_narrow g_le_t. apply f_greatest; trivial.
    apply d_greatest; trivial. now apply narrow_is_wide.
Qed.

Theorem narrow_up : forall t u f,
  Rnd_UP_pt wide t u -> Rnd_UP_pt narrow u f -> Rnd_UP_pt narrow t f.
Proof.
  intros t u f (_ & t_le_u & u_least) (f_narrow & u_le_f & f_least).
  repeat split.
  - exact f_narrow.
  - now apply Rle_trans with u.
  - intros g g_narrow t_le_g. apply f_least; trivial.
    apply u_least; trivial. now apply narrow_is_wide.
Qed.

(** Where no narrow number is below D(t), none is below t. *)
Theorem none_below : forall t d,
  Rnd_DN_pt wide t d -> (forall g, narrow g -> d < g) -> forall g, narrow g -> t < g.
Proof.
  intros t d (_ & _ & d_greatest) none g g_narrow.
  apply Rnot_le_lt. intros g_le_t.
  apply (Rlt_not_le _ _ (none g g_narrow)).
  apply d_greatest; trivial. now apply narrow_is_wide.
Qed.

Theorem none_above : forall t u,
  Rnd_UP_pt wide t u -> (forall g, narrow g -> g < u) -> forall g, narrow g -> g < t.
Proof.
  intros t u (_ & _ & u_least) none g g_narrow.
  apply Rnot_le_lt. intros t_le_g.
  apply (Rlt_not_le _ _ (none g g_narrow)).
  apply u_least; trivial. now apply narrow_is_wide.
Qed.

(** Where no wide number is below t (D(t) = -infinity), no narrow one is. *)
Theorem none_below_at_all : forall t : R,
  (forall g, wide g -> t < g) -> forall g, narrow g -> t < g.
Proof.
  intros t none g g_narrow. apply none. now apply narrow_is_wide.
Qed.

Theorem none_above_at_all : forall t : R,
  (forall g, wide g -> g < t) -> forall g, narrow g -> g < t.
Proof.
  intros t none g g_narrow. apply none. now apply narrow_is_wide.
Qed.
End Formats.

(** The finite numbers of binary32 and binary64. *)
Definition binary32 (x : R) : Prop :=
  generic_format radix2 (FLT_exp (-149) 24) x /\ Rabs x < bpow radix2 128.
Definition binary64 (x : R) : Prop :=
  generic_format radix2 (FLT_exp (-1074) 53) x /\ Rabs x < bpow radix2 1024.

Theorem a_float_is_a_double : forall x, binary32 x -> binary64 x.
Proof.
  intros x (x_format & x_small). split.
  - apply generic_inclusion_mag with (FLT_exp (-149) 24); trivial.
    intros _. unfold FLT_exp. lia.
  - apply Rlt_trans with (bpow radix2 128); trivial. apply bpow_lt. lia.
Qed.

Theorem narrow_down_binary : forall t d f,
  Rnd_DN_pt binary64 t d -> Rnd_DN_pt binary32 d f -> Rnd_DN_pt binary32 t f.
Proof. exact (narrow_down _ _ a_float_is_a_double). Qed.

Theorem narrow_up_binary : forall t u f,
  Rnd_UP_pt binary64 t u -> Rnd_UP_pt binary32 u f -> Rnd_UP_pt binary32 t f.
Proof. exact (narrow_up _ _ a_float_is_a_double). Qed.

(** The product of two floats is a double: no rounding precedes the narrowing. *)
Theorem product_is_a_double : forall x y, binary32 x -> binary32 y -> binary64 (x * y).
Proof.
  intros x y (x_format & x_small) (y_format & y_small). split.
  - apply FLT_format_generic in x_format; [|easy]. apply FLT_format_generic in y_format; [|easy].
    destruct x_format as [[m e] Ex Hm He]. destruct y_format as [[n k] Ey Hn Hk]. simpl in *.
    apply generic_format_FLT. exists (Float radix2 (m * n) (e + k)).
    + rewrite Ex, Ey. unfold F2R. simpl. rewrite mult_IZR, bpow_plus. ring.
    + simpl. rewrite Z.abs_mul.
      apply Z.lt_le_trans with (2 ^ 24 * 2 ^ 24)%Z; [|now compute].
      apply Z.mul_lt_mono_nonneg; try apply Z.abs_nonneg; assumption.
    + simpl. lia.
  - rewrite Rabs_mult. apply Rle_lt_trans with (bpow radix2 128 * bpow radix2 128).
    + apply Rmult_le_compat; try apply Rabs_pos; now apply Rlt_le.
    + rewrite <- bpow_plus. apply bpow_lt. lia.
Qed.
