#!/bin/sh
# The bits of a double, copied into a 64-bit integer, shifted left by one and compared with 0: an
# integer computation, and the usual way to ask for a zero where floating-point comparisons are not to
# be trusted. clang turns it into a floating-point comparison with 0 (cmpeqsd or ucomisd), which says
# "equal" for a subnormal number where the thread takes subnormal operands for zero (DAZ, as every
# process does that has loaded a library linked with gcc -Ofast). A test for the least exponent
# field, of the same integer, stays an integer test.
#
# With -frounding-math, by which a function may not take the default environment for granted, it does not.
set -eu
d=$(mktemp -d)
trap 'rm -rf "$d"' EXIT
case $(uname -m) in x86_64) ;; *) echo "skipped: x86-64 only"; exit 0 ;; esac
python3 -m venv "$d/venv"
"$d/venv/bin/pip" -q install ziglang==0.14.1
cat > "$d/zero.c" <<'EOF'
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <xmmintrin.h>
static uint64_t bits(double x) { uint64_t b; memcpy(&b, &x, sizeof b); return b; }
__attribute__((noinline)) int is_zero(double x) { return bits(x) << 1 == 0; }
__attribute__((noinline)) int has_least_exponent(double x) { return bits(x) << 1 >> 53 == 0; }
int main(void) {
  volatile double least = 0x1p-1074, one = 1;
  for (int daz = 0; daz < 2; ++daz) {
    _mm_setcsr(daz ? 0x1fc0 : 0x1f80);
    int z = is_zero(least), e = has_least_exponent(least), o = is_zero(one);
    _mm_setcsr(0x1f80);
    printf("DAZ %s: bits of 2^-1074 shifted are 0: %d; exponent field 0: %d; of 1: %d\n",
           daz ? "on" : "off", z, e, o);
  }
}
EOF
cc="$d/venv/bin/python -m ziglang cc"
export ZIG_GLOBAL_CACHE_DIR="$d/cache" ZIG_LOCAL_CACHE_DIR="$d/cache"
$cc --version | head -n 1
for flags in "-O0" "-O2" "-O2 -frounding-math"; do
  $cc $flags -fno-sanitize=undefined -o "$d/zero" "$d/zero.c"
  echo "$flags:"
  "$d/zero" | tee "$d/out$(echo "$flags" | tr -d ' ')"
done
right="DAZ on: bits of 2^-1074 shifted are 0: 0; exponent field 0: 1; of 1: 0"
wrong="DAZ on: bits of 2^-1074 shifted are 0: 1; exponent field 0: 1; of 1: 0"
grep -qx "$right" "$d/out-O0"
grep -qx "$wrong" "$d/out-O2"
grep -qx "$right" "$d/out-O2-frounding-math"
