# Sourced by ./run, ./check and bench/graze-report: installs Debian's packages and builds a preset.

graze_packages=(
  gcc g++ cmake ninja-build make
  libboost-dev libmpfr-dev libgmp-dev catch2 librapidcheck-dev libopenimageio-dev libpng-dev
  libtbb-dev zlib1g-dev libminizip-dev libcli11-dev libfmt-dev nlohmann-json3-dev libbenchmark-dev libxtensor-dev
  clang-19 libclang-rt-19-dev clang-format-19
  coq libcoq-flocq ocaml-nox ocaml-findlib libzarith-ocaml-dev gappa
  python3 python3-venv python3-distributed python3-matplotlib python3-mpmath
)

# What bench/graze-report measures besides, and draws with. Each is optional: what cannot be installed is
# named on the report's page.
graze_report_packages=(
  povray
  libcgal-dev libmpfi-dev libflint-dev libflint-arb-dev
  # those of the list of peers
  $(sed -n 's/^graze_peer_library([^ ]* \([^ ]*\) .*/\1/p' "$(dirname "${BASH_SOURCE[0]}")/../fuzz/peers/CMakeLists.txt")
)

# Cargo fetches the pinned sources of CORE-MATH and CRlibm. Debian's own cargo (1.65) is too old for
# the registry's protocol (1.68) and for the edition of the crates (1.85); its package cargo-web is not.
graze_cargo_package() {
  local cargo
  cargo=$(command -v cargo || true)
  [[ -n $cargo || ! -x $HOME/.cargo/bin/cargo ]] || cargo=$HOME/.cargo/bin/cargo
  [[ -n $cargo && $("$cargo" --version) =~ ^cargo\ 1\.([0-9]+) && ${BASH_REMATCH[1]} -ge 85 ]] ||
    echo cargo-web
}

graze_missing() { # PACKAGE...: those that dpkg does not have
  local package
  for package; do
    dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null | grep -q '^installed$' || echo "$package"
  done
}

# Installs what dpkg does not have; does nothing, at once, when all is there.
graze_install() {
  local missing
  mapfile -t missing < <(graze_missing "${graze_packages[@]}" $(graze_cargo_package))
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

# graze_install_optional PACKAGE...: installs what it can of the packages, all at once or else one by
# one, and names the others; never fails.
graze_install_optional() {
  local missing absent as_root=() package log
  missing=$(graze_missing "$@")
  [[ -n $missing ]] || return 0
  echo "installing, if possible:" $missing
  if ((EUID != 0)); then
    command -v sudo >/dev/null || { echo "needs root or sudo: goes on without" $missing >&2; return 0; }
    as_root=(sudo)
  fi
  log=$(mktemp)
  local get=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends)
  "${as_root[@]}" apt-get update -q >"$log" 2>&1 || true
  if ! "${get[@]}" $missing >>"$log" 2>&1; then
    for package in $missing; do
      "${get[@]}" "$package" >>"$log" 2>&1 || true
    done
  fi
  absent=$(graze_missing "$@")
  if [[ -n $absent ]]; then
    tail -n 3 "$log" >&2
    echo "could not be installed, and will be named as missing:" $absent >&2
  fi
  rm -f "$log"
}

# Installs the SMT solvers, pinned and by hash, in build/solvers; at once when they are there. Without
# them the tests that ask them count as skipped.
graze_install_solvers() {
  local pinned=proofs/smt/requirements.txt venv=build/solvers
  cmp -s "$pinned" "$venv/requirements.txt" && return 0
  echo "installing: the SMT solvers of $pinned"
  mkdir -p build
  rm -rf "$venv"
  local log=build/solvers.log
  if /usr/bin/python3 -m venv "$venv" >"$log" 2>&1 &&
     "$venv/bin/pip" install --disable-pip-version-check --require-hashes --only-binary :all: \
       -r "$pinned" >>"$log" 2>&1; then
    cp "$pinned" "$venv/requirements.txt"
  else
    tail -n 5 "$log" >&2
    echo "the SMT solvers could not be installed: their tests count as skipped" >&2
  fi
}

# graze_build PRESET [TARGET...]: configures and builds build/PRESET, all of it by default. In CI
# (where CI is set) warnings are errors.
graze_build() {
  local preset=$1
  shift
  local log="build/$preset/configure.log"
  mkdir -p "build/$preset"
  cmake --preset "$preset" ${CI:+-DGRAZE_WERROR=ON} >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
  cmake --build --preset "$preset" ${1:+--target "$@"}
}

# graze_build_some PRESET TARGET...: as graze_build, without the targets that this configuration does
# not have (their library is missing). One that fails to compile does not stop the others, and no older
# program of its name is left to be measured.
graze_build_some() {
  local preset=$1 target wanted=()
  shift
  mkdir -p "build/$preset"
  graze_build "$preset" help >"build/$preset/targets.txt"
  for target; do
    if grep -q "^$target: phony\$" "build/$preset/targets.txt"; then
      wanted+=("$target")
    else
      echo "not built here: $target"
    fi
  done
  ((${#wanted[@]})) || return 0
  cmake --build --preset "$preset" --target "${wanted[@]}" -- -k 0 && return 0
  for target in "${wanted[@]}"; do
    cmake --build --preset "$preset" --target "$target" >/dev/null 2>&1 && continue
    echo "could not be built: $target" >&2
    rm -f "build/$preset/bin/$target"
  done
}
