#!/usr/bin/env bash
# Builds the fuzz targets in build-fuzz/ and runs them:
#   scripts/fuzz.sh [target [seconds]]      by default each target for 60 s
#     target   experiment, set, byte_array, lua, recording, or all
# The seeds and the dictionaries are in src/testing/fuzz/; new inputs go to build-fuzz/corpus/, which grows from run to
# run. An input that fails is written to build-fuzz/, and the script ends with status 1. An hour for each target:
#   scripts/fuzz.sh all 3600
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
if [[ "${1:-}" == -h || "${1:-}" == --help ]]; then
  sed -n '2,8s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi
cd "$repo"
all=(byte_array set lua recording experiment)
targets=("${1:-all}")
seconds="${2:-60}"
if [[ "${targets[0]}" == all ]]; then
  targets=("${all[@]}")
elif [[ " ${all[*]} " != *" ${targets[0]} "* ]]; then
  die "unknown target '${targets[0]}'; there are all, ${all[*]}"
fi

say "Build of the fuzz targets (in build-fuzz/)"
configure "$repo/build-fuzz" --preset fuzz
build "$repo/build-fuzz" --target "${targets[@]/#/fuzz_}"

export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1
export UBSAN_OPTIONS=print_stacktrace=1
for target in "${targets[@]}"; do
  say "Target $target, ${seconds} s (after ${SECONDS} s)"
  mkdir -p "build-fuzz/corpus/$target"
  (cd build-fuzz && "bin/fuzz_$target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 -max_len=4096 \
    -dict="$repo/src/testing/fuzz/$target.dict" -artifact_prefix="$target-" -print_final_stats=1 -verbosity=0 \
    "corpus/$target" "$repo/src/testing/fuzz/corpus/$target") || die "target $target failed; see the input named above"
done
say "The fuzzers found nothing (after ${SECONDS} s)"
