#pragma once
/// The surfaces that are built in, and the list of them. The formula of each is written once and
/// evaluated over double, intervals, duals of both, and the oracle's numbers; in a form whose natural
/// extension is tight: no variable occurs twice except through functions that are tight on their own.
#include <graze/needs_cxx20.hpp>

#include <array>
#include <graze/octree/asterisk.hpp>
#include <graze/octree/box.hpp>
#include <graze/octree/formula.hpp>
#include <graze/octree/surface.hpp>
#include <tuple>

namespace graze::octree {

/// The union of nine balls: the least of nine |p - centre|^2 - radius^2.
/// All centres and squared radii are exact doubles.
struct spheres {
  static constexpr bool natural_extension_suffices = true;
  struct sphere {
    std::array<double, 3> centre;
    double radius;
  };
  static constexpr std::array<sphere, 9> parts{{{{0, 0, 0}, 1},
                                                {{1.75, 0, 0}, 0.625},
                                                {{-1.75, 0.25, 0}, 0.625},
                                                {{0, 1.75, 0.25}, 0.625},
                                                {{0, -1.75, 0}, 0.625},
                                                {{0.25, 0, 1.75}, 0.625},
                                                {{0, 0, -1.75}, 0.625},
                                                {{1.25, 1.25, 1.25}, 0.375},
                                                {{-1.25, -1.25, 1.25}, 0.375}}};

  /// The polynomial of one of the nine.
  template <class N> static N part(const sphere& s, const N& x, const N& y, const N& z) {
    using c = constants<N>;
    return sqr(x - c::exact(s.centre[0])) + sqr(y - c::exact(s.centre[1])) +
           sqr(z - c::exact(s.centre[2])) - c::exact(s.radius * s.radius);
  }

  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    N least = part(parts[0], x, y, z);
    for (std::size_t i = 1; i < parts.size(); ++i)
      least = lesser(least, part(parts[i], x, y, z));
    return least;
  }
};

/// (x^2-1)^2 + (y^2-1)^2 + (z^2-1)^2 - 1
struct quartdef {
  static constexpr bool natural_extension_suffices = true;
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    const auto one = constants<N>::exact(1);
    return sqr(sqr(x) - one) + sqr(sqr(y) - one) + sqr(sqr(z) - one) - one;
  }
};

/// x^4-5x^2 + y^4-5y^2 + z^4-5z^2 + 59/5, the decimal 11.8 being meant as a real number; each
/// x^4-5x^2 is (x^2-5/2)^2 - 25/4, and 3*25/4 - 59/5 = 139/20.
struct tanglecube {
  static constexpr bool natural_extension_suffices = true;
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    const auto shift = constants<N>::exact(2.5);
    return sqr(sqr(x) - shift) + sqr(sqr(y) - shift) + sqr(sqr(z) - shift) -
           constants<N>::template rational<139, 20>();
  }
};

/// x^3 - x + y^3 - y + z^3 - z
struct holesrot {
  static constexpr bool natural_extension_suffices = true;
  template <class N> N operator()(const N& x, const N& y, const N& z) const {
    return cube_minus_identity(x) + cube_minus_identity(y) + cube_minus_identity(z);
  }
};

/// A surface that is built in, as docs/definitions.md has it.
template <Surface F> struct built_in_surface {
  const char* name;
  const char* formula; ///< what it is, for people
  double reach;        ///< its domain is [-reach, reach]^3
  double scale;        ///< S, of the camera that shows it

  [[nodiscard]] static constexpr F surface() { return {}; }
  [[nodiscard]] constexpr box domain() const {
    return {{-reach, -reach, -reach}, {reach, reach, reach}};
  }
};

/// The surfaces that are built in. Each that is added here is compiled for every path, and is one of
/// the surfaces of graze-render, graze-voxelize, graze-fuzz, the benchmarks and the tests.
inline constexpr std::tuple built_in_surfaces{
    built_in_surface<spheres>{
        "spheres",
        "nine spheres: (0,0,0) r 1; (1.75,0,0), (-1.75,.25,0), (0,1.75,.25), (0,-1.75,0), "
        "(.25,0,1.75), (0,0,-1.75) r .625; (1.25,1.25,1.25), (-1.25,-1.25,1.25) r .375",
        2.5, 1.5},
    built_in_surface<quartdef>{"quartdef", "(x^2-1)^2+(y^2-1)^2+(z^2-1)^2-1", 1.5, 1.125},
    built_in_surface<tanglecube>{"tanglecube", "x^4-5x^2+y^4-5y^2+z^4-5z^2+11.8", 2.5, 2},
    built_in_surface<holesrot>{"holesrot", "x^3+y^3+z^3-x-y-z", 2, 2},
    built_in_surface<asterisk<3, 4>>{
        "asterisk(3,4)", "sin(3*atan2(y,x))*sin(4*atan2(hypot(x,y),z)) - hypot(hypot(x,y),z)", 1,
        0.5},
    built_in_surface<asterisk<9, 18>>{
        "asterisk(9,18)", "sin(9*atan2(y,x))*sin(18*atan2(hypot(x,y),z)) - hypot(hypot(x,y),z)", 1,
        0.5},
};

/// The row of F, which is in the list.
template <Surface F>
inline constexpr const built_in_surface<F>& built_in =
    std::get<built_in_surface<F>>(built_in_surfaces);

/// Calls visit(row) for each row, in the list's order.
template <class Visit> constexpr void for_each_built_in(Visit&& visit) {
  std::apply([&visit](const auto&... row) { (visit(row), ...); }, built_in_surfaces);
}

} // namespace graze::octree
