#pragma once
/// graze::support::status: done, or allowed; or the one-line reason why not.
#include <graze/expected.hpp>

namespace graze {

/// The form of graze::expected that has no value to give.
template <> class [[nodiscard]] expected<void> {
public:
  expected() = default;
  expected(unexpected why) : refused_(true), reason_(std::move(why.reason)) {}

  [[nodiscard]] bool has_value() const { return !refused_; }
  explicit operator bool() const { return has_value(); }

  /// Why not; empty when all is well.
  [[nodiscard]] const std::string& reason() const { return reason_; }

private:
  bool refused_ = false;
  std::string reason_;
};

namespace support {
using status = expected<void>;
} // namespace support

} // namespace graze
