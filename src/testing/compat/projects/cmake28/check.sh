# shellcheck shell=bash
# Nothing is in the way, so the robots drive 0.2 m/s: after 10 s two of three are beyond x = 1.
argos3 -c wander.argos
tail -n 1 arrivals.txt | expect 'clock' 1 100 0
tail -n 1 arrivals.txt | expect 'arrived robots' 2 2 0
# the first command acts in the second tick, of which a part may pass before the robot moves
tail -n 1 arrivals.txt | expect 'x of the first' 3 1.479 0.0015

# the libraries of the other folder, which asks for C++11 through CMake
sed 's/library="build.loop[^"]*" label="arrivals[^>]*/library="build\/analysis\/libspeeds" label="speeds_loop_functions" /' \
  wander.argos >speeds.argos
argos3 -c speeds.argos | grep '^speed of a: ' | expect 'speed' 4 0.2 1e-6
grep 'these targets ask for less.*footbot_wander.*arrivals.*speeds' configure.log >found
