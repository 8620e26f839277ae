; With C rounded once, to nearest, a lower bound can be above the one with C rounded both ways.
; undecided: cvc5
; expected: sat
(declare-const d1 F) (declare-const d2 F) (declare-const p F) (declare-const q F)
(assert (and (finite p) (finite q) (finite d1) (finite d2)))
(define-fun c () F (fp.mul RNE (mag d1) (mag d2)))
(define-fun once () F (lowb c c p q))
(define-fun sound () F (lowb (mul_down (mag d1) (mag d2)) (mul_up (mag d1) (mag d2)) p q))
(assert (fp.lt sound once))
; replay: once = lambda d1, d2, p, q: (lambda c: lowb(c, c, p, q))(mul_nearest(mag(d1), mag(d2)))
; replay: sound = lambda d1, d2, p, q: lowb(mul_down(mag(d1), mag(d2)), mul_up(mag(d1), mag(d2)), p, q)
; shows: sound < once
