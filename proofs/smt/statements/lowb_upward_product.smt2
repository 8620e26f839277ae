; After negation_of_difference: the lower bound by upward operations and negation is the directed one.
; expected: unsat
(declare-const c_down F) (declare-const c_up F) (declare-const u F)
(assert (not (= (mul_down (ite (fp.lt u zero) c_up c_down) u)
                (mul_down_upward (ite (fp.lt u zero) c_up c_down) u))))
