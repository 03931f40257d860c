// The visualization that the program sets, such as that of --live.

#include <argos3/core/simulator/loading/experiment_loader.h>
#include <argos3/core/simulator/loading/experiment_parts.h>
#include <argos3/core/simulator/loading/run_settings.h>
#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/replay/replay.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/core/simulator/visualization/visualization.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/profiler/profiler.h>
#include <argos3/core/utility/threads/thread_pool.h>

namespace argos {

namespace {

// what users' code draws into the first view that has such functions
void CopyUserFunctions(TConfigurationNode& section, TConfigurationNode& view) {
  TConfigurationNodeIterator it;
  for (it = it.begin(&section); it != it.end() && !NodeExists(view, "user_functions"); ++it) {
    TConfigurationNodeIterator functions("user_functions");
    for (functions = functions.begin(&*it); functions != functions.end(); ++functions) {
      AddChildNode(view, *functions);
    }
  }
}

}  // namespace

// in place of the children of <visualization>; the document stays that of the user
void CExperimentLoader::InitSetView(TConfigurationNode& root) {
  const SRunSettings::SOutput& wanted = *m_settings.Visualization;
  m_experiment.SetView = std::make_unique<TConfigurationNode>(wanted.Tag);
  if (NodeExists(root, "visualization")) {
    TConfigurationNode& section = GetNode(root, "visualization");
    if (NodeExists(section, wanted.Tag)) {
      m_experiment.SetView = GetNode(section, wanted.Tag).Clone();
    } else {
      CopyUserFunctions(section, *m_experiment.SetView);
    }
  }
  for (const auto& [name, value] : wanted.Attributes) {
    m_experiment.SetView->SetAttribute(name, value);
  }
  InitView(*m_experiment.SetView);
}

}  // namespace argos
