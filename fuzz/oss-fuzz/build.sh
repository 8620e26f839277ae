#!/bin/bash -eu
# Builds the fuzz targets into $OUT, each with its seeds; for OSS-Fuzz and ClusterFuzzLite, which set
# CC CXX CFLAGS CXXFLAGS LIB_FUZZING_ENGINE OUT SRC WORK. Works without their containers, too:
#   SRC=<folder that holds graze> OUT=... WORK=... CC=clang-19 CXX=clang++-19 \
#     CFLAGS="-O1 -fsanitize=address,fuzzer-no-link" CXXFLAGS="$CFLAGS" \
#     LIB_FUZZING_ENGINE=-fsanitize=fuzzer fuzz/oss-fuzz/build.sh [TARGET...]
targets=("$@")
((${#targets[@]})) || targets=(fuzz)

# The images' C++ library is libc++, which Debian's libfmt is not built for: fmt as headers, and no
# library that nothing is taken from. Libraries that the runner does not have go with the targets.
export CXXFLAGS="$CXXFLAGS -DFMT_HEADER_ONLY"
if [[ $CXXFLAGS == *-stdlib=libc++* ]]; then
  CXXFLAGS+=" -fexperimental-library" # std::jthread, before libc++ 20
fi
sources=()
if [[ -d $SRC/sources ]]; then # fetched with the image
  sources=(-DCORE_MATH_SOURCE_DIR="$SRC/sources/core-math-sys-1.4.0/vendor")
fi
cmake -S "$SRC/graze" -B "$WORK/build" -G Ninja -DGRAZE_BUILD_TESTS=OFF -DGRAZE_WITH_CRLIBM=OFF \
  -DGRAZE_FUZZING_ENGINE="$LIB_FUZZING_ENGINE" "${sources[@]}" \
  -DCMAKE_EXE_LINKER_FLAGS=-Wl,--as-needed -DCMAKE_BUILD_RPATH='$ORIGIN/lib' >"$WORK/configure.log" ||
  { cat "$WORK/configure.log"; exit 1; }
cmake --build "$WORK/build" --target "${targets[@]/%/_targets}"

mkdir -p "$OUT/lib"
for target in "$WORK"/build/bin/*_target; do
  name=$(basename "$target" _target)
  cp "$target" "$OUT/"
  ldd "$target" | awk '$3 ~ /lib(mpfr|gmp|gmpxx|z)\.so/ {print $3}' | xargs -r cp -Lt "$OUT/lib"
  rm -rf "$WORK/seeds"
  "$WORK/build/bin/${name}_replay" --seeds "$WORK/seeds"
  if [[ -d $SRC/graze/fuzz/corpus/$name ]]; then
    cp "$SRC/graze/fuzz/corpus/$name"/* "$WORK/seeds/"
  fi
  rm -f "$OUT/${name}_target_seed_corpus.zip"
  (cd "$WORK/seeds" && zip -q "$OUT/${name}_target_seed_corpus.zip" ./*)
done
