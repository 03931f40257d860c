-- Robots that stand still and flash like fireflies, and synchronise their flashes.
-- See controllers/footbot_synchronization for the same in C++, and for the source.

-- a flash is seen one tick after its order: a robot ignores flashes for this time after its own
local DEAF_TICKS = 2

local period = tonumber(robot.params.period) -- ticks
local coupling = tonumber(robot.params.coupling) -- share of the phase
local phase, ticks_since_flash

local function sees_flash()
  for _, blob in ipairs(robot.colored_blob_omnidirectional_camera) do
    local color = blob.color
    if color.red == 255 and color.green == 0 and color.blue == 0 then
      return true
    end
  end
  return false
end

function init()
  robot.colored_blob_omnidirectional_camera.enable()
  phase = robot.random.uniform()
  ticks_since_flash = period
end

function step()
  phase = phase + 1 / period
  ticks_since_flash = ticks_since_flash + 1
  if ticks_since_flash > DEAF_TICKS and sees_flash() then
    phase = phase * (1 + coupling)
  end
  if phase >= 1 then
    phase = 0
    ticks_since_flash = 0
    robot.leds.set_all_colors("red")
  else
    robot.leds.set_all_colors("black")
  end
end

function reset()
  init()
end

function destroy() end
