; uppb(p, q) = -lowb(q, p), first of two steps after negation_of_difference: for opposite differences
; both bounds choose the same constant.
; expected: unsat
(declare-const u F)
(assert (not (= (fp.lt zero u) (fp.lt (fp.neg u) zero))))
