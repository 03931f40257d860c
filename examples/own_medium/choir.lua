-- The robot "soloist" sounds its horn; a robot that hears a horn sounds its own, more softly.
function init() end

function step()
  if robot.id == "soloist" then
    robot.horn.set_volume(1)
  elseif robot.microphone.loudness > 0 then
    robot.horn.set_volume(0.5)
  end
end

function reset() end
function destroy() end
