#include <argos3/program/catalogue/samples.h>

#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/program/catalogue/log_silence.h>
#include <argos3/program/catalogue/manual.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace argos {

namespace {

namespace fs = std::filesystem;

constexpr const char* kScript = "argos3_sample.lua";
constexpr const char* kExperiment =
    R"(<experiment length="1" ticks_per_second="10" random_seed="1" />)";
constexpr const char* kArena = R"(<arena size="10,10,10">{}</arena>)";
constexpr const char* kFloor =
    R"(<floor id="sample_floor" source="loop_functions" pixels_per_meter="1" />)";

std::string TextOf(const TConfigurationNode& element) {
  std::ostringstream text;
  text << element;
  return text.str();
}

// one for each id that a robot names
std::string Controllers(const std::string& arena, const std::string& devices) {
  std::string controllers;
  for (const std::string& id : ValuesIn(arena, "config")) {
    controllers +=
        fmt::format(R"(<lua_controller id="{}">{}<params script="{}" /></lua_controller>)", id,
                    devices, kScript);
  }
  return WithTag("controllers", controllers);
}

std::string LoadXml(const std::string& xml, const std::function<void(CSimulator&)>& use) {
  const CLogSilence silence;
  try {
    CConfigurationDocument document;
    document.Parse(xml, "sample.argos");
    CSimulator simulator;
    const CSimulator::CScope scope(simulator);
    simulator.Load(document);
    if (use) {
      use(simulator);
    }
    simulator.Destroy();
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an exception that is not a std::exception was thrown";
  }
  return "";
}

}  // namespace

std::set<std::string> ValuesIn(const std::string& xml, const std::string& attribute) {
  const std::string start = ' ' + attribute + "=\"";
  std::set<std::string> values;
  for (size_t at = xml.find(start); at != std::string::npos; at = xml.find(start, at)) {
    at += start.size();
    values.insert(xml.substr(at, xml.find('"', at) - at));
  }
  return values;
}

std::string WithTag(const std::string& tag, const std::string& contents) {
  return fmt::format("<{0}>{1}</{0}>", tag, contents);
}

void SSampleExperiment::SetRobots(const std::string& robots) {
  Sections["arena"] = fmt::format(kArena, robots + kFloor);
}

std::string SSampleExperiment::ToXml() const {
  std::map<std::string, std::string> sections = Sections;
  sections.emplace("framework", WithTag("framework", kExperiment));
  sections.emplace("arena", fmt::format(kArena, ""));
  sections.emplace("media", WithTag("media", ""));
  sections.emplace("controllers", Controllers(sections.at("arena"), Devices));
  std::string xml;
  for (const auto& [tag, section] : sections) {
    xml += section + '\n';
  }
  return WithTag("argos-configuration", xml);
}

CSamples::CSamples(const std::vector<SPluginKind>& kinds) {
  const std::vector<SMatch> all = AllOf(kinds);
  for (const auto& [kind, plugin] : all) {
    if (!kind->Section.empty()) {
      m_sections.emplace(plugin->Label, kind->Section);
    }
  }
  // the examples of robots in their own manuals come first: those in others' are special
  for (const bool isForEntities : {true, false}) {
    for (const auto& [kind, plugin] : all) {
      const CManual manual((kind->Word == "entities") == isForEntities ? plugin->Long : "");
      for (TConfigurationNode example : manual.GetExamples()) {
        AddExample(*kind, example);
      }
    }
  }
  for (const auto& [kind, plugin] : all) {
    AddMissing(*kind, *plugin);
  }
}

void CSamples::AddExample(const SPluginKind& kind, TConfigurationNode& root) {
  static const std::set<std::string> kSections = {"arena",       "framework",    "media",
                                                  "outputs",     "overlays",     "physics_engines",
                                                  "robot_types", "visualization"};
  const std::string tag = root.Value();
  const auto plugin = m_sections.find(tag);
  if (tag == "loop_functions" || (tag == "arena" && kind.Word == "elements") ||
      (tag == "controllers" && kind.Word == tag)) {
    m_samples.push_back({"", {tag}, TextOf(root)});
  }
  if (tag == "controllers") {
    TConfigurationNodeIterator controller;
    for (controller = controller.begin(&root); controller != controller.end(); ++controller) {
      for (const char* const section : {"actuators", "sensors"}) {
        if (NodeExists(*controller, section)) {
          AddChildren(section, GetNode(*controller, section));
        }
      }
    }
  } else if (kSections.count(tag) > 0) {
    AddChildren(tag, root);
  } else if (kind.IsOfDevices() && NodeAttributeExists(root, "implementation")) {
    Add(kind.Section, root);
  } else if (plugin != m_sections.end()) {
    Add(plugin->second, root);
  }
}

