-- Robots that elect a leader by messages to their neighbours, and compute their distance to it in
-- hops.
-- See controllers/rab_chat for the same in C++.

local MAX_HOPS = 255
-- colours of 1, 2, ... hops
local SPECTRUM = { "red", "orange", "yellow", "green", "cyan", "blue", "purple", "magenta" }

local greatest -- greatest known number
local hops -- to the robot that drew it

local function say()
  robot.range_and_bearing.set_data({ greatest, hops })
  if hops == 0 then
    robot.leds.set_all_colors("white")
  else
    robot.leds.set_all_colors(SPECTRUM[math.min(hops, #SPECTRUM)])
  end
end

function init()
  greatest = math.floor(robot.random.uniform_int(0, 256))
  hops = 0
end

function step()
  for _, packet in ipairs(robot.range_and_bearing) do
    local number = math.floor(packet.data[1])
    local distance = math.floor(packet.data[2])
    local greater = number > greatest
    local nearer = number == greatest and distance + 1 < hops
    if (greater or nearer) and distance < MAX_HOPS then
      greatest = number
      hops = distance + 1
    end
  end
  say()
end

function reset()
  init()
end

function destroy() end
