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

run_in_work() { # run_in_work PROGRAM ARGUMENT...: prints what the program prints
  (cd "$work" && "$build/bin/$1" "${@:2}" 2>&1) || die "$* failed"
}

# stands for gnuplot: keeps its scripts and data, and writes pictures of nothing
install_gnuplot() {
  mkdir "$work/bin" "$work/out" "$work/kept"
  cat >"$work/bin/gnuplot" <<EOF
#!/bin/sh
cp -- *.gp *.dat "$work/out"
sed -n "s/^set output '\\(.*\\)'.*/\\1/p" "\$2" | while read -r picture; do echo '<svg></svg>' >"\$picture"; done
EOF
  chmod +x "$work/bin/gnuplot"
  export PATH="$work/bin:$PATH"
}

# prints the digest of the final state, and of the files in out/, which go to kept/ then
compute() { # compute <arguments of argos3>, <campaign FILE> or <plot ARGUMENT...>
  local output words digest files
  read -ra words <<<"$1"
  rm -rf -- "$work/out"
  mkdir "$work/out"
  if [[ "${words[0]}" == plot ]]; then
    output="$(run_in_work argos3-plot "${words[@]:1}")" || die "$output"
  elif [[ "${words[0]}" == campaign ]]; then
    output="$(run_in_work argos3-campaign run "${words[1]}" && run_in_work argos3-campaign report "${words[1]}" -o out &&
      run_in_work argos3-campaign export "${words[1]}" --csv out --json out/all.json)" || die "$output"
  else
    output="$(run_in_work argos3 "${words[@]}")" || die "$output"
  fi
  digest="$(sed -n 's/^digest: \([0-9a-f]\{16\}\)$/\1/p' <<<"$output")"
  # not runs.csv, which has times, nor pictures, which depend on other programs
  files="$(cd "$work" && find out -regex '.*[.]\(csv\|dat\|gp\|html\|json\|pov\|ppm\)' ! -name runs.csv 2>/dev/null | LC_ALL=C sort)" || true
  if [[ "$files" ]]; then
    # versions, times and the memory that was used are no results
    digest="$({
      echo "$digest" "$files"
      cd "$work" && xargs sed -E -e '/^# argos3 /d; /<svg/,/<\/svg>/d; /runs from /d; / time of all /d; / MiB</d' \
        -e 's/"(id|start_up|wall|cpu|total_wall|memory|started|machine|version)": [^,]*//g' <<<"$files"
    } | sha256sum | cut -c 1-16)"
    cp -r "$work/out/." "$work/kept"
  fi
  if [[ ! "$digest" && "$1" =~ ^(-q|--schema|--generate)\  ]]; then
    # without paths of this checkout and versions
    output="${output//"$build"/}"
    digest="$(grep -vE '20[0-9]{2}[.-]' <<<"${output//"$repo"/}" | sha256sum | cut -c 1-16)"
  fi
  echo "${digest:?"$1: neither a digest was printed nor a file written into out/"}"
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
# a campaign writes beside its file
cp "$repo"/src/testing/scenes/campaign/* "$work"
install_gnuplot
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
      echo "  $arguments: the digest is $digest, pinned is $expected"
    fi
  elif [[ -n "$line" && "$line" != \#* ]]; then
    die "$pinned: '$line' is neither '<digest> <arguments of argos3>', '<digest> campaign <file>' nor 'build: <compiler>'"
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
