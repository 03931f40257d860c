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

constexpr const char* kOwnAuthor = "the authors of this project";

using TPlugins = std::vector<SPluginText>;

TPlugins operator+(TPlugins plugins, const TPlugins& more) {
  plugins.insert(plugins.end(), more.begin(), more.end());
  return plugins;
}

// listed among the engines in an experiment file, but not an engine
TPlugins AutoPartition() {
  return {{"auto_partition", kOwnAuthor, "1.0",
           "Not an engine: creates one engine for each part of the arena.",
           kAutoPartitionDocumentation, "Usable",
           GetLibraryOf(reinterpret_cast<const void*>(&ListPluginKinds))}};
}

void ClearIfUnsaid(std::string& text) {
  if (text.find_first_not_of(" \n\t") == std::string::npos || text == "undefined" ||
      text == "UNDEFINED") {
    text.clear();
  }
}

}  // namespace

std::vector<SPluginKind> ListPluginKinds() {
  std::vector<SPluginKind> all = {
      {"actuators", "actuator", "actuators", "ACTUATORS", ListPlugins<CSimulatedActuator>()},
      {"sensors", "sensor", "sensors", "SENSORS", ListPlugins<CSimulatedSensor>()},
      {"physics_engines", "physics engine", "physics_engines", "PHYSICS ENGINES",
       ListPlugins<CPhysicsEngine>() + AutoPartition()},
      {"media", "medium", "media", "MEDIA", ListPlugins<CMedium>()},
      {"visualizations", "visualization", "visualization", "VISUALIZATIONS AND OTHER OUTPUTS",
       ListPlugins<CRunOutput>() + ListPlugins<CVisualization>()},
      {"overlays", "overlay", "overlays", "OVERLAYS", ListPlugins<COverlay>()},
      {"entities", "entity", "arena", "ENTITIES", ListPlugins<CEntity>()},
      {"robot_types", "robot type", "robot_types", "ROBOT TYPES", ListPlugins<CEntityType>()},
      {"fields", "field", "", "FIELDS", ListPlugins<CField>()},
      {"built_in_metrics", "built-in metric", "", "BUILT-IN METRICS",
       ListPlugins<CBuiltInMetric>()},
      {"controllers", "controller", "", "CONTROLLERS", ListPlugins<CCI_Controller>()},
      {"loop_functions", "loop functions", "", "LOOP FUNCTIONS", ListPlugins<CLoopFunctions>()},
      {"elements", "element", "", "OTHER ELEMENTS OF EXPERIMENT FILES", CElementText::GetAll()}};
  for (SPluginKind& kind : all) {
    kind.Header = "AVAILABLE " + kind.Header;
  }
  for (const auto& [word, kind] : CPluginKind::GetAll()) {
    all.push_back({word, "part of " + kind.Of, "", kind.Header, kind.List(), kind.Of});
  }
  for (SPluginKind& kind : all) {
    for (SPluginText& plugin : kind.Plugins) {
      for (std::string* const text :
           {&plugin.Author, &plugin.Version, &plugin.Brief, &plugin.Long, &plugin.Status}) {
        ClearIfUnsaid(*text);
      }
    }
  }
  return all;
}

std::vector<SMatch> AllOf(const std::vector<SPluginKind>& kinds) {
  std::vector<SMatch> all;
  for (const SPluginKind& kind : kinds) {
    for (const SPluginText& plugin : kind.Plugins) {
      all.push_back({&kind, &plugin});
    }
  }
  return all;
}

bool IsOwn(const SPluginText& plugin) {
  return plugin.Author == kOwnAuthor;
}

std::string LinkTargetOf(const std::string& library) {
  const std::string file = library.substr(library.rfind('/') + 1);
  const std::string prefix = "libargos3plugin_simulator_";
  if (file.rfind("libargos3core", 0) == 0) {
    return "ARGoS::core";
  }
  if (file.rfind(prefix, 0) != 0) {
    return "";
  }
  return "ARGoS::" + file.substr(prefix.size(), file.rfind('.') - prefix.size());
}

}  // namespace argos
