function step()
  local ok, message = pcall(error, {})
  xpcall(error, function(m) return debug.traceback(m) end, 'x')
  local t = setmetatable({}, {__index = function(_, k) return k .. k end})
  return table.concat({t.a, ('x'):rep(3, ','), string.format('%5.2f', 1.5)}), load('return ...')(1)
end
