; The assumption is needed: with an infinite plane or origin a bound can be NaN.
; expected: sat
(declare-const c_down F) (declare-const c_up F) (declare-const p F) (declare-const q F)
(assert (and (finite c_down) (fp.leq zero c_down) (fp.lt zero c_up)))
(assert (not (or (fp.isNaN p) (fp.isNaN q))))
(define-fun bound () F (lowb c_down c_up p q))
(assert (fp.isNaN bound))
; replay: bound = lambda c_down, c_up, p, q: lowb(c_down, c_up, p, q)
; shows: isnan(bound)
