; C rounded down is finite and not negative, C rounded up is positive and not NaN, for finite d.
; expected: unsat
(declare-const d1 F) (declare-const d2 F)
(assert (and (finite d1) (finite d2)))
(define-fun c_down () F (mul_down (mag d1) (mag d2)))
(define-fun c_up () F (mul_up (mag d1) (mag d2)))
(assert (not (and (finite c_down) (fp.leq zero c_down) (fp.lt zero c_up))))
