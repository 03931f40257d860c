#!/usr/bin/env bash
# Builds the examples of the first day against an installed simulator, as users do, runs them and checks their results:
#   scripts/examples.sh PREFIX [NAME]...     by default all of them
# Expected numbers are closed forms, or follow from the experiment by hand.
set -euo pipefail
(($# > 0)) || { sed -n '2,4s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
prefix="$(cd "$1" && pwd)"
shift
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
work="$(mktemp -d)"
trap 'rm -rf -- "$work"' EXIT
(($# > 0)) || set -- first_controller own_sensor own_medium own_robot own_engine_addon embedding evolution

# near WHAT FOUND WANTED TOLERANCE
near() {
  awk -v what="$1" -v found="$2" -v wanted="$3" -v tolerance="$4" 'BEGIN {
    if (found !~ /^[-+]?[0-9]+\.?[0-9]*(e[-+]?[0-9]+)?$/ || found - wanted > tolerance || wanted - found > tolerance) {
      print what ": expected " wanted " +- " tolerance ", found \"" found "\""
      exit 1
    }
  }'
}

# cell FILE TICK ROBOT COLUMN: a number of a table
cell() {
  awk -F, -v tick="$2" -v robot="$3" -v name="$4" '
    /^#/ { next }
    !column { for (i = 1; i <= NF; ++i) if ($i == name) column = i; next }
    $2 == tick && $4 == robot { print $column }' "$1"
}

rows() { # rows FILE: those of a table, without the comments at its head
  grep -v '^#' "$1"
}

# on_threads FILE EXPERIMENT: the table FILE is the same if two threads share the robots one by one
on_threads() {
  mv "$1" one_thread.csv
  sed 's/<framework>/<framework><system threads="2" grain="1" \/>/' "$2" >on_threads.argos
  argos3 -zc on_threads.argos
  cmp <(rows "$1") <(rows one_thread.csv)
}

check_first_controller() {
  argos3 -zc first_controller.argos --csv cpp
  argos3 -zc first_controller_lua.argos --csv lua
  cmp <(rows cpp/robots.csv) <(rows lua/robots.csv)
  # straight on at 10 cm/s, from the second tick on, but for a tenth of a tick; later it has turned away from the walls
  near "way after 3 s" "$(cell cpp/robots.csv 30 fb x)" 0.289 1e-9
  rows cpp/robots.csv | awk -F, '
    NR > 1 { if (NR > 2) way += sqrt(($5 - x) ^ 2 + ($6 - y) ^ 2); x = $5; y = $6; if ($8 < -1.5) turned = 1 }
    NR > 1 && (x > 0.85 || x < -0.85 || y > 0.85 || y < -0.85) { print "left the walls"; exit 1 }
    END { if (way < 3 || !turned) { print "drove " way " m, turned: " turned; exit 1 } }'
}

check_own_sensor() {
  argos3 -zc own_sensor.argos
  # from a heading of -60 degrees north is 150 degrees to the left; at the end it is ahead
  local robot
  for robot in cpp lua; do
    near "first reading of $robot" "$(cell compass.csv 1 "$robot" compass_north)" 2.6179938779914944 1e-12
    near "last reading of $robot" "$(cell compass.csv 300 "$robot" compass_north)" 0 1e-6
    near "last heading of $robot" "$(cell compass.csv 300 "$robot" yaw)" 1.5707963267948966 1e-6
  done
  # Gaussian noise of 0.1 rad: 300 errors have a standard deviation within 5 of its own of 0.1 / sqrt(600)
  near "noise" "$(rows compass.csv | awk -F, '
    $4 == "noisy" && $2 > 0 { d = $9 - (1.5707963267948966 - $8); if (d > 3) d -= 6.283185307179586; s += d * d; ++n }
    END { print sqrt(s / n) }')" 0.1 0.02
  on_threads compass.csv own_sensor.argos
}

check_own_medium() {
  argos3 -zc own_medium.argos
  # volume / (1 + d^2): heard one tick after the command; an answer is heard a tick later
  near "second, before" "$(cell loudness.csv 1 second microphone_loudness)" 0 0
  near "second" "$(cell loudness.csv 2 second microphone_loudness)" 0.5 1e-12
  near "third, before" "$(cell loudness.csv 2 third microphone_loudness)" 0 0
  near "third" "$(cell loudness.csv 3 third microphone_loudness)" 0.25 1e-12
  near "soloist" "$(cell loudness.csv 10 soloist microphone_loudness)" 0.25 1e-12
  near "second, both" "$(cell loudness.csv 10 second microphone_loudness)" 0.75 1e-12
  on_threads loudness.csv own_medium.argos
}

check_own_robot() {
  local engine
  for engine in dynamics2d kinematics2d dynamics3d pointmass3d; do
    sed "s/<dynamics2d /<$engine /" own_robot.argos >"$engine.argos"
    argos3 -zc "$engine.argos" --csv "$engine"
    # a circle of radius 0.35 m at 0.2 rad/s for 19.9 s, less the time in which the speed changes
    near "x in $engine" "$(cell "$engine/robots.csv" 200 free x)" -0.2598 0.003
    near "y in $engine" "$(cell "$engine/robots.csv" 200 free y)" 0.5845 0.003
    # the front of the other one is less than 10 cm, and more than 8, from the wall at 1.25 m
    near "stop in $engine" "$(cell "$engine/robots.csv" 200 stopped x)" 1.1 0.012
    near "standstill in $engine" "$(cell "$engine/robots.csv" 150 stopped x)" \
      "$(cell "$engine/robots.csv" 200 stopped x)" 1e-6
  done
  argos3 -c own_robot.argos
  test -s frames/frame_0000000200.png
}

check_own_engine_addon() {
  argos3 -zc own_engine_addon.argos
  # x = v (t - T (1 - exp(-t / T))), T = mass / drag = 1 s; the steps of 0.01 s add half a step at full speed
  near "way after 1 s" "$(cell box.csv 10 box x)" 0.3679 0.005
  near "way after 3 s" "$(cell box.csv 30 box x)" 2.0498 0.01
  near "height" "$(cell box.csv 30 box z)" 0 1e-4
}

check_embedding() {
  build/embedding race.argos >out
  # n - 1 ticks at 10 and 15 cm/s; the last two lines are those after the reset
  grep '^tick' out | cmp - <(printf 'tick %s\n' \
    "0: fast is at (0.000, 1.000)" "0: slow is at (0.000, 0.000)" \
    "50: fast is at (0.735, 1.000)" "50: slow is at (0.490, 0.000)" \
    "100: fast is at (1.485, 1.000)" "100: slow is at (0.990, 0.000)" \
    "0: fast is at (0.000, 1.000)" "0: slow is at (0.000, 0.000)")
  if build/embedding none.argos 2>error; then
    echo "a missing file was loaded"
    return 1
  fi
  grep -q 'none.argos' error
}

check_evolution() {
  build/evolution target.argos 1 | grep -E '^(gen|best)' >one
  build/evolution target.argos 2 | grep -E '^(gen|best)' >two
  cmp one two
  # the arc through the target: a quarter of a circle of radius 0.5 m, wheels 5.3 cm apart, 9.9 s
  local left right
  read -r left right < <(sed -n 's/^best.*speeds //p' one)
  near "speed of the left wheel" "$left" 7.51 0.15
  near "speed of the right wheel" "$right" 8.35 0.15
}

check() { # check NAME
  cp -r "$repo/examples/$1" "$work/$1"
  cd "$work/$1"
  cmake -S . -B build -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror"
  cmake --build build
  "check_$1"
}

run() { # run NAME
  local began="$SECONDS" status=0
  # a new shell, so that an error in a check ends it
  # shellcheck disable=SC2016  # that shell expands it
  "$BASH" -c 'set -euo pipefail; check "$1"' run "$1" >"$work/$1.log" 2>&1 || status=$?
  if ((status != 0)); then
    cat "$work/$1.log"
    echo "examples/$1 failed, see above"
    return 1
  fi
  echo "  $1: built, ran and checked in $((SECONDS - began)) s"
}

export PATH="$prefix/bin:$PATH" ARGOS_PLUGIN_PATH=build NO_COLOR=1 prefix repo work
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR="$work" CCACHE_NOHASHDIR=1
fi
# shellcheck disable=SC2046  # one name each
export -f near cell rows on_threads check run $(declare -F | sed -n 's/^declare -f[x ]* \(check_.*\)/\1/p')
failed=0
# shellcheck disable=SC2016  # that shell expands it
printf '%s\0' "$@" | xargs -0 -n 1 -P "$jobs" "$BASH" -c 'run "$1"' run || failed=1
((failed == 0)) || die "examples failed, see above"
echo "$# examples do what they should"
