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

# its operation draws the model, and shapes of display lists, with OpenGL calls that move them
sed 's|</argos-configuration>|<visualization><povray directory="out" every="50" render="false" /></visualization></argos-configuration>|' beetles.argos >drawn.argos
argos3 -n -c drawn.argos >drawn.log 2>&1
if grep "pictures show the solids" drawn.log; then exit 1; fi
# each of three beetles: 4 triangles of the model, 12 of a block, 40 of a strip and 2 x 18 of the discs of each of two
# wheels, 20 of each of two fans
test "$(grep -c "triangle {" out/scene_0000000050.pov)" = $((3 * (4 + 12 + 2 * (40 + 2 * 18) + 2 * 20)))
# the model's light is red, an LED green, the other one black, each in its own colour
test "$(grep -c "Argos_Flat(srgb <1," out/scene_0000000050.pov)" = 3
test "$(grep -c "Argos_Flat(srgb <0,1,0>" out/scene_0000000050.pov)" = 3
test "$(grep -c "Argos_Flat(srgb <0,0,0>" out/scene_0000000050.pov)" = 3

# without the file, a picture shows the solids
mv beetle.obj elsewhere.obj
argos3 -n -c drawn.argos >solids.log 2>&1
grep 'the drawing of <beetle> has failed: There is no model "beetle.obj"' solids.log
grep -q 'pictures show the solids of "b0" and other <beetle>' solids.log
