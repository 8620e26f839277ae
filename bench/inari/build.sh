#!/usr/bin/env bash
# build.sh FOLDER: makes FOLDER/release/libgraze_inari.so by cargo; where that cannot be done,
# FOLDER/missing.txt says why in a line. Ends with 0 either way: inari is one peer of many.
set -uo pipefail
script_dir=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
folder=$1
mkdir -p "$folder"
rm -f "$folder/missing.txt"
left_out() {
  rm -f "$folder/release/libgraze_inari.so"
  echo "$1" >"$folder/missing.txt"
  echo "inari is left out: $1"
  exit 0
}
cargo=$(command -v cargo || true)
[[ -n $cargo || ! -x $HOME/.cargo/bin/cargo ]] || cargo=$HOME/.cargo/bin/cargo
[[ -n $cargo ]] || left_out "cargo is not here"
# inari wants AVX2 and FMA at compile time; the programs that load it ask the processor first
RUSTFLAGS="-C target-cpu=haswell" "$cargo" build --quiet --release --locked \
  --manifest-path "$script_dir/Cargo.toml" --target-dir "$folder" >"$folder/build.log" 2>&1 ||
  left_out "cargo could not build it: $(grep -m 1 '^error' "$folder/build.log")"
