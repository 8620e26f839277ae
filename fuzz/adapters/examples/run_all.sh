#!/bin/sh
# Compiles the examples where there is a compiler, and asks each about some thousand tame rays:
#
#   run_all.sh GRAZE_FUZZ [python javascript c rust go java]
#
# segments.go is exact: nothing may be found. The others are as they are usually written, and wrong by a
# rounding: they must be found to miss, and nothing else (no crash, no answer that is none, no hint that
# the ray was another).
set -u
fuzz=$1
shift
here=$(cd "$(dirname "$0")" && pwd)
d=$(mktemp -d)
trap 'rm -rf "$d"' EXIT
failed=0

# NAME LANGUAGE TOOL EXPECTED-EXIT-CODE BUILD COMMAND OPTIONS
try() {
  name=$1 tool=$3 expected=$4 build=$5 command=$6 options=$7
  case " $languages " in *" $2 "*) ;; *) return ;; esac
  if ! command -v "$tool" > /dev/null; then
    echo "$name: skipped, no $tool"
    return
  fi
  if ! (cd "$d" && eval "$build") > "$d/log" 2>&1; then
    echo "$name: does not compile"
    cat "$d/log"
    failed=1
    return
  fi
  "$fuzz" run --command "cd '$d' && $command" --tame --rays 20000 --seconds 20 --threads 2 --timeout 10 \
    --no-shrink --json $options > "$d/out" 2> "$d/err"
  code=$?
  if [ $code -ne "$expected" ] || ! grep -q '"faults": 0,' "$d/out" || ! grep -q '"hint": null' "$d/out" ||
    [ -s "$d/err" ]; then
    echo "$name: exit code $code where $expected is right; said:"
    cat "$d/err"
    grep -m 3 -E '"(faults|hint|finding)":' "$d/out"
    failed=1
  else
    echo "$name: $(sed -n 's/^  "rays": \([0-9]*\),.*/\1/p' "$d/out" | head -n 1) rays," \
      "$(sed -n 's/^  "rays_with_finding": \([0-9]*\),.*/\1/p' "$d/out" | head -n 1) wrong, as is right"
  fi
}

languages=${*:-python javascript c rust go java}
try amanatides_woo.py python python3 1 : "python3 '$here/amanatides_woo.py'" "--level 10"
try octree_slabs.mjs javascript node 1 : "node '$here/octree_slabs.mjs'" "--level 10"
try slabs.c c "${CC:-cc}" 1 "${CC:-cc} -O2 -o slabs '$here/slabs.c'" ./slabs "--level 10"
try first_hit.rs rust rustc 1 "rustc -O -o first_hit '$here/first_hit.rs'" ./first_hit ""
try segments.go go go 0 "go build -o segments '$here/segments.go'" ./segments ""
try FirstVoxel.java java javac 1 "javac -d . '$here/FirstVoxel.java'" "java -cp . FirstVoxel" ""
exit $failed
