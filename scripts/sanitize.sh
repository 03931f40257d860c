#!/usr/bin/env bash
# Builds the tests with the sanitizers of clang and runs them:
#   scripts/sanitize.sh [memory|threads]...      by default both
#     memory    AddressSanitizer, UndefinedBehaviorSanitizer and all invariants (ARGOS_CHECK_INVARIANTS), over all
#               tests, in build-memory/
#     threads   ThreadSanitizer over the tests of threads and determinism, in build-threads/
# The configurations are the presets of these names in CMakePresets.json. Tests labelled soak are left out.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
if [[ "${1:-}" == -h || "${1:-}" == --help ]]; then
  sed -n '2,7s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi
if (($# == 0)); then
  set -- memory threads
fi
cd "$repo"

began() {
  say "$1 (after ${SECONDS} s)"
}

# the programs that have tests of threads or of determinism, and what these load when they run
thread_tests=(unit_thread_tests determinism_tests determinism_partition_tests)

for configuration in "$@"; do
  case "$configuration" in
    memory) targets=() selection=() ;;
    threads) targets=(--target "${thread_tests[@]}") selection=(--label-regex '^(threads|determinism)$') ;;
    *) die "unknown configuration '$configuration'; there are memory and threads" ;;
  esac
  began "Build with sanitizers ($configuration, in build-$configuration/)"
  configure "$repo/build-$configuration" --preset "$configuration"
  build "$repo/build-$configuration" "${targets[@]}"
  began "Tests with sanitizers ($configuration)"
  ctest --preset "$configuration" --parallel "$jobs" --progress "${selection[@]}"
done
say "The sanitizers found nothing (after ${SECONDS} s)"
