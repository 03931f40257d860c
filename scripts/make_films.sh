#!/usr/bin/env bash
# Makes a film of each experiment, see --help.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

if [[ "${1:-}" == "-h" || "${1:-}" == "--help" ]]; then
  cat <<'HELP'
Usage: scripts/make_films.sh [folder] [name...]

Makes a film of each experiment in experiments/, or only of those named (flocking, ...), one after the
other, of 720x540 pixels, each in less than a minute on two cores. They go to the folder, by default
out/films, with a contact sheet of four frames each (<name>.png).

Environment:
  ARGOS_BUILD   the build folder, by default build; it must be built
  FILM_FORMAT   mp4 (default), webm or gif
HELP
  exit 0
fi
folder="${1:-$repo/out/films}"
shift || true
build="${ARGOS_BUILD:-$repo/build}"
format="${FILM_FORMAT:-mp4}"
program="$build/bin/argos3"
[[ -x "$program" ]] || die "there is no $program; build first: cmake --build $build"
command -v ffmpeg >/dev/null || die "ffmpeg is missing: apt-get install ffmpeg"
mkdir -p "$folder"
folder="$(cd "$folder" && pwd)"
export ARGOS_PLUGIN_PATH="$build/lib/argos3:$build/experiments"
cd "$repo"

# name -> simulated seconds, and simulated seconds in a second of the film. By default 60 and 5.
declare -A plan=(
  [diffusion_1]="60 5" [diffusion_1_lua]="60 5" [epuck_obstacleavoidance]="60 5"
  [synchronization]="66 3" [synchronization_lua]="66 3"
  [flocking]="150 10" [flocking_lua]="150 10" [trajectories]="120 8"
  [gripping]="40 3" [foraging]="120 8" [pheromone]="300 40" [pheromone_lua]="300 40" [kilobots_lua]="30 2.5"
  [rab_chat]="10 1" [rab_chat_lua]="10 1"
  [eyebot_circle]="40 3" [eyebot_flocking]="40 3" [ramp_3d]="20 2"
  [rooms]="10 2" [rooms_16_engines]="10 2" [rooms_crowd]="10 2" [crawler_lua]="40 2" [crowd_lua]="4 1" [flock_above_rooms]="40 4"
  [aggregation_lua]="600 60" [best_of_n_lua]="400 40" [chain_lua]="100 10" [coverage_lua]="120 12"
)

make_film() {
  local name="$1" length speed
  read -r length speed <<<"${plan[$name]:-60 5}"
  local film="$folder/$name.$format" log="$folder/$name.log"
  local start="$SECONDS"
  if ! "$program" -zn -c "experiments/$name.argos" --length "$length" --video "$film" --speed "$speed" \
    --set "//offscreen/@size=720x540" >"$log" 2>&1; then
    tail -n 5 "$log" >&2
    return 1
  fi
  local frames
  frames="$(ffprobe -v error -count_packets -show_entries stream=nb_read_packets -of csv=p=0 "$film")"
  ffmpeg -y -v error -i "$film" -vf "select='not(mod(n\,$(((frames + 3) / 4))))',scale=640:-2,tile=2x2" \
    -frames:v 1 "$folder/$name.png"
  grep -h "is complete" "$log" | sed "s/^\[INFO\] The film //; s|$folder/||"
  printf '    made in %d s\n' "$((SECONDS - start))"
  rm -f -- "$log"
}

names=("$@")
if [[ ${#names[@]} -eq 0 ]]; then
  for file in experiments/*.argos; do
    names+=("$(basename "$file" .argos)")
  done
fi
failed=0
for name in "${names[@]}"; do
  make_film "$name" || {
    printf '%s: no film\n' "$name" >&2
    failed=1
  }
done
exit "$failed"
