#include "adapters.hpp"
#include <graze/oracle/rational.hpp>

namespace graze::fuzz {

namespace {

/// The oracle's rational form, octant by octant; the campaign judges by the other form, which has
/// no line in common with it. Gets the ray and the octants as they are.
class rational final : public traversal {
public:
  explicit rational(std::string_view name) : name_(name) {}
  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] promise promises() const override { return promise::exactly_touched; }
  void visit(const trial& t, visited& out) override {
    for (voxel_set left = t.all(); left != 0; left &= left - 1) {
      const auto v = static_cast<voxel>(std::countr_zero(left));
      const cube box = t.octant(v);
      if (oracle::rational::touches(t.origin, t.direction, box.lo,
                                    {box.hi(0), box.hi(1), box.hi(2)}))
        out.push(v);
    }
  }

private:
  std::string_view name_;
};

} // namespace

std::unique_ptr<traversal> make_rational(std::string_view name) {
  return std::make_unique<rational>(name);
}

} // namespace graze::fuzz
