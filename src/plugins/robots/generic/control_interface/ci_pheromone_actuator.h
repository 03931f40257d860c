#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_PHEROMONE_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_PHEROMONE_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>
#include <vector>

namespace argos {

/** Deposits substances on the ground. */
class CCI_PheromoneActuator : public CCI_Actuator {
 public:
  /** One substance. */
  struct SInterface {
    std::string Layer; /**< its id */
    Real Rate = 0.0; /**< deposited amount per second; holds until it is changed */

    typedef std::vector<SInterface> TVector;
  };

  /** One interface for each layer, in order; a controller may set the rates. */
  SInterface::TVector& GetInterfaces() { return m_vecInterfaces; }
  /** Sets the rate of the first layer, >= 0, amount per second. @throws CARGoSException if < 0. */
  void SetRate(Real rate);
  /** @throws CARGoSException also if the layer is unknown; the text lists the layers. */
  void SetRate(const std::string& layer, Real rate);

  /** robot.pheromone.<layer>.set_rate(rate) */
  void CreateLuaState(lua_State* state) override;

 protected:
  /** @throws CARGoSException if a rate is not a number >= 0. */
  static Real CheckRate(const SInterface& interface, Real rate);

  SInterface::TVector m_vecInterfaces;
};

}  // namespace argos

#endif
