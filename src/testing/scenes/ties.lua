-- Robots that drive as symmetrically as they stand: straight on, with a turn on the spot every second second.

local tick = 0

function step()
  tick = tick + 1
  local turns = tick % 20 >= 15
  if robot.wheels then
    robot.wheels.set_velocity(turns and -6 or 8, turns and 6 or 8)
  end
  if robot.gripper and robot.params.grips == "true" then
    if tick % 30 < 20 then
      if robot.gripper.lock then robot.gripper.lock() else robot.gripper.lock_positive() end
    else
      robot.gripper.unlock()
    end
  end
  if robot.turret then
    if tick % 40 < 20 then
      robot.turret.set_position_control_mode()
      robot.turret.set_rotation(1)
    else
      robot.turret.set_passive_mode()
    end
  end
end
