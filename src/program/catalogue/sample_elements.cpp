#include <argos3/program/catalogue/sample_elements.h>

#include <argos3/program/catalogue/manual.h>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace argos {

namespace {

// sections whose children are plug-ins, and the kinds of these
const std::map<std::string, std::string>& SectionsByKind() {
  static const std::map<std::string, std::string> sections = {
      {"actuators", "actuators"}, {"sensors", "sensors"},
      {"entities", "arena"},      {"physics_engines", "physics_engines"},
      {"media", "media"},         {"visualizations", "visualization"},
      {"overlays", "overlays"},   {"robot_types", "robot_types"}};
  return sections;
}

std::string TextOf(const TConfigurationNode& element) {
  std::ostringstream text;
  text << element;
  return text.str();
}

// "<leds implementation='default' />" of "leds (default)"
std::string BareElement(const std::string& section, const std::string& label) {
  const size_t bracket = label.find(" (");
  if (bracket != std::string::npos) {
    return fmt::format("<{} implementation=\"{}\" />", label.substr(0, bracket),
                       label.substr(bracket + 2, label.size() - bracket - 3));
  }
  return fmt::format("<{}{} />", label, section == "overlays" ? "" : " id=\"sample\"");
}

}  // namespace

std::string KeyOf(const TConfigurationNode& element) {
  const std::string implementation = element.GetAttribute("implementation");
  return implementation.empty() ? element.Value() : element.Value() + " (" + implementation + ")";
}

std::string CSampleElements::SectionOf(const SPluginKind& kind) {
  const auto found = SectionsByKind().find(kind.Word);
  return found == SectionsByKind().end() ? "" : found->second;
}

CSampleElements::CSampleElements(const std::vector<SPluginKind>& kinds) {
  NoteLabels(kinds);
  // the examples of robots in their own manuals come first: those in others' are special
  for (const bool isForEntities : {true, false}) {
    for (const SPluginKind& kind : kinds) {
      if ((kind.Word == "entities") == isForEntities) {
        AddExamples(kind);
      }
    }
  }
  for (const SPluginKind& kind : kinds) {
    AddMissing(kind);
  }
}

void CSampleElements::AddExamples(const SPluginKind& kind) {
  for (const SPluginText& plugin : kind.Plugins) {
    const CManual manual(plugin.Long);
    for (TConfigurationNode example : manual.GetExamples()) {
      AddExample(SectionOf(kind), example);
    }
  }
}

void CSampleElements::NoteLabels(const std::vector<SPluginKind>& kinds) {
  for (const SPluginKind& kind : kinds) {
    const std::string section = SectionOf(kind);
    for (const SPluginText& plugin : kind.Plugins) {
      if (!section.empty()) {
        m_sections.emplace(plugin.Label, section);
      }
    }
  }
}

void CSampleElements::AddExample(const std::string& ownSection, TConfigurationNode& root) {
  const std::string tag = root.Value();
  if (tag == "controllers") {
    AddDevices(root);
  } else if (tag == "outputs" || tag == "arena" || tag == "framework" || tag == "overlays" ||
             tag == "media" || tag == "physics_engines" || tag == "visualization" ||
             tag == "robot_types") {
    AddChildren(tag, root);
  } else if (tag == "loop_functions") {
    m_elements.push_back({"", tag, TextOf(root)});
  } else if ((ownSection == "sensors" || ownSection == "actuators") &&
             NodeAttributeExists(root, "implementation")) {
    Add(ownSection, root);
  } else {
    const auto known = m_sections.find(tag);
    if (known != m_sections.end()) {
      Add(known->second, root);
    }
  }
}

void CSampleElements::AddChildren(const std::string& section, TConfigurationNode& parent) {
  TConfigurationNodeIterator it;
  for (it = it.begin(&parent); it != it.end(); ++it) {
    Add(section, *it);
  }
}

void CSampleElements::AddDevices(TConfigurationNode& controllers) {
  TConfigurationNodeIterator controller;
  for (controller = controller.begin(&controllers); controller != controller.end(); ++controller) {
    for (const char* const section : {"actuators", "sensors"}) {
      if (NodeExists(*controller, section)) {
        AddChildren(section, GetNode(*controller, section));
      }
    }
  }
}

void CSampleElements::Add(const std::string& section, TConfigurationNode& element) {
  m_elements.push_back({section, KeyOf(element), TextOf(element)});
  if (section == "media" && m_mediaIds.emplace(element.GetAttribute("id"), true).second) {
    m_media += TextOf(element);
  }
  if (section == "visualization" && NodeExists(element, "overlays") && m_viewWithOverlays.empty()) {
    m_viewWithOverlays = element.Value();
  }
  if (section == "arena" && NodeExists(element, "controller")) {
    AddParts(element);
  }
}

void CSampleElements::AddParts(TConfigurationNode& robot) {
  TConfigurationNodeIterator it;
  for (it = it.begin(&robot); it != it.end(); ++it) {
    // settings of a robot for an engine are no part of it
    if (it->Value() != "body" && it->Value() != "controller" &&
        m_sections.count(it->Value()) == 0) {
      m_parts.emplace(it->Value(), TextOf(*it));
    }
  }
}

void CSampleElements::AddMissing(const SPluginKind& kind) {
  const std::string section = SectionOf(kind);
  for (const SPluginText& plugin : kind.Plugins) {
    if (!section.empty() && Of(section, plugin.Label).empty()) {
      m_elements.push_back({section, plugin.Label, BareElement(section, plugin.Label)});
    }
    const auto owner = m_sections.find(kind.Of);
    if (owner != m_sections.end()) {
      m_elements.push_back(
          {owner->second, kind.Of,
           "<" + kind.Of + " id=\"sample\"><" + plugin.Label + " /></" + kind.Of + ">"});
    }
  }
}

std::vector<std::string> CSampleElements::Of(const std::string& section,
                                             const std::string& key) const {
  std::vector<std::string> texts;
  for (const SSampleElement& element : m_elements) {
    if (element.Section == section && element.Key == key) {
      texts.push_back(element.Text);
    }
  }
  return texts;
}

SSampleExperiment CSampleElements::MakeSample(const SSampleElement& element) const {
  SSampleExperiment sample;
  sample.Media = m_media;
  const std::string& section = element.Section;
  if (section == "actuators") {
    sample.Actuators = element.Text;
  } else if (section == "sensors") {
    sample.Sensors = element.Text;
  } else if (section == "arena") {
    sample.Arena = element.Text;
  } else if (section == "physics_engines") {
    sample.Engines = element.Text;
  } else if (section == "media") {
    sample.Media = element.Text;
  } else if (section == "visualization") {
    sample.Visualization = element.Text;
  } else if (section == "outputs") {
    sample.Outputs = element.Text;
  } else if (section == "robot_types") {
    sample.RobotTypes = element.Text;
  } else if (section == "overlays") {
    sample.Visualization = "<" + m_viewWithOverlays + "><overlays>" + element.Text +
                           "</overlays></" + m_viewWithOverlays + ">";
  } else if (section == "framework") {
    sample.Framework =
        "<experiment length=\"1\" ticks_per_second=\"10\" random_seed=\"1\" />" + element.Text;
  } else {
    sample.Sections = element.Text;
  }
  return sample;
}

}  // namespace argos
