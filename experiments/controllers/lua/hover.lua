-- Flies to a place and stays there.
--
-- <params>: x, y, z (m).

function init()
  reset()
end

function step()
end

function reset()
  local place = robot.params
  robot.quadrotor.set_absolute_position(tonumber(place.x), tonumber(place.y), tonumber(place.z))
end

function destroy()
end
