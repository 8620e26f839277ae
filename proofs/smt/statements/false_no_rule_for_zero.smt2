; Without mag(0) = 1 a zero component makes C = 0, and an overflowing difference makes NaN of it.
; expected: sat
(declare-const d1 F) (declare-const d2 F) (declare-const p F) (declare-const q F)
(assert (and (finite p) (finite q) (finite d1) (finite d2)))
(define-fun bound () F
  (uppb (mul_down (fp.abs d1) (fp.abs d2)) (mul_up (fp.abs d1) (fp.abs d2)) p q))
(assert (fp.isNaN bound))
; replay: bound = lambda d1, d2, p, q: uppb(mul_down(abs(d1), abs(d2)), mul_up(abs(d1), abs(d2)), p, q)
; shows: isnan(bound)
