#pragma once
/// Subjects that are not lists of interval operations, each from a file of its own.
#include <graze/fuzz/self/subject.hpp>

namespace graze::fuzz::self {} // namespace graze::fuzz::self
