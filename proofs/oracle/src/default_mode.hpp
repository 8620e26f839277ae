#pragma once
#include <xmmintrin.h>

namespace graze::oracle {

/// Round to nearest, no flushing, all exceptions masked, for the scope's life; restores what it
/// found. What is computed within must be in a function that is not inlined, since a compiler may
/// move floating-point operations across the change. Costs a few cycles where nothing has to
/// change.
class default_mode {
public:
  default_mode() : found_(_mm_getcsr()) {
    if ((found_ & controls) != defaults)
      _mm_setcsr(defaults);
  }
  ~default_mode() {
    if ((found_ & controls) != defaults)
      _mm_setcsr(found_);
  }
  default_mode(const default_mode&) = delete;
  default_mode& operator=(const default_mode&) = delete;

private:
  static constexpr unsigned controls = 0xffc0; // FTZ, rounding, masks, DAZ; not the sticky flags
  static constexpr unsigned defaults = 0x1f80;
  unsigned found_;
};

} // namespace graze::oracle
