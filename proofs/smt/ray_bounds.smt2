; octree/geometry/include/graze/octree/ray_bounds.hpp over binary64, with its names. A bound takes C rounded
; both ways, as the prepared axis holds it.
(define-sort F () Float64)
(define-fun zero () F (_ +zero 11 53))
(define-fun one () F ((_ to_fp 11 53) RNE 1.0))
(define-fun finite ((x F)) Bool (not (or (fp.isNaN x) (fp.isInfinite x))))
(define-fun mag ((x F)) F (ite (fp.eq x zero) one (ite (fp.lt x zero) (fp.neg x) x)))
; directed: each operation rounded in the direction asked for
(define-fun sub_down ((x F) (y F)) F (fp.sub RTN x y))
(define-fun sub_up ((x F) (y F)) F (fp.sub RTP x y))
(define-fun mul_down ((x F) (y F)) F (fp.mul RTN x y))
(define-fun mul_up ((x F) (y F)) F (fp.mul RTP x y))
(define-fun lowb ((c_down F) (c_up F) (p F) (q F)) F
  (let ((u (sub_down p q))) (mul_down (ite (fp.lt u zero) c_up c_down) u)))
(define-fun uppb ((c_down F) (c_up F) (p F) (q F)) F
  (let ((u (sub_up p q))) (mul_up (ite (fp.lt zero u) c_up c_down) u)))
; upward: upward rounding alone, lower bounds by negation
(define-fun sub_down_upward ((x F) (y F)) F (fp.neg (fp.sub RTP y x)))
(define-fun mul_down_upward ((x F) (y F)) F (fp.neg (fp.mul RTP (fp.neg x) y)))
(define-fun lowb_upward ((c_down F) (c_up F) (p F) (q F)) F
  (let ((u (sub_down_upward p q))) (mul_down_upward (ite (fp.lt u zero) c_up c_down) u)))
