#!/usr/bin/env bash
# Runs the test programs of a build, many test cases in each process; ctest starts a process for each test case, which
# loads all plug-ins again:
#   scripts/run_tests.sh BUILD_FOLDER [PROGRAM]...     by default all test programs
# The output of a process is printed if it fails. A process that crashes names the test case in which it did, and runs
# none of the following ones; to run one test case alone: ctest --test-dir BUILD_FOLDER -R NAME
# Test cases labelled soak are left out: their tag hides them.
set -euo pipefail
(($# > 0)) || { sed -n '2,8s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
build="$(cd "$1" && pwd)"
shift
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
size=25        # test cases of a process
time_limit=2400 # seconds for a process
work="$(mktemp -d)"
trap 'rm -rf -- "$work"' EXIT

if (($# == 0)); then
  for program in "$build"/bin/*_tests; do
    [[ ! -x "$program" ]] || set -- "$@" "$(basename "$program")"
  done
fi
(($# > 0)) || die "no test programs in $build/bin; build $build first"

# a file with the names of test cases for each process: <program>.<number>
for program in "$@"; do
  # Catch2 returns the number of test cases
  "$build/bin/$program" --list-test-names-only >"$work/names" || [[ -s "$work/names" ]] || die "$program lists no test cases"
  # a comma or a quote would end the name
  sed 's/[\\,"]/\\&/g' "$work/names" >"$work/escaped"
  split --lines="$size" --numeric-suffixes=1 --suffix-length=3 "$work/escaped" "$work/$program."
  rm "$work/names" "$work/escaped"
done

run_part() { # run_part <file with names>
  local part="$1" began="$SECONDS" program name status=0 expected
  name="$(basename "$part")"
  program="${name%.*}"
  expected="$(wc -l <"$part")"
  (cd "$build" && timeout --signal=ABRT "$time_limit" "bin/$program" --input-file "$part") >"$part.log" 2>&1 || status=$?
  # names that match no test case are none of its failures
  if ((status == 0)) && ! grep -qE "^All tests passed \(.* in $expected test cases?\)" "$part.log"; then
    echo "not all of the $expected test cases ran" >>"$part.log"
    status=1
  fi
  if ((status != 0)); then
    cat "$part.log"
    echo "$name failed with status $status"
    return 1
  fi
  echo "  $name: $expected test cases passed in $((SECONDS - began)) s"
}
export -f run_part
export build time_limit

cases="$(cat "$work"/*_tests.* | wc -l)"
failed=0
# the programs whose test cases take longest come first, so that no core is idle at the end
find "$work" -name 'determinism*_tests.*' -o -name 'scenario*_tests.*' | sort >"$work/order"
find "$work" -name '*_tests.*' | sort | grep -vxFf "$work/order" >"$work/rest" || true
# shellcheck disable=SC2016  # that shell expands it
cat "$work/order" "$work/rest" | tr '\n' '\0' | xargs -0 -n 1 -P "$jobs" bash -c 'run_part "$1"' run_part || failed=1
((failed == 0)) || die "test cases failed, see above"
echo "$cases test cases passed"
