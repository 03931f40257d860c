#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_SIMPLE_RADIOS_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_SIMPLE_RADIOS_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/byte_array.h>

#include <string>
#include <vector>

namespace argos {

/** Sends messages of any size with the robot's radios. */
class CCI_SimpleRadiosActuator : virtual public CCI_Actuator {
 public:
  /** One radio. */
  struct SInterface {
    std::string Id; /**< of its entity */
    std::vector<CByteArray> Messages; /**< queue of messages; cleared after sending */

    typedef std::vector<SInterface> TVector;

    SInterface() = default;
    explicit SInterface(const std::string& id) : Id(id) {}
  };

  /** One interface for each radio, in order. */
  SInterface::TVector& GetInterfaces() { return m_vecInterfaces; }

  /** robot.simple_radios.<id>.send(table) */
  void CreateLuaState(lua_State* state) override;

 protected:
  SInterface::TVector m_vecInterfaces;
};

}  // namespace argos

#endif
