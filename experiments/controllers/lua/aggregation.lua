-- Aggregation: robots walk at random, stop where others have stopped, and seldom leave large groups.
-- After O. Soysal and E. Sahin, "Probabilistic aggregation strategies in swarm robotic systems",
-- IEEE Swarm Intelligence Symposium 2005.

local speed = tonumber(robot.params.speed) -- cm/s
local join = tonumber(robot.params.join) -- the larger, the sooner a robot stops near others
local leave = tonumber(robot.params.leave) -- probability of leaving in a tick, if alone
local stay = tonumber(robot.params.stay) -- the larger, the less robots leave groups

local has_stopped
local turning -- ticks left; negative: to the right

-- the number of robots in range that have stopped: they say 1
local function count_stopped()
  local count = 0
  for _, message in ipairs(robot.range_and_bearing) do
    count = count + message.data[1]
  end
  return count
end

-- straight on; turns away from what is ahead, by a random angle
local function walk()
  local left, right = 0, 0
  for _, reading in ipairs(robot.proximity) do
    if math.cos(reading.angle) > 0 then
      if reading.angle > 0 then
        left = left + reading.value
      else
        right = right + reading.value
      end
    end
  end
  if turning == 0 and left + right > 0.1 then
    local ticks = robot.random.uniform_int(5, 20)
    turning = left > right and -ticks or ticks
  end
  if turning > 0 then
    turning = turning - 1
    robot.wheels.set_velocity(-speed / 2, speed / 2)
  elseif turning < 0 then
    turning = turning + 1
    robot.wheels.set_velocity(speed / 2, -speed / 2)
  else
    robot.wheels.set_velocity(speed, speed)
  end
end

function init()
  has_stopped = false
  turning = 0
end

function step()
  local neighbours = count_stopped()
  if has_stopped then
    has_stopped = not robot.random.bernoulli(leave * math.exp(-stay * neighbours))
  else
    has_stopped = robot.random.bernoulli(1 - math.exp(-join * (neighbours + 0.05)))
  end
  if has_stopped then
    robot.wheels.set_velocity(0, 0)
  else
    walk()
  end
  robot.range_and_bearing.set_data(1, has_stopped and 1 or 0)
  robot.leds.set_all_colors(has_stopped and "red" or "blue")
end

function reset()
  init()
end

function destroy() end
