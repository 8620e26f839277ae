// Scopes restore MXCSR (status flags too) and the x87 control word as found, whatever was found,
// and the bounds are right in the meantime.
#include <catch2/catch.hpp>
#include <graze/rounding/nearest.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>

namespace rounding = graze::rounding;
namespace hardware = graze::rounding::hardware;

namespace {

/// Sets control words that a caller might have, and puts the test's own back.
class caller {
public:
  caller(unsigned mxcsr, unsigned short x87)
      : mxcsr_(hardware::mxcsr()), x87_(hardware::x87_control()) {
    hardware::set_mxcsr(mxcsr);
    hardware::set_x87_control(x87);
  }
  ~caller() {
    asm volatile("fnclex");
    hardware::set_x87_control(x87_);
    hardware::set_mxcsr(mxcsr_);
  }
  caller(const caller&) = delete;
  caller& operator=(const caller&) = delete;

private:
  unsigned mxcsr_;
  unsigned short x87_;
};

struct observed {
  double sum, difference, quotient_down, quotient_up, subnormal;
  unsigned mxcsr;
  unsigned short x87;
};

template <class B> observed in_scope() {
  observed o{};
  {
    [[maybe_unused]] const typename B::scope scope;
    o.sum = B::add_up(0.1, 0.2);
    o.difference = B::sub_down(0.1, 0.1);
    o.quotient_down = B::div_down(1, 3);
    o.quotient_up = B::div_up(1, 3);
    o.subnormal = B::mul_up(0x1p-1022, 0.5);
  }
  o.mxcsr = hardware::mxcsr();
  o.x87 = hardware::x87_control();
  return o;
}

// MXCSR: default; flags raised; FTZ; FTZ and DAZ; rounding down with FTZ; all exceptions unmasked
constexpr unsigned mxcsrs[] = {0x1f80, 0x1fbf, 0x9f80, 0x9fc0, 0xbf80, 0x0000, 0x5fa1};
// x87: default; 53 bits; 24 bits towards zero; down; invalid, overflow and zero divide unmasked;
// all
constexpr unsigned short x87s[] = {0x037f, 0x027f, 0x0c7f, 0x077f, 0x0372, 0x0340};

} // namespace

TEMPLATE_TEST_CASE("interval.backends: control words and status flags are as found", "[property]",
                   rounding::switching, rounding::upward, rounding::split) {
  for (const unsigned mxcsr : mxcsrs) {
    for (const unsigned short x87 : x87s) {
      observed o{};
      {
        const caller set(mxcsr, x87);
        o = in_scope<TestType>();
        asm volatile("fld1\n\tfaddp"
                     :
                     :
                     : "st", "st(1)"); // a pending x87 exception would trap here
      }
      CAPTURE(mxcsr, x87);
      CHECK(o.mxcsr == mxcsr);
      CHECK(o.x87 == x87);
      CHECK(o.sum == 0x1.3333333333334p-2);
      CHECK(o.difference == 0);
      CHECK(std::signbit(o.difference));
      CHECK(o.quotient_down == 0x1.5555555555555p-2);
      CHECK(o.quotient_up == 0x1.5555555555556p-2);
      CHECK(o.subnormal == 0x1p-1023);
    }
  }
}

TEST_CASE("interval.nearest: sets no control word", "[property]") {
  for (const unsigned short x87 : x87s) {
    observed o{};
    {
      const caller set(0x1f80, x87);
      o = in_scope<rounding::nearest>();
    }
    CHECK((o.mxcsr & ~0x3fu) == 0x1f80);
    CHECK(o.x87 == x87);
    CHECK(o.sum == 0x1.3333333333334p-2);
    CHECK(o.subnormal == 0x1p-1023);
  }
}

TEST_CASE("interval.backends: scopes nest", "[unit]") {
  const unsigned found = hardware::mxcsr();
  const unsigned short found_x87 = hardware::x87_control();
  {
    const rounding::upward::scope outer;
    {
      const rounding::split::scope inner;
      CHECK(rounding::split::sub_down(1, 0x1p-60) == 0x1.fffffffffffffp-1);
      CHECK(rounding::split::add_up(1, 0x1p-60) == 0x1.0000000000001p+0);
    }
    CHECK(rounding::upward::add_up(1, 0x1p-60) == 0x1.0000000000001p+0);
    CHECK(rounding::switching::add_down(1, 0x1p-60) == 1);
    CHECK(rounding::upward::add_up(1, 0x1p-60) == 0x1.0000000000001p+0);
  }
  CHECK((hardware::mxcsr() & ~0x3fu) == (found & ~0x3fu));
  CHECK(hardware::x87_control() == found_x87);
}

TEST_CASE("interval.nearest: a plain operation beside another backend's scope keeps its mode",
          "[regression]") {
  // x + y of nearest must not be moved into the scope before it, or after it
  volatile double one = 1, tiny = 0x1p-60;
  double inside = 0, before = 0, after = 0;
  before = rounding::nearest::add_down(one, tiny);
  {
    const rounding::upward::scope scope;
    inside = rounding::upward::add_up(one, tiny);
  }
  after = rounding::nearest::add_down(one, tiny);
  CHECK(before == 1);
  CHECK(inside == 0x1.0000000000001p+0);
  CHECK(after == 1);
}
