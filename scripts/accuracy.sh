#!/usr/bin/env bash
# Makes the tables in doc/internals/accuracy.md and the plot doc/images/accuracy.svg from doc/data/accuracy.csv, the output of
# argos3_accuracy_benchmark:
#   scripts/accuracy.sh             needs gnuplot (Debian: gnuplot-nox)
#   scripts/accuracy.sh --tables    only prints the tables; needs no gnuplot
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
csv="$repo/doc/data/accuracy.csv"
page="$repo/doc/internals/accuracy.md"
plot="$repo/doc/images/accuracy.svg"

# Definitions for awk: columns, and number formats with three digits and nothing below a thousandth.
# shellcheck disable=SC2016  # awk expands them
common='
  BEGIN { FS = "," }
  NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
  function field(name) { return $column[name] }
  function short(x) {
    if (x == "-") return "-"
    x += 0
    if (x == 0) return "0"
    if (x < 0.001) return "< 0.001"
    if (x < 0.1) return sprintf("%.3f", x)
    return sprintf(x < 10 ? "%.2f" : x < 100 ? "%.1f" : "%.0f", x)
  }
  function cost(world) {
    return field(world "_total_us") == "-" ? "-" : short(field(world "_total_us")) " (" short(field(world "_physics_us")) ")"
  }
  function isDefault() { return field("iterations") == "default" }
  function name() {
    return field("engine") (field("stepper") == "-" ? "" : " " field("stepper"))
  }
  # in crowds dynamics2d takes more than its minimum number of substeps
  function substeps(isInCrowd) {
    n = field("substeps")
    if (isDefault() && field("engine") == "dynamics2d" && isInCrowd) n = n " or more"
    return isDefault() ? "**" n "**" : n
  }
  function cell(text) { return text == "" ? "-" : text }
  # settings in the order of the file, numbers of robots separately
  function remember(key) {
    if (!(key in seen)) { seen[key] = 1; keys[++count] = key }
  }
'

free_table() {
  echo "| Engine | substeps | off its arc, mm | % of the path | rooms, N = 1,000: us | rooms, N = 10,000: us | touching, % | their overlap, maximum, % |"
  echo "|---|---|---|---|---|---|---|---|"
  awk "$common"'
    function keepMax(table, what) {
      if (field(what) != "-" && (!(key in table) || field(what) > table[key])) table[key] = field(what) + 0
    }
    {
      key = "| " name() " | " substeps(0)
      remember(key)
      arc[key] = short(field("arc_error_mm")) " | " short(field("arc_error_pct"))
      us[key, field("robots")] = cost("rooms")
      keepMax(touching, "rooms_touching_pct")
      keepMax(deepest, "rooms_overlap_max_pct")
    }
    END {
      for (i = 1; i <= count; ++i)
        print keys[i] " | " arc[keys[i]] " | " cell(us[keys[i], 1000]) " | " cell(us[keys[i], 10000]) " | " \
          (keys[i] in touching ? short(touching[keys[i]]) : "-") " | " (keys[i] in deepest ? short(deepest[keys[i]]) : "-") " |"
    }' "$csv"
}

crowd_table() { # crowd_table <robots>
  echo "| Engine | substeps | median, % | 99 %, % | maximum, % | in a wall, % | ticks | us |"
  echo "|---|---|---|---|---|---|---|---|"
  awk -v robots="$1" "$common"'
    field("robots") == robots && field("crowd_ticks") != "-" {
      print "| " name() " | " substeps(1) " | " short(field("crowd_overlap_median_pct")) " | " \
        short(field("crowd_overlap_p99_pct")) " | " short(field("crowd_overlap_max_pct")) " | " \
        short(field("crowd_wall_max_pct")) " | " field("crowd_ticks") " | " cost("crowd") " |"
    }' "$csv"
}

tables() {
  free_table
  for robots in 1000 10000; do
    printf '\n%s e-pucks in a crowd:\n\n' "${robots/%000/,000}"
    crowd_table "$robots"
  done
}

# points <world> <engine> <stepper>: cost, error, number of substeps, 1 for the default; by the number of substeps
points() {
  awk -v world="$1" -v engine="$2" -v stepper="$3" "$common"'
    BEGIN { x = (world == "arc" ? "rooms" : world) "_total_us"; y = world == "arc" ? "arc_error_pct" : "crowd_overlap_p99_pct" }
    field("robots") == 1000 && field("engine") == engine && field("stepper") == stepper && field(x) != "-" {
      print field(x), field(y) < 0.001 ? 0.001 : field(y), field("substeps"), isDefault()
    }' "$csv" | sort -n -k 3,3
}

draw() { # draw <folder>
  local world engine stepper
  for world in arc crowd; do
    for engine in kinematics2d pointmass3d; do
      points "$world" "$engine" - >"$1/${world}_$engine"
    done
    # the default of dynamics2d is a number of substeps
    points "$world" dynamics2d - | grep '0$' >"$1/${world}_dynamics2d" || true
    points "$world" dynamics2d - | sed -n 's/ [0-9]* 1$/ "2 to 64" 1/p' >"$1/${world}_adaptive"
    for stepper in mixed iterative; do
      points "$world" dynamics3d "$stepper" >"$1/${world}_$stepper"
    done
  done
  gnuplot -c "$repo/scripts/accuracy.gp" "$1" "$plot"
}

[[ -f "$csv" ]] || die "no $csv; doc/internals/accuracy.md says how to measure it"
case "${1:-}" in
  "") ;;
  --tables) tables; exit 0 ;;
  -h | --help) sed -n '2,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
  *) die "unknown argument '$1'; there is only --tables" ;;
esac
command -v gnuplot >/dev/null || die "gnuplot is missing; install it, for instance with: apt-get install gnuplot-nox"
work="$(mktemp -d)"
trap 'rm -rf -- "$work"' EXIT
tables >"$work/tables"
# between the two markers of the page
sed -i -e '/^<!-- tables: /,/^<!-- end of tables -->/{/^<!-- tables: /{r '"$work/tables"'
b};/^<!-- end of tables -->/b;d}' "$page"
draw "$work"
echo "wrote $page and $plot"
