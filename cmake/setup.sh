# Sourced by ./run and ./check: installs Debian's packages and builds a preset.

graze_packages=(
  g++ cmake ninja-build
  libboost-dev libmpfr-dev libgmp-dev catch2 librapidcheck-dev libopenimageio-dev
  libcli11-dev libfmt-dev nlohmann-json3-dev libbenchmark-dev libtbb-dev
  clang-19 libclang-rt-19-dev
)

# The build fetches third-party sources with cargo (cmake/elementary_sources.cmake): 1.85 or newer,
# for the edition that they are written in. Debian 12's own package `cargo` is older than that.
graze_has_cargo() {
  local version cargo
  for cargo in cargo "$HOME/.cargo/bin/cargo"; do
    version=$("$cargo" --version 2>/dev/null | sed -n 's/^cargo \([0-9]*\.[0-9]*\).*/\1/p') || true
    [[ -n $version ]] && printf '1.85\n%s\n' "$version" | sort -C -V && return 0
  done
  return 1
}

# Installs what dpkg does not have; does nothing, at once, when all is there.
graze_install() {
  local missing=() package
  graze_has_cargo || missing+=(cargo-web)
  for package in "$@" "${graze_packages[@]}"; do
    dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null | grep -q '^installed$' ||
      missing+=("$package")
  done
  ((${#missing[@]})) || return 0
  echo "installing: ${missing[*]}"
  local as_root=()
  if ((EUID != 0)); then
    command -v sudo >/dev/null || { echo "needs root or sudo to install: ${missing[*]}" >&2; exit 1; }
    as_root=(sudo)
  fi
  local log
  log=$(mktemp)
  if ! { "${as_root[@]}" apt-get update -q &&
         "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q \
           --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    echo "the packages could not be installed" >&2
    exit 1
  fi
  rm -f "$log"
}

# graze_build PRESET [CMAKE ARGUMENTS...]: configures and builds build/PRESET.
graze_build() {
  local preset=$1
  shift
  local log="build/$preset/configure.log"
  mkdir -p "build/$preset"
  cmake --preset "$preset" "$@" >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
  cmake --build --preset "$preset"
}
