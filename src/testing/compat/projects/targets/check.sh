# shellcheck shell=bash
test "$(grep -c '^-- ARGoS .*: TRUE$' configure.log)" = 5
test "$(grep -cE '^-- no ARGoS .*: (FALSE|0|)$' configure.log)" = 5
grep -qx -- '-- ARGoS::simulator is ARGoS::core' configure.log
ctest --test-dir build --output-on-failure --no-tests=error >ctest.log
# half a turn in 10 s of commands, the first of which acts in the second tick
argos3 -zc spin.argos --csv out
sed -n '$p' out/robots.csv | tr ',' ' ' | awk '{ print ($8 < 0) ? -$8 : $8 }' | expect 'heading at the end' 1 3.14159265 1e-6
