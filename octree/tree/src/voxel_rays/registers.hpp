#pragma once
/// A node's test where a register holds eight doubles (AVX-512): its slabs are in three of them.
#include "narrow.hpp"
#if defined(__AVX512F__) && defined(__AVX512DQ__)
#include <graze/batch/avx512.hpp>

namespace graze::octree::detail {
namespace {

template <class Planes> class registers_test {
  using P = batch::avx512;
  using V = P::vector;

public:
  using planes = Planes;

  GRAZE_BATCH_INLINE explicit registers_test(const voxel_rays_state& s)
      : from_(P::broadcast(s.from)), to_(P::broadcast(s.to)),
        z_from_(P::select(0xf0, P::broadcast(-s.to), from_)) {
    const voxel_rays_axis &x = s.axes[0], &y = s.axes[1], &z = s.axes[2];
    // slab i is entered by its plane i and left by plane i + 1, or the other way round
    const V slab = _mm512_setr_pd(0, 1, 2, 3, 0, 1, 2, 3);
    const V one = P::broadcast(1), none = P::zero();
    const V xy_sign = two(x.sign, y.sign), z_sign = P::broadcast(z.sign);
    const P::mask xy_back = P::less(xy_sign, none), z_back = P::less(z_sign, none);
    const V xy_enter = P::add_up(slab, P::select(xy_back, one, none));
    const V xy_leave = P::add_up(slab, P::select(xy_back, none, one));
    const V z_plane = P::add_up(slab, P::select(static_cast<P::mask>(z_back ^ 0xf0), one, none));
    if constexpr (Planes::tabled) {
      enter_steps_ = _mm512_and_pd(xy_sign, P::broadcast(-0.0));
    } else {
      enter_steps_ = P::mul_up(xy_sign, xy_enter);
      leave_steps_ = P::mul_up(xy_sign, xy_leave);
    }
    enter_origin_ = two(x.enter_origin, y.enter_origin);
    leave_origin_ = two(x.leave_origin, y.leave_origin);
    down_ = two(x.c_down, y.c_down);
    up_ = two(x.c_up, y.c_up);
    // leaves are negated, so that both halves are rounded down: uppb(p, q) = -lowb(q, p)
    half_ = _mm512_setr_pd(1, 1, 1, 1, -1, -1, -1, -1);
    if constexpr (Planes::tabled)
      z_steps_ = _mm512_and_pd(P::mul_up(z_sign, half_), P::broadcast(-0.0));
    else
      z_steps_ = P::mul_up(P::mul_up(z_sign, z_plane), half_);
    z_origin_ = P::mul_up(two(z.enter_origin, z.leave_origin), half_);
    z_down_ = P::broadcast(z.c_down);
    z_up_ = P::broadcast(z.c_up);
  }

  GRAZE_BATCH_INLINE void open(const voxel_rays_entry& e, const typename Planes::level& at) {
    const V zero = P::zero();
    V p, q, r; // planes: exact, in any rounding
    if constexpr (Planes::tabled) {
      const std::size_t x = at.first(e, 0), y = at.first(e, 1), z = at.first(e, 2);
      p = _mm512_xor_pd(enter_steps_, two_fours(at.enter[0] + x, at.enter[1] + y));
      q = _mm512_xor_pd(enter_steps_, two_fours(at.leave[0] + x, at.leave[1] + y));
      r = _mm512_xor_pd(z_steps_, two_fours(at.enter[2] + z, at.leave[2] + z));
    } else {
      const V h = P::broadcast(at.size), xy = two(e.lo[0], e.lo[1]);
      const V z = P::mul_up(P::broadcast(e.lo[2]), half_);
      p = _mm512_fmadd_pd(enter_steps_, h, xy);
      q = _mm512_fmadd_pd(leave_steps_, h, xy);
      r = _mm512_fmadd_pd(z_steps_, h, z);
    }
    const V u = P::sub_down(p, enter_origin_), v = P::sub_up(q, leave_origin_),
            w = P::sub_down(r, z_origin_);
    enter_ = P::max_or_second(
        P::select(P::less(u, zero), P::mul_down(up_, u), P::mul_down(down_, u)), from_);
    leave_ =
        P::min_or_second(P::select(P::less(zero, v), P::mul_up(up_, v), P::mul_up(down_, v)), to_);
    z_ = P::max_or_second(
        P::select(P::less(w, zero), P::mul_down(z_up_, w), P::mul_down(z_down_, w)), z_from_);
  }

  /// Three intervals have a common point if and only if any two have.
  [[nodiscard]] GRAZE_BATCH_INLINE std::uint64_t mask() const {
    // the first axis of a pair in turn, the second four times over
    const V ex = _mm512_shuffle_f64x2(enter_, enter_, 0x44),
            ey = _mm512_shuffle_f64x2(enter_, enter_, 0xee);
    const V lx = _mm512_shuffle_f64x2(leave_, leave_, 0x44),
            ly = _mm512_shuffle_f64x2(leave_, leave_, 0xee);
    const __m512i lanes01 = _mm512_setr_epi64(0, 0, 0, 0, 1, 1, 1, 1),
                  lanes23 = _mm512_setr_epi64(2, 2, 2, 2, 3, 3, 3, 3),
                  lanes45 = _mm512_setr_epi64(4, 4, 4, 4, 5, 5, 5, 5),
                  lanes67 = _mm512_setr_epi64(6, 6, 6, 6, 7, 7, 7, 7);
    const V z_leave = P::neg(z_);
    const V ey01 = _mm512_permutexvar_pd(lanes45, enter_),
            ey23 = _mm512_permutexvar_pd(lanes67, enter_),
            ly01 = _mm512_permutexvar_pd(lanes45, leave_),
            ly23 = _mm512_permutexvar_pd(lanes67, leave_),
            ez01 = _mm512_permutexvar_pd(lanes01, z_), ez23 = _mm512_permutexvar_pd(lanes23, z_),
            lz01 = _mm512_permutexvar_pd(lanes45, z_leave),
            lz23 = _mm512_permutexvar_pd(lanes67, z_leave);
    const unsigned xy = common(ex, lx, ey01, ly01, ey23, ly23),
                   xz = common(ex, lx, ez01, lz01, ez23, lz23),
                   yz = common(ey, ly, ez01, lz01, ez23, lz23);
    return xy * 0x0001'0001'0001'0001u & _pdep_u64(xz, 0x000f'000f'000f'000fu) * 0x1111u &
           _pdep_u64(yz, 0x1111'1111'1111'1111u) * 15u;
  }

  GRAZE_BATCH_INLINE void keep() {
    P::store(kept_enter_, enter_);
    P::store(kept_leave_, leave_);
    P::store(kept_z_, z_);
  }
  [[nodiscard]] GRAZE_BATCH_INLINE double enter(unsigned k) const {
    return k < 8 ? kept_enter_[k] : kept_z_[k - 8];
  }
  [[nodiscard]] GRAZE_BATCH_INLINE double leave(unsigned k) const {
    return k < 8 ? kept_leave_[k] : -kept_z_[k - 4];
  }

private:
  static GRAZE_BATCH_INLINE V two(double lower, double upper) {
    return P::select(0xf0, P::broadcast(upper), P::broadcast(lower));
  }
  static GRAZE_BATCH_INLINE V two_fours(const double* lower, const double* upper) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(lower)),
                              _mm256_loadu_pd(upper), 1);
  }
  static GRAZE_BATCH_INLINE unsigned common(V e, V l, V e01, V l01, V e23, V l23) {
    const __mmask8 lower = _mm512_mask_cmp_pd_mask(_mm512_cmp_pd_mask(e, l01, _CMP_LE_OQ), e01, l,
                                                   _CMP_LE_OQ),
                   upper = _mm512_mask_cmp_pd_mask(_mm512_cmp_pd_mask(e, l23, _CMP_LE_OQ), e23, l,
                                                   _CMP_LE_OQ);
    return static_cast<unsigned>(lower) | static_cast<unsigned>(upper) << 8;
  }

  V from_, to_, z_from_;
  V enter_steps_, leave_steps_, z_steps_, enter_origin_, leave_origin_, z_origin_, down_, up_,
      z_down_, z_up_, half_;
  V enter_, leave_, z_;
  alignas(64) double kept_enter_[8], kept_leave_[8], kept_z_[8];
};

template <class Planes> struct node_test_on<batch::avx512, Planes> {
  using type = registers_test<Planes>;
};

} // namespace
} // namespace graze::octree::detail
#endif
