#ifndef ARGOS3_CORE_SIMULATOR_VISUALIZATION_VISUALIZATION_H
#define ARGOS3_CORE_SIMULATOR_VISUALIZATION_VISUALIZATION_H

#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/plugins/factory.h>

namespace argos {

class CSimulator;
class CSpace;

/**
 * Owns the main loop: steps the simulator until the experiment is finished, and shows it.
 *
 * Drawing reads the space between ticks and changes nothing in it.
 */
class CVisualization : public CBaseConfigurableResource {
 public:
  CVisualization();
  ~CVisualization() override = default;

  void Init(TConfigurationNode&) override {}
  void Reset() override {}
  void Destroy() override {}

  /**
   * Runs the experiment: until CSimulator::IsExperimentFinished(), calls UpdateSpace(); then
   * CLoopFunctions::PostExperiment().
   */
  virtual void Execute() = 0;

 protected:
  CSimulator& m_cSimulator;
  CSpace& m_cSpace;
};

}  // namespace argos

#define REGISTER_VISUALIZATION(CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION,    \
                               LONG_DESCRIPTION, STATUS)                                \
  REGISTER_SYMBOL(CVisualization, CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, \
                  LONG_DESCRIPTION, STATUS)

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/simulator.h>
#endif

#endif