void CSamples::AddChildren(const std::string& section, TConfigurationNode& parent) {
  TConfigurationNodeIterator it;
  for (it = it.begin(&parent); it != it.end(); ++it) {
    Add(section, *it);
  }
}

void CSamples::Add(const std::string& section, TConfigurationNode& element) {
  const std::string text = TextOf(element);
  const SSample sample = {section, {element.Value(), element.GetAttribute("implementation")}, text};
  if (std::find(m_samples.begin(), m_samples.end(), sample) == m_samples.end()) {
    m_samples.push_back(sample);
  }
  if (section == "media" && m_mediaIds.insert(element.GetAttribute("id")).second) {
    m_media += text;
  }
  if (section == "visualization" && NodeExists(element, "overlays") && m_viewWithOverlays.empty()) {
    m_viewWithOverlays = element.Value();
  }
  if (section == "arena" && NodeExists(element, "controller")) {
    TConfigurationNodeIterator it;
    for (it = it.begin(&element); it != it.end(); ++it) {
      // settings of a robot for an engine are no part of it
      if (it->Value() != "body" && it->Value() != "controller" &&
          m_sections.count(it->Value()) == 0) {
        m_parts.emplace(it->Value(), TextOf(*it));
      }
    }
  }
}

void CSamples::AddMissing(const SPluginKind& kind, const SPluginText& plugin) {
  const SElementName name = SElementName::FromLabel(plugin.Label);
  if (!kind.Section.empty() && Of(kind.Section, name).empty()) {
    std::string attribute = kind.Section == "overlays" ? "" : R"( id="sample")";
    if (!name.Implementation.empty()) {
      attribute = fmt::format(R"( implementation="{}")", name.Implementation);
    }
    m_samples.push_back({kind.Section, name, "<" + name.Tag + attribute + " />"});
  }
  const auto owner = m_sections.find(kind.Of);
  if (owner != m_sections.end()) {
    m_samples.push_back({owner->second,
                         {kind.Of},
                         fmt::format(R"(<{0} id="sample"><{1} /></{0}>)", kind.Of, plugin.Label)});
  }
}

std::vector<SSample> CSamples::Of(const std::string& section, const SElementName& name) const {
  std::vector<SSample> samples;
  std::copy_if(
      m_samples.begin(), m_samples.end(), std::back_inserter(samples),
      [&](const SSample& sample) { return sample.Section == section && sample.Name == name; });
  return samples;
}

SSampleExperiment CSamples::MakeExperiment(const SSample& sample) const {
  SSampleExperiment experiment;
  experiment.Sections["media"] = WithTag("media", m_media);
  const std::string& section = sample.Section;
  if (section.empty()) {
    experiment.Sections[sample.Name.Tag] = sample.Text;
  } else if (section == "actuators" || section == "sensors") {
    experiment.Devices = WithTag(section, sample.Text);
  } else if (section == "arena") {
    experiment.Sections[section] = fmt::format(kArena, sample.Text);
  } else if (section == "overlays") {
    experiment.Sections["visualization"] =
        WithTag("visualization", WithTag(m_viewWithOverlays, WithTag(section, sample.Text)));
  } else if (section == "framework" && sample.Name.Tag != "experiment") {
    experiment.Sections[section] = WithTag(section, kExperiment + sample.Text);
  } else {
    experiment.Sections[section] = WithTag(section, sample.Text);
  }
  return experiment;
}

CSampleLoader::CSampleLoader() : m_folder("argos3_sample_"), m_previous(fs::current_path()) {
  fs::current_path(m_folder.GetPath());
  std::ofstream(kScript) << "function init() end function step() end function reset() end "
                            "function destroy() end\n";
  for (const std::string& label : CFactory<CPhysicsEngine>::GetLabels()) {
    m_engines.push_back(
        WithTag("physics_engines", fmt::format(R"(<{} id="sample_engine" />)", label)));
  }
}

CSampleLoader::~CSampleLoader() {
  std::error_code failure;
  fs::current_path(m_previous, failure);
}

std::string CSampleLoader::Load(SSampleExperiment& sample,
                                const std::function<void(CSimulator&)>& use) {
  if (sample.Sections.count("physics_engines") > 0) {
    return LoadXml(sample.ToXml(), use);
  }
  std::string first;
  for (auto engine = m_engines.begin(); engine != m_engines.end(); ++engine) {
    sample.Sections["physics_engines"] = *engine;
    const std::string error = LoadXml(sample.ToXml(), use);
    if (error.empty()) {
      std::rotate(m_engines.begin(), engine, engine + 1);
      return "";
    }
    first = first.empty() ? error : first;
    // other engines accept other bodies; all else is the same with each of them
    if (error.find("engine") == std::string::npos) {
      break;
    }
  }
  return first;
}

}  // namespace argos
