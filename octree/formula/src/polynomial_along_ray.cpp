// The first root of a polynomial along a ray: g(t) = f(o + t d), first with coefficients of a fixed
// precision on the part of the ray that is left open, then exactly.
#include "closer_look.hpp"
#include "exact_polynomial.hpp"
#include "integer_polynomial.hpp"
#include "real_roots.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <graze/octree/along_ray.hpp>
#include <graze/octree_formula.hpp>
#include <graze/rounding/hardware.hpp>
#include <utility>

namespace graze::octree::closer_look {
namespace {

using namespace tape;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr certified_hit no_hit{verdict::miss, false, infinity, infinity};

/// x as significand * 2^exponent, the significand odd or 0.
struct dyadic {
  std::int64_t significand;
  int exponent;
  explicit dyadic(double x) {
    significand = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    const int zeros =
        significand == 0 ? 0 : std::countr_zero(static_cast<std::uint64_t>(significand));
    significand /= std::int64_t{1} << zeros;
    exponent += zeros - 53;
  }
};

/// The sum of (c[k] +- radius) 2^exponent s^k; coefficients have precision_of<Bits> bits at most.
template <unsigned Bits> struct approximate_polynomial {
  using integer = fixed_integer<Bits>;
  static constexpr int precision = precision_of<Bits>;

  std::vector<integer> c;
  int exponent = 0;
  integer radius{0};

  static approximate_polynomial of(const binary_number<integer>& x) {
    return {{x.significand}, x.exponent, integer(x.is_exact ? 0 : 1)};
  }
  static approximate_polynomial of(double x) {
    const dyadic d(x);
    return {{integer(d.significand)}, d.exponent, integer(0)};
  }
  static const auto& constants(const exact_polynomial& f) {
    if constexpr (Bits == exact_polynomial::short_bits)
      return f.short_constants;
    else
      return f.long_constants;
  }

  [[nodiscard]] int bits() const {
    unsigned most = 0;
    for (const integer& x : c)
      most = std::max(most, bits_of(x));
    return static_cast<int>(most);
  }
  /// So that coefficients are short enough.
  void shorten() {
    if (const int more = bits() - precision; more > 0)
      shift(-more);
  }
  void shift(int by) {
    if (by == 0)
      return;
    const auto n = static_cast<unsigned>(std::min(std::abs(by), static_cast<int>(Bits) - 1));
    for (integer& x : c) {
      if (by > 0)
        x <<= n;
      else
        x >>= n;
    }
    if (by > 0)
      radius <<= n;
    else
      radius = (radius >> n) + 2;
    exponent -= by;
  }
  [[nodiscard]] bool is_zero() const {
    return radius.is_zero() &&
           std::all_of(c.begin(), c.end(), [](const integer& x) { return x.is_zero(); });
  }

  approximate_polynomial& operator+=(approximate_polynomial y) {
    if (y.is_zero())
      return *this;
    if (is_zero())
      return *this = std::move(y);
    if (exponent != y.exponent) {
      const int top = std::max(exponent + bits(), y.exponent + y.bits());
      const int common = std::max(std::min(exponent, y.exponent), top - precision);
      shift(exponent - common);
      y.shift(y.exponent - common);
    }
    if (c.size() < y.c.size())
      c.resize(y.c.size(), integer(0));
    for (std::size_t i = 0; i < y.c.size(); ++i)
      c[i] += y.c[i];
    radius += y.radius;
    shorten();
    return *this;
  }
  void negate() {
    for (integer& x : c)
      x = -x;
  }
  friend approximate_polynomial operator*(const approximate_polynomial& x,
                                          const approximate_polynomial& y) {
    approximate_polynomial r;
    r.c.assign(x.c.size() + y.c.size() - 1, integer(0));
    for (std::size_t i = 0; i < x.c.size(); ++i)
      if (!x.c[i].is_zero())
        for (std::size_t j = 0; j < y.c.size(); ++j)
          r.c[i + j] += x.c[i] * y.c[j];
    r.exponent = x.exponent + y.exponent;
    if (!x.radius.is_zero() || !y.radius.is_zero()) {
      const auto of_x = static_cast<unsigned>(x.bits()), of_y = static_cast<unsigned>(y.bits());
      r.radius = ((y.radius << of_x) + (x.radius << of_y) + x.radius * y.radius) *
                 static_cast<std::uint64_t>(std::min(x.c.size(), y.c.size()));
    }
    r.shorten();
    return r;
  }
  /// The radius may outgrow the integers: nothing is known then.
  [[nodiscard]] bool is_known() const {
    return bits_of(radius) < static_cast<unsigned>(precision) / 2;
  }
};

/// The sum of c[k] t^k 2^exponent / denominator.
struct rational_polynomial {
  integer_polynomial c;
  integer denominator{1};
  int exponent = 0;

