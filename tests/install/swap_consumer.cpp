// What a client of Boost.Interval in C++17 writes; returns 0 when the bounds hold.
#include <boost/numeric/interval.hpp>
#include <graze/boost_functions.hpp>

static_assert(__cplusplus == 201703L, "the package must not ask for more");

int main() {
  namespace il = boost::numeric::interval_lib;
  using interval =
      boost::numeric::interval<double,
                               il::policies<graze::boost_rounding<>, il::checking_base<double>>>;
  const interval e = boost::numeric::exp(interval(1)), third = interval(1) / 3.0;
  const bool holds = e.lower() == 0x1.5bf0a8b145769p+1 && e.upper() == 0x1.5bf0a8b14576ap+1 &&
                     third.lower() == 0x1.5555555555555p-2 && third.upper() == 0x1.5555555555556p-2;
  return holds ? 0 : 1;
}
