#!/bin/sh
# processes.sh KIND BIN LIBRARY: the programs of BIN in a process that began in another environment,
# or on a machine that is emulated. Exit code 0 if they are right or refuse in one line.
kind=$1 bin=$2 library=$3

fails() {
  echo "processes.sh $kind: $*" >&2
  exit 1
}

# refuses LINE... : the command's only line, on stderr, with exit code 2
refuses() {
  output=$("$@" 2>&1 >/dev/null)
  code=$?
  [ $code = 2 ] || fails "$* exits with $code, not 2"
  [ "$(printf '%s\n' "$output" | grep -c .)" = 1 ] || fails "$* does not say why in one line: $output"
  printf '%s\n' "$output" | grep -q 'does not round as it is told' || fails "$* says: $output"
}

case $kind in
preloaded)
  [ -e "$library" ] || fails "no $library"
  began=$(LD_PRELOAD=$library "$bin/graze-environments" --found --thinning 499) || fails "$began"
  case $began in
  *'began as a program should'*)
    echo "graze: skipped, this gcc links nothing into a library that sets FTZ and DAZ"
    exit 0
    ;;
  esac
  echo "$began"
  if [ -x "$bin/graze-fuzz" ]; then
    LD_PRELOAD=$library "$bin/graze-fuzz" run --traversal sound --rays 40000 --seed 3 --threads 2 ||
      fails "graze-fuzz run finds something"
    subjects=$("$bin/graze-fuzz" self --list | awk '/^[a-z]/ {print $1}')
    [ -n "$subjects" ] || fails "graze-fuzz names no subject of self"
    for subject in $subjects; do
      LD_PRELOAD=$library "$bin/graze-fuzz" self "$subject" --trials 3000 ||
        fails "graze-fuzz self $subject finds something"
    done
  fi
  ;;
valgrind)
  if ! command -v valgrind >/dev/null; then
    echo "graze: skipped, valgrind is not installed"
    exit 0
  fi
  refuses valgrind -q "$bin/graze-environments"
  [ ! -x "$bin/graze-fuzz" ] || refuses valgrind -q "$bin/graze-fuzz" list
  ;;
qemu)
  if ! command -v qemu-x86_64 >/dev/null; then
    echo "graze: skipped, qemu-x86_64 is not installed"
    exit 0
  fi
  # it rounds as told, or is refused
  qemu-x86_64 -cpu max "$bin/graze-environments" --thinning 49999 ||
    refuses qemu-x86_64 -cpu max "$bin/graze-environments"
  ;;
*)
  fails "unknown kind"
  ;;
esac
