# shellcheck shell=bash
# As scripts of genetic algorithms do, this one reads the last line of standard output: 50 reports, of one field.
test "$(argos3 -z -n -c gathering.argos 2>errors | tail -1)" = '50, 1'
# both libraries have both classes: one warning for each label, and no error
test "$(grep -c 'WARNING.*is registered by .*with the same class' errors)" = 2
grep 'label "field" of CLoopFunctions.*libgatherer.*and by.*libfield.*the same class CField' errors
# before it is what was printed at once
argos3 -z -n -c gathering.argos 2>errors | tail -2 | head -1 | grep -x 'reports of robots, fields'
# the line about the run is on the standard error, or in the error log
grep 'INFO. simulated 5 s' errors
test "$(argos3 -z -n -c gathering.argos -e errors 2>&1 | tail -1)" = '50, 1'
test -e build/libparameters.so
