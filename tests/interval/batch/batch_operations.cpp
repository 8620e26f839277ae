// Every operation on every path: the same bits as the baseline, zeros' signs included, and the same
// sets as the scalar type, whose operations MPFR judges in intervals.cpp; fma by MPFR itself.
#include "batch_inputs.hpp"
#include <graze/functions/arithmetic.hpp>
#include <graze/rounding/exact_fma.hpp>
#include <mpfr.h>
#include <string_view>

namespace batch = graze::batch;
using graze::bounds;
using namespace graze::test;
using scalar = graze::interval<>;

namespace {

/// x * y + z by MPFR.
double mpfr_multiply_add(double x, double y, double z, mpfr_rnd_t direction) {
  struct numbers {
    mpfr_t x, y, z, r;
    numbers() { mpfr_inits2(53, x, y, z, r, static_cast<mpfr_ptr>(nullptr)); }
    ~numbers() { mpfr_clears(x, y, z, r, static_cast<mpfr_ptr>(nullptr)); }
  };
  static numbers n;
  const mpfr_exp_t least = mpfr_get_emin(), greatest = mpfr_get_emax();
  mpfr_set_d(n.x, x, MPFR_RNDN);
  mpfr_set_d(n.y, y, MPFR_RNDN);
  mpfr_set_d(n.z, z, MPFR_RNDN);
  mpfr_set_emin(-1073);
  mpfr_set_emax(1024);
  const int inexact = mpfr_fma(n.r, n.x, n.y, n.z, direction);
  mpfr_subnormalize(n.r, inexact, direction);
  const double result = mpfr_get_d(n.r, direction);
  mpfr_set_emin(least);
  mpfr_set_emax(greatest);
  return result;
}

/// { s t + u } by the four corners, 0 times an unbounded end being 0.
bounds fma_of_corners(const bounds& x, const bounds& y, const bounds& z) {
  if (x.is_empty() || y.is_empty() || z.is_empty())
    return bounds::empty();
  bounds r{infinity, -infinity};
  for (const double a : {x.lo, x.hi})
    for (const double b : {y.lo, y.hi}) {
      const bool nothing = a == 0 || b == 0;
      const bool unbounded = !nothing && (a - a != 0 || b - b != 0);
      const double p = nothing ? 0 : unbounded ? (((a < 0) != (b < 0)) ? -infinity : infinity) : a;
      const double q = nothing || unbounded ? 1 : b;
      // an unbounded product does not meet an end of z of the other sign: -inf is below, +inf above
      r.lo =
          std::min(r.lo, z.lo == -infinity ? -infinity : mpfr_multiply_add(p, q, z.lo, MPFR_RNDD));
      r.hi = std::max(r.hi, z.hi == infinity ? infinity : mpfr_multiply_add(p, q, z.hi, MPFR_RNDU));
    }
  return r;
}

bounds bounds_of(const scalar& x) { return graze::to_bounds(x); }
scalar to(const bounds& x) {
  return graze::to_interval<graze::policies<graze::rounding::nearest>>(x);
}

struct operation {
  const char* name;
  bounds (*expected)(const bounds& x, const bounds& y, const bounds& z);
  void (*arrays)(batch::const_intervals x, batch::const_intervals y, batch::const_intervals z,
                 batch::intervals r);
  void (*pairs)(std::span<const bounds> x, std::span<const bounds> y, std::span<const bounds> z,
                std::span<bounds> r);
};

using cb = const bounds&;
using ci = batch::const_intervals;
using sp = std::span<const bounds>;
#define GRAZE_UNARY(name, expression)                                                              \
  {#name,                                                                                          \
   [](cb a, cb, cb) {                                                                              \
     const scalar x = to(a);                                                                       \
     return bounds_of(expression);                                                                 \
   },                                                                                              \
   [](ci x, ci, ci, batch::intervals r) { batch::name(x, r); },                                    \
   [](sp x, sp, sp, std::span<bounds> r) { batch::name(x, r); }}
#define GRAZE_BINARY(name, expression)                                                             \
  {#name,                                                                                          \
   [](cb a, cb b, cb) {                                                                            \
     const scalar x = to(a), y = to(b);                                                            \
     return bounds_of(expression);                                                                 \
   },                                                                                              \
   [](ci x, ci y, ci, batch::intervals r) { batch::name(x, y, r); },                               \
   [](sp x, sp y, sp, std::span<bounds> r) { batch::name(x, y, r); }}
// clang-format off
const operation operations[] = {
    GRAZE_UNARY(neg, -x),
    GRAZE_UNARY(sqr, graze::sqr(x)),
    GRAZE_UNARY(sqrt, sqrt(x)),
    GRAZE_UNARY(abs, abs(x)),
    GRAZE_BINARY(add, x + y),
    GRAZE_BINARY(sub, x - y),
    GRAZE_BINARY(mul, x * y),
    GRAZE_BINARY(div, x / y),
    GRAZE_BINARY(min, min(x, y)),
    GRAZE_BINARY(max, max(x, y)),
    GRAZE_BINARY(intersection, intersect(x, y)),
    GRAZE_BINARY(hull, hull(x, y)),
    {"fma", fma_of_corners,
     [](ci x, ci y, ci z, batch::intervals r) { batch::fma(x, y, z, r); },
     [](sp x, sp y, sp z, std::span<bounds> r) { batch::fma(x, y, z, r); }},
};
// clang-format on

/// A prime, so that every call ends in an incomplete register.
constexpr std::size_t chunk = 4099;

void every_operation(batch::path p) {
  const forced path(p);
  if (!path.runs())
    return;
  hard_intervals make(8);
  arrays x(chunk), y(chunk), z(chunk), r(chunk), base(chunk);
  std::vector<bounds> xs(chunk), ys(chunk), zs(chunk), rs(chunk);
  differences scalar_differs, path_differs, layout_differs;
  for (std::size_t done = 0; done < input_count(); done += chunk) {
    for (std::size_t i = 0; i < chunk; ++i) {
      make.next(xs[i], ys[i], zs[i]);
      x.set(i, xs[i]), y.set(i, ys[i]), z.set(i, zs[i]);
    }
    for (const operation& o : operations) {
      REQUIRE(!batch::force_path(batch::path::baseline));
      o.arrays(x, y, z, base);
      REQUIRE(!batch::force_path(p));
      o.arrays(x, y, z, r);
      o.pairs(xs, ys, zs, rs);
      for (std::size_t i = 0; i < chunk; ++i) {
        if (!same_bits(r[i], base[i]))
          path_differs.add(o.name, xs[i], ys[i], zs[i], r[i], base[i]);
        if (!same_bits(rs[i], r[i]))
          layout_differs.add(o.name, xs[i], ys[i], zs[i], rs[i], r[i]);
        const bounds expected = o.expected(xs[i], ys[i], zs[i]);
        if (std::string_view(o.name) == "fma" &&
            !same_set(graze::functions::fma::value(xs[i], ys[i], zs[i]), expected))
          scalar_differs.add("scalar fma", xs[i], ys[i], zs[i], r[i], expected);
        if (!same_set(r[i], expected))
          scalar_differs.add(o.name, xs[i], ys[i], zs[i], r[i], expected);
      }
    }
  }
  CHECK(scalar_differs.count() == 0);
  CHECK(path_differs.count() == 0);
  CHECK(layout_differs.count() == 0);
}

} // namespace

