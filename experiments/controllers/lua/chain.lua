-- Chain formation: robots line up behind each other, starting at the two robots of the nest. Each member of the chain tells its number;
-- explorers drive to the place behind the member with the largest number that they hear, and become the next one there.
-- For chains that are built by colours see S. Nouyan, A. Campo and M. Dorigo, "Path formation in a robot swarm",
-- Swarm Intelligence 2, 2008.

local speed = tonumber(robot.params.speed) -- cm/s
local spacing = tonumber(robot.params.spacing) -- cm: distance of members
local my_id = tonumber(robot.id:match("%d+")) -- the smaller one wins if two robots take the same place

local MAX_MEMBERS = 255 -- the largest number that a byte of a message can have
local PATIENCE = 20 -- ticks without a message of the member before

local patience -- ticks left
number = 0 -- in the chain: 1 and 2 for the nest, which stays; 0 of explorers. Global, so that the loop functions can read it

local function polar(length, angle)
  return vector2(length * math.cos(angle), length * math.sin(angle))
end

-- what is heard: places of members by number, in this robot's frame, cm; the greatest number; a push away from robots
local function listen()
  local members, last, push = {}, 0, vector2()
  for _, message in ipairs(robot.range_and_bearing) do
    local place = polar(message.range, message.horizontal_bearing)
    local its_number, its_id = message.data[1], message.data[2]
    if its_number > 0 then
      members[its_number] = { place = place, id = its_id }
      last = math.max(last, its_number)
    end
    if message.range < 0.4 * spacing then
      -- to the side as well, so that robots drive around each other
      local strength = 2 * (0.4 * spacing / message.range - 1)
      push = push - polar(strength, message.horizontal_bearing - 0.9)
    end
  end
  for _, reading in ipairs(robot.proximity) do
    push = push - polar(2 * reading.value, reading.angle)
  end
  return members, last, push
end

local function drive(direction)
  local angle = math.atan(direction.y, direction.x)
  local ahead = speed * math.max(0, math.cos(angle)) * math.min(1, direction:length())
  local turn = 0.7 * speed * math.sin(angle / 2)
  robot.wheels.set_velocity(ahead - turn, ahead + turn)
end

-- the free place behind the last member, in line with the one before it
local function next_place(members, last)
  local tail = members[last].place
  return tail + (tail - members[last - 1].place):normalize() * spacing
end

local function explore(members, last, push)
  if last == 0 then
    -- out of reach of the chain: back, in a wide arc
    drive(vector2(1, 0.25) + push)
  elseif not members[last - 1] then
    -- not in sight: to the last one
    drive(vector2(members[last].place):normalize() + push)
  else
    local place = next_place(members, last)
    if place:length() < 3 and last < MAX_MEMBERS then
      number = last + 1
      patience = PATIENCE
      robot.wheels.set_velocity(0, 0)
    else
      drive(vector2(place):normalize() * math.min(1, place:length() / 10) + push)
    end
  end
end

function init()
  number = tonumber(robot.params.number or 0)
end

-- leaves the chain if its place was taken twice, or if the member before it is not there any more
local function keep_place(members)
  local rival = members[number]
  patience = members[number - 1] and PATIENCE or patience - 1
  if patience == 0 or rival and rival.id < my_id then
    number = 0
  end
end

function step()
  local members, last, push = listen()
  if number > 2 then
    keep_place(members)
  end
  if number == 0 then
    explore(members, last, push)
  else
    robot.wheels.set_velocity(0, 0)
  end
  robot.range_and_bearing.set_data({ number, my_id })
  robot.leds.set_all_colors(number == 0 and "blue" or number <= 2 and "yellow" or "red")
end

function reset()
  init()
end

function destroy() end
