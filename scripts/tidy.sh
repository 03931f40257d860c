#!/usr/bin/env bash
# Runs clang-tidy:
#   scripts/tidy.sh BUILD_FOLDER           on files changed since the merge base with origin/main; on everything if there
#                                          is no merge base, or with CI=true
#   scripts/tidy.sh BUILD_FOLDER --all     on everything but tests
#   scripts/tidy.sh BUILD_FOLDER --tests   on the tests
#   scripts/tidy.sh BUILD_FOLDER FILE...   on these files
# Everything is checked several times faster in a unity build of clang, as continuous integration does: in build-memory/, once
# it is built. Files are checked in any other build: each unit of g++ without a precompiled header, so it must include the
# headers of the standard library that it needs. A changed header is checked through its own source, or through one that
# includes it. A unit that passed is not checked again until its preprocessed text, .clang-tidy, scripts/tidy/ or
# clang-tidy changes, see scripts/stamps.sh; ARGOS_CHECK_ALL=1 checks all units.
set -euo pipefail
(($# > 0)) || { sed -n '2,14s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
build="$(cd "$1" && pwd)"
shift
source "$(dirname "${BASH_SOURCE[0]}")/stamps.sh"
cd "$repo"
database="$build/compile_commands.json"
[[ -f "$database" ]] || die "no $database; configure $build first"
mapfile -t compiled < <(sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' "$database" | sort -u)

changed_files() {
  if [[ "${CI:-}" == true ]]; then
    return 1
  fi
  local base
  base="$(git merge-base HEAD origin/main 2>/dev/null)" || return 1
  git diff --name-only --diff-filter=d "$base" -- 'src' 'experiments' 'examples'
  git ls-files --others --exclude-standard -- 'src' 'experiments' 'examples'
}

by_source() {
  [[ "${compiled[*]}" != */Unity/* ]] || die "$build compiles several sources at once, so that only all can be checked: --all;" \
    "for single files configure, without building, a folder for sources one by one: cmake -G Ninja --preset ci, in build-ci/"
}

units=()
unit_of() { # unit_of <file>: the translation unit through which a file is checked
  local file="$1" candidate
  case "$file" in
    *.cpp) candidate="$repo/$file" ;;
    *.h)
      candidate="$repo/${file%.h}.cpp"
      [[ -f "$candidate" ]] || candidate="$(printf '%s\0' "${compiled[@]}" |
        xargs -0 grep -lE "^ *# *include *[<\"].*/$(basename "$file")[>\"]" | head -n 1 || true)"
      ;;
    *) return 0 ;;
  esac
  # not grep -q, which would leave printf with a broken pipe
  if printf '%s\n' "${compiled[@]}" | grep -xF -- "$candidate" >/dev/null; then
    units+=("$candidate")
  fi
}

if (($# > 0)) && [[ "$1" != --all && "$1" != --tests ]]; then
  by_source
  for file in "$@"; do
    unit_of "${file#"$repo"/}"
  done
  echo "tidy: ${#units[@]} unit(s) for the files given"
elif (($# == 0)) && changed="$(changed_files)"; then
  by_source
  while IFS= read -r file; do
    [[ -z "$file" ]] || unit_of "$file"
  done <<<"$changed"
  echo "tidy: ${#units[@]} unit(s) changed since the merge base with origin/main"
else
  wanted=other
  [[ "${1:-}" != --tests ]] || wanted="test"
  for file in "${compiled[@]}"; do
    kind=other
    [[ "$file" != */src/testing/* ]] || kind="test"
    [[ "$kind" == "$wanted" ]] || continue
    case "$file" in
      "$repo"/src/* | "$repo"/experiments/* | */Unity/*) units+=("$file") ;;
    esac
  done
  echo "tidy: ${#units[@]} units"
fi
((${#units[@]} > 0)) || exit 0

# Names in public headers follow ARGoS 3's API, in several styles; clang-tidy takes the style of a name from the
# .clang-tidy nearest to its file, which for headers is that of the build's links to them.
mkdir -p "$build/include"
printf "Checks: '-*'\n" >"$build/include/.clang-tidy"

# the compile commands without precompiled headers of g++, which clang-tidy cannot read
tidy="$build/tidy"
mkdir -p "$tidy"
sed -E -e 's/ -(Winvalid-pch|fpch-preprocess)//g' -e 's/ -include [^ ]*cmake_pch.hxx//' "$database" >"$tidy/compile_commands.json"

# The checks of scripts/tidy/ need the headers of clang-tidy. Without them the other checks run, slower, and the names
# of ours in .clang-tidy have no effect.
plugin="$tidy/argos_checks.so"
plugin_source="scripts/tidy/argos_checks.cpp"
llvm="$(clang-tidy --version | sed -n 's/.*LLVM version \([0-9]*\).*/\1/p')"
llvm_include="/usr/lib/llvm-$llvm/include"
load=()
if [[ -f "$llvm_include/clang-tidy/ClangTidyCheck.h" ]] && command -v clang++ >/dev/null; then
  if [[ ! "$plugin" -nt "$plugin_source" ]]; then
    clang++ -std=c++17 -O1 -fPIC -shared -fno-rtti -Wall -I"$llvm_include" -D_GNU_SOURCE -D__STDC_CONSTANT_MACROS \
      -D__STDC_FORMAT_MACROS -D__STDC_LIMIT_MACROS -o "$plugin" "$plugin_source"
  fi
  load=(-load "$plugin")
elif [[ "${CI:-}" == true ]]; then
  die "no $llvm_include/clang-tidy; install libclang-dev"
else
  echo "tidy: includes are not checked; that needs clang++ and libclang-dev"
fi

prepare_stamps tidy
rules="$({ cat .clang-tidy "$plugin_source" && clang-tidy --version; } | sha256sum | cut -d' ' -f1)"
export stamps tidy repo build rules
export load_plugin="${load[*]}"

check_one() {
  local unit="$1" number="$2" command key
  # the unit's own compile command, turned into a preprocessor run
  command="$(grep -B2 -F "\"file\": \"$unit\"" "$tidy/compile_commands.json" | sed -n 's/^ *"command": "\(.*\)",$/\1/p' |
    head -n 1 | sed -e 's/\\"/"/g' -e 's/\\\\/\\/g' -e 's/ -o [^ ]*//' -e 's/ -c / -E -P -C /')"
  # names of files in messages of assertions are those of this checkout
  key="$(set -o pipefail; cd "$build" && { eval "$command" 2>/dev/null | sed "s|$repo/||g" || echo "$RANDOM$RANDOM"; echo "$rules"; } |
    sha256sum | cut -d' ' -f1)"
  ! has_passed "$stamps/tidy/$key" || return 0
  echo "  $number ${unit#"$repo"/}"
  # the compiler's own warnings are checked by the build; unneeded includes are reported only
  local load
  read -ra load <<<"$load_plugin"
  # a unit of a unity build includes sources
  [[ "$unit" != */Unity/* ]] || load+=(--checks=-bugprone-suspicious-include)
  clang-tidy "${load[@]}" --quiet -p "$tidy" --warnings-as-errors='*,-argos-includes' --extra-arg=-Wno-everything "$unit" 2> >(
    grep -vE '^[0-9]+ warnings? (generated|treated)|^Suppressed|^Use -header-filter' >&2) || { forget_passed "$stamps/tidy/$key"; return 1; }
  note_passed "$stamps/tidy/$key"
}
export -f check_one has_passed note_passed forget_passed

list_units() {
  local unit number=0
  printf '%s\n' "${units[@]}" | sort -u | while IFS= read -r unit; do
    number=$((number + 1))
    printf '%s\0%s\0' "$unit" "$number/${#units[@]}"
  done
}

failed=0
# shellcheck disable=SC2016  # that shell expands them
list_units | xargs -0 -r -n 2 -P "$jobs" bash -c 'check_one "$1" "$2"' tidy || failed=1
((failed == 0)) || die "clang-tidy found something, see above"
