local mark = setmetatable({}, {__close = function() log('closed') end})
local c = coroutine.wrap(function(a) local x <close> = mark while true do a = coroutine.yield(a + 1) end end)
function step() for i = 1, 10 do c(i) end end
