#!/usr/bin/env bash
# Runs a form of this study, and writes tables, figures, verdicts and a description of the machine:
#   studies/efficiency/run.sh [--no-run] short|reduced|full [FOLDER]
# Runs during which other programs kept more than a tenth of a processor busy are repeated, three times at most.
# FOLDER is results/FORM by default, and for the short form short.results. A form that was stopped (Ctrl-C) goes on where
# it was; --no-run only writes what there is so far. Needs gnuplot, python3 and argos3-campaign: installed, or built in
# build/ or build-ci/ or, with ARGOS_BUILD=FOLDER, elsewhere.
set -euo pipefail
study="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
repo="$(cd "$study/../.." && pwd)"

die() {
  printf 'run.sh: %s\n' "$*" >&2
  exit 1
}

usage() {
  sed -n '2,7s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
}

run=1
if [[ "${1:-}" == --no-run ]]; then
  run=0
  shift
fi
case "${1:-}" in
  short) results="$study/short.results" ;;
  reduced | full) results="$study/results/$1" ;;
  -h | --help)
    usage
    exit 0
    ;;
  *)
    usage >&2
    die "the form must be short, reduced or full; found \"${1:-}\""
    ;;
esac
form="$1"
results="$(realpath -m -- "${2:-$results}")"

# the build tree first: its libraries are those of this source tree
find_build() {
  local folder
  if [[ -n "${ARGOS_BUILD:-}" && ! -x "$ARGOS_BUILD/bin/argos3-campaign" ]]; then
    die "ARGOS_BUILD: there is no bin/argos3-campaign in \"$ARGOS_BUILD\""
  fi
  for folder in "${ARGOS_BUILD:-}" "$repo/build" "$repo/build-ci"; do
    if [[ -n "$folder" && -x "$folder/bin/argos3-campaign" ]]; then
      # shellcheck disable=SC1091  # made by the build
      source "$folder/setup_env.sh"
      return
    fi
  done
  command -v argos3-campaign >/dev/null ||
    die "there is no argos3-campaign in PATH, $repo/build or $repo/build-ci: build it, or set ARGOS_BUILD"
}

describe_machine() { # describe_machine <when begun> <load> <version of the sources>
  cat <<TEXT
# Machine

| | |
|---|---|
| processor | $(lscpu | sed -n 's/^Model name: *//p' | head -n 1) |
| processors | $(nproc) |
| memory | $(awk '/^MemTotal/ { printf "%.1f GiB", $2 / 1048576 }' /proc/meminfo) |
| system | $(uname -srm) |
| argos3 | $(argos3 --version | head -n 1) |
| sources | $3 |
| form | $form: \`$form.xml\` |
| begun | $1 |
| ended | $(date -u +%Y-%m-%dT%H:%MZ) |
| load before the first run | $2 |
TEXT
}

# what can be looked at without running anything
describe_results() {
  local figure name
  cat <<TEXT
# Results: the form $form

Made by \`run.sh $form\`, see [the study](${1}README.md). [Verdicts](verdicts.md) about the printed values of the thesis,
[machine](machine.md), \`runs.csv\`: each run. Bars are 95 % intervals of the means.
TEXT
  for figure in figures/*.svg; do
    name="$(basename "$figure" .svg)"
    printf '\n## %s\n\n![%s](%s)\n' "$name" "$name" "$figure"
  done
}

for program in gnuplot python3; do
  command -v "$program" >/dev/null || die "$program is not installed"
done
find_build
cd "$study"
load="$(cut -d ' ' -f 1 /proc/loadavg)"
if ((run)) && awk -v load="$load" 'BEGIN { exit !(load > 0.5) }'; then
  printf 'run.sh: warning: other programs use the processors (load %s): times will be too long\n' "$load" >&2
fi
began="$(date -u +%Y-%m-%dT%H:%MZ)"
# described before results are written, which are files of the sources and would count as changes
sources="$(git -C "$repo" -c safe.directory="$repo" describe --always --dirty 2>/dev/null || echo unknown)"
mkdir -p "$results/figures"
status=0
if ((run)); then
  # runs that have failed, 3, do not prevent results of the others
  argos3-campaign run "$form.xml" || status=$?
  ((status == 0 || status == 3)) || exit "$status"
  for _ in 1 2 3; do
    status=0
    argos3-campaign retry "$form.xml" --where "other_load > 0.1" || status=$?
    ((status == 0 || status == 3)) || exit "$status"
  done
fi
argos3-campaign report "$form.xml"
argos3-campaign export "$form.xml" --csv "$form.tables"
cp "$form.tables/runs.csv" "$results/runs.csv"
cp "$form.report/figures/"*.svg "$results/figures/"
if ((run)) || [[ ! -f "$results/machine.md" ]]; then
  describe_machine "$began" "$load" "$sources" >"$results/machine.md"
fi
PYTHONDONTWRITEBYTECODE=1 ./verdicts.py "$results/runs.csv" >"$results/verdicts.md"
(cd "$results" && describe_results "$(realpath --relative-to="$results" "$study")/") >"$results/README.md"
printf '%s: README.md, verdicts.md, machine.md, runs.csv, figures/; all of it as a page: %s\n' \
  "$results" "$study/$form.report/report.html"
exit "$status"
