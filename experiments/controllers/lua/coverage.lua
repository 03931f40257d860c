-- Coverage: robots spread, because each is pushed away by its neighbours and by walls.
-- After A. Howard, M. Mataric and G. Sukhatme, "Mobile sensor network deployment using potential fields", DARS 2002.

local max_speed = tonumber(robot.params.max_speed) -- cm/s
local reach = tonumber(robot.params.reach) -- cm: robots that are farther away do not push

-- the sum of what pushes this robot: a vector in its frame, 1 if a neighbour is at half of the reach
local function force()
  local sum = vector2()
  for _, message in ipairs(robot.range_and_bearing) do
    local push = math.max(0, reach / message.range - 1)
    local angle = message.horizontal_bearing
    sum = sum - push * vector2(math.cos(angle), math.sin(angle))
  end
  for _, reading in ipairs(robot.proximity) do
    sum = sum - 4 * reading.value * vector2(math.cos(reading.angle), math.sin(reading.angle))
  end
  return sum
end

function init() end

function step()
  local push = force()
  local speed = max_speed * math.min(1, push:length())
  if speed < 0.1 * max_speed then
    robot.wheels.set_velocity(0, 0)
    robot.leds.set_all_colors("green")
    return
  end
  -- the wheels turn the robot to the force; it drives while it has it ahead
  local angle = math.atan(push.y, push.x)
  local ahead = speed * math.max(0, math.cos(angle))
  local turn = speed * math.sin(angle / 2)
  robot.wheels.set_velocity(ahead - turn, ahead + turn)
  robot.leds.set_all_colors("orange")
end

function reset() end

function destroy() end
