#include "adapters.hpp"
#include "box_traversal.hpp"

namespace graze::fuzz {

namespace {

/// Williams, Barrus, Morley and Shirley 2005, "An efficient and robust ray-box intersection
/// algorithm", journal of graphics tools 10(1): near and far planes chosen by the signs of the
/// inverse direction, and early exits.
class williams {
public:
  williams(const vec3& origin, const vec3& direction) : origin_(origin) {
    for (unsigned a = 0; a < 3; ++a)
      inverse_[a] = 1 / direction[a];
  }

  bool operator()(const vec3& lo, const vec3& hi) const {
    double enter = 0, leave = 0;
    for (unsigned a = 0; a < 3; ++a) {
      const bool backwards = inverse_[a] < 0;
      const double near = ((backwards ? hi : lo)[a] - origin_[a]) * inverse_[a];
      const double far = ((backwards ? lo : hi)[a] - origin_[a]) * inverse_[a];
      if (a == 0) {
        enter = near;
        leave = far;
        continue;
      }
      if (enter > far || near > leave)
        return false;
      if (near > enter)
        enter = near;
      if (far < leave)
        leave = far;
    }
    return enter < INFINITY && leave > 0;
  }

private:
  vec3 origin_, inverse_{};
};

} // namespace

std::unique_ptr<traversal> make_williams(std::string_view name) {
  return std::make_unique<box_traversal<williams>>(name);
}

} // namespace graze::fuzz
