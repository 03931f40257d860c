-- A robot with one arm that crawls: it reaches out, presses the foot on the ground, pulls, and lifts
-- the foot again.

-- targets of shoulder and elbow, rad; positive turns downwards
local GAIT = {
  { -0.6, 0.2 }, -- reach out
  { 0.0, 0.6 }, -- foot on the ground
  { -0.2, 1.5 }, -- pull
  { -0.9, 1.5 }, -- lift
}
local TICKS = 6 -- of a phase

local tick

function init()
  tick = 0
  robot.leds.set_single_color(1, "green")
end

function step()
  local phase = GAIT[tick // TICKS % #GAIT + 1]
  robot.joints.shoulder.set_target(phase[1])
  robot.joints.elbow.set_target(phase[2])
  robot.leds.set_single_color(2, robot.joints.elbow.encoder > 1 and "yellow" or "red")
  tick = tick + 1
end

function reset()
  init()
end

function destroy() end
