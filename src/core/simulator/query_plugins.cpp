#include <argos3/core/simulator/query_plugins.h>

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/actuator.h>
#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/physics_engine/space_partition.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/core/simulator/visualization/visualization.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/plugins/factory.h>
#include <argos3/core/utility/string_utilities.h>

#include <sstream>
#include <vector>

namespace argos {

namespace {

struct SPlugin {
  std::string Label;
  std::string Author;
  std::string Version;
  std::string Brief;
  std::string Long;
  std::string Status;
};

struct SKind {
  const char* Word;  // as the user asks for it
  const char* Header;
  std::vector<SPlugin> Plugins;  // by label
};

template <typename TYPE>
std::vector<SPlugin> List() {
  std::vector<SPlugin> plugins;
  for (const auto& [label, info] : CFactory<TYPE>::GetTypes()) {
    plugins.push_back({label, info.Author, info.Version, info.BriefDescription,
                       info.LongDescription, info.Status});
  }
  return plugins;
}

// what stands among the engines in an experiment file, but is none
std::vector<SPlugin> ListEngines() {
  std::vector<SPlugin> plugins = List<CPhysicsEngine>();
  plugins.push_back({"auto_partition", "the authors of this project", "1.0",
                     "Not an engine: one engine for each part of the arena.",
                     kAutoPartitionDocumentation, "Usable"});
  return plugins;
}

std::vector<SKind> ListAll() {
  return {{"actuators", "AVAILABLE ACTUATORS", List<CSimulatedActuator>()},
          {"sensors", "AVAILABLE SENSORS", List<CSimulatedSensor>()},
          {"physics_engines", "AVAILABLE PHYSICS ENGINES", ListEngines()},
          {"media", "AVAILABLE MEDIA", List<CMedium>()},
          {"visualizations", "AVAILABLE VISUALIZATIONS", List<CVisualization>()},
          {"entities", "AVAILABLE ENTITIES", List<CEntity>()},
          {"controllers", "AVAILABLE CONTROLLERS", List<CCI_Controller>()},
          {"loop_functions", "AVAILABLE LOOP FUNCTIONS", List<CLoopFunctions>()}};
}

void PrintList(std::ostream& stream, const SKind& kind) {
  stream << kind.Header << "\n\n";
  for (const SPlugin& plugin : kind.Plugins) {
    stream << "   [ " << plugin.Label << " ]\n      " << plugin.Brief << "\n\n";
  }
}

void PrintDocumentation(std::ostream& stream, const SPlugin& plugin) {
  stream << "[ " << plugin.Label << " ]\n"
         << plugin.Brief << "\nby " << plugin.Author << "\nVersion: " << plugin.Version
         << "\nStatus: " << plugin.Status << "\n\n"
         << plugin.Long << '\n';
}

void PrintMatches(std::ostream& stream, const std::string& query, const std::vector<SKind>& kinds) {
  std::vector<std::string> names;
  bool found = false;
  std::ostringstream matches;
  for (const SKind& kind : kinds) {
    names.push_back(kind.Word);
    for (const SPlugin& plugin : kind.Plugins) {
      names.push_back(plugin.Label);
      if (plugin.Label.find(query) == std::string::npos) {
        continue;
      }
      matches << (found ? std::string(78, '=') + '\n' : std::string());
      PrintDocumentation(matches, plugin);
      found = true;
    }
  }
  if (found) {
    stream << "Plug-ins whose name contains \"" << query << "\":\n\n" << matches.str();
    return;
  }
  const std::string nearest = NearestNames(query, names);
  stream << "Nothing found: no plug-in has a name that contains \"" << query << '"'
         << (nearest.empty() ? "" : "; near it: " + nearest) << '\n';
}

}  // namespace

std::string DescribePlugins(const std::string& query) {
  const std::vector<SKind> kinds = ListAll();
  std::ostringstream stream;
  bool isKind = false;
  for (const SKind& kind : kinds) {
    if (query == "all" || query == kind.Word) {
      PrintList(stream, kind);
      isKind = true;
    }
  }
  if (!isKind) {
    PrintMatches(stream, query, kinds);
  }
  return stream.str();
}

void QueryPlugins(const std::string& query) {
  const bool colored = LOG.IsColoredOutput();
  LOG.DisableColoredOutput();
  LOG << DescribePlugins(query);
  LOG.Flush();
  if (colored) {
    LOG.EnableColoredOutput();
  }
}

}  // namespace argos
