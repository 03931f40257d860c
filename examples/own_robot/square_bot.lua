-- Drives on a circle; stops in front of an obstacle, with a red LED.
function init() end

function step()
  if math.max(robot.proximity[1], robot.proximity[2]) > 0 then
    robot.wheels.set_velocity(0, 0)
    robot.leds.set_all_colors("red")
  else
    robot.wheels.set_velocity(6, 8)  -- cm/s: a circle of radius 0.35 m, to the left
    robot.leds.set_all_colors("green")
  end
end

function reset() end
function destroy() end
