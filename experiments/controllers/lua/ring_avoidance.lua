-- Obstacle avoidance with a ring of proximity sensors, counter-clockwise from ahead, on a robot with
-- two wheels. Parameters: sensors (how many of the readings are the ring), speed (cm/s).

local sensors, speed

function init()
  sensors = math.floor(tonumber(robot.params.sensors))
  speed = tonumber(robot.params.speed)
end

function step()
  -- obstacles pull backwards
  local x, y = 1, 0
  for i = 1, sensors do
    local angle = 2 * math.pi * (i - 1) / sensors
    local value = robot.proximity[i]
    x = x - value * math.cos(angle)
    y = y - value * math.sin(angle)
  end
  local turn = math.atan(y, x)
  if math.abs(turn) > 0.5 then
    local sign = turn > 0 and 1 or -1
    robot.wheels.set_velocity(-sign * speed / 2, sign * speed / 2)
    robot.leds.set_all_colors("red")
  else
    robot.wheels.set_velocity(speed * (1 - turn), speed * (1 + turn))
    robot.leds.set_all_colors("green")
  end
end

function reset() end

function destroy() end
