// What a shared object would export: a function that needs the archive.
#include <graze/interval.hpp>

extern "C" [[gnu::visibility("default")]] void shared_exp(double x, double* lower, double* upper);

void shared_exp(double x, double* lower, double* upper) {
  const graze::interval<> r = exp(graze::interval<>(x)) + sin(graze::interval<>(x));
  *lower = r.lower(), *upper = r.upper();
}
