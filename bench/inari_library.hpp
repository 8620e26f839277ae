#pragma once
/// inari (Rust) behind the C interface of bench/inari (src/lib.rs there), loaded at run time from
/// where the target graze-inari puts it.
#include <cstddef>
#include <dlfcn.h>
#include <fstream>
#include <string>

namespace graze::bench {

/// An opaque interval of inari's.
struct alignas(16) inari_number {
  unsigned char bytes[16];
};

class inari_library {
public:
  using unary = void (*)(std::size_t, const inari_number*, inari_number*);
  using binary = void (*)(std::size_t, const inari_number*, const inari_number*, inari_number*);

  static const inari_library& get() {
    static const inari_library library(GRAZE_BENCH_INARI);
    return library;
  }
  /// Why there is none; empty if there is.
  [[nodiscard]] const std::string& missing() const { return missing_; }

  /// "exp": graze_inari_exp.
  [[nodiscard]] unary find_unary(const char* name) const { return find<unary>(name); }
  [[nodiscard]] binary find_binary(const char* name) const { return find<binary>(name); }

  [[nodiscard]] inari_number make(double lower, double upper) const {
    const double ends[] = {lower, upper};
    inari_number x;
    make_(1, ends, &x);
    return x;
  }
  [[nodiscard]] double lower(const inari_number& x) const { return ends(x).lower; }
  [[nodiscard]] double upper(const inari_number& x) const { return ends(x).upper; }

private:
  struct pair {
    double lower, upper;
  };

  explicit inari_library(const std::string& folder) {
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
      missing_ = "this processor lacks AVX2 or FMA";
    else if (!(handle_ = dlopen((folder + "/release/libgraze_inari.so").c_str(), RTLD_NOW)))
      if (std::ifstream file(folder + "/missing.txt"); !std::getline(file, missing_))
        missing_ = "the target graze-inari has not been built";
    if (!missing_.empty())
      return;
    make_ = find<decltype(make_)>("make");
    ends_ = find<decltype(ends_)>("ends");
  }
  template <class Function> Function find(const char* name) const {
    return reinterpret_cast<Function>(dlsym(handle_, (std::string("graze_inari_") + name).c_str()));
  }
  [[nodiscard]] pair ends(const inari_number& x) const {
    double both[2];
    ends_(1, &x, both);
    return {both[0], both[1]};
  }

  void* handle_ = nullptr;
  std::string missing_;
  void (*make_)(std::size_t, const double*, inari_number*) = nullptr;
  void (*ends_)(std::size_t, const inari_number*, double*) = nullptr;
};

} // namespace graze::bench
