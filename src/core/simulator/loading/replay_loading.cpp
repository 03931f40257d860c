// Loading of a recording in place of an experiment: arena, views and outputs, and nothing that
// acts.

#include <argos3/core/simulator/context/load_errors.h>
#include <argos3/core/simulator/loading/experiment_loader.h>
#include <argos3/core/simulator/loading/experiment_parts.h>
#include <argos3/core/simulator/loading/load_warnings.h>
#include <argos3/core/simulator/loading/run_settings.h>
#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/replay/replay.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/core/simulator/visualization/visualization.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/profiler/profiler.h>
#include <argos3/core/utility/threads/thread_pool.h>

namespace argos {

CConfigurationDocument& CExperimentLoader::GetViewsDocument() const {
  return m_experiment.ViewsDocument != nullptr ? *m_experiment.ViewsDocument
                                               : *m_experiment.Document;
}

void CExperimentLoader::LoadReplay() {
  CLoadErrors errors;
  m_context.Loading.Begin();
  m_context.IsReplay = true;
  m_context.IsExactReplay = m_experiment.Replay->IsExact();
  TConfigurationNode& root = m_experiment.Document->GetRoot();
  TConfigurationNode& viewsRoot = GetViewsDocument().GetRoot();
  if (m_experiment.ViewsDocument == nullptr) {
    SkipRecordedOutputs(root);
  }
  AddOutputElements(errors);
  ApplyOverrides(errors);
  errors.Try("", [&] { ReadLeniency(root); });
  if (errors.Try("", [&] { InitReplay(root, errors); })) {
    InitViews(viewsRoot, errors);
    InitOutputs(viewsRoot, errors);
  }
  CheckUnread(errors);
  errors.ThrowIfAny();
  m_context.Loading.End();
  m_context.Space->MarkStart();
  LOG.Flush();
  LOGERR.Flush();
}

void CExperimentLoader::InitReplay(TConfigurationNode& root, CLoadErrors& errors) {
  // all that a run reads of <framework>, and a replay does not, would have no effect: an error in
  // --set
  TConfigurationNode& experiment = GetNode(GetNode(root, "framework"), "experiment");
  GetNodeAttributeOrDefault(experiment, "real_time", m_settings.IsRealTime, m_settings.IsRealTime);
  m_context.TickLength = m_experiment.Replay->GetTickLength();
  CreateRandomCategory();
  m_context.Space->Init(GetNode(root, "arena"));
  AdoptLoopFunctions(m_experiment.Replay->MakeLoopFunctions());
  m_experiment.Replay->Begin(*m_context.Space);
  m_settings.MaxClock = m_experiment.Replay->GetLastTick();
  m_context.Loading.RunChecks(errors);
}

// a replay must not overwrite what the recorded run has left
void CExperimentLoader::SkipRecordedOutputs(TConfigurationNode& root) const {
  if (!NodeExists(root, "outputs")) {
    return;
  }
  LOG << "[INFO] The outputs of the recorded run are not written again; --record, --video, or "
         "<outputs> "
         "of another file (-c), add some to the replay"
      << std::endl;
  root.RemoveChild(&GetNode(root, "outputs"));
}

}  // namespace argos
