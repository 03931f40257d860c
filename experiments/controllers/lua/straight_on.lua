-- Drives straight on, regardless of obstacles.
--
-- <params>: velocity (cm/s).

function init()
  reset()
end

function step()
end

function reset()
  local velocity = tonumber(robot.params.velocity or 10)
  robot.wheels.set_velocity(velocity, velocity)
end

function destroy()
end
