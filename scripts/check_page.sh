#!/usr/bin/env bash
# Checks the page of the live view: its types, its size, its decoder against argos3, and the page in a headless Chromium:
#   scripts/check_page.sh BUILD [TEST...]     by default all tests: decode, live, mock, page, tools, viewers
# BUILD is a build folder with bin/argos3 and the experiments. With PAGE_SHOTS=FOLDER the tests keep pictures of the page
# there. The tests "live", "tools" and "viewers" need a build with the live view. Needs npm, Node.js 18 or later and chromium, and a way to npm's packages, or these in npm's cache.
set -euo pipefail
(($# > 0)) || { sed -n '2,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
build="$(cd "$1" && pwd)"
shift
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
largest_page=400000 # bytes, compressed by gzip
for tool in npm node; do
  command -v "$tool" >/dev/null || die "there is no $tool; scripts/packages.txt names its package"
done
[[ -x "$build/bin/argos3" ]] || die "there is no bin/argos3 in $build"
work="$build/page_check"
# what the last check installed is kept while the lock file is the same
mkdir -p "$work"
find "$work" -mindepth 1 -maxdepth 1 ! -name node_modules ! -name installed -exec rm -rf -- {} +
find "$repo/src/plugins/visualizations/live/page" -mindepth 1 -maxdepth 1 ! -name node_modules ! -name dist ! -name out \
  -exec cp -r -t "$work" -- {} +
cd "$work"
if ! cmp -s package-lock.json installed; then
  npm ci --prefer-offline --ignore-scripts --no-audit --no-fund --loglevel=error
  cp package-lock.json installed
fi
npx --no-install tsc --noEmit
node build.mjs
size="$(gzip -9c dist/index.html | wc -c)"
((size <= largest_page)) || die "the page has $size bytes compressed, more than $largest_page"
echo "The page has $size bytes compressed, of at most $largest_page."
export ARGOS3="$build/bin/argos3" REPOSITORY="$repo" PAGE="$work/dist/index.html" REQUIRE_BROWSER=1
node test.mjs "$@"
