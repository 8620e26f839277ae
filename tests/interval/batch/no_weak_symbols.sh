#!/bin/sh
# no_weak_symbols.sh OBJECT...: no function of a file compiled for AVX may be one that the linker can
# take for a caller elsewhere (weak, as inline functions are).
status=0
for object in "$@"; do
  weak=$(nm "$object" | grep -E ' [Ww] ')
  if [ -n "$weak" ]; then
    echo "$object:"
    echo "$weak"
    status=1
  fi
done
exit $status
