#!/usr/bin/env bash
# Runs the test programs of a build, many test cases in each process; ctest starts a process for each test case, which
# loads all plug-ins again:
#   scripts/run_tests.sh BUILD_FOLDER [PROGRAM]...     by default all test programs
# The output of a process is printed if it fails. A process that crashes names the test case in which it did, and runs
# none of the following ones; to run one test case alone: ctest --test-dir BUILD_FOLDER -R NAME
# Test cases labelled soak are left out: their tag hides them. A process that passed does not run again before one of its
# inputs changes (scripts/stamps.sh); ARGOS_CHECK_ALL=1 runs all.
set -euo pipefail
(($# > 0)) || { sed -n '2,9s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
build="$(cd "$1" && pwd)"
shift
source "$(dirname "${BASH_SOURCE[0]}")/stamps.sh"
size=25        # test cases of a process
time_limit=2400 # seconds for a process
work="$(mktemp -d)"
mkdir "$work/parts" "$work/stamps" "$work/logs" "$work/passed"
: >"$work/run"
: >"$work/times"

if (($# == 0)); then
  for program in "$build"/bin/*_tests; do
    [[ ! -x "$program" ]] || set -- "$@" "$(basename "$program")"
  done
fi
(($# > 0)) || die "no test programs in $build/bin; build $build first"

# Where built files are that test programs load or run. Nearly each of them loads all plug-ins, so it depends on all of them.
built=(bin lib experiments testing setup_env.sh)

# What each test program depends on. Of the repository that is what is not compiled, but for what no test reads, and a
# source that a test reads.
print_inputs() {
  print_system &&
    (print_repository scripts/run_tests.sh scripts/lib.sh scripts/stamps.sh) &&
    (print_repository . ':!src/*.cpp' ':!scripts' ':!*.md' ':!.*') &&
    (print_repository doc/robots doc/campaigns.md src/testing/compat/reference_file_test.cpp) &&
    (cd "$build" && find "${built[@]}" -type f ! -name '*_tests' -print0 | print_files)
}

programs=("$@")

# write_stamps FOLDER: writes for each process a file with the path of its stamp
write_stamps() {
  local part name
  mkdir -p "$1"
  print_inputs >"$work/inputs" && (cd "$build/bin" && sha256sum -- "${programs[@]}") >"$work/programs" || return
  for part in "$work"/parts/*; do
    name="$(basename "$part")"
    { cat "$work/inputs" "$part" && grep -- " ${name%.*}\$" "$work/programs"; } | stamp_of tests >"$1/$name" || return
  done
}

# Only processes whose inputs are the same at the end passed with these inputs.
remember_passed() {
  local passed part
  passed="$(ls "$work/passed")"
  [[ -n "$passed" && -d "$work/stamps" ]] && write_stamps "$work/stamps_now" || return 0
  for part in $passed; do
    ! cmp -s "$work/stamps/$part" "$work/stamps_now/$part" || note_passed "$(<"$work/stamps/$part")"
  done
}

# also after an interruption
trap 'remember_passed; rm -rf -- "$work"' EXIT

# for each process a file with the names of its test cases: <program>.<number>
for program in "$@"; do
  # Catch2 returns the number of test cases
  "$build/bin/$program" --list-test-names-only >"$work/names" || [[ -s "$work/names" ]] || die "$program lists no test cases"
  # a comma or a quote would end the name
  sed 's/[\\,"]/\\&/g' "$work/names" >"$work/escaped"
  split --lines="$size" --numeric-suffixes=1 --suffix-length=3 "$work/escaped" "$work/parts/$program."
done

prepare_stamps tests
write_stamps "$work/stamps" || {
  echo "what the tests depend on cannot be read, so all of them run"
  rm -rf -- "$work/stamps"
}

run_part() { # run_part <file with names>
  local part="$1" began="$SECONDS" program name status=0 expected log
  name="$(basename "$part")"
  program="${name%.*}"
  log="$work/logs/$name"
  expected="$(wc -l <"$part")"
  (cd "$build" && timeout --signal=ABRT "$time_limit" "bin/$program" --durations yes --input-file "$part") >"$log" 2>&1 || status=$?
  # names that match no test case are none of its failures
  if ((status == 0)) && ! grep -qE "^All tests passed \(.* in $expected test cases?\)" "$log"; then
    echo "not all of the $expected test cases ran" >>"$log"
    status=1
  fi
  if ((status != 0)); then
    grep -vE '^[0-9]+\.[0-9]{3} s: ' "$log"
    echo "$name failed with status $status"
    [[ ! -f "$work/stamps/$name" ]] || forget_passed "$(<"$work/stamps/$name")"
    return 1
  fi
  touch "$work/passed/$name"
  echo "$((SECONDS - began)) $name" >>"$work/times"
  echo "  $name: $expected test cases passed in $((SECONDS - began)) s"
}
export -f run_part forget_passed
export build time_limit work

# The parts that run, those first that took longest when they ran in this build; unknown ones of some programs are long.
list_by_time() {
  cat "$build/test_times" >"$work/last_times" 2>/dev/null || true
  awk 'FILENAME == ARGV[1] { time[$2] = $1; next }
    {
      name = $0
      sub(/.*\//, "", name)
      print (name in time ? time[name] : name ~ /^(determinism|scenario)/ ? 1000 : 0) " " $0
    }' "$work/last_times" "$work/run" | sort -k 1,1nr | cut -d' ' -f2-
}

remember_times() {
  awk '!seen[$2]++' "$work/times" "$work/last_times" >"$work/new_times"
  # at once, in case another run reads them; it does not matter if they cannot be written
  { cp "$work/new_times" "$build/test_times.$$" && mv "$build/test_times.$$" "$build/test_times"; } 2>/dev/null || true
}

print_slowest() {
  # Catch2 prints a time for each repetition
  { grep -shE '^[0-9]+\.[0-9]{3} s: ' "$work"/logs/* || true; } | awk '
    { time = $1; sub(/^[0-9.]+ s: /, ""); sum[$0] += time }
    END { for (name in sum) if (sum[name] >= 1) printf "%.1f s: %s\n", sum[name], name }' | sort -k 1,1nr >"$work/slowest"
  [[ ! -s "$work/slowest" ]] || echo "The slowest test cases and sections:"
  sed -n '1,20s/^/  /p' "$work/slowest"
}

cases=0
passed_before=0
for part in "$work"/parts/*; do
  name="$(basename "$part")"
  number="$(wc -l <"$part")"
  cases=$((cases + number))
  if [[ -f "$work/stamps/$name" ]] && has_passed "$(<"$work/stamps/$name")"; then
    passed_before=$((passed_before + number))
  else
    echo "$part" >>"$work/run"
  fi
done
((passed_before == 0)) || echo "$passed_before test cases passed before with the same inputs; ARGOS_CHECK_ALL=1 runs them, too"

failed=0
# Those that take longest come first, so that no core is idle at the end. Some wait for most of the time: one more process
# than cores.
# shellcheck disable=SC2016  # that shell expands it
list_by_time | tr '\n' '\0' | xargs -0 -r -n 1 -P $((jobs + 1)) bash -c 'run_part "$1"' run_part || failed=1
remember_times
((failed == 0)) || die "test cases failed, see above"
print_slowest
echo "$cases test cases passed"
