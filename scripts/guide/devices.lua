-- Prints the names in the table of each device, for check_devices.py.
local named = { cameras = 2, simple_radios = 1, pheromone = 1, magnets = 1, joints = 1 }
local seen = {}

local function walk(path, value, names)
  if not seen[path] then
    seen[path] = true
    log("key ", path)
  end
  if type(value) == "table" then
    for key, inner in pairs(value) do
      if type(key) == "number" then
        walk(path .. "[i]", inner, 0)
      else
        walk(path .. "." .. (names > 0 and "*" or key), inner, names - 1)
      end
    end
  end
end

function init()
  for _, name in ipairs({ "colored_blob_omnidirectional_camera", "colored_blob_perspective_camera", "distance_scanner" }) do
    if robot[name] then robot[name].enable() end
  end
  if robot.leds and robot.leds.set_all_colors then robot.leds.set_all_colors("red") end
end

function step()
  for name, device in pairs(robot) do
    if type(device) == "table" and name ~= "params" and name ~= "random" then
      walk("robot." .. name, device, named[name] or 0)
    end
  end
end

function reset() end
function destroy() end
