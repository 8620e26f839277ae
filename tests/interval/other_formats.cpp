// Formats that have no bounds of ours: must not compile, with a line that says what does.
#include <boost/numeric/interval/transc.hpp>
#include <graze/interval.hpp>

using I = boost::numeric::interval<long double, graze::policies<>>;

I wrong(const I& x) {
#if defined(GRAZE_TEST_SUM)
  // (1 + 2^-60) - 1 was [-0, 0]
  return (x + I(0x1p-60L)) - x;
#elif defined(GRAZE_TEST_QUOTIENT)
  return x / x;
#elif defined(GRAZE_TEST_ROOT)
  return sqrt(x);
#elif defined(GRAZE_TEST_FUNCTION)
  return exp(x);
#elif defined(GRAZE_TEST_NUMBER)
  return I(1.0 / 3) = 0.1;
#endif
}
