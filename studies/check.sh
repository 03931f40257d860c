#!/usr/bin/env bash
# Runs the reduced form of a study, and tests whether it still has its main properties:
#   studies/check.sh NAME [PREFIX]
# PREFIX is where the simulator is installed; without it, the installation whose bin/ is in the PATH is used.
# The study is copied and built as a user would do it. The runs have fixed seeds, so the result is always the same.
set -euo pipefail
(($# == 1 || $# == 2)) || { sed -n '2,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
studies="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
name="$1"
[[ -f "$studies/$name/reduced.xml" ]] || { printf 'check.sh: there is no %s\n' "$studies/$name/reduced.xml" >&2; exit 2; }
cmake_options=()
if (($# == 2)); then
  prefix="$(cd "$2" && pwd)"
  PATH="$prefix/bin:$PATH"
  cmake_options=("-DCMAKE_PREFIX_PATH=$prefix")
fi
work="$(mktemp -d)"
trap 'rm -rf -- "$work"' EXIT

# without what a user's runs and builds have left
mkdir "$work/$name"
cp "$studies"/*.py "$work"
tar -C "$studies/$name" --exclude=./build --exclude=./results --exclude='*.sqlite*' --exclude='*.runs' --exclude='*.report' \
  --exclude='*.tables' -c . | tar -C "$work/$name" -x
cd "$work/$name"
if [[ -f CMakeLists.txt ]]; then
  { cmake -S . -B build -DCMAKE_BUILD_TYPE=Release "${cmake_options[@]}" && cmake --build build --parallel "$(nproc)"; } \
    >build.log 2>&1 || { cat build.log >&2; exit 1; }
fi
tables=()
for campaign in reduced*.xml; do
  argos3-campaign run "$campaign" --quiet
  argos3-campaign export "$campaign" --csv "${campaign%.xml}.tables"
  tables+=("${campaign%.xml}.tables/runs.csv")
done
PYTHONDONTWRITEBYTECODE=1 ./verdicts.py --test "${tables[@]}"
