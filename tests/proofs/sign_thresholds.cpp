// The thresholds that Gappa proves (proofs/gappa), read from its files and held against the C++
// formulas at corners: the plain double value is within T of the exact one, so that beyond T its
// sign is certain.
#include <boost/multiprecision/cpp_int.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <graze/octree/surfaces.hpp>
#include <random>
#include <string>

namespace {

using rational = boost::multiprecision::cpp_rational;

/// The number N 2^E of the line "# T = NbE".
double threshold(const std::string& scene) {
  std::ifstream file(std::string(GRAZE_GAPPA) + "/" + scene + ".gappa");
  for (std::string line; std::getline(file, line);)
    if (int digits = 0, exponent = 0;
        std::sscanf(line.c_str(), "# T = %db%d", &digits, &exponent) == 2)
      return std::ldexp(digits, exponent);
  return std::nan("");
}

/// Corners of random levels in [-half, half]^3; the worst error seen, as a part of T. The search
/// walks along x to where the value is next to zero, on every second point.
template <class Surface> double worst(const std::string& scene, double half, double allowed) {
  const Surface f;
  std::mt19937_64 bits(2005);
  std::uniform_int_distribution<int> levels(1, 53);
  double result = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double grid = std::ldexp(4, -levels(bits));
    const auto corner = [&] {
      const double at = std::uniform_real_distribution<>(-half, half)(bits);
      return std::clamp(std::nearbyint(at / grid) * grid, -half, half);
    };
    double x = corner();
    const double y = corner(), z = corner();
    if (i % 2 == 0)
      for (double a = x, b = corner(); (f(a, y, z) < 0) != (f(b, y, z) < 0);) {
        x = std::midpoint(a, b);
        if (x == a || x == b)
          break;
        ((f(x, y, z) < 0) == (f(a, y, z) < 0) ? a : b) = x;
      }
    const double value = f(x, y, z);
    const rational exact = f(rational(x), rational(y), rational(z));
    const rational error = abs(rational(value) - exact);
    result = std::max(result, static_cast<double>(error) / allowed);
    if (std::fabs(value) > allowed && (value < 0) != (exact < 0))
      FAIL(scene << ": wrong sign beyond the threshold");
  }
  return result;
}

template <class Surface> void check(const std::string& scene, double half) {
  const double allowed = threshold(scene);
  const double part = worst<Surface>(scene, half, allowed);
  INFO(scene << ": worst error is " << part << " of " << allowed);
  CHECK(part <= 1);
  CHECK(part > 0.05); // what is compared does round
}

} // namespace

TEST_CASE("proofs.gappa: plain double signs are right beyond the proved thresholds", "[gappa]") {
  using namespace graze::octree;
  int proven = 0;
  for_each_built_in([&proven]<class F>(const built_in_surface<F>& row) {
    if constexpr (is_algebraic<F>())
      if (threshold(row.name) > 0) {
        ++proven;
        check<F>(row.name, row.reach);
      }
  });
  CHECK(proven == 4);
}
