#!/usr/bin/env bash
# Runs clang-tidy:
#   scripts/tidy.sh BUILD_FOLDER           on files changed since the merge base with origin/main; on everything if
#                                          there is no merge base, or with CI=true
#   scripts/tidy.sh BUILD_FOLDER --all     on everything
#   scripts/tidy.sh BUILD_FOLDER FILE...   on these files
# A changed header is checked through its own source, or through the unit that compiles it alone. A unit that passed is
# not checked again until its preprocessed text or .clang-tidy changes.
set -euo pipefail
(($# > 0)) || { sed -n '2,8s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
build="$(cd "$1" && pwd)"
shift
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
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

units=()
unit_of() { # unit_of <file>: the translation unit through which a file is checked
  local file="$1" candidate
  case "$file" in
    *.cpp) candidate="$repo/$file" ;;
    *.h)
      candidate="$repo/${file%.h}.cpp"
      [[ -f "$candidate" ]] || candidate="$(printf '%s\n' "${compiled[@]}" |
        grep -E "^$build/header_checks/.*/$(basename "$file")\.cpp$" | head -n 1 || true)"
      ;;
    *) return 0 ;;
  esac
  # not grep -q, which would leave printf with a broken pipe
  if printf '%s\n' "${compiled[@]}" | grep -xF -- "$candidate" >/dev/null; then
    units+=("$candidate")
  fi
}

if (($# > 0)) && [[ "$1" != --all ]]; then
  for file in "$@"; do
    unit_of "${file#"$repo"/}"
  done
  echo "tidy: ${#units[@]} unit(s) for the files given"
elif (($# == 0)) && changed="$(changed_files)"; then
  while IFS= read -r file; do
    [[ -z "$file" ]] || unit_of "$file"
  done <<<"$changed"
  echo "tidy: ${#units[@]} unit(s) changed since the merge base with origin/main"
else
  for file in "${compiled[@]}"; do
    # tests are checked when they change; all of them would take continuous integration too long
    case "$file" in
      "$repo"/src/testing/*) ;;
      "$repo"/src/* | "$repo"/experiments/*) units+=("$file") ;;
    esac
  done
  echo "tidy: all ${#units[@]} units"
fi
((${#units[@]} > 0)) || exit 0

# Names in public headers follow ARGoS 3's API, in several styles; clang-tidy takes the style of a name from the
# .clang-tidy nearest to its file, which for headers is that of the build's links to them.
mkdir -p "$build/include"
printf "Checks: '-*'\n" >"$build/include/.clang-tidy"

stamps="$build/tidy_passed"
mkdir -p "$stamps"
export stamps build repo
rules="$(sha256sum .clang-tidy | cut -d' ' -f1)"
export rules

check_one() {
  local unit="$1" number="$2" command key
  # the unit's own compile command, turned into a preprocessor run
  command="$(grep -B2 -F "\"file\": \"$unit\"" "$build/compile_commands.json" | sed -n 's/^ *"command": "\(.*\)",$/\1/p' |
    head -n 1 | sed -e 's/\\"/"/g' -e 's/\\\\/\\/g' -e 's/ -o [^ ]*//' -e 's/ -c / -E -P -C /')"
  key="$(cd "$build" && { eval "$command" 2>/dev/null || echo "$RANDOM$RANDOM"; echo "$rules"; } | sha256sum | cut -d' ' -f1)"
  if [[ -f "$stamps/$key" ]]; then
    return 0
  fi
  echo "  $number ${unit#"$repo"/}"
  # the compiler's own warnings are checked by the build
  clang-tidy --quiet -p "$build" --warnings-as-errors='*' --extra-arg=-Wno-everything "$unit" 2> >(
    grep -vE '^[0-9]+ warnings? (generated|treated)|^Suppressed|^Use -header-filter' >&2) || return 1
  : >"$stamps/$key"
}
export -f check_one

number=0
failed=0
for unit in $(printf '%s\n' "${units[@]}" | sort -u); do
  number=$((number + 1))
  printf '%s\0%s\0' "$unit" "$number/${#units[@]}"
done | xargs -0 -r -n 2 -P "$jobs" bash -c 'check_one "$1" "$2"' tidy || failed=1
((failed == 0)) || die "clang-tidy found something, see above"
