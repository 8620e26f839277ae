#pragma once
/// One lane on any machine, by the backend `nearest`: the baseline where there is no SSE2, and the
/// plainest reading of what a path is.
#include <graze/needs_cxx20.hpp>

#include <graze/batch/path.hpp>
#include <graze/rounding/fused.hpp>
#include <graze/rounding/nearest.hpp>

namespace graze::batch {

struct portable : rounding::nearest {
  static constexpr const char* name = "portable";
  static constexpr std::size_t width = 1;
  using vector = double;
  using mask = bool;
  using fma_scope = empty_scope;
  class scope : rounding::hardware::mode_scope {
  public:
    scope() : mode_scope(rounding::hardware::mode::nearest) {}
  };

#define GRAZE_BATCH_OPERATION static GRAZE_BATCH_INLINE
  GRAZE_BATCH_OPERATION vector load(const double* p) { return *p; }
  GRAZE_BATCH_OPERATION void store(double* p, vector x) { *p = x; }
  GRAZE_BATCH_OPERATION vector broadcast(double x) { return x; }
  GRAZE_BATCH_OPERATION vector zero() { return 0; }
  GRAZE_BATCH_OPERATION vector fma_up(vector x, vector y, vector z) {
    return rounding::fma_up(x, y, z);
  }
  GRAZE_BATCH_OPERATION vector fma_down(vector x, vector y, vector z) {
    return rounding::fma_down(x, y, z);
  }
  GRAZE_BATCH_OPERATION vector neg(vector x) { return -x; }
  GRAZE_BATCH_OPERATION vector abs(vector x) { return __builtin_fabs(x); }
  GRAZE_BATCH_OPERATION vector max_or_second(vector p, vector q) { return p > q ? p : q; }
  GRAZE_BATCH_OPERATION vector min_or_second(vector p, vector q) { return p < q ? p : q; }
  GRAZE_BATCH_OPERATION vector min_number(vector p, vector q) {
    if (p != p || q != q)
      return p != p ? q : p;
    return p == q ? (__builtin_signbit(p) ? p : q) : (p < q ? p : q);
  }
  GRAZE_BATCH_OPERATION vector max_number(vector p, vector q) {
    if (p != p || q != q)
      return p != p ? q : p;
    return p == q ? (__builtin_signbit(p) ? q : p) : (p > q ? p : q);
  }
  GRAZE_BATCH_OPERATION vector greater_magnitude(vector p, vector q) {
    return max_or_second(abs(p), abs(q));
  }
  GRAZE_BATCH_OPERATION vector number_or(vector p, vector q) { return p != p ? q : p; }
  GRAZE_BATCH_OPERATION vector nan_for_zero(vector p) { return p == 0 ? __builtin_nan("") : p; }
  GRAZE_BATCH_OPERATION mask less(vector p, vector q) { return p < q; }
  GRAZE_BATCH_OPERATION mask less_equal(vector p, vector q) { return p <= q; }
  GRAZE_BATCH_OPERATION mask equal(vector p, vector q) { return p == q; }
  GRAZE_BATCH_OPERATION mask either_nan(vector p, vector q) { return p != p || q != q; }
  GRAZE_BATCH_OPERATION mask both(mask m, mask n) { return m && n; }
  GRAZE_BATCH_OPERATION mask either(mask m, mask n) { return m || n; }
  GRAZE_BATCH_OPERATION vector select(mask m, vector p, vector q) { return m ? p : q; }
  GRAZE_BATCH_OPERATION unsigned bits(mask m) { return m ? 1 : 0; }
  GRAZE_BATCH_OPERATION vector firsts(vector p, vector) { return p; }
  GRAZE_BATCH_OPERATION vector seconds(vector, vector q) { return q; }
#undef GRAZE_BATCH_OPERATION
};

} // namespace graze::batch
