#!/usr/bin/env bash
# Runs every command of doc/guide/ against an installed simulator, and compares every listing with its file, every output
# with the one that is shown, and every picture with the one that the commands have made:
#   scripts/check_guide.sh [--pictures] PREFIX [PAGE]...     by default all pages; --pictures makes the pages' pictures
# scripts/guide/check_pages.py says how pages mark their blocks, pictures.py how pictures are compared.
set -euo pipefail
(($# > 0)) || { sed -n '2,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
options=()
if [[ "$1" == --pictures ]]; then
  options=("$1")
  shift
fi
prefix="$(cd "$1" && pwd)"
shift
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
[[ -x "$prefix/bin/argos3" ]] || die "there is no bin/argos3 in $prefix"
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=include_file_mtime
fi
export PYTHONDONTWRITEBYTECODE=1
python3 "$repo/scripts/guide/test_check_pages.py"
python3 "$repo/scripts/guide/check_pages.py" "${options[@]}" "$repo" "$prefix" "$@"
