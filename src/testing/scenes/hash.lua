-- Robots that use every device they have: a number made of all readings decides how they move, what they show and send,
-- so a change of any reading becomes a change of the poses.

sum = 0  -- global: a table shows it

local function add(value)
  local kind = type(value)
  if kind == "number" then
    -- infinite and undefined readings count, too
    if value ~= value then value = 0.123 elseif value > 1e9 then value = 0.456 elseif value < -1e9 then value = 0.789 end
    sum = (1.7 * sum + 3.1 + value * 97) % 1000
  elseif kind == "boolean" then
    add(value and 1 or 0)
  elseif kind == "string" then
    add(#value)
  elseif kind == "table" then
    local keys = {}
    for key in pairs(value) do keys[#keys + 1] = key end
    table.sort(keys, function(a, b)
      if type(a) == type(b) then return a < b end
      return type(a) == "number"
    end)
    for _, key in ipairs(keys) do add(value[key]) end
  end
end

-- in [-1, 1]
local function draw()
  sum = (3.9 * sum + 17.3) % 1000
  return sum / 500 - 1
end

local function call(device, name, ...)
  if device and device[name] then device[name](...) end
end

function init()
  for _, name in ipairs({ "colored_blob_omnidirectional_camera", "colored_blob_perspective_camera", "distance_scanner" }) do
    call(robot[name], "enable")
  end
  sum = 37 * (tonumber((robot.id:gsub("%D", ""))) or 1) % 1000
end

function step()
  local names = {}
  for name, device in pairs(robot) do
    if type(device) == "table" and name ~= "params" and name ~= "random" then names[#names + 1] = name end
  end
  table.sort(names)
  for _, name in ipairs(names) do add(robot[name]) end

  call(robot.wheels, "set_velocity", 12 + 12 * draw(), 12 + 12 * draw())
  call(robot.differential_drive, "set_linear_velocity", 0.05 + 0.1 * draw(), 0.05 + 0.1 * draw())
  call(robot.planar_drive, "set_velocity", 0.1 * draw(), 0.1 * draw(), draw())
  call(robot.range_and_bearing, "set_data", 1, math.floor(100 + 100 * draw()))
  call(robot.leds, "set_all_colors", draw() > 0 and "red" or "blue")
  call(robot.leds, "set_single_color", 1, math.floor(100 + 100 * draw()), 50, 100)
  call(robot.directional_leds, "set_all_colors", draw() > 0 and "green" or "orange")
  call(robot.tags, "set_all_payloads", string.rep("x", math.floor(4 + 3 * draw())))
  call(robot.turret, draw() > 0.9 and "set_passive_mode" or "set_position_control_mode")
  call(robot.turret, "set_rotation", 3 * draw())
  call(robot.distance_scanner, "set_rpm", 30 * draw())
  call(robot.pan_tilt_camera, "set_pan", 0.5 * draw())
  call(robot.pan_tilt_camera, "set_tilt", 0.5 * draw())
  if robot.quadrotor then
    call(robot.quadrotor, "set_absolute_position", 2 * draw(), 2 * draw(), 1 + 0.5 * draw())
    call(robot.quadrotor, "set_absolute_yaw", 3 * draw())
    call(robot.quadrotor, "set_linear_velocity", draw(), draw(), draw())
    call(robot.quadrotor, "set_rotational_speed", draw())
  end
  if robot.pheromone then call(robot.pheromone.trail, "set_rate", 1 + draw()) end
  if robot.simple_radios then call(robot.simple_radios.wifi, "send", { draw(), "text" }) end
  if robot.magnets then call(robot.magnets.front, "set_current", 3 * draw()) end
  call(robot.rfid, "write", { math.floor(100 + 100 * draw()) })
  if robot.joints then
    for _, name in ipairs({ "elbow", "wrist", "slide" }) do call(robot.joints[name], "set_target", 0.8 * draw()) end
  end
  call(robot.gripper, draw() > -0.6 and "lock" or "unlock")
  call(robot.gripper, draw() > -0.6 and "lock_positive" or "unlock")
end

function reset() end
function destroy() end
