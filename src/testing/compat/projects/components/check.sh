# shellcheck shell=bash
export ARGOS_PLUGIN_PATH="$PWD/build"
# the library of the project counts, not the installed one of its name
argos3 -q odometer | grep 'distance driven' >found
argos3 -c back_and_forth.argos >run.log
# 10 cm/s: 1 cm a tick, ahead and back
grep -o '^.*\] 10 odometer .*$' run.log | sed 's/.*\] //' >at_10
grep -o '^.*\] 15 odometer .*$' run.log | sed 's/.*\] //' >at_15
paste at_10 at_15 | awk '{ print $6 - $3 }' | expect 'path of five ticks' 1 0.05 1e-9
# the first command acts in the second tick, and changes of speed may take a part of a tick
grep '] 50 odometer' run.log | sed 's/.*odometer //' | expect 'path of all ticks' 1 0.4875 0.003
# the component that does not exist
grep 'no library argos3plugin_simulator_some_other_robot' configure.log >found
test ! -e build/libsome_other_controller.so
