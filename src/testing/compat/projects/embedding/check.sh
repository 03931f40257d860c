# shellcheck shell=bash
build/designer race.argos >run.log
# 99 of 100 ticks at 20 cm/s, less the part of a tick that a change of speed may take
grep '^straight' run.log | expect 'straight' 2 1.979 0.0015
grep '^turn' run.log | expect 'turn on the spot' 2 0 1e-9
grep '^initial' run.log | expect 'no motion' 2 0 1e-9
grep '^best' run.log | expect 'evolved' 2 1.93 0.06
grep '^again' run.log | expect 'the same trial again' 2 0 0
grep '^trials' run.log | expect 'number of trials' 2 64 0
test "$(grep -c 'Loading all plug-ins' run.log)" = 1
# an unknown label is an error
sed 's/<dynamics2d /<dynamics2 /' race.argos >wrong.argos
if build/designer wrong.argos >wrong.log 2>&1; then
  echo "an unknown engine was accepted"
  exit 1
fi
grep 'wrong.argos:.*there is no physics engine of type <dynamics2>; did you mean "dynamics2d"' wrong.log >found
