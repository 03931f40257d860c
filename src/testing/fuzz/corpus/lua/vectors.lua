local v = vector3(1, 2, 3):normalize() + vector3(0, 0, 1) * 2
local q = quaternion(0.5, vector3(0, 0, 1)) * quaternion()
function step() log(v:rotate(q).x, vector2(1, 2):dot(vector2(3, 4)), tostring(q)) end
