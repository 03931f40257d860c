#ifndef ARGOS3_CORE_SIMULATOR_LOADING_EXPERIMENT_LOADER_H
#define ARGOS3_CORE_SIMULATOR_LOADING_EXPERIMENT_LOADER_H

#include <argos3/core/simulator/context/simulation_context.h>

#include <functional>
#include <memory>
#include <utility>

namespace argos {

class CConfigurationDocument;
class CLoopFunctions;
class CTick;
class CVisualization;
struct SExperimentParts;
struct SRunSettings;

/**
 * Makes an experiment from its document: the parts of the file, in the order of their
 * initialisation. A failed part is recorded and loading continues, so that one run reports all
 * errors.
 */
class CExperimentLoader {
 public:
  /** @param experiment  has a document; gets the parts. @param settings  completed from the file.
   */
  CExperimentLoader(SSimulationContext& context, CTick& tick, SExperimentParts& experiment,
                    SRunSettings& settings)
      : m_context(context), m_tick(tick), m_experiment(experiment), m_settings(settings) {}

  /** What each worker thread calls first. */
  void SetWorkerStart(std::function<void()> start) { m_startWorker = std::move(start); }
  /** Makes the visualization of an experiment without one. */
  void SetDefaultVisualization(std::function<std::unique_ptr<CVisualization>()> make) {
    m_makeDefaultVisualization = std::move(make);
  }

  /** @throws CARGoSException that reports all errors that can be found without running. */
  void Load();
  /**
   * The same for a replay: of the recorded experiment, only arena, length of a tick and views; the
   * replay adds the entities. @throws CARGoSException
   */
  void LoadReplay();

 private:
  CConfigurationDocument& GetViewsDocument() const;
  void ApplyOverrides(CLoadErrors& errors);
  void InitReplay(TConfigurationNode& root, CLoadErrors& errors);
  void SkipRecordedOutputs(TConfigurationNode& root) const;
  void ReadLeniency(TConfigurationNode& root);
  void InitFramework(TConfigurationNode& node, CLoadErrors& errors);
  void InitSystem(TConfigurationNode& framework);
  void InitExperiment(TConfigurationNode& framework);
  // seeds the generators with the seed of the settings
  void CreateRandomCategory();
  void InitProfiling(TConfigurationNode& framework);
  void ReplaceFramework();
  void LogLength() const;
  void InitRandom(TConfigurationNode& experiment);
  using TInitChild = void (CExperimentLoader::*)(TConfigurationNode&);
  void InitChildren(TConfigurationNode& section, CLoadErrors& errors, TInitChild init);
  void InitRobotTypes(TConfigurationNode& section, CLoadErrors& errors);
  void InitControllers(TConfigurationNode& node, CLoadErrors& errors);
  void InitRobotType(TConfigurationNode& node);
  void InitController(TConfigurationNode& node);
  void CreateLoopFunctions(TConfigurationNode& root, CLoadErrors& errors);
  void CreateLoopFunctionsOf(TConfigurationNode& node);
  void AdoptLoopFunctions(std::unique_ptr<CLoopFunctions> loopFunctions);
  void InitPhysics(TConfigurationNode& node, CLoadErrors& errors);
  void InitMedia(TConfigurationNode& node, CLoadErrors& errors);
  void InitArena(TConfigurationNode& node, CLoadErrors& errors);
  void InitLoopFunctions(TConfigurationNode& root, CLoadErrors& errors);
  void PostSpaceInit(CLoadErrors& errors);
  void AddOutputElements(CLoadErrors& errors);
  void InitViews(TConfigurationNode& root, CLoadErrors& errors);
  void InitView(TConfigurationNode& node);
  void InitSetView(TConfigurationNode& root);
  void InitOutputs(TConfigurationNode& root, CLoadErrors& errors);
  bool MayAddRobots() const;
  void CheckUnread(CLoadErrors& errors) const;

  SSimulationContext& m_context;
  CTick& m_tick;
  SExperimentParts& m_experiment;
  SRunSettings& m_settings;
  std::function<void()> m_startWorker;
  std::function<std::unique_ptr<CVisualization>()> m_makeDefaultVisualization;
};

}  // namespace argos

#endif
