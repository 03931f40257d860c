-- The metric of aggregation: the share of the robots that are in the largest group. Two robots are in one group if they
-- are at most "distance" apart, or if both are in a group with a third one.

local distance = tonumber(simulation.params.distance) -- m

-- marks the group of a robot, and returns its size
local function visit(robots, first)
  first.is_visited = true
  local group = { first }
  local next = 1
  while group[next] do
    local here = group[next]
    for _, other in ipairs(robots) do
      if not other.is_visited and (other.x - here.x) ^ 2 + (other.y - here.y) ^ 2 <= distance ^ 2 then
        other.is_visited = true
        group[#group + 1] = other
      end
    end
    next = next + 1
  end
  return #group
end

local function measure()
  local robots = {}
  for _, id in ipairs(simulation.ids("e-puck")) do
    local x, y = simulation.position(id)
    robots[#robots + 1] = { x = x, y = y }
  end
  local largest = 0
  for _, first in ipairs(robots) do
    if not first.is_visited then
      largest = math.max(largest, visit(robots, first))
    end
  end
  metrics.record("largest_group", largest / #robots)
end

init = measure
reset = measure
post_step = measure
