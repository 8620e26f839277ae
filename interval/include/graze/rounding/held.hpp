#pragma once
/// `held<B>`: the operations of B for code whose caller holds a scope of B.
#include <graze/rounding/backend.hpp>

namespace graze::rounding {

/// The same operations with an empty scope: inner loops set no mode.
template <GRAZE_BACKEND B> struct held : B {
  struct scope {
    scope() {}
  };
};

namespace detail {
template <class B> struct held_once {
  using type = held<B>;
};
template <class B> struct held_once<held<B>> {
  using type = held<B>;
};
} // namespace detail
/// held<B>, and held<B> itself for held<B>.
template <GRAZE_BACKEND B> using held_once = typename detail::held_once<B>::type;

} // namespace graze::rounding
