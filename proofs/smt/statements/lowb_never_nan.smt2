; A lower bound is never NaN: finite p, q, and constants as prepared_constants has them.
; expected: unsat
(declare-const c_down F) (declare-const c_up F) (declare-const p F) (declare-const q F)
(assert (and (finite p) (finite q) (finite c_down) (fp.leq zero c_down) (fp.lt zero c_up)))
(assert (fp.isNaN (lowb c_down c_up p q)))
