-- Tells robots of targets, and measures the flock: flocking_scenarios.h in Lua, for robots in Lua. The metrics are the same.

local TOWARDS_LIGHT, AWAY = 0, math.pi -- targets, as angles from the direction to the light
local scenario = tonumber(simulation.params.scenario)
local settled_time = tonumber(simulation.params.settled) -- s
local ids, ends, settled
local phase, informed, target, has_risen
local sum_of_order, sum_of_accuracy -- since the last settled_time of the phase began

local function inform(id, goal, priority)
  simulation.set_variable(id, "goal", goal)
  simulation.set_variable(id, "priority", priority)
end

local function draw_robot(except)
  local id
  repeat
    id = ids[simulation.random.uniform_int(1, #ids + 1)]
  until id ~= except
  return id
end

local function measure()
  local x, y = 0, 0
  for _, id in ipairs(ids) do
    local yaw = simulation.yaw(id)
    x, y = x + math.cos(yaw) / #ids, y + math.sin(yaw) / #ids
  end
  -- the light is at -x; the order times the cosine is the part of the mean in the direction of the target
  local order, accuracy = math.sqrt(x * x + y * y), (1 + (target == AWAY and x or -x)) / 2
  metrics.record("order", order)
  metrics.record("accuracy", accuracy)
  return order, accuracy
end

local function begin_phase(number)
  phase = number
  sum_of_order, sum_of_accuracy = 0, 0
  if scenario == 2 then
    -- the target moves; another robot knows it
    local before = informed
    informed, target = draw_robot(before), TOWARDS_LIGHT
    inform(before, false, false)
    inform(informed, target, false)
  elseif number == 2 then
    inform(draw_robot(informed), TOWARDS_LIGHT, true)
  else
    for _, id in ipairs(ids) do
      if id ~= informed then
        inform(id, false, false)
      end
    end
  end
end

function init()
  ids = simulation.ids("foot-bot")
  settled = settled_time / simulation.tick_length
  ends = {}
  for number = 1, scenario do
    ends[number] = math.floor(simulation.length / simulation.tick_length + 0.5) * number // scenario
  end
  for _, id in ipairs(ids) do
    inform(id, false, false)
  end
  target, has_risen = AWAY, false
  informed = draw_robot()
  inform(informed, target, false)
  phase, sum_of_order, sum_of_accuracy = 1, 0, 0
  measure()
end

function reset()
  init()
end

function post_step()
  local order, accuracy = measure()
  local tick = simulation.clock()
  if not has_risen and phase == 1 and (accuracy >= 0.9 or tick == ends[1]) then
    has_risen = true
    metrics.record("rise", simulation.time())
  end
  if tick + settled > ends[phase] then
    sum_of_order, sum_of_accuracy = sum_of_order + order, sum_of_accuracy + accuracy
  end
  if tick == ends[phase] then
    metrics.record("order_" .. phase, sum_of_order / settled)
    metrics.record("accuracy_" .. phase, sum_of_accuracy / settled)
    if phase < scenario then
      begin_phase(phase + 1)
    end
  end
end
