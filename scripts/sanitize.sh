#!/usr/bin/env bash
# Builds the tests with the sanitizers of clang and runs them:
#   scripts/sanitize.sh [memory|threads]...      by default both
#     memory    AddressSanitizer, UndefinedBehaviorSanitizer and all invariants (ARGOS_CHECK_INVARIANTS), over all
#               tests, in build-memory/; uses of variables of functions that have returned are found in tests of
#               units and contracts only, because that search takes a quarter of the time
#     threads   ThreadSanitizer over the tests of threads and determinism, in build-threads/
# The configurations are the presets of these names in CMakePresets.json. Tests labelled soak are left out.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
if [[ "${1:-}" == -h || "${1:-}" == --help ]]; then
  sed -n '2,8s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi
if (($# == 0)); then
  set -- memory threads
fi
cd "$repo"

began() {
  say "$1 (after ${SECONDS} s)"
}

# the programs that have tests of threads or of determinism
thread_tests=(unit_thread_tests unit_demand_tests determinism_tests determinism_partition_tests)

# the options of the sanitizers, of the test presets
while IFS= read -r option; do
  # shellcheck disable=SC2016  # CMake's name for the folder
  export "${option//'${sourceDir}'/$repo}"
done < <(sed -nE 's/.*"([A-Z]+SAN_OPTIONS)": "([^"]*)".*/\1=\2/p' CMakePresets.json)
[[ -n "${ASAN_OPTIONS:-}" && -n "${TSAN_OPTIONS:-}" ]] || die "found no options of the sanitizers in CMakePresets.json"

for configuration in "$@"; do
  case "$configuration" in
    memory) programs=() ;;
    threads) programs=("${thread_tests[@]}") ;;
    *) die "unknown configuration '$configuration'; there are memory and threads" ;;
  esac
  began "Build with sanitizers ($configuration, in build-$configuration/)"
  configure "$repo/build-$configuration" --preset "$configuration"
  build "$repo/build-$configuration" ${programs[0]:+--target "${programs[@]}"}
  began "Tests with sanitizers ($configuration)"
  if [[ "$configuration" == memory ]]; then
    mapfile -t programs < <(cd "$repo/build-memory/bin" && printf '%s\n' *_tests)
    mapfile -t long < <(printf '%s\n' "${programs[@]}" | grep -E '^(scenario|determinism)_')
    ASAN_OPTIONS="$ASAN_OPTIONS:detect_stack_use_after_return=0" \
      "$repo/scripts/run_tests.sh" "$repo/build-memory" "${long[@]}"
    mapfile -t programs < <(printf '%s\n' "${programs[@]}" | grep -vE '^(scenario|determinism)_')
  fi
  "$repo/scripts/run_tests.sh" "$repo/build-$configuration" "${programs[@]}"
done
say "The sanitizers found nothing (after ${SECONDS} s)"
