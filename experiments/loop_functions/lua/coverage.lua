-- The metric of coverage: the share of the arena that is at most "radius" from a robot. The pictures show these discs.

local radius = tonumber(simulation.params.radius) -- m
local cell = tonumber(simulation.params.cell) -- m, side of the squares that are counted

local function is_covered(x, y, robots)
  for _, place in ipairs(robots) do
    if (place.x - x) ^ 2 + (place.y - y) ^ 2 <= radius ^ 2 then
      return true
    end
  end
  return false
end

local function places()
  local list = {}
  for _, id in ipairs(simulation.ids("e-puck")) do
    local x, y = simulation.position(id)
    list[#list + 1] = vector3(x, y, 0)
  end
  return list
end

local function measure()
  local robots = places()
  local min, max = simulation.arena.min, simulation.arena.max
  local covered, total = 0, 0
  for x = min.x + cell / 2, max.x, cell do
    for y = min.y + cell / 2, max.y, cell do
      total = total + 1
      covered = covered + (is_covered(x, y, robots) and 1 or 0)
    end
  end
  metrics.record("covered", covered / total)
end

init = measure
reset = measure

-- once a second: this takes longer than the robots
function post_step()
  if simulation.clock() % 10 == 0 then
    measure()
  end
end

function draw_in_world()
  for _, place in ipairs(places()) do
    draw.circle(place, radius, "80,160,220,60")
  end
end
