#pragma once
/// graze::expected<T>: a value, or the one-line reason why there is none.
#include <graze/needs_cxx20.hpp>

#include <cassert>
#include <optional>
#include <string>
#include <utility>

namespace graze {

/// The reason of a refused construction; one line, without a full stop, fit to be printed.
struct unexpected {
  std::string reason;
};

/// Holds a T or a reason. Numerics never throw: whoever constructs looks first.
template <class T> class expected {
public:
  expected(T value) : value_(std::move(value)) {}
  expected(unexpected why) : reason_(std::move(why.reason)) {}

  [[nodiscard]] bool has_value() const { return value_.has_value(); }
  explicit operator bool() const { return has_value(); }

  const T& operator*() const& { return assert(value_), *value_; }
  T& operator*() & { return assert(value_), *value_; }
  T&& operator*() && { return assert(value_), *std::move(value_); }
  const T* operator->() const { return assert(value_), &*value_; }
  T* operator->() { return assert(value_), &*value_; }

  /// Why there is no value; empty when there is one.
  [[nodiscard]] const std::string& reason() const { return reason_; }

private:
  std::optional<T> value_;
  std::string reason_;
};

} // namespace graze
