# shellcheck shell=bash
argos3 -n -c collecting.argos >run.log 2>&1
grep '^robots_at_start' run.log | expect 'entities in the constructor' 2 0 0
grep '^ticks_per_second' run.log | expect 'ticks per second in the constructor' 2 16 0
grep '^tick_length' run.log | expect 'length of a tick in the constructor' 2 0.0625 0
grep '^resource_ticks' run.log | expect 'ticks of 2.5 s' 2 40 0
grep '^engines' run.log | expect 'engines in Init()' 2 1 0
grep '^iterations' run.log | expect 'iterations in Init()' 2 12 0
# one warning for the engine, though it was asked for twice
test "$(grep -c 'WARNING.*dyn2d' run.log)" = 1
