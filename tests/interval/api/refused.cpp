// Each case by itself must be refused, by words that say what to do; case 0 is fine.
#if !defined(GRAZE_REFUSED)
#define GRAZE_REFUSED 0
#endif

#if GRAZE_REFUSED == 4
#include <graze/interval.hpp>
#elif GRAZE_REFUSED == 2 || GRAZE_REFUSED == 3
#include <boost/numeric/interval.hpp>
#include <graze/boost_rounding.hpp>
namespace il = boost::numeric::interval_lib;
using I =
    boost::numeric::interval<long double,
                             il::policies<graze::boost_rounding<>, il::checking_base<long double>>>;
#if GRAZE_REFUSED == 2
I refused(const I& x) { return x + x; }
#else
I refused(const I& x) { return exp(x); }
#endif
#else
#include <graze/interval.hpp>
template <class T> using I = boost::numeric::interval<T, graze::policies<>>;
I<double> accepted(const I<double>& x) { return sqrt(x) + x * x; }
#if GRAZE_REFUSED == 1
I<long double> refused(const I<long double>& x) { return x - I<long double>(1); }
#endif
#endif
