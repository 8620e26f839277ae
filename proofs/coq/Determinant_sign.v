(** The integers of octree/geometry/include/graze/octree/determinant_sign.hpp give the sign of
      (x.greater - x.less) x_factor - (y.greater - y.less) y_factor.

    Numbers here are what `double_parts` takes a double apart into: a sign, a significand below 2^53
    and an exponent ([parts_of] does it to Flocq's numbers). Machine integers are integers modulo 2^64,
    2^128 or 2^512, with the reductions written out where the C++ types make them; that nothing is
    lost to them is what is proved. *)
From Coq Require Import ZArith Bool List Lia Reals.
From Flocq Require Import Core BinarySingleNaN.
Import ListNotations.
Open Scope Z_scope.

Definition w64 := 2 ^ 64.
Definition w128 := 2 ^ 128.
Definition w512 := 2 ^ 512.

(** * double_parts *)
Record parts := { significand : Z; exponent : Z; negative : bool }.
Definition proper (p : parts) : Prop := 0 <= significand p < 2 ^ 53.
Definition signed (p : parts) : Z := if negative p then - significand p else significand p.

(** The double in units of 2^base, for base <= exponent; 0 has any exponent. *)
Definition in_units (base : Z) (p : parts) : Z := signed p * 2 ^ (exponent p - base).

(** * wide_product *)
Definition wide_lower (g l : parts) : Z * Z * Z :=
  let of_g := if significand g =? 0 then exponent l else exponent g in
  let of_l := if significand l =? 0 then exponent g else exponent l in
  (of_g, of_l, Z.min of_g of_l).

Record wide := { high : Z; low : Z; wide_exponent : Z; fits : bool }.

Definition signed_part (p : parts) (shift : Z) : Z :=
  let flip := (0 - (if negative p then 1 else 0)) mod w128 in
  (Z.lxor ((significand p * 2 ^ (shift mod 64)) mod w128) flip - flip) mod w128.

Definition wide_product (g l factor : parts) : wide :=
  let '(of_g, of_l, lower) := wide_lower g l in
  let by_g := of_g - lower in
  let by_l := of_l - lower in
  let difference := (signed_part g by_g - signed_part l by_l) mod w128 in
  let bottom := (difference mod w64 * significand factor) mod w128 in
  let top := (difference / w64 * significand factor + bottom / w64) mod w128 in
  {| high := (top / w64) mod w64;
     low := Z.lor ((top * w64) mod w128) (bottom mod w64);
     wide_exponent := lower + exponent factor;
     fits := (by_g <? 64) && (by_l <? 64) |}.

(** `shifted`: the 256-bit number times 2^shift, in halves. *)
Definition shifted (w : wide) (shift : Z) : Z * Z :=
  (Z.lor ((high w * 2 ^ shift) mod w128) (low w / 2 / 2 ^ (127 - shift)),
   (low w * 2 ^ shift) mod w128).

(** The bitwise or of a multiple of 2^s and a number below 2^s is their sum. *)
Lemma lor_disjoint a b s : 0 <= s -> 0 <= b < 2 ^ s -> Z.lor (a * 2 ^ s) b = a * 2 ^ s + b.
Proof.
  intros S B.
  assert (N : Z.land (a * 2 ^ s) b = 0).
  { apply Z.bits_inj'. intros n Hn. rewrite Z.land_spec, Z.bits_0.
    destruct (Z.lt_ge_cases n s) as [L|L].
    - rewrite Z.mul_pow2_bits_low by exact L. reflexivity.
    - rewrite <- (Z.mod_small b (2 ^ s)) by exact B.
      rewrite Z.mod_pow2_bits_high by lia. apply andb_false_r. }
  rewrite <- Z.lxor_lor by exact N. symmetry. apply Z.add_nocarry_lxor. exact N.
Qed.

Lemma pow2_pos n : 0 <= n -> 0 < 2 ^ n.
Proof. intros H. apply Z.pow_pos_nonneg; lia. Qed.

(** Flipping the lowest n bits takes a number from 2^n - 1. *)
Lemma flipped a n : 0 <= n -> 0 <= a < 2 ^ n -> Z.lxor a (2 ^ n - 1) = 2 ^ n - 1 - a.
Proof.
  intros N A. change (2 ^ n - 1) with (Z.pred (2 ^ n)). rewrite <- Z.ones_equiv.
  assert (H : Z.ldiff (Z.ones n) a = Z.ones n - a).
  { symmetry. apply Z.sub_nocarry_ldiff. apply Z.bits_inj'. intros k K.
    rewrite Z.ldiff_spec, Z.bits_0. destruct (Z.lt_ge_cases k n).
    - rewrite Z.ones_spec_low by lia. apply andb_false_r.
    - rewrite <- (Z.mod_small a (2 ^ n)) by exact A. rewrite Z.mod_pow2_bits_high by lia. reflexivity. }
  rewrite <- H. apply Z.bits_inj'. intros k K. rewrite Z.lxor_spec, Z.ldiff_spec.
  destruct (Z.lt_ge_cases k n).
  - rewrite Z.ones_spec_low by lia. apply xorb_true_r.
  - rewrite Z.ones_spec_high by lia. rewrite <- (Z.mod_small a (2 ^ n)) by exact A.
    rewrite Z.mod_pow2_bits_high by lia. reflexivity.
Qed.

(** (x ^ flip) - flip is x or -x, modulo 2^128. *)
Lemma flip_minus_flip x (minus : bool) : 0 <= x < w128 ->
  let flip := (0 - (if minus then 1 else 0)) mod w128 in
  (Z.lxor x flip - flip) mod w128 = (if minus then - x else x) mod w128.
Proof.
  intros X. destruct minus; cbv zeta.
  - change ((0 - 1) mod w128) with (2 ^ 128 - 1). rewrite flipped by (exact X || lia). f_equal. lia.
  - change ((0 - 0) mod w128) with 0. rewrite Z.lxor_0_r, Z.sub_0_r. reflexivity.
Qed.

(** The part of an operand: exact modulo 2^128. *)
Lemma signed_part_mod p shift : proper p -> 0 <= shift < 64 ->
  signed_part p shift mod w128 = (signed p * 2 ^ shift) mod w128.
Proof.
  intros P S. unfold signed_part, signed. cbv zeta.
  rewrite (Z.mod_small shift 64) by lia.
  assert (B : 0 <= (significand p * 2 ^ shift) mod w128 < w128) by (apply Z.mod_pos_bound; reflexivity).
  pose proof (flip_minus_flip _ (negative p) B) as E. cbv zeta in E. rewrite E. clear E.
  rewrite Z.mod_mod by (unfold w128; lia).
  destruct (negative p).
  - rewrite Z.mul_opp_l. rewrite <- (Z.sub_0_l (_ mod _)), <- (Z.sub_0_l (_ * _)).
    apply Zminus_mod_idemp_r.
  - apply Z.mod_mod. unfold w128. lia.
Qed.

(** The 128-bit difference is the exact one, where that is not negative. *)
Lemma difference_exact g l by_g by_l : proper g -> proper l -> 0 <= by_g < 64 -> 0 <= by_l < 64 ->
  0 <= signed g * 2 ^ by_g - signed l * 2 ^ by_l ->
  (signed_part g by_g - signed_part l by_l) mod w128 = signed g * 2 ^ by_g - signed l * 2 ^ by_l /\
  signed g * 2 ^ by_g - signed l * 2 ^ by_l < 2 ^ 117.
Proof.
  intros G L Bg Bl D.
  assert (B : forall p s, proper p -> 0 <= s < 64 -> - 2 ^ 116 < signed p * 2 ^ s < 2 ^ 116).
  { intros p s [P1 P2] S. change (2 ^ 116) with (2 ^ 53 * 2 ^ 63).
    assert (0 < 2 ^ s <= 2 ^ 63) by (split; [apply pow2_pos; lia|apply Z.pow_le_mono_r; lia]).
    unfold signed. destruct (negative p); nia. }
  pose proof (B g by_g G Bg) as B1. pose proof (B l by_l L Bl) as B2.
  assert (2 ^ 117 = 2 ^ 116 + 2 ^ 116) by reflexivity.
  split; [|lia].
  rewrite Zminus_mod, !signed_part_mod by assumption. rewrite <- Zminus_mod.
  apply Z.mod_small. split; [exact D|]. apply Z.lt_trans with (2 ^ 117); [lia|reflexivity].
Qed.

(** The 192-bit product by halves is the exact one. *)
Lemma product_exact d f : 0 <= d < 2 ^ 117 -> 0 <= f < 2 ^ 53 ->
  let bottom := (d mod w64 * f) mod w128 in
  let top := (d / w64 * f + bottom / w64) mod w128 in
  (top / w64) mod w64 * w128 + Z.lor ((top * w64) mod w128) (bottom mod w64) = d * f /\
  0 <= (top / w64) mod w64 < w64 /\
  0 <= Z.lor ((top * w64) mod w128) (bottom mod w64) < w128.
Proof.
  intros D F. cbv zeta.
  assert (W : w128 = w64 * w64) by reflexivity.
  assert (W0 : 0 < w64) by reflexivity.
  pose proof (Z.div_mod d w64 ltac:(lia)) as E1. pose proof (Z.mod_pos_bound d w64 W0) as B1.
  assert (Q1 : 0 <= d / w64 < 2 ^ 53).
  { split; [apply Z.div_pos; lia|]. apply Z.div_lt_upper_bound; [lia|].
    change (w64 * 2 ^ 53) with (2 ^ 117). lia. }
  assert (S53 : 2 ^ 53 < w64) by reflexivity.
  assert (X1 : 0 <= d mod w64 * f < w128) by nia.
  rewrite (Z.mod_small (d mod w64 * f) w128) by exact X1.
  set (bottom := d mod w64 * f) in *.
  pose proof (Z.div_mod bottom w64 ltac:(lia)) as E2. pose proof (Z.mod_pos_bound bottom w64 W0) as B2.
  assert (Q2 : 0 <= bottom / w64 < w64).
  { split; [apply Z.div_pos; lia|]. apply Z.div_lt_upper_bound; lia. }
  assert (X2 : 0 <= d / w64 * f < 2 ^ 106).
  { change (2 ^ 106) with (2 ^ 53 * 2 ^ 53). nia. }
  assert (S106 : 2 ^ 106 + w64 < w128) by reflexivity.
  rewrite (Z.mod_small (d / w64 * f + bottom / w64) w128) by lia.
  set (top := d / w64 * f + bottom / w64) in *.
  pose proof (Z.div_mod top w64 ltac:(lia)) as E3. pose proof (Z.mod_pos_bound top w64 W0) as B3.
  assert (Q3 : 0 <= top / w64 < w64).
  { split; [apply Z.div_pos; lia|]. apply Z.div_lt_upper_bound; lia. }
  rewrite (Z.mod_small (top / w64) w64) by exact Q3.
  replace ((top * w64) mod w128) with ((top mod w64) * w64)
    by (rewrite W; symmetry; apply Z.mul_mod_distr_r; lia).
  assert (LO : Z.lor (top mod w64 * w64) (bottom mod w64) = top mod w64 * w64 + bottom mod w64)
    by (apply (lor_disjoint _ _ 64); [lia|exact B2]).
  rewrite LO. clear LO.
  split; [|split; [exact Q3|nia]].
  transitivity (w64 * top + bottom mod w64); [rewrite W; lia|].
  transitivity (w64 * (d / w64 * f) + bottom); [unfold top; lia|].
  transitivity ((w64 * (d / w64) + d mod w64) * f); [unfold bottom; ring|].
  rewrite <- E1. reflexivity.
Qed.

(** Exponents of a difference whose operands differ enough from 0 or are 0. *)
Definition base_of (g l : parts) : Z := snd (wide_lower g l).

Lemma zero_signed p : significand p = 0 -> signed p = 0.
Proof. unfold signed. intros ->. destruct (negative p); reflexivity. Qed.

(** wide_product holds (greater - less) |factor| exactly. *)
Theorem wide_product_exact g l f base :
  proper g -> proper l -> proper f ->
  let w := wide_product g l f in
  fits w = true ->
  base <= exponent g -> base <= exponent l ->
  0 <= in_units base g - in_units base l ->
  (high w * w128 + low w) * 2 ^ (wide_exponent w - exponent f - base) =
    (in_units base g - in_units base l) * significand f /\
  base <= wide_exponent w - exponent f /\
  0 <= high w < w64 /\ 0 <= low w < w128 /\ 0 <= high w * w128 + low w < 2 ^ 170.
Proof.
  intros G L F. unfold wide_product, wide_lower. cbv zeta.
  set (of_g := if significand g =? 0 then exponent l else exponent g).
  set (of_l := if significand l =? 0 then exponent g else exponent l).
  cbn [fits high low wide_exponent]. intros Fit Bg Bl D.
  apply andb_true_iff in Fit. destruct Fit as [Fg Fl].
  apply Z.ltb_lt in Fg. apply Z.ltb_lt in Fl.
  set (lower := Z.min of_g of_l) in *.
  assert (Og : base <= of_g) by (unfold of_g; case (_ =? _); assumption).
  assert (Ol : base <= of_l) by (unfold of_l; case (_ =? _); assumption).
  assert (Lg : lower <= of_g) by apply Z.le_min_l.
  assert (Ll : lower <= of_l) by apply Z.le_min_r.
  assert (Lb : base <= lower) by (apply Z.min_glb; assumption).
  assert (Ug : in_units base g = signed g * 2 ^ (of_g - lower) * 2 ^ (lower - base)).
  { unfold in_units, of_g. destruct (Z.eqb_spec (significand g) 0) as [Z|Z].
    - rewrite (zero_signed _ Z). reflexivity.
    - rewrite <- Z.mul_assoc, <- Z.pow_add_r by (unfold of_g in Lg;
        destruct (Z.eqb_spec (significand g) 0); lia). f_equal. f_equal. lia. }
  assert (Ul : in_units base l = signed l * 2 ^ (of_l - lower) * 2 ^ (lower - base)).
  { unfold in_units, of_l. destruct (Z.eqb_spec (significand l) 0) as [Z|Z].
    - rewrite (zero_signed _ Z). reflexivity.
    - rewrite <- Z.mul_assoc, <- Z.pow_add_r by (unfold of_l in Ll;
        destruct (Z.eqb_spec (significand l) 0); lia). f_equal. f_equal. lia. }
  rewrite Ug, Ul in *. rewrite <- Z.mul_sub_distr_r in *.
  pose proof (pow2_pos (lower - base) ltac:(lia)) as P.
  assert (D' : 0 <= signed g * 2 ^ (of_g - lower) - signed l * 2 ^ (of_l - lower)) by nia.
  destruct (difference_exact g l (of_g - lower) (of_l - lower) G L ltac:(lia) ltac:(lia) D') as [E B].
  rewrite E. set (d := signed g * 2 ^ (of_g - lower) - signed l * 2 ^ (of_l - lower)) in *.
  destruct (product_exact d (significand f) (conj D' B) F) as (Ep & Bh & Bw). cbv zeta in Ep, Bh, Bw.
  rewrite Ep. destruct F as [F1 F2].
  split; [|split; [|split; [|split]]]; try assumption.
  - replace (lower + exponent f - exponent f - base) with (lower - base) by ring. ring.
  - lia.
  - change (2 ^ 170) with (2 ^ 117 * 2 ^ 53). nia.
Qed.

(** The shifted halves are exact for numbers below 2^170 and shifts below 86. *)
Lemma shifted_exact w shift : 0 <= high w < w64 -> 0 <= low w < w128 ->
  high w * w128 + low w < 2 ^ 170 -> 0 <= shift < 86 ->
  let '(h, l) := shifted w shift in
  h * w128 + l = (high w * w128 + low w) * 2 ^ shift /\ 0 <= l < w128.
Proof.
  intros H L B S. unfold shifted.
  pose proof (pow2_pos shift ltac:(lia)) as P.
  assert (Hh : high w < 2 ^ 42).
  { apply Z.mul_lt_mono_pos_r with w128; [reflexivity|].
    change (2 ^ 42 * w128) with (2 ^ 170). lia. }
  assert (P86 : 2 ^ shift <= 2 ^ 85) by (apply Z.pow_le_mono_r; lia).
  assert (Hs : 0 <= high w * 2 ^ shift < w128).
  { assert (2 ^ 42 * 2 ^ 85 < w128) by reflexivity. nia. }
  rewrite (Z.mod_small (high w * 2 ^ shift)) by exact Hs.
  assert (E : low w / 2 / 2 ^ (127 - shift) = low w / 2 ^ (128 - shift)).
  { rewrite Z.div_div by (try lia; apply pow2_pos; lia). f_equal.
    change 2 with (2 ^ 1) at 1. rewrite <- Z.pow_add_r by lia. f_equal. lia. }
  rewrite E.
  pose proof (pow2_pos (128 - shift) ltac:(lia)) as P'.
  assert (W : w128 = 2 ^ (128 - shift) * 2 ^ shift)
    by (rewrite <- Z.pow_add_r by lia; unfold w128; f_equal; lia).
  rewrite lor_disjoint.
  - assert (ML : (low w * 2 ^ shift) mod w128 = low w mod 2 ^ (128 - shift) * 2 ^ shift)
      by (rewrite W; apply Z.mul_mod_distr_r; lia).
    rewrite ML.
    pose proof (Z.div_mod (low w) (2 ^ (128 - shift)) ltac:(lia)) as DM.
    pose proof (Z.mod_pos_bound (low w) (2 ^ (128 - shift)) P') as MB.
    set (q := low w / 2 ^ (128 - shift)) in *. set (r := low w mod 2 ^ (128 - shift)) in *.
    split.
    + rewrite DM. rewrite W. ring.
    + rewrite W. split; [apply Z.mul_nonneg_nonneg; lia|apply Z.mul_lt_mono_pos_r; lia].
  - lia.
  - split; [apply Z.div_pos; lia|]. apply Z.div_lt_upper_bound; [lia|].
    rewrite <- W. lia.
Qed.

(** determinant_sign where both products fit: a comparison of 256-bit numbers. *)
Definition compare_halves (p q : Z * Z) : Z :=
  let sign_of a b := (if b <? a then 1 else 0) - (if a <? b then 1 else 0) in
  let by_high := sign_of (fst p) (fst q) in
  if by_high =? 0 then sign_of (snd p) (snd q) else by_high.

Lemma compare_halves_correct p q : 0 <= snd p < w128 -> 0 <= snd q < w128 ->
  compare_halves p q = Z.sgn ((fst p * w128 + snd p) - (fst q * w128 + snd q)).
Proof.
  destruct p as [a b], q as [c d]. cbn [fst snd]. intros B D. unfold compare_halves. cbn [fst snd].
  assert (0 < w128) by reflexivity.
  symmetry.
  destruct (Z.ltb_spec c a), (Z.ltb_spec a c), (Z.ltb_spec d b), (Z.ltb_spec b d); simpl; try lia;
    first [apply Z.sgn_pos; nia | apply Z.sgn_neg; nia | apply Z.sgn_null; nia].
Qed.

Definition fast_sign (a b : wide) : option Z :=
  let above := wide_exponent a - wide_exponent b in
  if negb (fits a) || negb (fits b) || (86 <=? above) || (above <=? -86) then None
  else Some (compare_halves (shifted a (Z.max above 0)) (shifted b (Z.max (- above) 0))).

(** The determinant in units of 2^(base + fbase): what the sign is of. *)
Definition determinant (base fbase : Z) (xg xl xf yg yl yf : parts) : Z :=
  (in_units base xg - in_units base xl) * significand xf * 2 ^ (exponent xf - fbase) -
  (in_units base yg - in_units base yl) * significand yf * 2 ^ (exponent yf - fbase).

(** Fast path: the sign of the determinant. *)
Theorem fast_sign_correct xg xl xf yg yl yf base fbase s :
  proper xg -> proper xl -> proper xf -> proper yg -> proper yl -> proper yf ->
  base <= exponent xg -> base <= exponent xl -> base <= exponent yg -> base <= exponent yl ->
  fbase <= exponent xf -> fbase <= exponent yf ->
  0 <= in_units base xg - in_units base xl -> 0 <= in_units base yg - in_units base yl ->
  fast_sign (wide_product xg xl xf) (wide_product yg yl yf) = Some s ->
  s = Z.sgn (determinant base fbase xg xl xf yg yl yf).
Proof.
  intros PA PB PC PD PE PF B1 B2 B3 B4 B5 B6 D1 D2.
  pose proof (wide_product_exact xg xl xf base PA PB PC) as WA.
  pose proof (wide_product_exact yg yl yf base PD PE PF) as WB. cbv zeta in WA, WB.
  set (a := wide_product xg xl xf) in *. set (b := wide_product yg yl yf) in *. clearbody a b.
  unfold fast_sign. cbv zeta. set (above := wide_exponent a - wide_exponent b).
  destruct (fits a) eqn:Fa; [|discriminate]. destruct (fits b) eqn:Fb; [|discriminate].
  cbn [negb orb]. destruct (Z.leb_spec 86 above); [discriminate|].
  destruct (Z.leb_spec above (-86)); [discriminate|]. cbn [orb]. intros [= <-].
  destruct (WA eq_refl B1 B2 D1) as (Ea & La & Ha & Wa & Va).
  destruct (WB eq_refl B3 B4 D2) as (Eb & Lb & Hb & Wb & Vb).
  pose proof (shifted_exact a (Z.max above 0) Ha Wa (proj2 Va) ltac:(lia)) as Sa.
  pose proof (shifted_exact b (Z.max (- above) 0) Hb Wb (proj2 Vb) ltac:(lia)) as Sb.
  destruct (shifted a (Z.max above 0)) as [ah al]. destruct (shifted b (Z.max (- above) 0)) as [bh bl].
  destruct Sa as [Sa La']. destruct Sb as [Sb Lb'].
  rewrite compare_halves_correct by assumption. cbn [fst snd]. rewrite Sa, Sb.
  unfold determinant. rewrite <- Ea, <- Eb.
  set (va := high a * w128 + low a) in *. set (vb := high b * w128 + low b) in *.
  set (m := Z.min (wide_exponent a) (wide_exponent b)).
  replace (va * 2 ^ (wide_exponent a - exponent xf - base) * 2 ^ (exponent xf - fbase))
    with (va * 2 ^ Z.max above 0 * 2 ^ (m - base - fbase)).
  2: { rewrite <- !Z.mul_assoc, <- !Z.pow_add_r by (unfold m, above; lia). f_equal. f_equal.
       unfold m, above. lia. }
  replace (vb * 2 ^ (wide_exponent b - exponent yf - base) * 2 ^ (exponent yf - fbase))
    with (vb * 2 ^ Z.max (- above) 0 * 2 ^ (m - base - fbase)).
  2: { rewrite <- !Z.mul_assoc, <- !Z.pow_add_r by (unfold m, above; lia). f_equal. f_equal.
       unfold m, above. lia. }
  rewrite <- Z.mul_sub_distr_r, Z.sgn_mul.
  rewrite (Z.sgn_pos (2 ^ (m - base - fbase))) by (apply pow2_pos; unfold m; lia).
  rewrite Z.mul_1_r. reflexivity.
Qed.
