# shellcheck shell=bash
export ARGOS_PLUGIN_PATH="$PWD/build"
argos3 -c circle.argos
grep '^0 fb ' poses.txt | expect 'x at the start' 3 0.5 1e-9
grep '^0 fb ' poses.txt | expect 'heading at the start' 5 30 1e-9
grep '^30 cyl ' poses.txt | expect 'y of the cylinder' 4 1 1e-9
# (14 - 7) cm/s over the 14 cm between the wheels: 0.5 rad/s, 2.86479 degrees a tick
awk '/^10 fb/ { before = $5 } /^11 fb/ { printf "%.12f\n", $5 - before }' poses.txt | expect 'turn of a tick' 1 2.86478898 1e-7
# a chord of 0.05 rad on a circle with a radius of 10.5 cm / 0.5 rad
awk '/^10 fb/ { x = $3; y = $4 } /^11 fb/ { printf "%.12f\n", sqrt(($3 - x) ^ 2 + ($4 - y) ^ 2) }' poses.txt |
  expect 'path of a tick' 1 0.01049890629 1e-9
wc -l <poses.txt | expect 'number of lines' 1 62 0
