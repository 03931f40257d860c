#!/usr/bin/env bash
# Builds the projects of src/testing/compat/projects/ against an installed simulator, runs them and checks the numbers
# that they print or write:
#   scripts/outside_projects.sh PREFIX FOLDER [NAME]...     by default all projects
# Each project is copied to a new folder in FOLDER, configured and built in its folder build/, and checked by its check.sh,
# which is run there with argos3 of PREFIX in the PATH and these files and functions:
#   configure.log               what CMake said
#   expect WHAT FIELD VALUE TOLERANCE   fails unless that field of the last line of the input is VALUE +- TOLERANCE
set -euo pipefail
(($# > 1)) || { sed -n '2,8s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
prefix="$(cd "$1" && pwd)"
mkdir -p "$2"
work="$(cd "$2" && pwd)"
shift 2
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
projects="$repo/src/testing/compat/projects"
# projects that wait for a feature: leave them out unless they are named
waiting=()

if (($# == 0)); then
  for folder in "$projects"/*/; do
    name="$(basename "$folder")"
    [[ " ${waiting[*]} " == *" $name "* ]] || set -- "$@" "$name"
  done
fi

expect() { # expect WHAT FIELD VALUE TOLERANCE
  tail -n 1 | awk -v what="$1" -v field="$2" -v value="$3" -v tolerance="$4" '
    { found = $field }
    END {
      if (found !~ /^[-+]?[0-9]+\.?[0-9]*(e[-+]?[0-9]+)?$/ || found - value > tolerance || value - found > tolerance) {
        print what ": expected " value " +- " tolerance ", found \"" found "\""
        exit 1
      }
    }'
}

build_project() {
  export CMAKE_PREFIX_PATH="$prefix" PKG_CONFIG_PATH="$prefix/lib/pkgconfig" PATH="$prefix/bin:$PATH"
  if command -v ccache >/dev/null; then
    # paths relative to FOLDER's parent: if PREFIX is there too, what was compiled in another place need not be again
    CCACHE_BASEDIR="$(dirname "$work")"
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_NOHASHDIR=1 CCACHE_BASEDIR
  fi
  cmake -S . -B build >configure.log 2>&1 || { cat configure.log; return 1; }
  cmake --build build --parallel 1
}

check_project() { # check_project NAME: builds and checks one project
  local name="$1" folder="$work/$1" began="$SECONDS"
  rm -rf -- "$folder"
  cp -r "$projects/$name" "$folder"
  if ! (cd "$folder" && build_project && bash -euo pipefail check.sh) >"$folder.log" 2>&1; then
    cat "$folder.log"
    echo "the project $name failed, see above"
    return 1
  fi
  echo "  $name: built, ran and checked in $((SECONDS - began)) s"
}
export -f expect build_project check_project
export work prefix projects

failed=0
# shellcheck disable=SC2016  # that shell expands it
printf '%s\0' "$@" | xargs -0 -n 1 -P "$jobs" bash -c 'check_project "$1"' check_project || failed=1
((failed == 0)) || die "projects failed, see above"
echo "$# projects built against the installed simulator do what they should"
