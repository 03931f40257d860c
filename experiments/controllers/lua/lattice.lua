-- A lattice of triangles from a local rule: robots pull those that are farther than 45 cm, and push the nearer ones.
function step()
  local x, y = 0, 0
  for _, message in ipairs(robot.range_and_bearing) do
    local pull = 1 - (45 / message.range)^4
    x = x + pull * math.cos(message.horizontal_bearing)
    y = y + pull * math.sin(message.horizontal_bearing)
  end
  local turn, speed = 8 * math.atan(y, x), math.max(0, math.min(10, 5 * x))
  robot.wheels.set_velocity(speed - turn, speed + turn)
  robot.leds.set_all_colors(#robot.range_and_bearing > 9 and "green" or "red")
end
