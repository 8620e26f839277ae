; uppb(p, q) = -lowb(q, p), second step: the same constant times opposite differences gives opposite
; bounds, bit for bit.
; expected: unsat
(declare-const c F) (declare-const u F)
(assert (not (= (mul_up c u) (fp.neg (mul_down c (fp.neg u))))))
