-- Drives towards the light. What is in the way is pushed: together, robots move what is too heavy
-- for each of them.
--
-- <params>: velocity (cm/s).

local WHEEL_BASE = 14 -- cm, between the wheels of a foot-bot
local GAIN = 1.5 -- rad/s per rad

local velocity

-- the direction of the light, rad; 0, straight ahead, if other robots hide it
local function find_light()
  local x, y = 0, 0
  for i = 1, #robot.light do
    local reading = robot.light[i]
    x = x + reading.value * math.cos(reading.angle)
    y = y + reading.value * math.sin(reading.angle)
  end
  return (x == 0 and y == 0) and 0 or math.atan(y, x)
end

function init()
  velocity = tonumber(robot.params.velocity or 10)
end

function step()
  local angle = find_light()
  -- turn on the spot unless the light is ahead
  local ahead = math.max(0, math.cos(angle)) * velocity
  local turn = 0.5 * WHEEL_BASE * GAIN * angle
  robot.wheels.set_velocity(ahead - turn, ahead + turn)
end

function reset() end

function destroy() end