TEST_CASE("interval.batch: exact::multiply_add equals MPFR bit for bit", "[property][mpfr]") {
  hard_operands make(19);
  namespace exact = graze::rounding::exact;
  long wrong = 0;
  for (std::size_t i = 0; i < input_count(); ++i) {
    const auto kind = [&] {
      return static_cast<hardness>(make.below(static_cast<std::uint64_t>(hardness::count)));
    };
    const auto [x, y] = make.next(kind());
    double z = make.next(kind()).x;
    switch (make.below(4)) { // cancelling, or next to what cancels, or at a gap of a few bits
    case 0:
      z = -x * y;
      break;
    case 1:
      z = make.nudged(-x * y);
      break;
    case 2:
      if (const double p = x * y; std::isnormal(p))
        z = std::ldexp(make.with_exponent(0),
                       std::ilogb(p) + static_cast<int>(make.below(260)) - 130);
      break;
    default:
      break;
    }
    for (const auto& [direction, rounding] : {std::pair{exact::direction::down, MPFR_RNDD},
                                              std::pair{exact::direction::up, MPFR_RNDU}}) {
      const double got = exact::multiply_add(x, y, z, direction);
      const double expected = mpfr_multiply_add(x, y, z, rounding);
      if (!same_bits(got, expected) && ++wrong < 10)
        UNSCOPED_INFO(text({x, y}) << " " << text({z, got}) << " expected " << text({expected, 0}));
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("interval.batch: baseline equals the scalar type", "[property]") {
  every_operation(batch::path::baseline);
}
TEST_CASE("interval.batch: avx2 equals the scalar type and the baseline's bits", "[property]") {
  every_operation(batch::path::avx2);
}
TEST_CASE("interval.batch: avx512 equals the scalar type and the baseline's bits", "[property]") {
  every_operation(batch::path::avx512);
}

namespace {

void every_size(batch::path p) {
  const forced path(p);
  if (!path.runs())
    return;
  hard_intervals make(9);
  constexpr std::size_t most = 41;
  constexpr double guard = 0x1.abcdefp+100;
  long wrong = 0;
  for (std::size_t n = 0; n < most; ++n)
    for (std::size_t offset = 0; offset < 8; ++offset)
      for (const operation& o : operations) {
        std::vector<bounds> xs(n), ys(n), zs(n), rs(n + 2, bounds{guard, guard});
        arrays x(n + offset), y(n + offset), z(n + offset), r(n + offset + 1);
        std::fill(r.lo.begin(), r.lo.end(), guard);
        std::fill(r.hi.begin(), r.hi.end(), guard);
        for (std::size_t i = 0; i < n; ++i) {
          make.next(xs[i], ys[i], zs[i]);
          x.set(i + offset, xs[i]), y.set(i + offset, ys[i]), z.set(i + offset, zs[i]);
        }
        const auto part = [&](auto& a) {
          return decltype(batch::intervals{}){std::span(a.lo).subspan(offset, n),
                                              std::span(a.hi).subspan(offset, n)};
        };
        o.arrays(part(x), part(y), part(z), part(r));
        o.pairs(xs, ys, zs, std::span(rs).subspan(1, n));
        o.arrays(part(x), part(y), part(z), part(x)); // in place
        for (std::size_t i = 0; i < r.size(); ++i) {
          const bool inside = i >= offset && i < offset + n;
          const bounds expected = inside
                                      ? o.expected(xs[i - offset], ys[i - offset], zs[i - offset])
                                      : bounds{guard, guard};
          wrong += !same_set(r[i], expected);
          if (inside)
            wrong += !same_set(x[i], expected) + !same_set(rs[i - offset + 1], expected);
        }
        wrong += rs.front().lo != guard || rs.back().hi != guard;
      }
  CHECK(wrong == 0);
}

void every_predicate(batch::path p) {
  const forced path(p);
  if (!path.runs())
    return;
  hard_intervals make(10);
  long wrong = 0;
  for (std::size_t done = 0; done < input_count();) {
    const std::size_t n = 1 + done % 61;
    done += n;
    arrays x(n), y(n);
    for (std::size_t i = 0; i < n; ++i) {
      bounds a, b, unused;
      make.next(a, b, unused);
      if (i % 3 == 0)
        b = i % 2 == 0 ? a : bounds{a.hi, a.is_empty() ? a.hi : infinity};
      if (b.lo == infinity)
        b = a;
      x.set(i, a), y.set(i, b);
    }
    const auto check = [&](auto predicate, auto expected) {
      std::vector<std::uint8_t> bits((n + 7) / 8, 0xa5);
      predicate(bits);
      for (std::size_t i = 0; i < 8 * bits.size(); ++i)
        wrong += ((bits[i / 8] >> i % 8 & 1) != 0) != (i < n && expected(to(x[i]), to(y[i])));
    };
    using I = const scalar&;
    check([&](auto& b) { batch::certainly_less(x, y, b); }, [](I a, I b) { return a < b; });
    check([&](auto& b) { batch::certainly_less_equal(x, y, b); }, [](I a, I b) { return a <= b; });
    check([&](auto& b) { batch::equal(x, y, b); }, [](I a, I b) { return a == b; });
    check([&](auto& b) { batch::subset(x, y, b); },
          [](I a, I b) { return bounds_of(a).within(bounds_of(b)); });
    check([&](auto& b) { batch::overlaps(x, y, b); },
          [](I a, I b) { return !empty(intersect(a, b)); });
    check([&](auto& b) { batch::contains_zero(x, b); },
          [](I a, I) { return bounds_of(a).contains(0); });
    check([&](auto& b) { batch::is_empty(x, b); }, [](I a, I) { return empty(a); });
  }
  CHECK(wrong == 0);
}

void polynomials(batch::path p) {
  const forced path(p);
  if (!path.runs())
    return;
  hard_intervals make(11);
  arrays x(chunk), y(chunk), z(chunk), r(chunk), base(chunk), wide(chunk);
  const bounds s{2.5, 2.5}, c{0x1.bccccccccccccp+2, 0x1.bcccccccccccdp+2};
  const std::vector<bounds> coefficients{{-1, -1}, {0.1, 0.2}, {-3, 2}, {0x1p-1074, 1}};
  differences scalar_differs, path_differs;
  for (std::size_t done = 0; done < input_count(); done += chunk) {
    for (std::size_t i = 0; i < chunk; ++i) {
      bounds a, unused;
      make.next(a, unused, unused);
      x.set(i, make.moderate()), y.set(i, make.moderate()), z.set(i, make.moderate());
      wide.set(i, a);
      if (i % 4 == 0)
        x.set(i, a);
    }
    const auto check = [&](const char* name, auto run, auto expected) {
      REQUIRE(!batch::force_path(batch::path::baseline));
      run(base);
      REQUIRE(!batch::force_path(p));
      run(r);
      for (std::size_t i = 0; i < chunk; ++i) {
        if (!same_bits(r[i], base[i]))
          path_differs.add(name, x[i], y[i], wide[i], r[i], base[i]);
        const bounds e = expected(i);
        if (!same_set(r[i], e))
          scalar_differs.add(name, x[i], y[i], wide[i], r[i], e);
      }
    };
    check(
        "biquadratic", [&](arrays& out) { batch::biquadratic(x, y, z, s, c, out); },
        [&](std::size_t i) {
          const auto term = [&](const bounds& t) { return graze::sqr(graze::sqr(to(t)) - to(s)); };
          return bounds_of(term(x[i]) + term(y[i]) + term(z[i]) - to(c));
        });
    check(
        "horner", [&](arrays& out) { batch::horner(coefficients, wide, out); },
        [&](std::size_t i) {
          bounds value = wide[i].is_empty() ? wide[i] : bounds{0, 0};
          for (std::size_t k = coefficients.size(); k-- > 0;)
            value = fma_of_corners(wide[i], value, coefficients[k]);
          return value;
        });
  }
  CHECK(scalar_differs.count() == 0);
  CHECK(path_differs.count() == 0);
}

} // namespace

#define GRAZE_EACH_PATH(title, function)                                                           \
  TEST_CASE("interval.batch: baseline, " title, "[property]") { function(batch::path::baseline); } \
  TEST_CASE("interval.batch: avx2, " title, "[property]") { function(batch::path::avx2); }         \
  TEST_CASE("interval.batch: avx512, " title, "[property]") { function(batch::path::avx512); }
GRAZE_EACH_PATH("arrays of any size and address, in place, nothing else written", every_size)
GRAZE_EACH_PATH("predicates equal the scalar type's", every_predicate)
GRAZE_EACH_PATH("polynomials equal the scalar type's", polynomials)
