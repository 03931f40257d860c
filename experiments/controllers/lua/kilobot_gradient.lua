-- Kilobots that compute their distance to one of them, in hops, from the messages of their
-- neighbours, and wander slowly. A distance that no neighbour confirms is forgotten.

local UNKNOWN = 255
local MEMORY = 20 -- ticks
local SPEED = 1 -- cm/s
local SENT = 1 -- second byte of every message
-- colours of 0, 1, 2, ... hops
local SPECTRUM = { "white", "red", "orange", "yellow", "green", "cyan", "blue", "purple", "magenta" }

local hops, age
local left, right, moving

local function choose_motion()
  local turn = robot.random.uniform(-1, 1)
  left = SPEED * math.min(1, 1 - turn)
  right = SPEED * math.min(1, 1 + turn)
  moving = math.floor(robot.random.uniform(10, 40))
end

function init()
  hops = robot.id == robot.params.source and 0 or UNKNOWN
  age = 0
  choose_motion()
end

function step()
  local least = UNKNOWN
  for _, packet in ipairs(robot.range_and_bearing) do
    -- before its first step, a robot sends zeros
    if packet.data[2] == SENT then
      least = math.min(least, math.floor(packet.data[1]))
    end
  end
  if hops > 0 then
    age = age + 1
    if least + 1 <= hops or age > MEMORY then
      hops = math.min(least + 1, UNKNOWN)
      age = 0
    end
  end
  robot.range_and_bearing.set_data({ hops, SENT, 0 })
  robot.leds.set_all_colors(hops < UNKNOWN and SPECTRUM[math.min(hops + 1, #SPECTRUM)] or "black")
  moving = moving - 1
  if moving <= 0 then
    choose_motion()
  end
  robot.wheels.set_velocity(left, right)
end

function reset()
  init()
end

function destroy() end
