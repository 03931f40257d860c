function step()
  log(robot.random.uniform(1, 2), robot.random.uniform_int(5), robot.random.poisson(3))
  log(robot.random.bernoulli(0.2), robot.random.exponential(1), robot.random.gaussian(1, 2))
end
