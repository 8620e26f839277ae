#!/usr/bin/env bash
# make.sh GRAZE_RENDER: the pictures of docs/view.md, by the commands of its table.
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "$0")"
S=$(sed -n 's/^    S="\(.*\)"$/\1/p' ../view.md)
grep -o '`graze-render \$S [^`]*`' ../view.md | tr -d '`' | while read -r _ _ options; do
  "$program" $S $options
done
