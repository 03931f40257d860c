#ifndef ARGOS3_CORE_SIMULATOR_LOADING_EXPERIMENT_PARTS_H
#define ARGOS3_CORE_SIMULATOR_LOADING_EXPERIMENT_PARTS_H

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/outputs/run_outputs.h>
#include <argos3/core/simulator/physics_engine/engine_lookup.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/rng.h>

#include <exception>
#include <memory>
#include <vector>

namespace argos {

class CArenaFilling;
class CConfigurationDocument;
class CLoopFunctions;
class CProfiler;
class CReplay;
class CThreadPool;
class CTick;
class CVisualization;
struct STickTimes;

/**
 * What exists from the loading of an experiment to its destruction.
 *
 * Destroy() must be called before the destructor.
 */
struct SExperimentParts {
  explicit SExperimentParts(SSimulationContext& context);
  ~SExperimentParts();
  SExperimentParts(const SExperimentParts&) = delete;
  SExperimentParts& operator=(const SExperimentParts&) = delete;

  bool IsLoaded() const { return Rng != nullptr; }
  /** The caller keeps ownership. */
  void SetLoopFunctions(CLoopFunctions* loopFunctions);
  /** Starts the profiler, which measures @p tick. */
  void StartProfiling(std::unique_ptr<CProfiler> profiler, CTick& tick);
  /**
   * Finishes the outputs, calls the loop functions' Destroy() if their Init() was called, and then
   * destroys the outputs, the visualization, the entities, the loop functions, media, engines, the
   * profiler, random numbers and threads, in this order. A Destroy() of users' code that throws
   * does not stop the others.
   * @return the first exception, or null.
   */
  std::exception_ptr Destroy();

  std::unique_ptr<CConfigurationDocument> OwnDocument; /**< null if the program owns it */
  CConfigurationDocument* Document = nullptr;
  /** In a replay, the file that has views and outputs; null: that of the experiment. */
  std::unique_ptr<CConfigurationDocument> ViewsDocument;
  std::unique_ptr<CReplay> Replay; /**< null: the run is simulated */
  CRandom::CRNG* Rng = nullptr; /**< the first of the category "argos", which owns it */
  std::unique_ptr<CThreadPool> Pool; /**< has no workers until an experiment is loaded */
  std::unique_ptr<CProfiler> Profiler; /**< null: no profiling */
  std::unique_ptr<STickTimes> ProfiledTicks; /**< exists with the profiler only */
  // these have the order of the context's lists
  std::vector<std::unique_ptr<CPhysicsEngine>> Engines;
  std::vector<std::unique_ptr<CMedium>> Media;
  std::unique_ptr<CLoopFunctions> OwnLoopFunctions; /**< null if the program owns them */
  bool AreLoopFunctionsReady = false; /**< initialised and not destroyed */
  bool ChecksControllersAtEnd = false; /**< robots must have used the controllers of the file */
  std::unique_ptr<TConfigurationNode> SetView; /**< of the program; null: that of the file */
  std::unique_ptr<CVisualization> Visualization;
  CRunOutputs Outputs;
  CEngineLookup EngineLookup;
  std::unique_ptr<CArenaFilling> Filling; /**< null in a replay */

 private:
  void FinishProfiling();

  SSimulationContext& m_context;
  CTick* m_profiledTick = nullptr;
};

}  // namespace argos

#endif
