#!/bin/sh
# cxx17_headers.sh COMPILER BOOST FOLDER...: in C++17 each header compiles by itself, or the first
# thing that is said is that it needs C++20, and little after it.
set -u
compiler=$1 boost=$2
shift 2
include="-I$boost"
for folder; do include="$include -I$folder"; done
refused=0 fine=0 bad=0
for folder; do
  for header in $(cd "$folder" && find . -name '*.hpp' | sed 's,^[.]/,,' | sort); do
    case $header in
    graze/needs_cxx20.hpp) continue ;;
    graze/boost_functions_of_bound.hpp) continue ;; # a piece of boost_functions.hpp
    esac
    if output=$(echo "#include <$header>" | $compiler -std=c++17 -fsyntax-only $include -x c++ - 2>&1); then
      fine=$((fine + 1))
    elif echo "$output" | grep error: | head -n 1 | grep -q 'this header needs C++20' &&
         [ "$(echo "$output" | grep -c error:)" -le 2 ]; then
      refused=$((refused + 1))
    else
      bad=$((bad + 1))
      echo "$header:" && echo "$output" | grep error: | head -n 3
    fi
  done
done
echo "$fine headers serve C++17, $refused say that they need C++20, $bad do neither"
[ $bad -eq 0 ] && [ $fine -ge 5 ] && [ $refused -gt 0 ]
