#pragma once
// Included first by every header that needs C++20, so that an older standard is told once.
#if __cplusplus <= 201703L
#error                                                                                             \
    "graze: this header needs C++20 (-std=c++20); <graze/boost_rounding.hpp> and <graze/boost_functions.hpp> serve C++17"
#include <graze needs C++20 for this header> // does not exist: ends the compilation
#endif