  static rational_polynomial of(const split_rational& x) { return {{x.n}, x.d, x.exponent}; }
  static rational_polynomial of(double x) {
    const dyadic d(x);
    return {{integer(d.significand)}, integer(1), d.exponent};
  }
  static const auto& constants(const exact_polynomial& f) { return f.constants; }

  void multiply(const integer& factor, int shift) {
    for (integer& x : c) {
      if (factor != 1)
        x *= factor;
      x <<= static_cast<unsigned>(shift);
    }
  }
  [[nodiscard]] bool is_zero() const {
    return std::all_of(c.begin(), c.end(), [](const integer& x) { return x.is_zero(); });
  }
  rational_polynomial& operator+=(rational_polynomial y) {
    if (y.is_zero())
      return *this;
    if (is_zero())
      return *this = std::move(y);
    const integer common =
        denominator == y.denominator ? denominator : lcm(denominator, y.denominator);
    const int least = std::min(exponent, y.exponent);
    multiply(common / denominator, exponent - least);
    y.multiply(common / y.denominator, y.exponent - least);
    denominator = common;
    exponent = least;
    if (c.size() < y.c.size())
      c.resize(y.c.size(), integer(0));
    for (std::size_t i = 0; i < y.c.size(); ++i)
      c[i] += y.c[i];
    return *this;
  }
  void negate() {
    for (integer& x : c)
      x = -x;
  }
  friend rational_polynomial operator*(const rational_polynomial& x, const rational_polynomial& y) {
    rational_polynomial r{integer_polynomial(x.c.size() + y.c.size() - 1, integer(0)),
                          x.denominator * y.denominator, x.exponent + y.exponent};
    for (std::size_t i = 0; i < x.c.size(); ++i)
      if (!x.c[i].is_zero())
        for (std::size_t j = 0; j < y.c.size(); ++j)
          r.c[i + j] += x.c[i] * y.c[j];
    return r;
  }
  [[nodiscard]] static bool is_known() { return true; }
};

/// The part of f that decides, over polynomials; nothing where too little is known of one.
template <class P>
std::optional<P> run(const program& p, const exact_polynomial& f,
                     const std::array<P, 3>& position) {
  std::vector<P> r(p.registers);
  for (std::size_t a = 0; a < 3; ++a)
    r[a] = position[a];
  const auto& constants = P::constants(f);
  const auto constant = [&](std::size_t n) { return P::of(constants[n]); };
  for (std::size_t k = 0; k < f.instructions; ++k) {
    const instruction& i = p.code[k];
    const P &a = r[i.a], &b = r[i.b];
    const auto n = static_cast<std::size_t>(i.n);
    P to;
    switch (i.op) {
    case opcode::constant:
      to = constant(n);
      break;
    case opcode::add_constant:
      to = a;
      to += constant(n);
      break;
    case opcode::mul_constant:
      to = a * constant(n);
      break;
    case opcode::add:
      to = a;
      to += b;
      break;
    case opcode::sub:
      to = b;
      to.negate();
      to += a;
      break;
    case opcode::mul:
      to = a * b;
      break;
    case opcode::neg:
      to = a;
      to.negate();
      break;
    case opcode::sqr:
      to = a * a;
      break;
    case opcode::pown: {
      to = P::of(1.0);
      for (auto bit = std::bit_floor(static_cast<unsigned>(i.n)); bit != 0; bit >>= 1) {
        to = to * to;
        if ((static_cast<unsigned>(i.n) & bit) != 0)
          to = to * a;
      }
      break;
    }
    case opcode::polynomial: {
      const tape::polynomial& q = p.polynomials[n];
      to = constant(q.first_coefficient);
      for (std::uint32_t j = 1; j <= q.degree; ++j) {
        to = to * a;
        to += constant(q.first_coefficient + j);
      }
      break;
    }
    default:
      return std::nullopt;
    }
    if (!to.is_known())
      return std::nullopt;
    r[i.target] = std::move(to);
  }
  return std::move(r[f.result]);
}

/// o + t d, where t is the polynomial given.
template <class P> std::array<P, 3> points(const ray& r, const P& t) {
  std::array<P, 3> x;
  for (std::size_t a = 0; a < 3; ++a) {
    x[a] = r.direction()[a] == 0 ? P::of(0.0) : t * P::of(r.direction()[a]);
    x[a] += P::of(r.origin()[a]);
  }
  return x;
}

/// The stretch of a ray in which the first root is, if there is one.
struct stretch {
  double from, to;
  ray_span span;
};

/// By coefficients of a fixed precision; nothing where that does not decide.
template <unsigned Bits>
std::optional<certified_hit> approximately(const program& p, const exact_polynomial& f,
                                           const ray& r, const stretch& in) {
  using P = approximate_polynomial<Bits>;
  using fixed = typename P::integer;
  // t = from + s 2^scale; doubles from there on are multiples of 2^(scale - grain) in s
  constexpr int grain = 110;
  if (!(in.from < in.to))
    return std::nullopt;
  int scale = 0;
  std::frexp(in.to - in.from, &scale);
  const double from = in.from < std::ldexp(1.0, scale - 50) ? 0 : in.from;
  if (from == 0)
    std::frexp(in.to, &scale);
  const dyadic first(from);
  P t = P::of(from);
  t += P{{fixed(0), fixed(1)}, scale, fixed(0)};
  const std::optional<P> g = run(p, f, points(r, t));
  if (!g)
    return std::nullopt;

  const std::size_t degree = g->c.size() - 1;
  const isolated root = first_root(bernstein<fixed>::of(g->c, g->radius), 100, 400);
  if (root.what == isolation::none)
    return no_hit;
  if (root.what != isolation::root)
    return std::nullopt;

  const auto multiples = [&](double x) -> std::optional<fixed> {
    const dyadic d(x);
    const int shift = d.exponent - (scale - grain);
    if (d.significand == 0)
      return fixed(0);
    if (shift < 0 || shift > grain)
      return std::nullopt;
    return fixed(d.significand) << static_cast<unsigned>(shift);
  };
  const auto base = multiples(from);
  if (!base)
    return std::nullopt;
  const auto place = [&](double x) {
    auto m = multiples(x);
    if (m)
      *m -= *base;
    return m;
  };
  const fixed error = g->radius * static_cast<std::uint64_t>(degree + 1) +
                      static_cast<std::uint64_t>(2 * degree + 2);
  const auto sign = [&](double x) -> std::optional<int> {
    const auto s = place(x);
    if (!s)
      return std::nullopt;
    fixed value = g->c[degree];
    for (std::size_t k = degree; k-- > 0;)
      value = ((value * *s) >> static_cast<unsigned>(grain)) + g->c[k];
    if (value > error)
      return 1;
    if (value < -error)
      return -1;
    return std::nullopt;
  };
  /// the least double that is not before from + k 2^(scale - depth)
  const auto not_before = [&](const integer& k) -> std::optional<double> {
    const fixed target = fixed(k) << (static_cast<unsigned>(grain) - root.depth);
    double x = from + std::ldexp(k.convert_to<double>(), scale - static_cast<int>(root.depth));
    for (int tries = 0; tries < 8; ++tries) {
      const auto here = place(x), below = x > 0 ? place(previous(x)) : std::optional(fixed(-1));
      if (!here || !below)
        return std::nullopt;
      if (*here < target)
        x = next(x);
      else if (*below >= target)
        x = previous(x);
      else
        return x;
    }
    return std::nullopt;
  };
  const auto lo = not_before(root.first), beyond = not_before(root.first + 1);
  if (!lo || !beyond)
    return std::nullopt;
  const auto end = place(*beyond);
  const double hi = end == (fixed(root.first + 1) << (static_cast<unsigned>(grain) - root.depth))
                        ? *beyond
                        : previous(*beyond);
  const auto t_root = narrowed(*lo, hi, root.before, sign);
  if (!t_root || t_root->far > hi) // beyond it there may be another root
    return std::nullopt;
  if (t_root->near > in.to || t_root->near > in.span.exit_up)
    return no_hit;
  if (t_root->near < in.span.entry_up || t_root->far > in.span.exit_down)
    return std::nullopt;
  return certified_hit{verdict::hit, !f.is_power, t_root->near, t_root->far};
}

/// The exact [entry, exit] of the ray in the domain, for t >= 0.
std::pair<rational, std::optional<rational>> clipped(const ray& r, const box& domain) {
  std::pair<rational, std::optional<rational>> range{0, std::nullopt};
  for (int a = 0; a < 3; ++a) {
    const double d = r.direction()[a];
    if (d == 0)
      continue;
    const rational o = exactly(r.origin()[a]), slope = exactly(d);
    const rational in = (exactly(d > 0 ? domain.lo[a] : domain.hi[a]) - o) / slope,
                   out = (exactly(d > 0 ? domain.hi[a] : domain.lo[a]) - o) / slope;
    if (in > range.first)
      range.first = in;
    if (!range.second || out < *range.second)
      range.second = out;
  }
  return range;
}

/// Bits of the coordinates along the ray, as integers.
int coordinate_bits(const ray& r) {
  int most = 1;
  for (int a = 0; a < 3; ++a) {
    const dyadic o(r.origin()[a]), d(r.direction()[a]);
    const auto top = [](const dyadic& x) {
      return x.exponent + static_cast<int>(bits_of(integer(x.significand)));
    };
    if (d.significand != 0 && o.significand != 0)
      most = std::max(most, std::max(top(o), top(d)) - std::min(o.exponent, d.exponent));
    else
      most = std::max(most, 53);
  }
  return most;
}

std::optional<certified_hit> exactly_along(const program& p, const exact_polynomial& f,
                                           const ray& r, const box& domain, const stretch& in) {
  const auto limbs = (f.degree * static_cast<std::uint64_t>(coordinate_bits(r)) + 256) / 64;
  constexpr std::uint64_t most_work = 1 << 22;
  if ((f.work + 16) * limbs * limbs > most_work)
    return std::nullopt;
  const auto [entry, exit] = clipped(r, domain);
  if (!exit || entry > *exit)
    return exit ? std::optional(no_hit) : std::nullopt;
  rational_polynomial t{{integer(0), integer(1)}};
  auto g = run(p, f, points(r, t));
  if (!g)
    return std::nullopt;
  integer_polynomial& c = g->c;
  while (!c.empty() && c.back().is_zero())
    c.pop_back();
  const auto hit = [](const rational& first, const rational& last, bool unique) {
    return certified_hit{verdict::hit, unique, enclosure_of(first).lower(),
                         enclosure_of(last).upper()};
  };
  if (c.empty())
    return hit(entry, entry, false);
  const rational first = std::max(entry, exactly(in.from)), last = std::min(*exit, exactly(in.to));
  if (first > last)
    return no_hit;
  if (c.size() == 1)
    return no_hit;
  const auto simple = square_free(std::move(c));
  if (!simple)
    return std::nullopt;
  // of the simple part's roots the multiple ones of g
  integer_polynomial multiple{integer(1)};
  if (simple->repeated.size() > 1) {
    const auto common = greatest_common_divisor(simple->part, simple->repeated);
    if (!common)
      return std::nullopt;
    multiple = *common;
  }
  if (first == last) {
    if (sign_at(simple->part, first) != 0)
      return no_hit;
    return hit(first, first, !f.is_power && sign_at(multiple, first) != 0);
  }
  const isolated root =
      first_root(bernstein<integer>::of(on_interval(simple->part, first, last), integer(0)), 4000,
                 static_cast<unsigned>(most_work / ((f.degree + 1) * (f.degree + 1) * limbs)));
  if (root.what == isolation::none)
    return no_hit;
  if (root.what == isolation::unknown)
    return std::nullopt;
  const rational step = (last - first) / (integer(1) << root.depth);
  const rational t0 = first + root.first * step, t1 = t0 + step;
  if (root.what == isolation::at)
    return hit(t0, t0, !f.is_power && sign_at(multiple, t0) != 0);
  const auto t_root =
      narrowed(enclosure_of(t0).upper(), enclosure_of(t1).lower(), root.before,
               [&](double x) { return std::optional(sign_at(simple->part, exactly(x))); });
  if (!t_root)
    return std::nullopt;
  bool unique = !f.is_power && sign_at(multiple, t0) == sign_at(multiple, t1);
  if (unique && exactly(t_root->far) > t1) { // is there another one beyond t1?
    const rational far = std::min(*exit, exactly(t_root->far));
    unique =
        !(t1 < far) ||
        first_root(bernstein<integer>::of(on_interval(simple->part, t1, far), integer(0)), 100, 200)
                .what == isolation::none;
  }
  return certified_hit{verdict::hit, unique, t_root->near, t_root->far};
}

} // namespace

std::optional<certified_hit> at_polynomial(const program& f, const ray& r, const box& domain,
                                           const certified_hit& found) {
  if (!f.exact)
    return std::nullopt;
  stretch in{found.t_near, found.t_far, {}};
  {
    const rounding::upward::scope scope;
    in.span = along_ray<formula_surface, rounding::upward>(formula_surface(f), r).within(domain);
  }
  in.to = std::min(in.to, in.span.exit_up);
  if (!(in.from <= in.to) || !std::isfinite(in.to))
    return std::nullopt;
  const rounding::hardware::mode_scope scope(rounding::hardware::mode::nearest);
  constexpr unsigned short_bits = exact_polynomial::short_bits,
                     long_bits = exact_polynomial::long_bits;
  if (const auto h = approximately<short_bits>(f, *f.exact, r, in))
    return h;
  if (const auto h = approximately<long_bits>(f, *f.exact, r, in))
    return h;
  return exactly_along(f, *f.exact, r, domain, in);
}

} // namespace graze::octree::closer_look
