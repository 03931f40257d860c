#ifndef ARGOS3_TESTING_SUPPORT_EXPERIMENT_H
#define ARGOS3_TESTING_SUPPORT_EXPERIMENT_H

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/configuration/configuration_document.h>

#include <functional>
#include <string>

namespace argos {

/**
 * The text of an experiment; the defaults are the minimum that works.
 *
 * SExperiment{.Engines = "<dynamics2d id='dyn2d' />", .Arena = "<box ... />"}.ToXml()
 */
struct SExperiment {
  UInt32 Threads = 0;
  std::string Method = "balance_quantity";
  UInt32 TicksPerSecond = 10;
  Real Length = 0.0; /**< s; 0 = unlimited */
  UInt32 Seed = 1;
  std::string Controllers = ""; /**< children of <controllers> */
  std::string LoopFunctions = ""; /**< the whole element, or empty */
  std::string Engines = ""; /**< children of <physics_engines> */
  std::string Media = ""; /**< children of <media> */
  std::string ArenaSize = "10,10,2";
  std::string ArenaCenter = ""; /**< empty: as if the attribute is absent */
  std::string ArenaAttributes = ""; /**< others, such as "periodic='x'" */
  std::string Arena = ""; /**< children of <arena> */

  std::string ToXml() const;
};

/**
 * An experiment that runs headless in a simulator of its own.
 *
 * Several may exist at once, also in one thread. Code that uses the current simulator (constructors
 * of entities, loop functions of users) needs a CSimulator::CScope around it.
 */
class CTestWorld {
 public:
  /**
   * Loads an experiment.
   * @param prepare  called before loading, for overrides.
   * @throws CARGoSException on any loading error.
   */
  explicit CTestWorld(const std::string& xml, const std::function<void(CSimulator&)>& prepare = {});
  explicit CTestWorld(const SExperiment& experiment,
                      const std::function<void(CSimulator&)>& prepare = {})
      : CTestWorld(experiment.ToXml(), prepare) {}

  CSimulator& GetSimulator() { return m_simulator; }
  CSpace& GetSpace() { return m_simulator.GetSpace(); }
  /** Runs that many ticks. */
  void Step(UInt32 ticks = 1);
  UInt64 ComputeDigest() { return GetSpace().ComputeDigest(); }

  /** @return the entity with that qualified id. @throws std::bad_cast if it is not an ENTITY. */
  template <typename ENTITY>
  ENTITY& Get(const std::string& id) {
    return dynamic_cast<ENTITY&>(GetSpace().GetEntity(id));
  }
  /** @return the loop functions. @throws std::bad_cast if they are not FUNCTIONS. */
  template <typename FUNCTIONS>
  FUNCTIONS& GetLoopFunctions() {
    return dynamic_cast<FUNCTIONS&>(m_simulator.GetLoopFunctions());
  }

 private:
  CConfigurationDocument m_document;  // outlives everything loaded from it
  CSimulator m_simulator;
};

/** The error on loading an experiment; empty if it loads. */
std::string LoadError(const SExperiment& experiment);

}  // namespace argos

#endif
