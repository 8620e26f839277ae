; The same from the ray's components: finite p, q, d1, d2 give a lower bound that is not NaN.
; expected: unsat
(declare-const d1 F) (declare-const d2 F) (declare-const p F) (declare-const q F)
(assert (and (finite p) (finite q) (finite d1) (finite d2)))
(assert (fp.isNaN (lowb (mul_down (mag d1) (mag d2)) (mul_up (mag d1) (mag d2)) p q)))
