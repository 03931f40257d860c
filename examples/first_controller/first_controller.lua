-- Drives straight on, and turns away from what the proximity sensors see ahead.
local speed  -- cm/s

-- called once: reads the attributes of <params>
function init()
  speed = tonumber(robot.params.speed or 10)
end

-- called in every tick, after the sensors were updated
function step()
  local left, right = 0, 0
  for _, reading in ipairs(robot.proximity) do
    local is_ahead = math.cos(reading.angle) > 0
    if is_ahead and reading.angle > 0 then
      left = left + reading.value
    elseif is_ahead then
      right = right + reading.value
    end
  end
  if left + right < 0.1 then
    robot.wheels.set_velocity(speed, speed)
  elseif left > right then
    robot.wheels.set_velocity(speed, -speed)
  else
    robot.wheels.set_velocity(-speed, speed)
  end
end

function reset() end
function destroy() end
