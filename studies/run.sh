#!/usr/bin/env bash
# Runs a study in full, and puts figures, tables of means and verdicts into its folder results/:
#   studies/run.sh NAME [PREFIX]
# PREFIX is where the simulator is installed; without it, the installation whose bin/ is in the PATH is used.
# All campaigns of the study but the reduced ones are run. If it was stopped, the same command continues it.
set -euo pipefail
(($# == 1 || $# == 2)) || { sed -n '2,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
cmake_options=()
if (($# == 2)); then
  prefix="$(cd "$2" && pwd)"
  PATH="$prefix/bin:$PATH"
  cmake_options=("-DCMAKE_PREFIX_PATH=$prefix")
fi
cd "$(dirname "${BASH_SOURCE[0]}")/$1"
if [[ -f CMakeLists.txt ]]; then
  cmake -S . -B build -DCMAKE_BUILD_TYPE=Release "${cmake_options[@]}" >/dev/null
  cmake --build build --parallel "$(nproc)"
fi
campaigns=(full*.xml)
for file in *.xml; do
  [[ "$file" == full* || "$file" == reduced* ]] || campaigns+=("$file")
done
tables=()
for file in "${campaigns[@]}"; do
  campaign="${file%.xml}"
  argos3-campaign run "$file"
  argos3-campaign export "$file" --csv "$campaign.tables"
  argos3-campaign report "$file"
  tables+=("$campaign.tables/runs.csv")
  rm -rf "results/$campaign"
  mkdir -p "results/$campaign"
  cp "$campaign.report/tables/summary.csv" "results/$campaign"
  find "$campaign.report/figures" -name '*.svg' -exec cp -t "results/$campaign" {} +
done
PYTHONDONTWRITEBYTECODE=1 ./verdicts.py "${tables[@]}" >results/verdicts.md
cat results/verdicts.md
