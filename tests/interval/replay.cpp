// replay FILE: every backend, every operation, every operand pair of the file, bit for bit; once
// with a scope around each call, after which the control words must be as before, and once with a
// scope around many; then the operators of intervals that hold one number. replay --visible: the
// cases in visible_operands.cpp. Built by each compiler at several levels of optimization, with
// flags of its own.
#include "expectations.hpp"
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <graze/interval.hpp>
#include <graze/rounding/nearest.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/switching.hpp>
#include <graze/rounding/upward.hpp>
#include <utility>
#include <vector>

using namespace graze::test;
namespace rounding = graze::rounding;

int visible_operands();

namespace {

long failures = 0;

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (a != a && b != b);
}

void compare(const char* backend, const char* route, const expectation& e, std::size_t i,
             double found) {
  if (same(found, e.results[i]))
    return;
  if (++failures <= 20)
    std::printf("%s, %s: %s(%a, %a) = %a, MPFR %a\n", backend, route, operation_names[i], e.x, e.y,
                found, e.results[i]);
}

struct control_words {
  unsigned mxcsr = rounding::hardware::mxcsr();
  unsigned short x87 = rounding::hardware::x87_control();
};

template <class B, std::size_t i> void one_call(const expectation& e) {
  constexpr bool restores_flags = !std::is_same_v<B, rounding::nearest>;
  constexpr unsigned compared = restores_flags ? ~0u : ~0x3fu;
  const control_words before;
  double found = 0;
  {
    [[maybe_unused]] const typename B::scope scope;
    found = operation<B, i>(e.x, e.y);
  }
  const control_words after;
  compare(B::name, "a scope a call", e, i, found);
  if (((before.mxcsr ^ after.mxcsr) & compared) != 0 || before.x87 != after.x87)
    if (++failures <= 20)
      std::printf("%s: %s(%a, %a) left MXCSR %x for %x, x87 %x for %x\n", B::name,
                  operation_names[i], e.x, e.y, after.mxcsr, before.mxcsr, after.x87, before.x87);
}

template <class B> void replay(const std::vector<expectation>& all) {
  for (const expectation& e : all)
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      (one_call<B, i>(e), ...);
    }(std::make_index_sequence<operation_count>{});

  constexpr std::size_t block = 1024;
  std::vector<std::array<double, operation_count>> found(block);
  for (std::size_t from = 0; from < all.size(); from += block) {
    const std::size_t count = all.size() - from < block ? all.size() - from : block;
    {
      [[maybe_unused]] const typename B::scope scope;
      for (std::size_t k = 0; k < count; ++k)
        all_operations<B>(all[from + k].x, all[from + k].y, found[k]);
    }
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t i = 0; i < operation_count; ++i)
        compare(B::name, "a scope for many", all[from + k], i, found[k][i]);
  }
}

/// The bounds of an operation on [x, x] and [y, y] are its two rounded results, a zero of either
/// sign; on no real number, and for x / 0 and the root of a negative number, the empty set.
template <class I>
void compare_set(const char* type, const expectation& e, std::size_t i, bool is_empty, const I& r) {
  const double down = e.results[i], up = e.results[i + 1];
  if (is_empty ? empty(r) : r.lower() == down && r.upper() == up)
    return;
  if (++failures <= 20)
    std::printf("%s: %s and up of [%a] and [%a] = [%a, %a], MPFR [%a, %a]\n", type,
                operation_names[i], e.x, e.y, r.lower(), r.upper(), down, up);
}

template <class I, class B>
void replay_sets(const char* type, const std::vector<expectation>& all) {
  constexpr std::size_t block = 1024;
  const auto a_number = [](double x) { return x - x == 0; };
  std::vector<std::array<I, 5>> found(block);
  for (std::size_t from = 0; from < all.size(); from += block) {
    const std::size_t count = all.size() - from < block ? all.size() - from : block;
    {
      [[maybe_unused]] const typename B::scope scope;
      for (std::size_t k = 0; k < count; ++k) {
        const I x = all[from + k].x, y = all[from + k].y;
        found[k] = {x + y, x - y, x * y, x / y, sqrt(x)};
      }
    }
    for (std::size_t k = 0; k < count; ++k) {
      const expectation& e = all[from + k];
      const bool none = !a_number(e.x) || !a_number(e.y);
      for (std::size_t i = 0; i < 3; ++i)
        compare_set(type, e, 2 * i, none, found[k][i]);
      if (e.x != 0 || e.y == 0) // 0 / y is exactly 0, whatever y's sign
        compare_set(type, e, 6, none || e.y == 0, found[k][3]);
      compare_set(type, e, 8, !a_number(e.x) || e.x < 0, found[k][4]);
    }
  }
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: replay FILE | --visible\n");
    return 2;
  }
  if (std::strcmp(argv[1], "--visible") == 0)
    return visible_operands() == 0 ? 0 : 1;
  std::FILE* file = std::fopen(argv[1], "rb");
  if (file == nullptr) {
    std::fprintf(stderr, "cannot read %s\n", argv[1]);
    return 2;
  }
  std::vector<expectation> all;
  std::vector<expectation> part(1 << 14);
  while (const std::size_t n = std::fread(part.data(), sizeof(expectation), part.size(), file))
    all.insert(all.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(n));
  std::fclose(file);
  if (all.size() < 1'000'000) {
    std::fprintf(stderr, "%s holds %zu operand pairs; 1000000 are needed\n", argv[1], all.size());
    return 2;
  }
  replay<rounding::switching>(all);
  replay<rounding::upward>(all);
  replay<rounding::nearest>(all);
  replay<rounding::split>(all);
  using rounding::nearest, rounding::upward;
  replay_sets<graze::interval<nearest>, nearest>("interval<nearest>", all);
  replay_sets<graze::interval<upward>, nearest>("interval<upward>", all);
  replay_sets<graze::unprotected<upward>, upward>("unprotected<upward>", all);
  std::printf("4 backends, 10 operations, %zu operand pairs: %ld wrong\n", all.size(), failures);
  return failures == 0 ? 0 : 1;
}
