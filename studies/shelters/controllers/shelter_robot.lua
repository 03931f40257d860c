-- The controller of shelter_robot.h in Lua: a foot-bot that joins the group under a shelter, and leaves it, with probabilities
-- that the shelter broadcasts. The bytes of a message are those of shelter_message.h.
local BEACON = 13 -- the LED in the centre of the robot: others see one light of it
local TICKS_PER_SECOND = 10
local OBSTACLE = 0.1 -- sum of the proximity readings that makes a free robot turn
local TURN_GAIN = 10 -- cm/s of a wheel for a right angle
local COLORS = { free = "green", in_group = "red", leaving = "blue" }

local p = {} -- parameters; lengths in cm
local state, was_in_range, turn_ticks, turn_sign

local function happens(probability)
  return robot.random.uniform() <= probability
end

local function enter(new_state)
  state = new_state
  robot.leds.set_single_color(BEACON, COLORS[state])
  -- each state has the camera that it needs
  if state == "free" then
    robot.colored_blob_omnidirectional_camera.disable()
  else
    robot.colored_blob_omnidirectional_camera.enable()
  end
end

-- the nearest active shelter, if the robot is in its range, else nil
local function find_shelter()
  local best, nearest = p.range, nil
  for _, packet in ipairs(robot.range_and_bearing) do
    local data = packet.data
    local distance = packet.range * math.cos(packet.vertical_bearing)
    if data[1] == 1 and distance <= best then
      best = distance
      nearest = {
        distance = distance,
        angle = packet.horizontal_bearing,
        join = (256 * data[2] + data[3]) / 65535,
        leave = (256 * data[4] + data[5]) / 1e6,
      }
    end
  end
  return nearest
end

local function walk()
  local x, y = 0, 0
  for _, reading in ipairs(robot.proximity) do
    local ahead = math.cos(reading.angle)
    if ahead > 0 then
      x = x + reading.value * ahead
      y = y + reading.value * math.sin(reading.angle)
    end
  end
  if turn_ticks == 0 then
    if math.sqrt(x * x + y * y) > OBSTACLE then
      turn_sign = y > 0 and -1 or 1
    elseif happens(1 / (p.walk * TICKS_PER_SECOND)) then
      turn_sign = happens(0.5) and 1 or -1
    else
      robot.wheels.set_velocity(p.speed, p.speed)
      return
    end
    turn_ticks = robot.random.uniform_int(2, 13) -- up to some 100 degrees
  end
  turn_ticks = turn_ticks - 1
  robot.wheels.set_velocity(-turn_sign * p.speed, turn_sign * p.speed)
end

-- a robot that leaves has more room around it
local function force_of(neighbor)
  local color = neighbor.color
  local is_blue = color.blue == 255
  local is_one_of_mine = state == "in_group" and color.red == 255
  local rest = (state == "leaving" or is_blue) and p.way or p.distance
  if neighbor.distance <= 0 or (neighbor.distance > rest and not is_one_of_mine) then
    return 0, 0
  end
  local square = (rest / neighbor.distance) ^ 2
  local force = -p.push * 100 / neighbor.distance * (square * square - square)
  return force * math.cos(neighbor.angle), force * math.sin(neighbor.angle)
end

local function drive(x, y)
  local speed = math.min(math.sqrt(x * x + y * y), p.pace)
  if speed < p.rest then
    robot.wheels.set_velocity(0, 0)
    return
  end
  local sign = x < 0 and -1 or 1 -- ahead or back, whichever is nearer
  local angle = math.atan(sign * y, sign * x)
  local ahead = sign * speed * math.cos(angle)
  local turn = TURN_GAIN * angle / (math.pi / 2)
  robot.wheels.set_velocity(ahead - turn, ahead + turn)
end

local function follow_forces(shelter)
  local x, y = 0, 0
  if shelter then
    local force = state == "in_group" and p.pull or -p.pace
    x, y = force * math.cos(shelter.angle), force * math.sin(shelter.angle)
  end
  for _, neighbor in ipairs(robot.colored_blob_omnidirectional_camera) do
    local dx, dy = force_of(neighbor)
    x, y = x + dx, y + dy
  end
  drive(x, y)
end

local function change_state(shelter)
  if state == "free" then
    if shelter and not was_in_range and happens(shelter.join) then
      enter("in_group")
    end
  elseif not shelter then
    enter("free")
  elseif state == "in_group" and happens(shelter.leave) then
    enter("leaving")
  end
end

function init()
  for _, name in ipairs({ "speed", "pace", "walk", "pull", "push", "rest" }) do
    p[name] = tonumber(robot.params[name])
  end
  for _, name in ipairs({ "range", "distance", "way" }) do
    p[name] = tonumber(robot.params[name]) * 100
  end
  reset()
end

function reset()
  was_in_range = false
  turn_ticks, turn_sign = 0, 1
  enter("free")
end

function step()
  local shelter = find_shelter()
  if state == "free" then
    walk()
  else
    follow_forces(shelter)
  end
  change_state(shelter)
  was_in_range = shelter ~= nil
end
