-- Drives straight on, and turns away from obstacles.
-- See controllers/footbot_diffusion for the same in C++: a test checks that both give bitwise equal
-- runs.
--
-- <params>: alpha (degrees) and delta are the thresholds of obstacles, velocity (cm/s) is the
-- speed.

local BEHIND = math.rad(120) -- larger than a right angle: a robot leaves a wall instead of following it

local alpha, delta, velocity
local state

-- the mean of the readings, each a vector of its value in the direction of its sensor
local function sum_up_proximity()
  local x, y = 0, 0
  for i = 1, #robot.proximity do
    local reading = robot.proximity[i]
    x = x + reading.value * math.cos(reading.angle)
    y = y + reading.value * math.sin(reading.angle)
  end
  return vector2(x / #robot.proximity, y / #robot.proximity)
end

local function enter(new_state)
  state = new_state
  local left = state == "turning left" and -velocity or velocity
  local right = state == "turning right" and -velocity or velocity
  robot.wheels.set_velocity(left, right)
  if robot.leds then
    robot.leds.set_all_colors(state == "free" and "green" or "orange")
  end
end

function init()
  alpha = math.rad(tonumber(robot.params.alpha or 7.5))
  delta = tonumber(robot.params.delta or 0.1)
  velocity = tonumber(robot.params.velocity or 10)
  reset()
end

function step()
  local crowd = sum_up_proximity()
  local angle = (crowd.x == 0 and crowd.y == 0) and 0 or math.atan(crowd.y, crowd.x)
  local negligible = crowd:length() < delta and math.abs(angle) <= alpha
  if negligible or math.abs(angle) > BEHIND then
    enter("free")
  elseif state == "free" then
    -- keep the direction until the way is free, to get out of corners
    enter(angle > 0 and "turning right" or "turning left")
  end
end

function reset()
  enter("free")
end

function destroy() end
