-- The controller of shelter.h in Lua: a shelter, which counts its group and broadcasts the probabilities to join and to leave.
-- The bytes of a message are those of shelter_message.h.
local DEAF_TICKS = 50 -- longer than a signal runs to and fro between shelters
local WIDTH, HEIGHT = 640, 480 -- image of the camera, pixels; its diagonal spans twice the aperture

local p = {} -- parameters
local number, size, starts_active
local events = {} -- of this shelter: [tick] = whether it activates
local tick, is_active, ticks_since_reset, deaf_ticks, hops_to_send
local group, window_ticks, window_group, is_steady, has_converged

local function show()
  robot.leds.set_all_colors(not is_active and "black" or has_converged and "white" or "yellow")
end

local function read_sizes(text)
  local sizes = {}
  for word in text:gmatch("%d+") do
    sizes[#sizes + 1] = tonumber(word)
  end
  size = sizes[math.min(number + 1, #sizes)]
end

local function read_events(text)
  local first
  for shelter, sign, time in text:gmatch("(%d+)([+-])(%d+)") do
    if tonumber(shelter) == number then
      events[tonumber(time)] = sign == "+"
      first = first or sign
    end
  end
  starts_active = first ~= "+"
end

-- restarts the decay, and sends the signal on to <hops> more shelters
local function restart(hops)
  ticks_since_reset = 0
  hops_to_send = hops
  deaf_ticks = DEAF_TICKS
  window_ticks = 0
  has_converged = false
end

local function hear_resets()
  if deaf_ticks > 0 then
    deaf_ticks = deaf_ticks - 1
    return
  end
  for _, packet in ipairs(robot.range_and_bearing) do
    if packet.data[6] > 0 then
      restart(packet.data[6] - 1)
      return
    end
  end
end

local function follow_events()
  if events[tick] ~= nil then
    is_active = events[tick]
    restart(p.hops)
    show()
  end
end

local function count()
  -- the camera is on for one tick of each period
  local camera = robot.colored_blob_perspective_camera
  local phase = tick % p.count_every
  if phase == p.count_every - 1 then
    camera.enable()
  end
  if phase ~= 0 then
    return
  end
  camera.disable()
  local focus = math.sqrt(WIDTH ^ 2 + HEIGHT ^ 2) / 2 / math.tan(math.rad(p.aperture)) -- pixels
  local radius = focus * p.range / p.height -- of the disc in the image, pixels
  group = 0
  for _, blob in ipairs(camera) do
    local x, y = blob.x + 0.5 - WIDTH / 2, blob.y + 0.5 - HEIGHT / 2
    if blob.color.red == 255 and x * x + y * y <= radius * radius then
      group = group + 1
    end
  end
end

local function judge_convergence()
  if window_ticks == 0 then
    window_group = group
    is_steady = true
  end
  -- standard deviation of the number of robots that leave by chance in a window
  local tolerance = math.sqrt(p.window * window_group * p.leave_low * (1 - p.leave_low))
  is_steady = is_steady and math.abs(group - window_group) <= tolerance
  window_ticks = window_ticks + 1
  if window_ticks == p.window then
    has_converged = is_steady
    window_ticks = 0
  end
  if is_active then
    metrics.record("converged", has_converged and 1 or 0)
  end
  show()
end

local function broadcast()
  local join, leave = 0, 0
  if is_active then
    local decay = math.exp(-math.log(10) / p.delta * ticks_since_reset)
    if group < size then
      join = math.floor(size / p.capacity * 65535 + 0.5)
    end
    leave = math.floor(((p.leave_high - p.leave_low) * decay + p.leave_low) * 1e6 + 0.5)
  end
  robot.range_and_bearing.set_data({
    is_active and 1 or 0, join // 256, join % 256, leave // 256, leave % 256, hops_to_send, 0, 0
  })
end

function init()
  for _, name in ipairs({
    "range", "capacity", "leave_high", "leave_low", "delta", "count_every", "window", "hops", "height", "aperture"
  }) do
    p[name] = tonumber(robot.params[name])
  end
  p.hops = math.tointeger(p.hops)
  number = tonumber(robot.id:match("%d+"))
  read_sizes(robot.params.sizes)
  read_events(robot.params.events)
  reset()
end

function reset()
  tick, is_active, ticks_since_reset, deaf_ticks, hops_to_send = 0, starts_active, 0, 0, 0
  group, window_ticks, window_group, is_steady, has_converged = 0, 0, 0, true, false
  show()
end

function step()
  robot.ceiling.attach()
  hops_to_send = 0
  ticks_since_reset = ticks_since_reset + 1
  hear_resets()
  follow_events()
  count()
  judge_convergence()
  broadcast()
  tick = tick + 1
end
