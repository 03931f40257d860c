#!/usr/bin/env bash
# Compares the digests of the experiments in src/testing/digests.txt with the pinned ones:
#   scripts/digests.sh BUILD_FOLDER           fails if a digest differs
#   scripts/digests.sh BUILD_FOLDER --pin         writes the digests of this build into the file
#   scripts/digests.sh BUILD_FOLDER --any-build   compares those of another compiler, build type or level of optimization
# Digests are pinned for one compiler and build type, which the file names: another build is compared only on request.
set -euo pipefail
(($# > 0)) || { sed -n '2,6s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
build="$(cd "$1" && pwd)"
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
mode="${2:-compare}"
[[ "$mode" == compare || "$mode" == --pin || "$mode" == --any-build ]] ||
  die "unknown argument '$mode'; there are --pin and --any-build"
cd "$repo"
pinned="src/testing/digests.txt"
export ARGOS_PLUGIN_PATH="$build/experiments"

describe_build() {
  local compiler id version type
  compiler="$(cat "$build"/CMakeFiles/*/CMakeCXXCompiler.cmake)"
  id="$(sed -n 's/^set(CMAKE_CXX_COMPILER_ID "\(.*\)")$/\1/p' <<<"$compiler")"
  version="$(sed -n 's/^set(CMAKE_CXX_COMPILER_VERSION "\([0-9]*\).*")$/\1/p' <<<"$compiler")"
  type="$(sed -n 's/^CMAKE_BUILD_TYPE:[A-Z]*=//p' "$build/CMakeCache.txt")"
  echo "$id $version $type $(uname -m)"
}

compute() { # compute <arguments of argos3>: prints the digest
  local output words
  read -ra words <<<"$1"
  output="$(cd "$work" && "$build/bin/argos3" "${words[@]}" 2>&1)" || die "argos3 $1 failed:" "$output"
  sed -n 's/^digest: //p' <<<"$output" | grep -E '^[0-9a-f]{16}$' || die "argos3 $1 printed no digest:" "$output"
}

this_build="$(describe_build)"
pinned_build="$(sed -n 's/^build: //p' "$pinned")"
if [[ "$mode" == compare && "$this_build" != "$pinned_build" ]]; then
  echo "digests: not compared; they are pinned for '$pinned_build', and $build is '$this_build'"
  exit 0
fi

differences=0
# experiments write their data into the current folder
work="$(mktemp -d)"
trap 'rm -rf -- "$work"' EXIT
ln -s "$repo/experiments" "$repo/src" "$work"
new="$work/digests.txt"
while IFS= read -r line; do
  if [[ "$line" == build:* ]]; then
    line="build: $this_build"
  elif [[ "$line" =~ ^([0-9a-f]+)\ +(.+)$ ]]; then
    expected="${BASH_REMATCH[1]}"
    arguments="${BASH_REMATCH[2]}"
    digest="$(compute "$arguments")"
    line="$digest  $arguments"
    if [[ "$digest" != "$expected" ]]; then
      differences=$((differences + 1))
      echo "  argos3 $arguments: the digest is $digest, pinned is $expected"
    fi
  elif [[ -n "$line" && "$line" != \#* ]]; then
    die "$pinned: '$line' is neither '<digest> <arguments of argos3>' nor 'build: <compiler>'"
  fi
  printf '%s\n' "$line" >>"$new"
done <"$pinned"

if [[ "$mode" == --pin ]]; then
  cat "$new" >"$pinned"
  echo "digests: $pinned is pinned for '$this_build'; $differences changed"
elif ((differences > 0)) && [[ "$mode" == --any-build ]]; then
  die "$differences of the digests of '$this_build' differ from those pinned for '$pinned_build'"
elif ((differences > 0)); then
  die "$differences of the pinned digests differ: the simulation behaves differently. If that is" \
    "intended, say why in the commit and run: scripts/digests.sh ${build#"$repo"/} --pin"
elif [[ "$mode" == --any-build ]]; then
  echo "digests: those of '$this_build' are equal to those pinned for '$pinned_build'"
else
  echo "digests: as pinned for '$this_build'"
fi
