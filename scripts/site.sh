#!/usr/bin/env bash
# Makes the site: the user's guide and the other pages with mkdocs, the API reference of the installed headers with
# Doxygen, one search for both; a warning is an error:
#   scripts/site.sh [OUT]     site/ by default; needs what run.sh or test.sh has built in build/, or in BUILD_DIR
# To look at it: python3 -m http.server --directory site, then http://localhost:8000. The pages work as files, too, but
# browsers let only those of a server search.
set -euo pipefail
if [[ "${1:-}" == -h || "${1:-}" == --help ]]; then
  sed -n '2,6s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
out="${1:-$repo/site}"
for tool in doxygen mkdocs python3; do
  command -v "$tool" >/dev/null || die "there is no $tool; run: scripts/setup.sh site"
done
awesome=/usr/share/doxygen-awesome-css
[[ -d "$awesome" ]] || die "there is no $awesome; run: scripts/setup.sh site"
work="$(mktemp -d)"
trap 'rm -rf -- "$work"' EXIT
argos3="$release_build/bin/argos3"
[[ -x "$argos3" ]] || die "there is no $argos3; build it with scripts/run.sh"
prefix="$work/prefix"
cmake --install "$release_build" --prefix "$prefix" --component dev >/dev/null
[[ ! -e "$out" || -f "$out/search/search_index.json" ]] || die "$out exists and is no site; name another folder"

# quiet COMMAND...: its output only if it fails
quiet() {
  "$@" >"$work/log" 2>&1 || { sed "s|$work/||g" "$work/log" >&2; die "$1 failed, see above"; }
}

version="$(sed -n 's/^set(ARGOS_VERSION "\(.*\)")$/\1/p' "$prefix/share/argos3/cmake/ARGoSSettings.cmake")"
quiet python3 "$repo/scripts/site/stage_pages.py" "$repo" "$argos3" "$work/pages"

quiet python3 "$repo/scripts/site/stage_headers.py" "$prefix/include" "$work/include"
# a tab that leads back to the pages
(cd "$work" && doxygen -l layout.xml && sed -i \
  's|<tab type="mainpage" visible="yes" title=""/>|<tab type="user" url="../index.html" title="Guide"/>&|' layout.xml)
grep -q 'title="Guide"' "$work/layout.xml" || die "Doxygen's layout has no tab of the main page"
{
  cat "$repo/scripts/site/Doxyfile"
  echo "PROJECT_NUMBER=$version"
  echo "INPUT=$repo/scripts/site/groups.dox $work/include"
  echo "OUTPUT_DIRECTORY=$work/pages/docs/api"
  echo "LAYOUT_FILE=$work/layout.xml"
  echo "STRIP_FROM_PATH=$work/include"
  echo "STRIP_FROM_INC_PATH=$work/include"
  echo "HTML_EXTRA_STYLESHEET=$awesome/doxygen-awesome.css $repo/scripts/site/api.css"
  echo "GENERATE_TAGFILE=$work/api.tag"
} >"$work/Doxyfile"
mkdir "$work/pages/docs/api"
quiet doxygen "$work/Doxyfile"

quiet mkdocs build --quiet --strict --config-file "$work/pages/mkdocs.yml"
python3 "$repo/scripts/site/break_names.py" "$work/pages/site"
python3 "$repo/scripts/site/merge_search.py" "$work/api.tag" "$work/pages/site"
# with the Python of the packages, which has lunr
/usr/bin/python3 "$repo/scripts/site/check_questions.py" "$work/pages/site"
if command -v chromium >/dev/null; then
  python3 "$repo/scripts/site/check_widths.py" "$work/pages/site"
else
  echo "  the layout is not checked: there is no chromium"
fi
rm -rf -- "$out"
mkdir -p "$(dirname "$out")"
mv "$work/pages/site" "$out"
echo "  $(find "$out" -name '*.html' | wc -l) pages, $(du -sh "$out" | cut -f1), in $out"
