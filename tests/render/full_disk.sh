#!/usr/bin/env bash
# full_disk.sh GRAZE_RENDER: on a file system that is full, graze-render says so in one line, ends with
# code 1, leaves an older picture as it was and nothing else. The file system is a tmpfs of 32 KiB in a
# mount namespace of this test's own; where that is not permitted the test is skipped (77).
set -euo pipefail
if [[ ${2-} != mounted ]]; then
  # root, anybody, root whose file system is no mount point (a chroot)
  for own in "unshare --mount" "unshare --mount --map-root-user" "unshare --mount --propagation unchanged"; do
    if $own true 2>/dev/null; then exec $own bash "$0" "$1" mounted; fi
  done
  echo "skipped: no mount namespaces here"
  exit 77
fi
disk=$(mktemp -d)
trap 'umount "$disk" 2>/dev/null; rmdir "$disk"' EXIT
mount -t tmpfs -o size=32k none "$disk" || { echo "skipped: no tmpfs here"; exit 77; }
echo "an older picture" >"$disk/a.exr"
code=0
said=$("$1" --scene spheres --size 200 -o "$disk/a.exr" 2>&1 >/dev/null) || code=$?
echo "exit code $code: $said"
[[ $code == 1 && $said != *$'\n'* && $said == *"cannot write"* ]]
[[ $(ls -A "$disk") == a.exr && $(<"$disk/a.exr") == "an older picture" ]]
