#!/usr/bin/env bash
# Runs every command of doc/guide/ against an installed simulator, and compares every listing with its file and every
# output with the one that is shown:
#   scripts/check_guide.sh PREFIX [PAGE]...     by default all pages
# scripts/guide/check_pages.py says how pages mark their blocks.
set -euo pipefail
(($# > 0)) || { sed -n '2,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
prefix="$(cd "$1" && pwd)"
shift
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
[[ -x "$prefix/bin/argos3" ]] || die "there is no bin/argos3 in $prefix"
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=include_file_mtime
fi
export PYTHONDONTWRITEBYTECODE=1
python3 "$repo/scripts/guide/test_check_pages.py"
python3 "$repo/scripts/guide/check_pages.py" "$repo" "$prefix" "$@"
