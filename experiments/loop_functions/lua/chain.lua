-- The metrics of the chain: the number of its members, and the distance of the last one from the nest. The pictures show
-- the chain as a line.

local function members()
  local list = {}
  for _, id in ipairs(simulation.ids("e-puck")) do
    local number = simulation.get_variable(id, "number")
    if number and number > 0 then
      local x, y = simulation.position(id)
      list[math.floor(number)] = vector3(x, y, 0.06)
    end
  end
  return list
end

local function measure()
  local list = members()
  metrics.record("members", #list)
  metrics.record("reach", #list > 0 and (list[#list] - list[1]):length() or 0, "m")
end

init = measure
reset = measure
post_step = measure

function draw_in_world()
  local list = members()
  if #list > 1 then
    draw.path({ table.unpack(list) }, "red", 3)
  end
end
