#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_PHEROMONE_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_PHEROMONE_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/vector2.h>

#include <string>
#include <vector>

namespace argos {

/** Smells substances on the ground. */
class CCI_PheromoneSensor : public CCI_Sensor {
 public:
  /** At one point. */
  struct SReading {
    Real Value = 0.0; /**< concentration, amount per m^2 */
    CVector2 Offset; /**< of the point from the robot's centre, in the robot's frame, cm */
  };
  typedef std::vector<SReading> TReadings;

  /** One substance. */
  struct SInterface {
    std::string Layer; /**< its id */
    TReadings Readings; /**< at each point, in the order of the experiment file */

    typedef std::vector<SInterface> TVector;
  };

  /** One for each layer that is smelled, in order. */
  const SInterface::TVector& GetInterfaces() const { return m_vecInterfaces; }
  /** Of the first layer. */
  const TReadings& GetReadings() const { return m_vecInterfaces.front().Readings; }
  /**
   * Valid as long as the sensor: look it up once.
   * @throws CARGoSException with the layers there are, if it is none of them.
   */
  const TReadings& GetReadings(const std::string& layer) const;

  /** robot.pheromone.<layer>[i] = { value, offset } */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  SInterface::TVector m_vecInterfaces;
};

}  // namespace argos

#endif
