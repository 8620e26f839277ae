; RD(x - y) = -RU(y - x), bit for bit, for every x and y (one NaN).
; undecided: cvc5
; expected: unsat
(declare-const x F) (declare-const y F)
(assert (not (= (sub_down x y) (sub_down_upward x y))))
