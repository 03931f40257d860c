-- Food, nest and trails, painted on the ground; a data file lists how much was delivered.
-- See loop_functions/trails for the same in C++.

local FULL = tonumber(simulation.params.full) -- 1/m^2, concentration with the strongest colour
local NEST = { x = -1.1, y = 0, radius = 0.25 }
local FOOD = { { x = 1, y = 0.6, radius = 0.15 }, { x = 1, y = -0.6, radius = 0.15 } }

local file

local function contains(disc, x, y)
  return (x - disc.x) ^ 2 + (y - disc.y) ^ 2 < disc.radius ^ 2
end

function init()
  reset()
end

function reset()
  destroy()
  file = assert(io.open(simulation.params.output, "w"))
  assert(file:write("tick,carrying,delivered,trail\n"))
end

function post_step()
  simulation.floor_changed()
  local carrying, delivered = 0, 0
  for _, id in ipairs(simulation.ids("e-puck")) do
    carrying = carrying + (simulation.get_variable(id, "has_food") and 1 or 0)
    delivered = delivered + simulation.get_variable(id, "delivered")
  end
  simulation.metric("carrying", carrying)
  simulation.metric("delivered", delivered)
  assert(file:write(string.format("%d,%d,%d,%g\n", simulation.clock(), carrying, delivered,
    simulation.total_pheromone("scents", "trail"))))
end

function destroy()
  if file then
    local closed = file
    file = nil
    assert(closed:close()) -- a full disk may be reported only here
  end
end

function floor_color(x, y)
  if contains(NEST, x, y) then
    return "gray50"
  end
  for _, food in ipairs(FOOD) do
    if contains(food, x, y) then
      return "black"
    end
  end
  local strength = math.min(1, simulation.pheromone("scents", "trail", x, y) / FULL)
  return 255, math.floor(255.5 - 65 * strength), math.floor(255.5 - 255 * strength)
end
