// Where the surface is, and the camera that shows it.
#include "scene_surface.hpp"

#include <cmath>
#include <graze/octree/lane_kernels.hpp>
#include <utility>

namespace graze::render {
namespace {

using backend = octree::kernel_backend;
using octree::box;

/// The parts of a box in which a surface may be, in halves of halves, without those that cannot matter:
/// `matters(part)` is asked before f is, and `keep(part)` is told of the least that are left.
template <class F, class Matters, class Keep>
void for_each_part(const F& f, const box& whole, int halvings, int& most_tests,
                   const Matters& matters, const Keep& keep) {
  if (!matters(whole))
    return;
  if (most_tests-- > 0) {
    if (octree::has_no_zero<backend>(f, whole))
      return;
    if (halvings > 0) {
      const vec3 middle = {whole.lo[0] / 2 + whole.hi[0] / 2, whole.lo[1] / 2 + whole.hi[1] / 2,
                           whole.lo[2] / 2 + whole.hi[2] / 2};
      for (unsigned i = 0; i < 8; ++i) {
        box part = whole;
        for (std::size_t a = 0; a < 3; ++a)
          ((i >> a & 1) != 0 ? part.lo : part.hi)[a] = middle[a];
        for_each_part(f, part, halvings - 1, most_tests, matters, keep);
      }
      return;
    }
  }
  keep(whole);
}

double longest_side(const box& b) {
  return std::max({b.hi[0] - b.lo[0], b.hi[1] - b.lo[1], b.hi[2] - b.lo[2]});
}

template <class F> ball extent_of(const F& f, const box& domain) {
  [[maybe_unused]] const backend::scope scope;
  constexpr int halvings = 6, most_tests = 1 << 15, most_rounds = 16;
  box found = domain;
  for (int round = 0; round < most_rounds; ++round) { // a small surface in a large domain
    constexpr double infinity = std::numeric_limits<double>::infinity();
    box held = {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    int tests = most_tests;
    for_each_part(
        f, found, halvings, tests, [&](const box& part) { return !octree::contains(held, part); },
        [&](const box& part) {
          for (std::size_t a = 0; a < 3; ++a) {
            held.lo[a] = std::min(held.lo[a], part.lo[a]);
            held.hi[a] = std::max(held.hi[a], part.hi[a]);
          }
        });
    if (held.empty())
      return ball_about(domain);
    const bool shrunk = longest_side(held) < longest_side(found) / 2;
    found = held;
    if (!shrunk)
      break;
  }
  ball about = ball_about(found);
  const auto farthest = [&](const box& part) {
    double square = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double away = std::max(std::fabs(part.lo[a] - about.middle[a]),
                                   std::fabs(part.hi[a] - about.middle[a]));
      square += away * away;
    }
    return std::sqrt(square);
  };
  double radius = 0;
  int tests = most_tests;
  for_each_part(
      f, found, halvings, tests, [&](const box& part) { return farthest(part) > radius; },
      [&](const box& part) { radius = farthest(part); });
  if (radius > 0 && std::isfinite(radius))
    about.radius = std::min(radius, about.radius);
  return about;
}

} // namespace

ball surface_extent(const scene& s) {
  if (!check_domain(s.domain))
    return {{0, 0, 0}, 1};
  ball found = ball_about(s.domain);
  if (s.built_in.empty()) {
    if (const auto whole = whole_formula(s))
      found = extent_of(whole->surface(), s.domain);
    return found;
  }
  octree::for_each_built_in([&](const auto& row) {
    if (row.name == s.built_in)
      found = extent_of(row.surface(), s.domain);
  });
  return found;
}

std::vector<light> headlight(const camera& view) { return {{view.eye, 0.9}}; }

expected<framed_camera> settle_view(scene& s, const framing& asked,
                                    const std::optional<ball>& shown) {
  const framing whole = s.fitted ? asked.over(*s.fitted) : asked;
  const auto made = s.fitted ? frame(whole, shown ? *shown : surface_extent(s))
                             : frame(whole, s.view, ball_about(s.domain).middle);
  if (!made && whole.empty()) // a domain too large or too small for it
    return framed_camera{s.view, ball_about(s.domain).middle, {0, 1, 0}};
  if (!made)
    return made;
  s.view = made->view;
  if (whole.turns() && s.lit == scene::lamps::usual)
    s.lit = scene::lamps::headlight;
  if (s.lit == scene::lamps::headlight)
    s.lights = headlight(s.view);
  return made;
}

} // namespace graze::render
