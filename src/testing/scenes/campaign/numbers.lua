-- Numbers that look like results: they depend on the parameters and on the seed, have ties and outliers, and some runs end early.
local tick = 0
local delivered = 0

function init()
  metrics.record("delivered", 0)
end

function reset() end

function post_step()
  tick = tick + 1
  local params = simulation.params
  local robots, speed = tonumber(params.robots), tonumber(params.speed)
  local luck = math.random()
  delivered = delivered + math.floor(luck * robots * (speed + 3 * tonumber(params.bonus)) / 20)
  metrics.record("delivered", delivered)
  metrics.record("distance", robots * (0.3 + luck) + tick * speed / 100)
  if luck > 0.7 and tick > 3 then metrics.record("late", tick) end
end

function is_experiment_finished()
  return delivered > 60
end

function post_experiment()
  metrics.record("efficiency", delivered / (1 + tick * tonumber(simulation.params.robots)))
end
