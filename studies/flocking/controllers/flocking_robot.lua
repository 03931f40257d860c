-- A foot-bot of a flock, some of whose members know a target: flocking_robot.h in Lua.
-- All vectors are in the robot's frame, unless said otherwise.

local params = robot.params
local algorithm = params.algorithm
local alpha, beta, gamma = tonumber(params.alpha), tonumber(params.beta), tonumber(params.gamma)
local epsilon = tonumber(params.epsilon)
local s = tonumber(params.distance) / math.sqrt(2) -- m
local reach = tonumber(params.reach) -- m
local forward_gain = tonumber(params.forward_gain) -- cm/s for a force of 1
local turn_gain = tonumber(params.turn_gain) -- rad/s for a force of 1
local max_speed = tonumber(params.max_speed) -- cm/s
local max_turn_rate = 1.5 -- rad/s
local needed_agreement = tonumber(params.agreement)
local confidence_step = tonumber(params.confidence_step)
local AXIS = 14 -- distance between the wheels, cm

-- set by the loop functions: the target's angle from the direction to the light, or false; whether it has priority
goal, priority = false, false
local average, sent, confidence -- mean of the messages of the last step; last direction sent, in the frame of the light

local function polar(length, angle)
  return vector2(length * math.cos(angle), length * math.sin(angle))
end

local function turned(vector, angle)
  return vector2(vector):rotate(angle)
end

local function normalized(vector)
  local length = vector:length()
  return length > 0 and vector * (1 / length) or vector2()
end

local function measure_light()
  local sum = vector2()
  for _, reading in ipairs(robot.light) do
    sum = sum + polar(reading.value, reading.angle)
  end
  return math.atan(sum.y, sum.x)
end

-- a potential like that between molecules
local function proximal()
  local sum = vector2()
  for _, packet in ipairs(robot.range_and_bearing) do
    local d = packet.range / 100
    if d < reach then
      sum = sum + polar(-8 * epsilon * (2 * s ^ 4 / d ^ 5 - s ^ 2 / d ^ 3), packet.horizontal_bearing)
    end
  end
  return sum
end

-- in the frame of the light; angles are sent as 16 bits, 0 to 65535 for a full turn
local function sum_of_messages()
  local sum = vector2()
  for _, packet in ipairs(robot.range_and_bearing) do
    sum = sum + polar(1, (packet.data[1] * 256 + packet.data[2]) / 65536 * 2 * math.pi)
  end
  return sum
end

local function adapt_confidence(agreement)
  if not goal then
    confidence = 0
  elseif algorithm == "ics" or priority then
    confidence = 1
  else
    local step = agreement >= needed_agreement and confidence_step or -confidence_step
    confidence = math.max(0, math.min(1, confidence + step))
  end
end

local function choose_message(light)
  local heading = vector2(1, 0)
  if algorithm == "hcs" then
    return heading
  end
  local to_goal = goal and polar(1, goal + light) or vector2()
  local mean = average:length() > 0 and average or heading
  local sum = to_goal * confidence + mean * (1 - confidence)
  return sum:length() > 0 and normalized(sum) or mean
end

local function send(vector)
  local code = math.floor(math.atan(vector.y, vector.x) / (2 * math.pi) % 1 * 65536) % 65536
  robot.range_and_bearing.set_data({ code // 256, code % 256 })
end

local function drive(force)
  local forward = math.max(0, math.min(max_speed, forward_gain * force.x))
  local turn = math.max(-max_turn_rate, math.min(max_turn_rate, turn_gain * force.y))
  robot.wheels.set_velocity(forward - turn * AXIS / 2, forward + turn * AXIS / 2)
end

function init()
  average, sent, confidence = vector2(), vector2(), 0
end

function reset()
  init()
end

function step()
  local light = measure_light()
  local received = sum_of_messages()
  local count = #robot.range_and_bearing
  adapt_confidence(count > 0 and received:length() / count or 1)

  local to_goal = goal and polar(1, goal + light) or vector2()
  local alignment = normalized(turned(received + sent, light))
  drive(proximal() * alpha + to_goal * beta + alignment * gamma)

  sent = turned(choose_message(light), -light)
  send(sent)
  average = normalized(turned(received, light))
  robot.leds.set_all_colors(goal and "yellow" or "black")
end
