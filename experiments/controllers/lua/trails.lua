-- Fetches food with trails, like ants: wanders until it stands on food, deposits a trail on the way
-- home, and follows trails that it finds.
-- See controllers/epuck_trails for the same in C++, and for the source.
--
-- <params>: max_speed (cm/s), rate (amount deposited per second), threshold (1/m^2: sum of both antennae on a trail),
-- wandering (standard deviation of the change of direction in a step, rad), nest_x, nest_y (m).

local FOOD_GREY, NEST_GREY = 0.25, 0.6 -- food is darker than FOOD_GREY, the nest is between both
local CROWDED = 0.1
local EVASION = math.rad(-140) -- robots that meet both pass on the right
local SHYNESS = 1.5
local TURN_GAIN = 3 -- gain of the difference between the antennae
local OUTWARDS = 0.6 -- weight of the direction away from the nest
local DRIFT_KEPT = 0.9

local max_speed = tonumber(robot.params.max_speed or 8)
local rate = tonumber(robot.params.rate or 1)
local threshold = tonumber(robot.params.threshold or 5)
local wandering = tonumber(robot.params.wandering or 0.1)
local nest = vector2(tonumber(robot.params.nest_x or 0), tonumber(robot.params.nest_y or 0))

local drift -- turn of a wandering robot per step, rad
has_food = false -- read by the loop functions, like the next one
delivered = 0

local function vector_home()
  local position = robot.positioning.position
  local way = nest - vector2(position.x, position.y)
  local heading = robot.positioning.orientation:toeulerangles()
  return way:length() > 0 and way:normalize():rotate(-heading) or way
end

local function vector_off_obstacles()
  local sum = vector2()
  for _, reading in ipairs(robot.proximity) do
    sum = sum + vector2(reading.value, 0):rotate(reading.angle)
  end
  if sum:length() <= CROWDED then
    return vector2()
  end
  return vector2(SHYNESS, 0):rotate(math.atan(sum.y, sum.x) + EVASION)
end

local function search()
  local left, right = robot.pheromone.trail[1].value, robot.pheromone.trail[2].value
  if left + right >= threshold then
    drift = 0
    return vector2(1, TURN_GAIN * (left - right) / (left + right)) - OUTWARDS * vector_home()
  end
  drift = DRIFT_KEPT * drift + robot.random.gaussian(wandering)
  return vector2(1, 0):rotate(drift)
end

-- the outer wheel has full speed, the inner one slows down with the angle to the heading
local function follow(way)
  local angle = math.atan(way.y, way.x)
  local inner = max_speed * (1 - 2 * math.min(1, math.abs(angle) / (math.pi / 2)))
  if angle > 0 then
    robot.wheels.set_velocity(inner, max_speed)
  else
    robot.wheels.set_velocity(max_speed, inner)
  end
end

local function take_or_deliver()
  local grey = math.max(robot.ground[1], robot.ground[2], robot.ground[3])
  if not has_food and grey < FOOD_GREY then
    has_food = true
    robot.leds.set_all_colors("green")
    robot.pheromone.trail.set_rate(rate)
  elseif has_food and grey > FOOD_GREY and grey < NEST_GREY then
    has_food = false
    delivered = delivered + 1
    robot.leds.set_all_colors("black")
    robot.pheromone.trail.set_rate(0)
  end
end

function init()
  reset()
end

function step()
  take_or_deliver()
  follow((has_food and vector_home() or search()) + vector_off_obstacles())
end

function reset()
  drift, has_food, delivered = 0, false, 0
  robot.leds.set_all_colors("black")
end

function destroy() end
