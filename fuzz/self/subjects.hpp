#pragma once
/// Subjects that are not lists of interval operations, each from a file of its own.
#include <self/subject.hpp>

namespace graze::fuzz::self {

#if defined(__x86_64__)
subject control_words_subject();
#endif

} // namespace graze::fuzz::self
