-- Goes straight on, whatever is in the way.
--
-- <params>: velocity (cm/s) says how fast.

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
