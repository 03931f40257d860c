#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_PHEROMONE_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_PHEROMONE_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>
#include <vector>

namespace argos {

/** Lays substances on the ground. */
class CCI_PheromoneActuator : public CCI_Actuator {
 public:
  /** One substance. */
  struct SInterface {
    std::string Layer; /**< its id */
    Real Rate = 0.0; /**< how much is laid, amount per second; holds until it is changed */

    typedef std::vector<SInterface> TVector;
  };

  /** One for each layer that can be laid, in order; a controller may set the rates. */
  SInterface::TVector& GetInterfaces() { return m_vecInterfaces; }
  /** Sets the rate of the first layer. @param rate >= 0, amount per second. @throws CARGoSException
   * if it is not. */
  void SetRate(Real rate);
  /** @throws CARGoSException also with the layers there are, if @p layer is none of them. */
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
