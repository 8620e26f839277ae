#pragma once
/// Eight intervals at once, for formulas written once over any number type.
///
/// `interval8<Path>` is used inside a file compiled for the path's instructions, under a scope:
///   // compiled once for each path (graze/batch/per_path.hpp)
///   const batch::this_path::scope scope;
///   auto value = formula(interval8<batch::this_path>::load(lo, hi), ...);
/// and chosen by batch::path_in_use() (graze/batch.hpp). Without a path of one's own, the span
/// functions of graze/batch.hpp choose one.
#include <graze/needs_cxx20.hpp>

#include <graze/batch.hpp> // before `baseline` below, which g++ would see its enumerator shadow
#include <graze/batch/formulas.hpp>
#include <utility>
#if defined(__x86_64__)
#include <graze/batch/sse2.hpp>
#else
#include <graze/batch/portable.hpp>
#endif
#if defined(__AVX2__) && defined(__FMA__)
#include <graze/batch/avx2.hpp>
#endif
#if defined(__AVX512F__) && defined(__AVX512DQ__)
#include <graze/batch/avx512.hpp>
#endif

namespace graze {

namespace batch {
/// The path that every machine of this kind has.
#if defined(__x86_64__)
using baseline = sse2;
#else
using baseline = portable;
#endif
} // namespace batch

/// Lane i is bit i.
struct mask8 {
  unsigned bits = 0;
  [[nodiscard]] GRAZE_BATCH_INLINE constexpr bool operator[](std::size_t lane) const {
    return (bits >> lane & 1) != 0;
  }
  [[nodiscard]] GRAZE_BATCH_INLINE constexpr bool all() const { return bits == 0xff; }
  [[nodiscard]] GRAZE_BATCH_INLINE constexpr bool any() const { return bits != 0; }
  [[nodiscard]] GRAZE_BATCH_INLINE constexpr bool none() const { return bits == 0; }
};

/// Eight intervals, the lower bounds together and the upper bounds together. Every operation is
/// tightest in every lane (0 ulp) and set-based; see batch/formulas.hpp for what each encloses and
/// for the zeros' signs: the bits are the same on every path. NaN in both bounds is the empty set.
/// The path's scope must live (avx512: or else FTZ and DAZ be off).
template <class Path> class interval8 {
public:
  using path = Path;
  static constexpr std::size_t lane_count = 8;

  /// Zero in all lanes.
  GRAZE_BATCH_INLINE interval8() : interval8(0.0) {}
  /// The same number, finite, in all lanes.
  GRAZE_BATCH_INLINE explicit interval8(double x) : interval8(x, x) {}
  /// [lo, hi] in all lanes.
  GRAZE_BATCH_INLINE interval8(double lo, double hi) {
    for (part& p : parts_)
      p = {Path::broadcast(lo), Path::broadcast(hi)};
  }
  /// Eight lower and eight upper bounds, at any address.
  GRAZE_BATCH_INLINE static interval8 load(const double* lo, const double* hi) {
    interval8 r{uninitialized{}};
    for (std::size_t i = 0; i < count; ++i)
      r.parts_[i] = {Path::load(lo + i * Path::width), Path::load(hi + i * Path::width)};
    return r;
  }
  GRAZE_BATCH_INLINE void store(double* lo, double* hi) const {
    for (std::size_t i = 0; i < count; ++i) {
      Path::store(lo + i * Path::width, parts_[i].lo);
      Path::store(hi + i * Path::width, parts_[i].hi);
    }
  }

#define GRAZE_BATCH_FRIEND friend GRAZE_BATCH_INLINE
  GRAZE_BATCH_FRIEND interval8 operator-(const interval8& x) { return lanewise<&f::neg>(x); }
  GRAZE_BATCH_FRIEND interval8 operator+(const interval8& x, const interval8& y) {
    return lanewise<&f::add>(x, y);
  }
  GRAZE_BATCH_FRIEND interval8 operator-(const interval8& x, const interval8& y) {
    return lanewise<&f::sub>(x, y);
  }
  GRAZE_BATCH_FRIEND interval8 operator*(const interval8& x, const interval8& y) {
    return lanewise<&f::mul>(x, y);
  }
  GRAZE_BATCH_FRIEND interval8 operator/(const interval8& x, const interval8& y) {
    return lanewise<&f::div>(x, y);
  }
  GRAZE_BATCH_FRIEND interval8 fma(const interval8& x, const interval8& y, const interval8& z) {
    return lanewise<&f::fma>(x, y, z);
  }
  GRAZE_BATCH_FRIEND interval8 sqr(const interval8& x) { return lanewise<&f::sqr>(x); }
  GRAZE_BATCH_FRIEND interval8 sqrt(const interval8& x) { return lanewise<&f::sqrt>(x); }
  GRAZE_BATCH_FRIEND interval8 abs(const interval8& x) { return lanewise<&f::abs>(x); }
  GRAZE_BATCH_FRIEND interval8 min(const interval8& x, const interval8& y) {
    return lanewise<&f::min>(x, y);
  }
  GRAZE_BATCH_FRIEND interval8 max(const interval8& x, const interval8& y) {
    return lanewise<&f::max>(x, y);
  }
  /// min under the name that formulas of surfaces use.
  GRAZE_BATCH_FRIEND interval8 lesser(const interval8& x, const interval8& y) { return min(x, y); }
  GRAZE_BATCH_FRIEND interval8 intersect(const interval8& x, const interval8& y) {
    return lanewise<&f::intersection>(x, y);
  }
  GRAZE_BATCH_FRIEND interval8 hull(const interval8& x, const interval8& y) {
    return lanewise<&f::hull>(x, y);
  }

  // Lanes in which it is certain of all members; also where an operand is empty.
  GRAZE_BATCH_FRIEND mask8 operator<(const interval8& x, const interval8& y) {
    return masked<&f::certainly_less>(x, y);
  }
  GRAZE_BATCH_FRIEND mask8 operator<=(const interval8& x, const interval8& y) {
    return masked<&f::certainly_less_equal>(x, y);
  }
  GRAZE_BATCH_FRIEND mask8 operator>(const interval8& x, const interval8& y) { return y < x; }
  GRAZE_BATCH_FRIEND mask8 operator>=(const interval8& x, const interval8& y) { return y <= x; }
  /// Lanes of equal sets.
  GRAZE_BATCH_FRIEND mask8 operator==(const interval8& x, const interval8& y) {
    return masked<&f::equal>(x, y);
  }
  GRAZE_BATCH_FRIEND mask8 subset(const interval8& x, const interval8& y) {
    return masked<&f::subset>(x, y);
  }
  /// Lanes with a common member.
  GRAZE_BATCH_FRIEND mask8 overlaps(const interval8& x, const interval8& y) {
    return masked<&f::overlaps>(x, y);
  }
  GRAZE_BATCH_FRIEND mask8 contains_zero(const interval8& x) {
    return masked<&f::contains_zero>(x);
  }
  GRAZE_BATCH_FRIEND mask8 empty(const interval8& x) { return masked<&f::is_empty>(x); }
#undef GRAZE_BATCH_FRIEND

  using part = batch::part<Path>;
  /// An operation of one's own: Operation(part...), always_inline and written over Path, for each
  /// register of the operands. Each part goes through the whole operation before the next: no more
  /// registers than it needs.
  template <auto Operation, class... Operands>
  static GRAZE_BATCH_INLINE interval8 lanewise(const Operands&... x) {
    return lanewise<Operation>(std::make_index_sequence<count>{}, x...);
  }
  /// A predicate of one's own, likewise: the lanes in which Predicate(part...) holds.
  template <auto Predicate, class... Operands>
  static GRAZE_BATCH_INLINE mask8 lanes_where(const Operands&... x) {
    return masked<Predicate>(x...);
  }
  /// From registers: lanes i * Path::width onwards are parts[i].
  static GRAZE_BATCH_INLINE interval8
  from_registers(const part (&parts)[lane_count / Path::width]) {
    interval8 r{uninitialized{}};
    for (std::size_t i = 0; i < count; ++i)
      r.parts_[i] = parts[i];
    return r;
  }

  /// To registers: lanes i * Path::width onwards.
  [[nodiscard]] GRAZE_BATCH_INLINE const part& registers(std::size_t i) const { return parts_[i]; }

private:
  using f = batch::formulas<Path>;
  static constexpr std::size_t count = lane_count / Path::width;
  struct uninitialized {};
  GRAZE_BATCH_INLINE explicit interval8(uninitialized) {}

  template <auto Operation, std::size_t I, class... Operands>
  static GRAZE_BATCH_INLINE void assign(interval8& r, const Operands&... x) {
    r.parts_[I] = Operation(x.parts_[I]...);
  }
  template <auto Operation, std::size_t... I, class... Operands>
  static GRAZE_BATCH_INLINE interval8 lanewise(std::index_sequence<I...>, const Operands&... x) {
    interval8 r{uninitialized{}};
    (assign<Operation, I>(r, x...), ...);
    return r;
  }
  template <auto Predicate, std::size_t I, class... Operands>
  static GRAZE_BATCH_INLINE unsigned bits_of(const Operands&... x) {
    return Path::bits(Predicate(x.parts_[I]...)) << I * Path::width;
  }
  template <auto Predicate, class... Operands>
  static GRAZE_BATCH_INLINE mask8 masked(const Operands&... x) {
    return masked<Predicate>(std::make_index_sequence<count>{}, x...);
  }
  template <auto Predicate, std::size_t... I, class... Operands>
  static GRAZE_BATCH_INLINE mask8 masked(std::index_sequence<I...>, const Operands&... x) {
    return {(bits_of<Predicate, I>(x...) | ...)};
  }

  part parts_[count];
};

} // namespace graze
