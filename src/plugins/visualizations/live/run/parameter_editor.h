#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_PARAMETER_EDITOR_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_PARAMETER_EDITOR_H

#include <argos3/core/control_interface/changeable_parameters.h>
#include <argos3/plugins/simulator/visualizations/live/link/live_messages.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace argos {

class CEntity;
class CSimulator;

/**
 * Numbers that controllers and loop functions declare as changeable, see CChangeableParameters.
 * Between ticks, on the main thread.
 */
class CParameterEditor {
 public:
  explicit CParameterEditor(CSimulator& simulator) : m_simulator(simulator) {}

  /**
   * @param root  whose controller is asked; null: the loop functions.
   * @return a list of objects with "name", "value", "min", "max", "unit"; empty if there are none.
   */
  TJson List(CEntity* root) const;
  /**
   * Sets a value, of the loop functions, of a robot, or of all robots whose controllers are of the
   * same class.
   * @param arguments  "name", "value"; "all": true or false, the default.
   * @return the number of "robots" that were changed.
   * @throws CARGoSException if there is no such parameter, or the value is outside of its range.
   */
  TJson Set(CEntity* root, const TJson& arguments);

  /** The values from before the first changes are set, for a reset. */
  void Restore();

 private:
  CChangeableParameters* Find(CEntity* root) const;
  bool SetValue(CEntity* root, const std::string& name, Real value, bool isRequired);

  CSimulator& m_simulator;
  std::map<std::pair<std::string, std::string>, Real>
      m_originals;  // by id of the robot, empty for loop functions, and name
};

}  // namespace argos

#endif
