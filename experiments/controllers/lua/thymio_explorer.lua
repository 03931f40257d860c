-- A Thymio's "explorer" behaviour: drives ahead, turns away from what its front sensors see, and
-- shows on its top what it does. The rear sensors make it drive on.

local speed

function init()
  speed = tonumber(robot.params.speed)
end

function step()
  local p = robot.proximity
  local left = p[1] + p[2]
  local right = p[4] + p[5]
  if left + right + p[3] == 0 then
    robot.wheels.set_velocity(speed, speed)
    robot.leds.set_all_colors(p[6] + p[7] > 0 and "blue" or "green")
  elseif left > right then
    robot.wheels.set_velocity(speed / 2, -speed / 2)
    robot.leds.set_all_colors("yellow")
  else
    robot.wheels.set_velocity(-speed / 2, speed / 2)
    robot.leds.set_all_colors("red")
  end
end

function reset() end

function destroy() end
