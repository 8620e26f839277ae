#pragma once
/// `held<B>`: the operations of B for code whose caller holds a scope of B.
#include <graze/rounding/backend.hpp>

namespace graze::rounding {

/// The same operations with an empty scope: inner loops set no mode.
template <Backend B> struct held : B {
  struct scope {
    scope() {}
  };
};

} // namespace graze::rounding
