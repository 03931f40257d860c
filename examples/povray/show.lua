function init() end
function step()
  if robot.leds then robot.leds.set_all_colors(robot.id == "f0" and "red" or robot.id=="f1" and "green" or "blue") end
end
function reset() end
function destroy() end
