#include <argos3/core/simulator/program/query_plugins.h>

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
#include <argos3/core/utility/configuration/value_range.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/plugins/process_wide.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <map>
#include <mutex>
#include <sstream>
#include <vector>

namespace argos {

namespace {

constexpr const char* kViews = "visualizations";

struct SKind {
  std::string Word;  // argument of -q
  std::string Header;
  std::vector<SPluginText> Plugins;  // by label
  std::string Of = "";  // label of the owning plug-in; empty: the core
};

// a kind added by a library
struct SAddedKind {
  std::string Of;
  std::string Header;
  CPluginKind::TList* List;
};

// by word; guarded by the mutex of registrations
std::map<std::string, SAddedKind>& GetAddedKinds() {
  static std::map<std::string, SAddedKind> kinds;
  return kinds;
}

// copied, because lists take locks that come before this one
std::map<std::string, SAddedKind> CopyAddedKinds() {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
  return GetAddedKinds();
}

// includes what is listed among the engines in an experiment file, but is not an engine
std::vector<SPluginText> ListEngines() {
  std::vector<SPluginText> plugins = ListPlugins<CPhysicsEngine>();
  plugins.push_back({"auto_partition", "the authors of this project", "1.0",
                     "Not an engine: creates one engine for each part of the arena.",
                     kAutoPartitionDocumentation, "Usable"});
  return plugins;
}

// both may be children of <visualization>
std::vector<SPluginText> ListViewsAndOutputs() {
  std::vector<SPluginText> plugins = ListPlugins<CRunOutput>();
  const std::vector<SPluginText> views = ListPlugins<CVisualization>();
  plugins.insert(plugins.end(), views.begin(), views.end());
  return plugins;
}

std::vector<SKind> ListAll() {
  std::vector<SKind> all = {
      {"actuators", "AVAILABLE ACTUATORS", ListPlugins<CSimulatedActuator>()},
      {"sensors", "AVAILABLE SENSORS", ListPlugins<CSimulatedSensor>()},
      {"physics_engines", "AVAILABLE PHYSICS ENGINES", ListEngines()},
      {"media", "AVAILABLE MEDIA", ListPlugins<CMedium>()},
      {kViews, "AVAILABLE VISUALIZATIONS AND OTHER OUTPUTS", ListViewsAndOutputs()},
      {"overlays", "AVAILABLE OVERLAYS", ListPlugins<COverlay>()},
      {"entities", "AVAILABLE ENTITIES", ListPlugins<CEntity>()},
      {"robot_types", "AVAILABLE ROBOT TYPES", ListPlugins<CEntityType>()},
      {"fields", "AVAILABLE FIELDS", ListPlugins<CField>()},
      {"built_in_metrics", "AVAILABLE BUILT-IN METRICS", ListPlugins<CBuiltInMetric>()},
      {"controllers", "AVAILABLE CONTROLLERS", ListPlugins<CCI_Controller>()},
      {"loop_functions", "AVAILABLE LOOP FUNCTIONS", ListPlugins<CLoopFunctions>()}};
  for (const auto& [word, kind] : CopyAddedKinds()) {
    all.push_back({word, kind.Header, kind.List(), kind.Of});
  }
  return all;
}

void PrintList(std::ostream& stream, const SKind& kind) {
  stream << kind.Header << "\n\n";
  for (const SPluginText& plugin : kind.Plugins) {
    stream << "   [ " << plugin.Label << " ]\n      " << plugin.Brief << "\n\n";
  }
}

void PrintDocumentation(std::ostream& stream, const SPluginText& plugin) {
  stream << "[ " << plugin.Label << " ]\n"
         << plugin.Brief << "\nby " << plugin.Author << "\nVersion: " << plugin.Version
         << "\nStatus: " << plugin.Status << "\n\n"
         << plugin.Long << '\n';
  if (plugin.Long.find("ATTRIBUTES") != std::string::npos) {
    stream << kRangesDocumentation << '\n';
  }
}

void PrintKindsOf(std::ostream& stream, const std::string& label, const std::vector<SKind>& kinds) {
  for (const SKind& kind : kinds) {
    if (kind.Of == label) {
      PrintList(stream, kind);
    }
  }
}

void PrintMatches(std::ostream& stream, const std::string& query, const std::vector<SKind>& kinds) {
  std::vector<std::string> names;
  bool found = false;
  CTextOutput matches;
  for (const SKind& kind : kinds) {
    names.push_back(kind.Word);
    for (const SPluginText& plugin : kind.Plugins) {
      names.push_back(plugin.Label);
      if (plugin.Label.find(query) == std::string::npos) {
        continue;
      }
      if (found) {
        matches << std::string(78, '=') << '\n';
      }
      PrintDocumentation(matches, plugin);
      PrintKindsOf(matches, plugin.Label, kinds);
      found = true;
    }
  }
  if (found) {
    stream << "Plug-ins whose name contains \"" << query << "\":\n\n" << matches.str();
    return;
  }
  const std::string nearest = NearestNames(query, names);
  stream << "Nothing found: no plug-in has a name that contains \"" << query << '"'
         << (nearest.empty() ? "" : "; similar names: " + nearest) << '\n';
}

}  // namespace

CPluginKind::CPluginKind(const std::string& word, const std::string& of, const std::string& header,
                         TList* list) {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
  GetAddedKinds()[word] = {of, header, list};
}

std::string DescribePlugins(const std::string& query) {
  const std::vector<SKind> kinds = ListAll();
  CTextOutput stream;
  bool isKind = false;
  for (const SKind& kind : kinds) {
    if (query == "all" || query == kind.Word || (query == "outputs" && kind.Word == kViews)) {
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
