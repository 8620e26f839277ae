; With C rounded down and C rounded up in each other's place, a bound is NaN.
; expected: sat
(declare-const d1 F) (declare-const d2 F) (declare-const p F) (declare-const q F)
(assert (and (finite p) (finite q) (finite d1) (finite d2)))
(define-fun bound () F (lowb (mul_up (mag d1) (mag d2)) (mul_down (mag d1) (mag d2)) p q))
(assert (fp.isNaN bound))
; replay: bound = lambda d1, d2, p, q: lowb(mul_up(mag(d1), mag(d2)), mul_down(mag(d1), mag(d2)), p, q)
; shows: isnan(bound)
