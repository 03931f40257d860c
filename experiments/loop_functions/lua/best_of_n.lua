-- The ground of best of n: tiles of three colours, at random places but in exact numbers. The metrics are the shares of
-- the robots that have each opinion.

local tile = tonumber(simulation.params.tile) -- m
local shares = { tonumber(simulation.params.black), tonumber(simulation.params.grey) } -- the rest is white
local COLOURS = { "black", "gray50", "white" }

local columns = math.ceil(simulation.arena.size.x / tile)
local tiles -- colours, by rows

-- as many of each colour as the shares say, shuffled with the seed of the run
local function lay_tiles()
  local total = columns * math.ceil(simulation.arena.size.y / tile)
  tiles = {}
  for i = 1, total do
    tiles[i] = i <= shares[1] * total and 1 or i <= (shares[1] + shares[2]) * total and 2 or 3
  end
  for i = total, 2, -1 do
    local j = simulation.random.uniform_int(1, i + 1)
    tiles[i], tiles[j] = tiles[j], tiles[i]
  end
end

local function count()
  local counts = { 0, 0, 0 }
  local ids = simulation.ids("e-puck")
  for _, id in ipairs(ids) do
    local opinion = simulation.get_variable(id, "opinion")
    counts[opinion] = counts[opinion] + 1
  end
  metrics.record("for_black", counts[1] / #ids)
  metrics.record("for_grey", counts[2] / #ids)
  metrics.record("for_white", counts[3] / #ids)
  return math.max(table.unpack(counts)) == #ids
end

function init()
  lay_tiles()
  count()
end

function reset()
  init()
  simulation.floor_changed()
end

-- all agree: the run is over
function post_step()
  if count() then
    simulation.finish()
  end
end

function floor_color(x, y)
  local column = math.floor((x - simulation.arena.min.x) / tile)
  local row = math.floor((y - simulation.arena.min.y) / tile)
  return COLOURS[tiles[math.min(#tiles, row * columns + column + 1)]]
end
