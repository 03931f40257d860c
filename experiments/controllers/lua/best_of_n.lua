-- Best of n: robots find out which colour of the ground is the most frequent one, by voting.
-- After G. Valentini, D. Brambilla, H. Hamann and M. Dorigo, "Collective perception of environmental features in a robot
-- swarm", ANTS 2016: each measures how frequent the colour of its opinion is, then tells its opinion the longer, the more
-- frequent it was, and at last takes over the opinion of one of those that it hears.

local COLOURS = { "red", "green", "blue" } -- of LEDs, for the opinions 1, 2, 3: black, grey and white ground

local speed = tonumber(robot.params.speed) -- cm/s
local time = tonumber(robot.params.time) -- ticks: mean time of a measurement, and of telling if the share was 1/2

opinion = 1 -- global, so that the loop functions can read it

local is_telling, ticks_left
local seen, seen_own -- ticks of this measurement; those on the colour of the opinion
local heard -- opinions heard while telling
local turning -- ticks left; negative: to the right

-- the opinion that the ground here would speak for: the reading is 0 on black, 0.5 on grey and 1 on white ground
local function ground_colour()
  return math.floor(2 * robot.ground[1] + 1.5)
end

local function measure()
  is_telling = false
  ticks_left = 1 + robot.random.exponential(time)
  seen, seen_own = 0, 0
end

local function tell()
  is_telling = true
  ticks_left = 1 + robot.random.exponential(2 * time * seen_own / math.max(1, seen))
  heard = {}
end

local function listen()
  for _, message in ipairs(robot.range_and_bearing) do
    if message.data[1] > 0 then
      heard[#heard + 1] = math.floor(message.data[1])
    end
  end
end

-- straight on, with turns now and then; turns away from what is ahead
local function walk()
  for _, reading in ipairs(robot.proximity) do
    if reading.value > 0.1 and math.abs(reading.angle) < math.pi / 2 and turning == 0 then
      local ticks = robot.random.uniform_int(5, 15)
      turning = reading.angle > 0 and -ticks or ticks
    end
  end
  if turning == 0 and robot.random.bernoulli(0.02) then
    turning = robot.random.uniform_int(-10, 11)
  end
  local turn = turning > 0 and 1 or turning < 0 and -1 or 0
  turning = turning - turn
  if turn == 0 then
    robot.wheels.set_velocity(speed, speed)
  else
    robot.wheels.set_velocity(-turn * speed / 2, turn * speed / 2)
  end
end

function init()
  opinion = robot.random.uniform_int(1, #COLOURS + 1)
  turning = 0
  measure()
end

function step()
  walk()
  ticks_left = ticks_left - 1
  if is_telling then
    listen()
    if ticks_left <= 0 then
      if #heard > 0 then
        opinion = heard[robot.random.uniform_int(1, #heard + 1)]
      end
      measure()
    end
  else
    seen = seen + 1
    seen_own = seen_own + (ground_colour() == opinion and 1 or 0)
    if ticks_left <= 0 then
      tell()
    end
  end
  robot.range_and_bearing.set_data(1, is_telling and opinion or 0)
  robot.leds.set_all_colors(COLOURS[opinion])
end

function reset()
  init()
end

function destroy() end
