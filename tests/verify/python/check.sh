#!/usr/bin/env bash
# Checks that the wheel of a build serves a stranger: in an empty venv, without a network, beside the system's NumPy.
#   check.sh BUILD_FOLDER
set -euo pipefail
build=$(cd "$1" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
for python in python3 /usr/bin/python3 ""; do
  [ -n "$python" ] || { echo "skipped: no python3 has NumPy and venv (Debian: python3-numpy python3-venv)"; exit 0; }
  "$python" -c 'import ensurepip, numpy, venv' 2>/dev/null && break
done
nice cmake --build "$build" --target wheel >"$build/wheel.log" || { cat "$build/wheel.log"; exit 1; }
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
"$python" -m venv --system-site-packages "$room/venv"
"$room/venv/bin/pip" install --quiet --no-index --disable-pip-version-check "$build"/wheel/nipref-*.whl
cd "$room"
export PYTHONDONTWRITEBYTECODE=1
unset NIPREF_DATA NIPREF_KERNEL_HOST LD_LIBRARY_PATH
venv/bin/nipref --version >version
grep -q '^nipref ' version
venv/bin/python "$here/test_nipref.py"
for notebook in "$here"/../../../verify/python/notebooks/*.py; do
  echo "$notebook"
  venv/bin/python "$notebook"
done
