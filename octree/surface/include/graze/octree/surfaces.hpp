#pragma once
/// The four algebraic surfaces of the scenes. Each formula is written once and evaluated over
/// double, intervals, duals of both, and the oracle's numbers; in a form whose natural extension is
/// tight: no variable occurs twice except through functions that are tight on their own.
#include <graze/needs_cxx20.hpp>

#include <array>
#include <concepts>
#include <graze/octree/formula.hpp>

namespace graze::octree {

/// A surface f(x, y, z) = 0: a callable over any number type.
template <class F>
concept Surface = requires(const F f, double x) {
  { f(x, x, x) } -> std::same_as<double>;
};

/// True for a surface of which the mean value form is not asked for: the natural interval extension
/// is its range but for rounding, or so near to it that the mean value form costs more than it
/// saves (graze-inclusion-bench). `static constexpr bool natural_extension_suffices = true` in the
/// surface says so. A bound holds either way.
template <class F> consteval bool natural_extension_suffices() {
  if constexpr (requires { F::natural_extension_suffices; })
    return F::natural_extension_suffices;
  return false;
}
/// The same of an object whose type does not know: its member natural_extension_suffices() says so.
template <class F> bool natural_extension_suffices(const F& f) {
  if constexpr (requires { f.natural_extension_suffices(); })
    return f.natural_extension_suffices();
  return natural_extension_suffices<F>();
}

/// f is defined and continuous at every point of space, as a surface is taken to be unless its
/// member continuous() denies it. Of such a one continuous_on<B>(box) says where it is proven
/// (inclusion.hpp, is_continuous_on); octree_formula.hpp has the rules that it must keep.
template <class F> bool is_continuous(const F& f) {
  if constexpr (requires { f.continuous(); })
    return f.continuous();
  return true;
}

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

} // namespace graze::octree
