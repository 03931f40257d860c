-- Turns a robot to the north and drives on.
function init() end

function step()
  local turn = 5 * robot.compass.north
  robot.wheels.set_velocity(10 - turn, 10 + turn)
end

function reset() end
function destroy() end
