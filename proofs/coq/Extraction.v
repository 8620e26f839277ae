(** The model as a program: the definitions of Model.v and Model_descent.v themselves, over binary64,
    written out as OCaml. proofs/tie compares it with the C++ code bit for bit.

    Nothing is defined anew but names: the format, the backends, and numbers as their 64 bits by
    Flocq's reading of the interchange format.

    Trusted here: Coq's extraction; [ExtrOcamlZBigInt], which turns [Z] into Zarith's integers; and
    three functions that go bit by bit in Coq (a hundred times slower where exponents lie far apart),
    of which the program uses Zarith's own: the number of digits, the shift to the left, and the
    shift to the right with its two bits of what is lost. The definitions come along as
    [digits_as_defined], [shift_as_defined], [shr_as_defined], and the program compares them with
    their substitutes each time it starts. *)
From Coq Require Import ZArith List SpecFloat Zpower Extraction ExtrOcamlBasic ExtrOcamlZBigInt.
From Flocq Require Import Core BinarySingleNaN.
From Flocq Require Binary Bits.
From Graze Require Import Model Model_descent Exact_integer.

Definition Hprec : Prec_gt_0 53 := eq_refl.
Definition Hmax : Prec_lt_emax 53 1024 := eq_refl.
Definition number := float 53 1024.

(** The number that 64 bits stand for, and back; a NaN becomes the quiet one without payload. *)
Definition number_of_bits (bits : Z) : number := Binary.B2BSN 53 1024 (Bits.b64_of_bits bits).
Definition canonical_nan : { x : Bits.binary64 | Binary.is_nan 53 1024 x = true } :=
  exist _ (Binary.B754_nan 53 1024 false (2 ^ 51) eq_refl) eq_refl.
Definition bits_of_number (x : number) : Z := Bits.bits_of_b64 (Binary.BSN2B 53 1024 canonical_nan x).

(** The bits of a number are its own. *)
Lemma number_of_bits_of_number : forall x : number, number_of_bits (bits_of_number x) = x.
Proof.
  intros x. unfold number_of_bits, bits_of_number, Bits.b64_of_bits, Bits.bits_of_b64.
  rewrite Bits.binary_float_of_bits_of_binary_float. apply Binary.B2BSN_BSN2B.
Qed.

Definition directed_backend : backend 53 1024 := @directed 53 1024 Hprec Hmax.
Definition upward_backend : backend 53 1024 := @upward 53 1024 Hprec Hmax.
Definition nearest_backend : backend 53 1024 := nearest_as_coded.
Definition nearest_fma_backend : backend 53 1024 := nearest_fma_as_coded.

Definition prepare_ray (b : backend 53 1024) : three number -> three number -> three (axis 53 1024) :=
  @prepare 53 1024 Hprec Hmax b.

(** The cell's planes, in the mode given: exact in a root_cube in any, but for the sign of a plane
    that is 0. *)
Definition hi_plane : mode -> number -> number -> number := @hi_at 53 1024 Hprec Hmax.
Definition mid_plane : mode -> number -> number -> number := @mid_at 53 1024 Hprec Hmax.
Definition root_state := @enter_root 53 1024 Hprec Hmax.
Definition children := @split 53 1024 Hprec Hmax.
Definition descent := @descend 53 1024 Hprec Hmax.

Definition digits_as_defined := Eval unfold digits2_pos in digits2_pos.
Definition shift_as_defined := Eval unfold shift_pos in shift_pos.
Definition shr_as_defined := Eval unfold shr in shr.

Extract Constant digits2_pos => "Zarith_bits.digits".
Extract Constant shift_pos => "Zarith_bits.shift_left".
Extract Constant shr =>
 "(fun mrs e n ->
    if Big_int_Z.sign_big_int n <= 0 then (mrs, e) else
    let m, r, rest = Zarith_bits.shift_right n mrs.shr_m in
    ({ shr_m = m; shr_r = r; shr_s = mrs.shr_r || mrs.shr_s || rest }, Big_int_Z.add_big_int e n))".

Extraction Language OCaml.
Set Warnings "-extraction-opaque-accessed".
Extraction "model.ml" number_of_bits bits_of_number directed_backend upward_backend
  nearest_backend nearest_fma_backend prepare_ray lowb uppb enter_at
  leave_at within common passes2 passes touches_box half origin_side hi_plane mid_plane root_state
  passed children descent digits_as_defined shift_as_defined shr_as_defined digits2_pos
  shift_pos shr.
