function step() robot.leds.set_all_colors("cyan") end
function init() end
function reset() end
function destroy() end
