# shellcheck shell=bash
# The last step of the controllers sees 49 ticks of motion: the first command acts in the second tick.
export ARGOS_PLUGIN_PATH="$PWD/build"
for engine in dynamics2d kinematics2d dynamics3d pointmass3d; do
  sed "s/<dynamics2d id=\"engine\" velocity_lag=\"0\"/<$engine id=\"engine\"/" beetles.argos >"$engine.argos"
  argos3 -n -c "$engine.argos" >"$engine.log"
  # 0.1 m/s for 4.9 s, of which 2D engines take a tenth of a tick to start
  grep '^position_of_b0' "$engine.log" | expect "$engine: straight, y" 3 0.49 0.01
  grep '^position_of_b0' "$engine.log" | expect "$engine: straight, x" 2 0 1e-3
  # a circle of 8 cm, at 1 rad/s
  grep '^position_of_b1' "$engine.log" | expect "$engine: circle, x" 2 "$(awk 'BEGIN { print -1 + 0.08 * sin(4.9) }')" 0.01
  grep '^position_of_b1' "$engine.log" | expect "$engine: circle, y" 3 "$(awk 'BEGIN { print -1 + 0.08 * (1 - cos(4.9)) }')" 0.01
  # a wall stops a robot of 6 cm at its face, except in the engine without contacts
  [[ "$engine" == pointmass3d ]] ||
    grep '^position_of_b2' "$engine.log" | expect "$engine: wall, x" 2 0.34 0.005
done

# its operations that draw with OpenGL are accepted; a picture shows its solids
sed 's|</argos-configuration>|<visualization><offscreen directory="out" every="50" /></visualization></argos-configuration>|' beetles.argos >drawn.argos
argos3 -n -c drawn.argos >drawn.log 2>&1
grep -q 'pictures show the solids of "b0" and other <beetle>' drawn.log
