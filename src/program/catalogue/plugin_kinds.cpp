#include <argos3/program/catalogue/plugin_kinds.h>

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/actuator.h>
#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/entity/entity_type.h>
#include <argos3/core/simulator/entity/sensor.h>
#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/outputs/field.h>
#include <argos3/core/simulator/outputs/run_output.h>
#include <argos3/core/simulator/physics_engine/space_partition.h>
#include <argos3/core/simulator/space/built_in_metric.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/core/simulator/visualization/overlay.h>
#include <argos3/core/simulator/visualization/visualization.h>
#include <argos3/core/utility/plugins/process_wide.h>

namespace argos {

namespace {

// includes what is listed among the engines in an experiment file, but is not an engine
std::vector<SPluginText> ListEngines() {
  std::vector<SPluginText> plugins = ListPlugins<CPhysicsEngine>();
  plugins.push_back({"auto_partition", "the authors of this project", "1.0",
                     "Not an engine: creates one engine for each part of the arena.",
                     kAutoPartitionDocumentation, "Usable",
                     GetLibraryOf(reinterpret_cast<const void*>(&ListPluginKinds))});
  return plugins;
}

// both may be children of <visualization>
std::vector<SPluginText> ListViewsAndOutputs() {
  std::vector<SPluginText> plugins = ListPlugins<CRunOutput>();
  const std::vector<SPluginText> views = ListPlugins<CVisualization>();
  plugins.insert(plugins.end(), views.begin(), views.end());
  return plugins;
}

}  // namespace

std::vector<SPluginKind> ListPluginKinds() {
  std::vector<SPluginKind> all = {
      {"actuators", "actuator", "AVAILABLE ACTUATORS", ListPlugins<CSimulatedActuator>()},
      {"sensors", "sensor", "AVAILABLE SENSORS", ListPlugins<CSimulatedSensor>()},
      {"physics_engines", "physics engine", "AVAILABLE PHYSICS ENGINES", ListEngines()},
      {"media", "medium", "AVAILABLE MEDIA", ListPlugins<CMedium>()},
      {"visualizations", "visualization", "AVAILABLE VISUALIZATIONS AND OTHER OUTPUTS",
       ListViewsAndOutputs()},
      {"overlays", "overlay", "AVAILABLE OVERLAYS", ListPlugins<COverlay>()},
      {"entities", "entity", "AVAILABLE ENTITIES", ListPlugins<CEntity>()},
      {"robot_types", "robot type", "AVAILABLE ROBOT TYPES", ListPlugins<CEntityType>()},
      {"fields", "field", "AVAILABLE FIELDS", ListPlugins<CField>()},
      {"built_in_metrics", "built-in metric", "AVAILABLE BUILT-IN METRICS",
       ListPlugins<CBuiltInMetric>()},
      {"controllers", "controller", "AVAILABLE CONTROLLERS", ListPlugins<CCI_Controller>()},
      {"loop_functions", "loop functions", "AVAILABLE LOOP FUNCTIONS",
       ListPlugins<CLoopFunctions>()}};
  for (const auto& [word, kind] : CPluginKind::GetAll()) {
    all.push_back({word, "part of " + kind.Of, kind.Header, kind.List(), kind.Of});
  }
  return all;
}

}  // namespace argos
