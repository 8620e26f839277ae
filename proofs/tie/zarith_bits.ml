(* Zarith's own for what Coq does bit by bit; named by proofs/coq/Extraction.v. The model has a
   module Z, which hides Zarith's there. *)
let digits m = Z.of_int (Z.numbits m)
let shift_left n m = Z.shift_left m (Z.to_int n)

(* |m| without its n lowest bits, n > 0, with the sign of m; the highest of those bits; whether
   another is set. *)
let shift_right n m =
  let n = Z.to_int n and magnitude = Z.abs m in
  let kept = Z.shift_right magnitude n in
  ((if Z.sign m < 0 then Z.neg kept else kept), Z.testbit magnitude (n - 1),
   magnitude <> Z.zero && Z.trailing_zeros magnitude < n - 1)
