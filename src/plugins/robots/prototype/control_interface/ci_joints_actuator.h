#ifndef ARGOS3_PLUGINS_ROBOTS_PROTOTYPE_CONTROL_INTERFACE_CI_JOINTS_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_PROTOTYPE_CONTROL_INTERFACE_CI_JOINTS_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>
#include <vector>

namespace argos {

/** The motors of a robot's joints. */
class CCI_JointsActuator : virtual public CCI_Actuator {
 public:
  /** The motor of one joint. */
  struct SInterface {
    enum class EMode : UInt8 { DISABLED, POSITION, VELOCITY };

    std::string Id; /**< of the joint */
    EMode Mode; /**< of the experiment file */
    Real Target; /**< rad or m; rad/s or m/s; 0 at the start */

    typedef std::vector<SInterface> TVector;

    SInterface(const std::string& id, EMode mode);
  };

  /** One interface for each joint that is listed, in order; a controller sets the targets. */
  SInterface::TVector& GetInterfaces();

  /** robot.joints.<id>.set_target(v) */
  void CreateLuaState(lua_State* state) override;

 protected:
  SInterface::TVector m_vecInterfaces;
};

}  // namespace argos

#endif
