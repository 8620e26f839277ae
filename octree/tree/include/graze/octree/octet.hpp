#pragma once
/// Eight doubles in the registers of a path: what the eight children of an octant have each.
/// For files compiled for the path's instructions; everything is always_inline (batch/path.hpp).
#include <graze/needs_cxx20.hpp>

#include <graze/interval8.hpp>

namespace graze::octree {

/// Lane i is of child i, or of whatever the user numbers from 0 to 7.
template <class Path> struct octet {
  using vector = typename Path::vector;
  static constexpr std::size_t width = Path::width, count = 8 / width;
  vector part[count];

  static GRAZE_BATCH_INLINE octet broadcast(double x) {
    octet r;
#pragma GCC unroll 8
    for (std::size_t i = 0; i < count; ++i)
      r.part[i] = Path::broadcast(x);
    return r;
  }
  static GRAZE_BATCH_INLINE octet load(const double* x) {
    octet r;
#pragma GCC unroll 8
    for (std::size_t i = 0; i < count; ++i)
      r.part[i] = Path::load(x + i * width);
    return r;
  }
  GRAZE_BATCH_INLINE void store(double* x) const {
#pragma GCC unroll 8
    for (std::size_t i = 0; i < count; ++i)
      Path::store(x + i * width, part[i]);
  }

  /// Operation(register...) for each register of the operands.
  template <auto Operation, class... Operands>
  static GRAZE_BATCH_INLINE octet each(const Operands&... x) {
    octet r;
#pragma GCC unroll 8
    for (std::size_t i = 0; i < count; ++i)
      r.part[i] = Operation(x.part[i]...);
    return r;
  }
  /// Bit i is Predicate's verdict on lane i.
  template <auto Predicate, class... Operands>
  static GRAZE_BATCH_INLINE unsigned where(const Operands&... x) {
    unsigned bits = 0;
#pragma GCC unroll 8
    for (std::size_t i = 0; i < count; ++i)
      bits |= Path::bits(Predicate(x.part[i]...)) << (i * width);
    return bits;
  }

  static GRAZE_BATCH_INLINE octet add_up(const octet& x, const octet& y) {
    return each<&Path::add_up>(x, y);
  }
  static GRAZE_BATCH_INLINE octet sub_up(const octet& x, const octet& y) {
    return each<&Path::sub_up>(x, y);
  }
  static GRAZE_BATCH_INLINE octet mul_up(const octet& x, const octet& y) {
    return each<&Path::mul_up>(x, y);
  }
  static GRAZE_BATCH_INLINE octet neg(const octet& x) { return each<&Path::neg>(x); }
  /// x where it is less, else y.
  static GRAZE_BATCH_INLINE octet min(const octet& x, const octet& y) {
    return each<&Path::min_or_second>(x, y);
  }
  /// x where it is greater, else y.
  static GRAZE_BATCH_INLINE octet max(const octet& x, const octet& y) {
    return each<&Path::max_or_second>(x, y);
  }
  static GRAZE_BATCH_INLINE unsigned less(const octet& x, const octet& y) {
    return where<&Path::less>(x, y);
  }
  static GRAZE_BATCH_INLINE unsigned less_equal(const octet& x, const octet& y) {
    return where<&Path::less_equal>(x, y);
  }
};

namespace detail {
/// All bits or none, so that a register loaded from here is a mask of the paths that keep masks in
/// registers of numbers: entry b has lane i set where bit i of b is.
struct lane_masks {
  alignas(64) std::uint64_t mask[256][8];
};
consteval lane_masks make_lane_masks() {
  lane_masks m{};
  for (unsigned b = 0; b < 256; ++b)
    for (unsigned i = 0; i < 8; ++i)
      m.mask[b][i] = (b >> i & 1) != 0 ? ~std::uint64_t{0} : 0;
  return m;
}
inline constexpr lane_masks masks_of_lanes = make_lane_masks();

/// Element `Lane` of x in all lanes of register I.
template <class Path, std::size_t Lane>
GRAZE_BATCH_INLINE typename Path::vector in_all_lanes(const octet<Path>& x) {
  const typename Path::vector v = x.part[Lane / Path::width];
  if constexpr (Path::width == 1) {
    return v;
#if defined(__x86_64__)
  } else if constexpr (Path::width == 2) {
    return Lane % 2 == 0 ? Path::firsts(v, v) : Path::seconds(v, v);
#endif
#if defined(__AVX2__)
  } else if constexpr (Path::width == 4) {
    return _mm256_permute4x64_pd(v, static_cast<int>(Lane % 4) * 0x55);
#endif
  }
}
} // namespace detail

/// Lane i is element `Lane` of p where bit `Bit` of i is 0, of q where it is 1: an axis's two
/// values, dealt to the eight children.
template <std::size_t Lane, unsigned Bit, class Path>
GRAZE_BATCH_INLINE octet<Path> spread(const octet<Path>& p, const octet<Path>& q) {
  octet<Path> r;
#if defined(__AVX512F__)
  if constexpr (Path::width == 8) {
    constexpr long long a = Lane, b = Lane + 8;
    const __m512i from = Bit == 0   ? _mm512_setr_epi64(a, b, a, b, a, b, a, b)
                         : Bit == 1 ? _mm512_setr_epi64(a, a, b, b, a, a, b, b)
                                    : _mm512_setr_epi64(a, a, a, a, b, b, b, b);
    r.part[0] = _mm512_permutex2var_pd(p.part[0], from, q.part[0]);
    return r;
  } else
#endif
  {
    const auto of_p = detail::in_all_lanes<Path, Lane>(p),
               of_q = detail::in_all_lanes<Path, Lane>(q);
#pragma GCC unroll 8
    for (std::size_t i = 0; i < octet<Path>::count; ++i) {
      if ((Path::width >> Bit) >= 2) { // the bit tells lanes of one register apart
#if defined(__AVX2__)
        if constexpr (Path::width == 4)
          r.part[i] = _mm256_blend_pd(of_p, of_q, Bit == 0 ? 0xa : 0xc);
#endif
#if defined(__x86_64__)
        if constexpr (Path::width == 2)
          r.part[i] = Path::firsts(of_p, of_q);
#endif
      } else {
        r.part[i] = (i * Path::width >> Bit & 1) != 0 ? of_q : of_p;
      }
    }
    return r;
  }
}

/// Lane i is q's where bit i of `lanes` (below 256) is set, else p's.
template <class Path>
GRAZE_BATCH_INLINE octet<Path> chosen(unsigned mask, const octet<Path>& q, const octet<Path>& p) {
  octet<Path> r;
#pragma GCC unroll 8
  for (std::size_t i = 0; i < octet<Path>::count; ++i) {
    if constexpr (Path::width == 8)
      r.part[i] = Path::select(static_cast<typename Path::mask>(mask), q.part[i], p.part[i]);
    else if constexpr (Path::width == 1)
      r.part[i] = (mask >> i & 1) != 0 ? q.part[i] : p.part[i];
    else
      r.part[i] = Path::select(
          Path::load(reinterpret_cast<const double*>(detail::masks_of_lanes.mask[mask]) +
                     i * Path::width),
          q.part[i], p.part[i]);
  }
  return r;
}

} // namespace graze::octree
