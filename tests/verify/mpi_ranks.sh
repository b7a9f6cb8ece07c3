#!/bin/bash
# What MPI's ranks find together is what one process finds, also when one of them was killed and the job begun again:
#   tests/verify/mpi_ranks.sh [build folder, default build] [mpiexec]
set -euo pipefail
build=$(realpath "${1:-$(dirname "$0")/../../build}") mpiexec=${2:-mpiexec}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
audit=(audit I1 I3 --points 60000 --quiet --json --no-times)
# Open MPI wants to be told that cores may be shared; others have no such option.
ranks=("$mpiexec" -n 3)
"$mpiexec" --version | grep -q "Open MPI\|OpenRTE" && ranks+=(--oversubscribe)
lines() { cat run/shard-*.jsonl 2>/dev/null | wc -l; }

"$build/verify/nipref" "${audit[@]}" >alone.json
"${ranks[@]}" "$build/verify/nipref-mpi" "${audit[@]}" >together.json
cmp alone.json together.json

"${ranks[@]}" "$build/verify/nipref-mpi" "${audit[@]}" --out run >killed.json 2>killed.txt &
job=$!
until (($(lines) >= 2)); do sleep 0.02; done
kill -9 "$(pgrep -f "nipref-mpi ${audit[*]} --out run" -P "$(pgrep -d, -f "$mpiexec.*--out run")" | tail -1)"
if wait $job; then
  echo "the job outlived its rank"
  exit 1
fi
kept=$(lines)
"${ranks[@]}" "$build/verify/nipref-mpi" "${audit[@]}" --out run >resumed.json
cmp alone.json resumed.json
echo "killed with $kept blocks there, $(lines) in all"
((kept < $(lines)))
