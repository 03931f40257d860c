# shellcheck shell=bash
export ARGOS_PLUGIN_PATH="$PWD/build"
argos3 -n -c listening.argos >run.log
grep '^speakers' run.log | expect 'speakers' 2 2 0
# 50 / 5^2 + 25 / 10^2 and 50 / 4^2 + 25 / (9^2 + 8^2), from the third tick on
grep '^heard_by_fb' run.log | expect 'heard by the foot-bot' 2 2.25 1e-9
grep '^heard_by_ep' run.log | expect 'heard by the e-puck' 2 3.29741 1e-5
grep '^heard_by_fb' run.log | head -n 2 | expect 'heard before the sound arrives' 2 0 0
grep '^heard_by_fb' run.log | head -n 3 | expect 'heard when the sound arrives' 2 2.25 1e-9
grep -c '^heard_by' run.log | expect 'number of readings' 1 10 0
