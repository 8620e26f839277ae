# Sourced by ./run and ./check: installs Debian's packages and builds a preset.

graze_packages=(
  gcc g++ cmake ninja-build make
  libboost-dev libmpfr-dev libgmp-dev catch2 librapidcheck-dev libopenimageio-dev
  libtbb-dev zlib1g-dev libcli11-dev libfmt-dev nlohmann-json3-dev libbenchmark-dev
  clang-19 libclang-rt-19-dev
  coq libcoq-flocq ocaml-nox ocaml-findlib libzarith-ocaml-dev gappa
  python3 python3-venv python3-distributed
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

# Installs what dpkg does not have; does nothing, at once, when all is there.
graze_install() {
  local missing=() package
  for package in "${graze_packages[@]}" $(graze_cargo_package); do
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
