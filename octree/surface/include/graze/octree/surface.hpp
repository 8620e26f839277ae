#pragma once
/// What a surface is, and what is known of one beside its values.
#include <graze/needs_cxx20.hpp>

#include <concepts>

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

/// Along a line the surface's zeros are those of polynomials, so that an oracle finds them exactly.
/// `static constexpr bool is_algebraic = false` in the surface denies it.
template <class F> consteval bool is_algebraic() {
  if constexpr (requires { F::is_algebraic; })
    return F::is_algebraic;
  return true;
}

} // namespace graze::octree
