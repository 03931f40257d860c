#ifndef OWN_SENSOR_CI_COMPASS_SENSOR_H
#define OWN_SENSOR_CI_COMPASS_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/math/angles.h>

/** A compass as controllers see it: on a real robot, too. North is the y axis of the arena. */
class CCI_CompassSensor : public argos::CCI_Sensor {
 public:
  /** Direction of north in the robot's frame, in [-pi, pi]: 0 is ahead, positive is to the left. */
  argos::CRadians GetNorth() const { return m_north; }

  // for Lua: robot.compass.north
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;
  // for tables: <table fields="readings:compass" />
  std::vector<SColumn> GetReadingColumns() const override { return {{"north", "rad"}}; }
  void CopyReadings(argos::Real* numbers, std::size_t count) const override;

 protected:
  argos::CRadians m_north;
};

#endif
