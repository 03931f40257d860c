-- Drives straight on, at the speed in <params>.
local speed  -- cm/s

function init() speed = tonumber(robot.params.speed) end  -- attributes are text
function step() robot.wheels.set_velocity(speed, speed) end
function reset() end
function destroy() end
