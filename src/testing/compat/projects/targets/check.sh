# shellcheck shell=bash
test "$(grep -c '^-- ARGoS .*: 1$' configure.log)" = 5
test "$(grep -c '^-- no ARGoS .*: 0$' configure.log)" = 5
grep -qx -- '-- ARGoS::simulator is ARGoS::core' configure.log
ctest --test-dir build --output-on-failure --no-tests=error >ctest.log
# pi / 10 rad/s for 10 s: the first command acts in the second tick, and nine tenths of it in that tick
argos3 -zc spin.argos --csv out
sed -n '$p' out/robots.csv | tr ',' ' ' | awk '{ print ($8 < 0) ? -$8 : $8 }' | expect 'heading at the end' 1 3.1384510609 1e-9
