-- drives straight on, with red LEDs, and sends
function init()
  robot.wheels.set_velocity(10, 10)
  robot.leds.set_all_colors("red")
end

function step()
  robot.range_and_bearing.set_data(1, 1)
end

function reset() end

function destroy() end
