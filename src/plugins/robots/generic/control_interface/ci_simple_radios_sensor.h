#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_SIMPLE_RADIOS_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_SIMPLE_RADIOS_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/byte_array.h>

#include <string>
#include <vector>

namespace argos {

/** Receives messages of any size with the robot's radios. */
class CCI_SimpleRadiosSensor : virtual public CCI_Sensor {
 public:
  /** One radio. */
  struct SInterface {
    std::string Id; /**< of its entity */
    std::vector<CByteArray> Messages; /**< received in the last step */

    typedef std::vector<SInterface> TVector;

    SInterface() = default;
    explicit SInterface(const std::string& id) : Id(id) {}
  };

  /** One for each radio, in order. */
  const SInterface::TVector& GetInterfaces() const { return m_vecInterfaces; }

  /** robot.simple_radios.<id>.recv[i]: the tables that Lua robots sent; other bytes are left out */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  SInterface::TVector m_vecInterfaces;
};

}  // namespace argos

#endif
