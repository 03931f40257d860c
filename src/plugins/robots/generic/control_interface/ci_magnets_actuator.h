#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_MAGNETS_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_MAGNETS_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>
#include <vector>

namespace argos {

/** The currents of a robot's magnets. */
class CCI_MagnetsActuator : virtual public CCI_Actuator {
 public:
  /** One magnet. */
  struct SInterface {
    std::string Id; /**< of its entity */
    Real Current; /**< multiple of the current of the active field; 0 at the start */

    typedef std::vector<SInterface> TVector;

    SInterface(const std::string& id, Real current);
  };

  /** One interface for each magnet, in order; a controller sets the currents. */
  SInterface::TVector& GetInterfaces();

  /** robot.magnets.<id>.set_current(c) */
  void CreateLuaState(lua_State* state) override;

 protected:
  SInterface::TVector m_vecInterfaces;
};

}  // namespace argos

#endif
