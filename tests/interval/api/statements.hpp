// What a client of Boost.Interval writes, a statement a line: its name, the code, and what the
// judge computes for it. Included with GRAZE_STATEMENT(kind, name, code, judge) defined; x and y
// are two intervals of the type I, in the judge's column bounds.
//
// kinds: set, an interval, to be the tightest; number and truth, of operands that are not empty;
// ours, a set that Boost's own types do not give (no such code, or a number rounded unasked);
// c_remainder, a set, but for unprotect<interval>, whose fmod is Boost's.

// functions, qualified and not
#define GRAZE_BOTH(name)                                                                           \
  GRAZE_STATEMENT(set, name##_qualified, boost::numeric::name(x), ranges::name(x))                 \
  GRAZE_STATEMENT(set, name##_unqualified, name(x), ranges::name(x))
GRAZE_BOTH(exp)
GRAZE_BOTH(log)
GRAZE_BOTH(sin)
GRAZE_BOTH(cos)
GRAZE_BOTH(tan)
GRAZE_BOTH(asin)
GRAZE_BOTH(acos)
GRAZE_BOTH(atan)
GRAZE_BOTH(sinh)
GRAZE_BOTH(cosh)
GRAZE_BOTH(tanh)
GRAZE_BOTH(asinh)
GRAZE_BOTH(acosh)
GRAZE_BOTH(atanh)
GRAZE_BOTH(sqrt)
GRAZE_BOTH(abs)
#undef GRAZE_BOTH
GRAZE_STATEMENT(set, square, boost::numeric::square(x), ranges::sqr(x))
GRAZE_STATEMENT(set, square_unqualified, square(x), ranges::sqr(x))

// arithmetic
GRAZE_STATEMENT(set, plus, +x, x)
GRAZE_STATEMENT(set, minus, -x, ranges::neg(x))
GRAZE_STATEMENT(set, sum, x + y, ranges::add(x, y))
GRAZE_STATEMENT(set, difference, x - y, ranges::sub(x, y))
GRAZE_STATEMENT(set, product, x* y, ranges::mul(x, y))
GRAZE_STATEMENT(set, quotient, x / y, ranges::div(x, y))
GRAZE_STATEMENT(set, add_onto, onto(x, [&](I& r) { r += y; }), ranges::add(x, y))
GRAZE_STATEMENT(set, subtract_from, onto(x, [&](I& r) { r -= y; }), ranges::sub(x, y))
GRAZE_STATEMENT(set, multiply_by, onto(x, [&](I& r) { r *= y; }), ranges::mul(x, y))
GRAZE_STATEMENT(set, divide_by, onto(x, [&](I& r) { r /= y; }), ranges::div(x, y))
GRAZE_STATEMENT(set, inverse, il::multiplicative_inverse(x), ranges::recip(x))
GRAZE_STATEMENT(set, add_points, il::add<I>(0.1, 0.7), ranges::add({0.1, 0.1}, {0.7, 0.7}))
GRAZE_STATEMENT(set, sub_points, il::sub<I>(0.1, 0.7), ranges::sub({0.1, 0.1}, {0.7, 0.7}))
GRAZE_STATEMENT(set, mul_points, il::mul<I>(0.1, 0.7), ranges::mul({0.1, 0.1}, {0.7, 0.7}))
GRAZE_STATEMENT(set, div_points, il::div<I>(0.1, 0.7), ranges::div({0.1, 0.1}, {0.7, 0.7}))
GRAZE_STATEMENT(set, two_parts, parts(x, y), ranges::div(x, y))

// numbers beside
GRAZE_STATEMENT(set, sum_double, x + 0.1, ranges::add(x, {0.1, 0.1}))
GRAZE_STATEMENT(set, double_difference, 0.1 - x, ranges::sub({0.1, 0.1}, x))
GRAZE_STATEMENT(set, double_product, -0.1 * x, ranges::mul({-0.1, -0.1}, x))
GRAZE_STATEMENT(set, quotient_double, x / -3.0, ranges::div(x, {-3, -3}))
GRAZE_STATEMENT(set, double_quotient, 3.0 / x, ranges::div({3, 3}, x))
GRAZE_STATEMENT(set, add_double, onto(x, [](I& r) { r += 0.1; }), ranges::add(x, {0.1, 0.1}))
GRAZE_STATEMENT(set, divide_by_double, onto(x, [](I& r) { r /= 0.1; }), ranges::div(x, {0.1, 0.1}))
GRAZE_STATEMENT(set, of_int, I(3) * x, ranges::mul({3, 3}, x))
GRAZE_STATEMENT(set, of_long, I(big) * x, ranges::mul(around_big, x))
GRAZE_STATEMENT(set, of_long_double, I(0.1L) * x, ranges::mul(around_tenth, x))
GRAZE_STATEMENT(ours, sum_int, x + 3, ranges::add(x, {3, 3}))
GRAZE_STATEMENT(ours, sum_long, x + big, ranges::add(x, around_big))
GRAZE_STATEMENT(ours, unsigned_difference, 7ul - x, ranges::sub({7, 7}, x))
GRAZE_STATEMENT(ours, product_long_double, x * 0.1L, ranges::mul(x, around_tenth))
GRAZE_STATEMENT(ours, float_quotient, 0.1f / x, ranges::div({0.1f, 0.1f}, x))
GRAZE_STATEMENT(ours, int128_product, int128{big} * x, ranges::mul(around_big, x))
GRAZE_STATEMENT(ours, add_long, onto(x, [](I& r) { r += big; }), ranges::add(x, around_big))
GRAZE_STATEMENT(ours, multiply_by_long_double, onto(x, [](I& r) { r *= 0.1L; }),
                ranges::mul(x, around_tenth))
GRAZE_STATEMENT(ours, hull_long, hull(x, big), ranges::convex_hull(x, around_big))
GRAZE_STATEMENT(ours, max_int, max(x, 1), ranges::max(x, {1, 1}))
GRAZE_STATEMENT(ours, min_long_double, min(0.1L, x), ranges::min(around_tenth, x))

// powers and roots
GRAZE_STATEMENT(set, pow_7, pow(x, 7), ranges::pown(x, 7).value)
GRAZE_STATEMENT(set, pow_2_qualified, boost::numeric::pow(x, 2), ranges::pown(x, 2).value)
GRAZE_STATEMENT(set, pow_minus_3, pow(x, -3), ranges::pown(x, -3).value)
GRAZE_STATEMENT(set, third_root, nth_root(x, 3), ranges::rootn(x, 3).value)
GRAZE_STATEMENT(set, fourth_root, boost::numeric::nth_root(x, 4), ranges::rootn(x, 4).value)
GRAZE_STATEMENT(ours, pow_0, pow(x, 0), ranges::pown(x, 0).value)
GRAZE_STATEMENT(ours, pow_half, pow(x, 0.5), ranges::pow(x, {0.5, 0.5}))
GRAZE_STATEMENT(ours, pow_real, boost::numeric::pow(x, 2.5), ranges::pow(x, {2.5, 2.5}))
GRAZE_STATEMENT(ours, pow_whole_double, pow(x, 3.0), ranges::pown(x, 3).value)
GRAZE_STATEMENT(ours, pow_long, pow(x, 4l), ranges::pown(x, 4).value)
GRAZE_STATEMENT(ours, pow_interval, pow(x, y), ranges::pow(x, y))

// remainders, set operations
GRAZE_STATEMENT(c_remainder, remainder, fmod(x, y), c_remainder(x, y))
GRAZE_STATEMENT(c_remainder, remainder_qualified, boost::numeric::fmod(x, y), c_remainder(x, y))
GRAZE_STATEMENT(c_remainder, remainder_double, fmod(x, 3.0), c_remainder(x, {3, 3}))
GRAZE_STATEMENT(set, intersection, intersect(x, y), ranges::intersection(x, y))
GRAZE_STATEMENT(set, intersection_qualified, boost::numeric::intersect(x, y),
                ranges::intersection(x, y))
GRAZE_STATEMENT(set, convex_hull, hull(x, y), ranges::convex_hull(x, y))
GRAZE_STATEMENT(set, hull_double, boost::numeric::hull(x, 1.0), ranges::convex_hull(x, {1, 1}))
GRAZE_STATEMENT(set, hull_of_numbers, I::hull(2.0, 1.0), (bounds{1, 2}))
GRAZE_STATEMENT(set, greater, max(x, y), ranges::max(x, y))
GRAZE_STATEMENT(set, lesser, boost::numeric::min(x, y), ranges::min(x, y))
GRAZE_STATEMENT(set, greater_double, boost::numeric::max(x, 1.0), ranges::max(x, {1, 1}))
GRAZE_STATEMENT(set, widened, widen(x, 0.1), ranges::add(x, {-0.1, 0.1}))
GRAZE_STATEMENT(set, halves, joined(bisect(x)), x)
GRAZE_STATEMENT(set, pi, il::pi<I>(), (bounds{0x1.921fb54442d18p+1, 0x1.921fb54442d19p+1}))
GRAZE_STATEMENT(set, half_pi, il::pi_half<I>(),
                (bounds{0x1.921fb54442d18p+0, 0x1.921fb54442d19p+0}))
GRAZE_STATEMENT(set, two_pi, il::pi_twice<I>(),
                (bounds{0x1.921fb54442d18p+2, 0x1.921fb54442d19p+2}))
GRAZE_STATEMENT(set, whole, std::numeric_limits<I>::infinity(), bounds::entire())

// numbers and truths
GRAZE_STATEMENT(number, lower_end, boost::numeric::lower(x), x.lo)
GRAZE_STATEMENT(number, upper_end, upper(x), x.hi)
GRAZE_STATEMENT(number, checked_lower_end, boost::numeric::checked_lower(x), x.lo)
GRAZE_STATEMENT(number, checked_upper_end, checked_upper(x), x.hi)
GRAZE_STATEMENT(number, width_qualified, boost::numeric::width(x), mpfr::sub_up(x.hi, x.lo))
GRAZE_STATEMENT(number, width_unqualified, width(x), mpfr::sub_up(x.hi, x.lo))
GRAZE_STATEMENT(number, greatest_magnitude, norm(x), ranges::abs(x).hi)
GRAZE_STATEMENT(truth, middle_within, in(boost::numeric::median(x), x), true)
GRAZE_STATEMENT(truth, is_member, boost::numeric::in(1.0, x), x.contains(1))
GRAZE_STATEMENT(truth, has_zero, zero_in(x), x.contains(0))
GRAZE_STATEMENT(truth, is_subset, boost::numeric::subset(x, y), x.within(y))
GRAZE_STATEMENT(truth, is_proper_subset, proper_subset(x, y), x.within(y) && !y.within(x))
GRAZE_STATEMENT(truth, is_equal, boost::numeric::equal(x, y), x.within(y) && y.within(x))
GRAZE_STATEMENT(truth, has_common_point, boost::numeric::overlap(x, y),
                !ranges::intersection(x, y).is_empty())
GRAZE_STATEMENT(truth, is_point, singleton(x), x.lo == x.hi)
GRAZE_STATEMENT(truth, is_less, il::cerlt(x, y), x.hi < y.lo)
GRAZE_STATEMENT(truth, is_less_unqualified, cerlt(x, y), x.hi < y.lo)
GRAZE_STATEMENT(truth, text_holds, encloses(printed(x), x), true)
