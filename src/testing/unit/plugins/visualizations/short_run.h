#ifndef ARGOS3_TESTING_UNIT_PLUGINS_VISUALIZATIONS_SHORT_RUN_H
#define ARGOS3_TESTING_UNIT_PLUGINS_VISUALIZATIONS_SHORT_RUN_H

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/configuration/configuration_document.h>

#include <string>

namespace argos {

/** An experiment of ten ticks, in an arena that is empty by default; the current simulator. */
class CShortRun {
 public:
  /** @param visualization, arena  children of the elements of these names. */
  explicit CShortRun(const std::string& visualization, const std::string& arena = "")
      : m_scope(m_simulator) {
    m_document.Parse(R"(<argos-configuration>
      <framework><experiment length="1" ticks_per_second="10" random_seed="1"/></framework>
      <controllers/><arena size="2,2,1">)" +
                         arena + R"(</arena><physics_engines/>
      <media/>
      <visualization>)" + visualization +
                         "</visualization></argos-configuration>",
                     "test.argos");
    m_simulator.Load(m_document);
  }
  CSimulator& GetSimulator() { return m_simulator; }
  void Run() { m_simulator.Execute(); }

 private:
  CConfigurationDocument m_document;
  CSimulator m_simulator;
  CSimulator::CScope m_scope;
};

}  // namespace argos

#endif
