#!/usr/bin/env bash
# Installs missing packages, builds the simulator and runs an experiment, without a display:
#   scripts/run.sh [EXPERIMENT [ARGUMENTS OF argos3...]]
# EXPERIMENT is an .argos file, by default experiments/diffusion_10.argos, searched in the current folder and in the
# repository. The simulator runs in the current folder: frames are written under its out/.
#   scripts/run.sh experiments/diffusion_10.argos --seed 7 --threads 2
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

experiment="experiments/diffusion_10.argos"
if (($# > 0)) && [[ "$1" == -h || "$1" == --help ]]; then
  sed -n '2,6s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi
if (($# > 0)) && [[ "$1" != -* ]]; then
  experiment="$1"
  shift
fi
if [[ ! -f "$experiment" ]]; then
  [[ -f "$repo/$experiment" ]] || die "no file '$experiment', neither in $PWD nor in $repo; there are:" \
    "$(cd "$repo" && printf '%s ' experiments/*.argos)"
  experiment="$repo/$experiment"
fi

say "Packages"
"$repo/scripts/setup.sh"

say "Build (Release, in build/)"
configure "$repo/build" -DCMAKE_BUILD_TYPE=Release -DARGOS_BUILD_TESTING=OFF
build "$repo/build"

say "Run $experiment"
mkdir -p out
before="$(mktemp)"
trap 'rm -f "$before"' EXIT
status=0
"$repo/build/bin/argos3" -c "$experiment" "$@" || status=$?
((status == 0)) || die "argos3 ended with exit code $status"

written="$(find out -type f -newer "$before" -printf '%h\n' | sort | uniq -c)"
if [[ -n "$written" ]]; then
  say "Written"
  while read -r count folder; do
    echo "$count file(s) in $PWD/$folder"
  done <<<"$written"
fi
