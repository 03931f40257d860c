-- Each robot takes the mean heading of the robots that it hears and its own one, with an error: the model of T. Vicsek
-- et al., "Novel type of phase transition in a system of self-driven particles", Physical Review Letters 75, 1995.

local noise = tonumber(robot.params.noise) -- rad: errors are uniform, at most half of this to either side
local speed = tonumber(robot.params.speed) -- cm/s
local QUICKNESS = 15 -- cm/s of a wheel for each radian that is left to turn
local MOST = 8 -- cm/s, so that a robot turns by at most 0.3 rad in a tick
local CODES = 65536 -- of headings, in two bytes

local function turned(angle)
  return (angle + math.pi) % (2 * math.pi) - math.pi
end

function step()
  local heading = robot.positioning.orientation:toeulerangles()
  local x, y = math.cos(heading), math.sin(heading)
  for _, message in ipairs(robot.range_and_bearing) do
    local theirs = (256 * message.data[1] + message.data[2]) * 2 * math.pi / CODES
    x, y = x + math.cos(theirs), y + math.sin(theirs)
  end
  local wanted = math.atan(y, x) + robot.random.uniform(-noise / 2, noise / 2)
  local turn = math.max(-MOST, math.min(MOST, QUICKNESS * turned(wanted - heading)))
  robot.wheels.set_velocity(speed - turn, speed + turn)
  local code = math.floor(heading / (2 * math.pi) * CODES) % CODES
  robot.range_and_bearing.set_data({ code // 256, code % 256 })
end
