; RD(x - y) = -RD(y - x) is false: the error, and already the sign of zero, is another.
; expected: sat
(declare-const x F) (declare-const y F)
(define-fun down () F (sub_down x y))
(define-fun negated () F (fp.neg (sub_down y x)))
(assert (and (finite x) (finite y) (not (= down negated))))
; replay: down = lambda x, y: sub_down(x, y)
; replay: negated = lambda x, y: -sub_down(y, x)
; shows: bits(down) != bits(negated)
