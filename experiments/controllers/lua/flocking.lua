-- Foot-bots that keep a distance from each other, and drive to a light, as a flock.
-- See controllers/footbot_flocking for the same in C++, and for the source of the forces.

local BEACON = 13 -- index of the LED on top
-- radius of the neighbourhood, in target distances
local REACH = 1.8

local max_speed = tonumber(robot.params.max_speed) -- cm/s
local target_distance = tonumber(robot.params.target_distance) -- cm
local gain = tonumber(robot.params.gain) -- cm^2/s
local light_speed = tonumber(robot.params.light_speed) -- cm/s

-- a vector of that length and angle (rad), in the robot's frame
local function polar(length, angle)
  return vector2(length * math.cos(angle), length * math.sin(angle))
end

local function vector_to_light()
  local sum = vector2()
  for _, reading in ipairs(robot.light) do
    sum = sum + polar(reading.value, reading.angle)
  end
  if sum:length() == 0 then
    return sum
  end
  return sum:normalize() * light_speed
end

local function flocking_vector()
  local sum = vector2()
  for _, blob in ipairs(robot.colored_blob_omnidirectional_camera) do
    if blob.color.red == 255 and blob.color.green == 0 and blob.distance < REACH * target_distance then
      local ratio = target_distance / blob.distance
      local repulsion = gain / blob.distance * (ratio ^ 4 - ratio ^ 2)
      sum = sum + polar(-repulsion, blob.angle)
    end
  end
  return sum
end

-- the outer wheel has the requested speed, the inner one slows down with the angle between the
-- vector and the heading
local function follow(velocity)
  local speed = math.min(velocity:length(), max_speed)
  local angle = math.atan(velocity.y, velocity.x)
  local turn = math.min(1, math.abs(angle) / (math.pi / 2))
  local inner = speed * (1 - 2 * turn)
  if angle > 0 then
    robot.wheels.set_velocity(inner, speed)
  else
    robot.wheels.set_velocity(speed, inner)
  end
end

function init()
  robot.colored_blob_omnidirectional_camera.enable()
  robot.leds.set_single_color(BEACON, "red")
end

function step()
  robot.leds.set_single_color(BEACON, "red")
  follow(vector_to_light() + flocking_vector())
end

function reset()
  init()
end

function destroy() end
