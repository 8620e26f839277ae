; RD(x y) = -RU((-x) y), bit for bit, for every x and y (one NaN).
; expected: unsat
(declare-const x F) (declare-const y F)
(assert (not (= (mul_down x y) (mul_down_upward x y))))
