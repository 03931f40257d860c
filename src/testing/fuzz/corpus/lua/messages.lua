function step()
  local t = robot.roundtrip({1, 2.5, 'x', true, {vector2(1, 2), quaternion()}, k = {}})
  for key, value in pairs(t) do log(key, value) end
end
