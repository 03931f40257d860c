-- The order parameter of the Vicsek model, in [0,1]: the length of the mean direction of the robots. It is 1 if all go the
-- same way.

local function measure()
  local robots = simulation.ids("e-puck")
  local x, y = 0, 0
  for _, id in ipairs(robots) do
    local yaw = simulation.yaw(id)
    x, y = x + math.cos(yaw), y + math.sin(yaw)
  end
  metrics.record("order", math.sqrt(x * x + y * y) / #robots)
end

init = measure
reset = measure
post_step = measure
