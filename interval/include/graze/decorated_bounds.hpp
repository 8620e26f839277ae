#pragma once
/// Bounds with a decoration (IEEE 1788-2015, clause 11), without policies: what compiled functions
/// take and give. graze::decorated<Backend> (decorated.hpp) is the type for users' code.
#include <graze/needs_cxx20.hpp>

#include <graze/bounds.hpp>
#include <graze/decoration.hpp>

namespace graze {

/// A set and what is known of how it came to be. Kept by new_dec and set_dec (construct.hpp) and by
/// every operation: `ill` is NaI alone, whose part is empty; the empty set is `trv`; `com` is
/// bounded.
struct decorated_bounds {
  bounds part;
  decoration label;

  static constexpr decorated_bounds nai() { return {bounds::empty(), decoration::ill}; }
  [[nodiscard]] constexpr bool is_nai() const { return label == decoration::ill; }
};

} // namespace graze
