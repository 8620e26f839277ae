; With <= for < in lowb, an infinite constant meets u = 0: NaN.
; expected: sat
(declare-const c_down F) (declare-const c_up F) (declare-const p F) (declare-const q F)
(assert (and (finite p) (finite q) (finite c_down) (fp.leq zero c_down) (fp.lt zero c_up)))
(define-fun u () F (sub_down p q))
(define-fun bound () F (mul_down (ite (fp.leq u zero) c_up c_down) u))
(assert (fp.isNaN bound))
; replay: bound = lambda c_down, c_up, p, q: (lambda u: mul_down(c_up if u <= 0 else c_down, u))(sub_down(p, q))
; shows: isnan(bound)
