#!/usr/bin/env bash
# Installs missing packages, builds the simulator and runs an experiment, without a display:
#   scripts/run.sh [EXPERIMENT [ARGUMENTS OF argos3...]]
# EXPERIMENT is an .argos file, by default experiments/diffusion_10.argos, searched in the current folder and in the
# repository. The simulator runs in the current folder: frames are written under its out/. It is built in build/ of the
# repository, or where BUILD_DIR says, with warnings as errors on the compiler of Debian 12.
#   scripts/run.sh experiments/diffusion_10.argos --seed 7 --threads 2
#   scripts/run.sh experiments/diffusion_10.argos --live     in a web browser; installs and builds what that needs
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

experiment="experiments/diffusion_10.argos"
if (($# > 0)) && [[ "$1" == -h || "$1" == --help ]]; then
  sed -n '2,8s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
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
marks=(run)
for argument in "$@"; do
  [[ "$argument" != --live && "$argument" != --live=* ]] || marks=(run live)
done
"$repo/scripts/setup.sh" "${marks[@]}"

say "Build (Release, in ${release_build#"$repo"/}/)"
if [[ "$(sed -n 's/^ARGOS_BUILD_TESTING:BOOL=//p' "$release_build/CMakeCache.txt" 2>/dev/null)" != ON ]]; then
  # as test.sh with the compiler for which it is made; with others, a warning stops no run
  werror=OFF
  [[ "$(c++ --version 2>/dev/null | head -n 1)" != *"Debian 12."* ]] || werror=ON
  configure_release "$release_build" -DARGOS_BUILD_TESTING=OFF -DARGOS_WERROR="$werror"
fi
# a build that was configured before Boost and npm were there looks for them again
if ((${#marks[@]} > 1)) && [[ ! -f "$release_build/share/argos3/live/index.html" ]]; then
  cmake "$release_build" >/dev/null
fi
build "$release_build" --target run

say "Run $experiment"
mkdir -p out
before="$(mktemp)"
trap 'rm -f "$before"' EXIT
status=0
"$release_build/bin/argos3" -c "$experiment" "$@" || status=$?
((status == 0)) || die "argos3 ended with exit code $status"

last="$(find out -type f -newer "$before" -printf '%T@ %p\n' | sort -n | tail -n 1 | cut -d ' ' -f 2-)"
if [[ -n "$last" ]]; then
  say "Written"
  find out -type f -newer "$before" -printf '%h\n' | sort | uniq -c | while read -r count folder; do
    echo "$count file(s) in $PWD/$folder"
  done
  echo "The last one: $PWD/$last"
fi

say "Next"
here="$(realpath --relative-to="$PWD" "$release_build")"
[[ "$here" != ../../* ]] || here="$release_build"
echo ". $here/setup_env.sh            # puts argos3, argos3-campaign and argos3-plot into the PATH of this shell"
echo "argos3 -zc $(realpath --relative-to="$PWD" "$repo/experiments")/pheromone.argos --video pheromone.mp4 --speed 25"
hints=()
for tool in ffmpeg:films gnuplot:plots; do
  command -v "${tool%:*}" >/dev/null || hints+=("${tool%:*} (for ${tool#*:})")
done
((${#hints[@]} == 0)) || printf 'Not installed: %s; sudo apt-get install ffmpeg gnuplot-nox\n' "$(printf '%s, ' "${hints[@]}" | sed 's/, $//')"
echo "The guide: $repo/doc/guide/index.md; to install: sudo cmake --install $here"
