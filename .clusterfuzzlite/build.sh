#!/bin/bash -eu
exec "$SRC/graze/fuzz/oss-fuzz/build.sh" "$@"
