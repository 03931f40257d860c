-- does nothing
function init() end

function step() end

function reset() end

function destroy() end
