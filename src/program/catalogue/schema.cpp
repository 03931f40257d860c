#include <argos3/program/catalogue/schema.h>

#include <argos3/program/catalogue/answer.h>
#include <argos3/program/catalogue/manual.h>
#include <argos3/program/catalogue/recorded_grammar.h>
#include <argos3/program/catalogue/schema_pattern.h>

#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>

namespace argos {

namespace {

using EKind = SSchemaPattern::EKind;

// numbers as ParseNumber() reads them
constexpr const char* kReal = "[+\\-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+\\-]?[0-9]+)?";

std::string Blanks(const std::string& pattern) {
  return "\\s*" + pattern + "\\s*";
}

// n numbers
std::string List(int n, const std::string& separator) {
  const std::string number = Blanks(std::string("(") + kReal + ")");
  std::string list = number;
  for (int i = 1; i < n; ++i) {
    list += separator + number;
  }
  return list;
}

SSchemaPattern Reference(const std::string& name) {
  return {EKind::Reference, name};
}

SSchemaPattern AnyNumberOf(std::vector<SSchemaPattern> choices) {
  if (choices.empty()) {
    return {EKind::Empty};
  }
  return {EKind::ZeroOrMore, "", "", {{EKind::Choice, "", "", std::move(choices)}}};
}

SSchemaPattern OfType(const std::string& type) {
  static const std::map<std::string, std::string> definitions = {
      {"real", "real"},       {"integer", "integer"}, {"natural", "natural"},
      {"boolean", "boolean"}, {"colour", "colour"},   {"x,y", "xy"},
      {"x,y,z", "xyz"},       {"z,y,x", "zyx"},       {"min:max", "range"}};
  const auto found = definitions.find(type);
  return found == definitions.end() ? SSchemaPattern{EKind::Text} : Reference(found->second);
}

void AddTypes(SSchema& schema) {
  const auto add = [&schema](const std::string& name, const std::string& pattern) {
    schema.Definitions[name] = {EKind::Matching, pattern};
  };
  add("real", List(1, ""));
  // whole numbers may be written as 25.0 or 1e3
  add("integer", Blanks("[+\\-]?[0-9]+(\\.0*)?([eE][+]?[0-9]+)?"));
  add("natural", Blanks("[+]?[0-9]+(\\.0*)?([eE][+]?[0-9]+)?"));
  add("xy", List(2, ","));
  add("xyz", List(3, ","));
  add("zyx", List(3, ","));
  add("range", List(2, ":"));
  add("colour", Blanks("([A-Za-z][A-Za-z0-9]*|[0-9]+\\s*(,\\s*[0-9]+\\s*){2,3})"));
  schema.Definitions["boolean"] = {
      EKind::Choice, "", "", {{EKind::Value, "true"}, {EKind::Value, "false"}}};
  // what users' code reads
  schema.Definitions["anything"] = {EKind::ZeroOrMore,
                                    "",
                                    "",
                                    {{EKind::Choice,
                                      "",
                                      "",
                                      {{EKind::Attribute, "", "", {{EKind::Text}}},
                                       {EKind::Element, "", "", {Reference("anything")}},
                                       {EKind::Text}}}}};
}

/* Turns the recorded requests into definitions. */
class CSchemaMaker {
 public:
  CSchemaMaker(CRecordedGrammar& grammar, const std::vector<SPluginKind>& kinds);
  SSchema Make();

 private:
  struct SDescribed {
    std::string Brief;
    CManual Manual;
  };

  void MergeDevices();
  void MergeEntities();
  void MergeOverlays(const SRequestedElement& element);
  const SDescribed* Find(const std::string& section, const std::string& key) const;
  bool IsOpen(const std::string& path, const SRequestedElement& element) const;

  SSchemaPattern Element(const std::string& key, const SRequestedElement& element,
                         const std::string& path, const SDescribed* described,
                         const std::string& text = "");
  SSchemaPattern Attribute(const std::string& tag, const std::string& name,
                           const SRequestedAttribute& attribute, const std::string& path,
                           const SDescribed* described) const;
  SSchemaPattern Contents(const SRequestedElement& element, const std::string& path,
                          const SDescribed* described);
  SSchemaPattern Special(const SRequestedElement& element, const std::string& path);
  std::vector<SSchemaPattern> Plugins(const SRequestedElement& section, const std::string& name,
                                      const std::string& path);
  SSchemaPattern Controllers(const SRequestedElement& section);
  SSchemaPattern Arena(bool withTypes);
  SSchemaPattern Root(bool withTypes);

  CRecordedGrammar& m_grammar;
  SRequestedElement m_root;  // a copy, completed
  SSchema m_schema;
  std::map<std::string, SDescribed> m_described;  // by section and key
  SRequestedElement m_entities;  // all, as children
  SRequestedElement m_overlays;
  bool m_withTypes = false;
};

CSchemaMaker::CSchemaMaker(CRecordedGrammar& grammar, const std::vector<SPluginKind>& kinds)
    : m_grammar(grammar) {
  for (const SPluginKind& kind : kinds) {
    const std::string section = CSampleElements::SectionOf(kind);
    for (const SPluginText& plugin : kind.Plugins) {
      if (!section.empty()) {
        m_described.emplace(
            section + '/' + plugin.Label,
            SDescribed{IsUnsaid(plugin.Brief) ? "" : plugin.Brief, CManual(plugin.Long)});
      }
    }
  }
  m_root.Merge(m_grammar.GetRoot());
  MergeDevices();
  MergeEntities();
  MergeOverlays(m_root);
}

// what devices have in common, such as <noise>, is read by the same code in each
void CSchemaMaker::MergeDevices() {
  std::vector<SRequestedElement*> devices;
  for (const auto& [label, controller] : m_root.Child("controllers").Children) {
    for (const char* const section : {"actuators", "sensors"}) {
      for (const auto& [key, device] : controller->Child(section).Children) {
        devices.push_back(device.get());
      }
    }
  }
  SRequestedElement common;
  for (const SRequestedElement* const device : devices) {
    for (const auto& [tag, child] : device->Children) {
      if (child->IsVisited) {
        common.Child(tag).Merge(*child);
      }
    }
  }
  for (SRequestedElement* const device : devices) {
    for (const auto& [tag, child] : device->Children) {
      if (!child->IsVisited && common.Find(tag) != nullptr) {
        child->Merge(*common.Find(tag));
      }
    }
  }
}

// robots inside and outside <distribute> are the same; what one robot contains, others can contain
void CSchemaMaker::MergeEntities() {
  const SRequestedElement* const arena = m_root.Find("arena");
  if (arena == nullptr) {
    return;
  }
  const auto merge = [this](const SRequestedElement& parent) {
    for (const auto& [tag, entity] : parent.Children) {
      if (m_described.count("arena/" + tag) > 0) {
        m_entities.Child(tag).Merge(*entity);
      }
    }
  };
  merge(*arena);
  const SRequestedElement* const distribute = arena->Find("distribute");
  const SRequestedElement* const entity =
      distribute == nullptr ? nullptr : distribute->Find("entity");
  if (entity != nullptr) {
    merge(*entity);
  }
  SRequestedElement parts;
  const std::vector<std::string>& robots = m_grammar.GetCatalogue().GetRobots();
  for (const std::string& robot : robots) {
    for (const auto& [tag, part] : m_entities.Child(robot).Children) {
      if (part->IsVisited) {
        parts.Child(tag).Merge(*part);
      }
    }
  }
  for (const std::string& robot : robots) {
    SRequestedElement& element = m_entities.Child(robot);
    for (const auto& [tag, part] : parts.Children) {
      const bool isEngine = m_described.count("physics_engines/" + tag) > 0;
      if (isEngine || element.Find(tag) != nullptr) {
        element.Child(tag).Merge(*part);
      }
    }
  }
}

void CSchemaMaker::MergeOverlays(const SRequestedElement& element) {
  for (const auto& [tag, child] : element.Children) {
    if (tag == "overlays") {
      m_overlays.Merge(*child);
    } else {
      MergeOverlays(*child);
    }
  }
}

const CSchemaMaker::SDescribed* CSchemaMaker::Find(const std::string& section,
                                                   const std::string& key) const {
  const auto found = m_described.find(section + '/' + key);
  return found == m_described.end() ? nullptr : &found->second;
}

// true for what users' code reads, and what was only looked for
bool CSchemaMaker::IsOpen(const std::string& path, const SRequestedElement& element) const {
  const std::string tag = path.substr(path.rfind('/') + 1);
  return !element.IsVisited || tag == "params" || tag == "loop_functions" ||
         tag == "user_functions";
}

SSchemaPattern CSchemaMaker::Attribute(const std::string& tag, const std::string& name,
                                       const SRequestedAttribute& attribute,
                                       const std::string& path, const SDescribed* described) const {
  SSchemaPattern pattern = {EKind::Attribute, name};
  pattern.Text = described == nullptr ? "" : described->Manual.TextOf(tag, name);
  pattern.Parts.push_back(OfType(TypeOf(attribute)));
  return m_grammar.IsRequired(path, name)
             ? pattern
             : SSchemaPattern{EKind::Optional, "", "", {std::move(pattern)}};
}

SSchemaPattern CSchemaMaker::Contents(const SRequestedElement& element, const std::string& path,
                                      const SDescribed* described) {
  std::vector<SSchemaPattern> choices;
  const std::string tag = path.substr(path.rfind('/') + 1);
  if (tag == "overlays") {
    choices = Plugins(m_overlays, "overlays", path);
  } else {
    for (const auto& [key, child] : element.Children) {
      choices.push_back(Element(key, *child, path + '/' + key, described));
    }
  }
  if (element.IsOpen) {
    choices.push_back({EKind::Element, "", "", {Reference("anything")}});
  }
  if (element.HasText || element.IsOpen) {
    choices.push_back({EKind::Text});
  }
  return AnyNumberOf(std::move(choices));
}

SSchemaPattern CSchemaMaker::Element(const std::string& key, const SRequestedElement& element,
                                     const std::string& path, const SDescribed* described,
                                     const std::string& text) {
  const std::string tag = TagOf(key);
  SSchemaPattern pattern = {EKind::Element, tag, text};
  if (IsOpen(path, element)) {
    pattern.Parts = {Reference("anything")};
    return pattern;
  }
  for (const auto& [name, attribute] : element.Attributes) {
    if (name == "implementation" && tag != key) {
      const std::string implementation = key.substr(tag.size() + 2, key.size() - tag.size() - 3);
      pattern.Parts.push_back({EKind::Attribute, name, "", {{EKind::Value, implementation}}});
    } else {
      pattern.Parts.push_back(Attribute(tag, name, attribute, path, described));
    }
  }
  if (element.IsOpen) {
    SSchemaPattern any = {EKind::Attribute, "", "", {{EKind::Text}}};
    for (const auto& [name, attribute] : element.Attributes) {
      any.Except.push_back(name);
    }
    pattern.Parts.push_back({EKind::ZeroOrMore, "", "", {std::move(any)}});
  }
  pattern.Parts.push_back(Special(element, path));
  if (pattern.Parts.back().Kind == EKind::Empty) {
    pattern.Parts.back() = Contents(element, path, described);
  }
  if (pattern.Parts.back().Kind == EKind::Empty && pattern.Parts.size() > 1) {
    pattern.Parts.pop_back();
  }
  return pattern;
}

// sections whose children are plug-ins; Empty for other elements
SSchemaPattern CSchemaMaker::Special(const SRequestedElement& element, const std::string& path) {
  if (path == "controllers") {
    return Controllers(element);
  }
  if (path == "arena") {
    return Arena(m_withTypes);
  }
  if (path == "arena/distribute/entity") {
    return Reference(m_withTypes ? "entities_and_robots" : "entities");
  }
  for (const char* const section :
       {"physics_engines", "media", "visualization", "outputs", "robot_types"}) {
    if (path == section) {
      return AnyNumberOf(Plugins(element, section, path));
    }
  }
  return {EKind::Empty};
}

std::vector<SSchemaPattern> CSchemaMaker::Plugins(const SRequestedElement& section,
                                                  const std::string& name,
                                                  const std::string& path) {
  std::vector<SSchemaPattern> plugins;
  for (const auto& [key, element] : section.Children) {
    // outputs may be in both sections
    const SDescribed* described = Find(name, key);
    described = described == nullptr && name == "outputs" ? Find("visualization", key) : described;
    if (described == nullptr) {
      continue;
    }
    std::string id = name + '.' + key;
    Replace(id, " (", ".");
    Replace(id, ")", "");
    SRequestedElement known;
    known.Merge(*element);
    if (m_grammar.IsUnknown(name, key) && name != "outputs") {
      known.IsOpen = true;
      known.IsVisited = true;
    }
    m_schema.Definitions[id] = Element(key, known, path + '/' + key, described, described->Brief);
    plugins.push_back(Reference(id));
  }
  return plugins;
}

// any name: libraries that a file names may have further controllers
SSchemaPattern CSchemaMaker::Controllers(const SRequestedElement& section) {
  SRequestedElement all;
  for (const auto& [label, controller] : section.Children) {
    all.Merge(*controller);
  }
  SSchemaPattern controller = {EKind::Element, "", "A controller of robots: its tag is its label."};
  for (const auto& [name, attribute] : all.Attributes) {
    controller.Parts.push_back(
        Attribute("", name, attribute, "controllers/lua_controller", nullptr));
  }
  std::vector<SSchemaPattern> parts = {{EKind::Element,
                                        "params",
                                        "Attributes and elements for the controller.",
                                        {Reference("anything")}}};
  for (const char* const devices : {"actuators", "sensors"}) {
    SSchemaPattern list = {EKind::Element, devices};
    list.Parts.push_back(AnyNumberOf(Plugins(
        all.Child(devices), devices, std::string("controllers/lua_controller/") + devices)));
    parts.push_back(std::move(list));
  }
  controller.Parts.push_back(AnyNumberOf(std::move(parts)));
  return AnyNumberOf({std::move(controller)});
}

SSchemaPattern CSchemaMaker::Arena(bool withTypes) {
  std::vector<SSchemaPattern> choices;
  std::vector<std::string> tags = {"distribute"};
  for (SSchemaPattern& plugin : Plugins(m_entities, "arena", "arena")) {
    tags.push_back(plugin.Name.substr(plugin.Name.find('.') + 1));
    choices.push_back(std::move(plugin));
  }
  m_schema.Definitions["entities"] = AnyNumberOf(choices);
  const SRequestedElement* const arena = m_root.Find("arena");
  const SRequestedElement* const distribute =
      arena == nullptr ? nullptr : arena->Find("distribute");
  // the tag of a robot of <robot_types> is the id of its type
  const SSchemaPattern typed = {
      EKind::Element, "", "A robot of a type in robot_types.", {Reference("anything")}, tags};
  if (withTypes) {
    choices.push_back(typed);
    m_schema.Definitions["entities_and_robots"] = AnyNumberOf(choices);
  }
  if (distribute != nullptr) {
    choices.push_back(Element("distribute", *distribute, "arena/distribute", nullptr,
                              "Places a number of entities at random or in a grid."));
  }
  return AnyNumberOf(std::move(choices));
}

SSchemaPattern CSchemaMaker::Root(bool withTypes) {
  m_withTypes = withTypes;
  SSchemaPattern root = {EKind::Element, "argos-configuration"};
  std::vector<SSchemaPattern> sections;
  for (const auto& [tag, section] : m_root.Children) {
    if (tag != "robot_types") {
      sections.push_back(Element(tag, *section, tag, nullptr));
    }
  }
  SSchemaPattern rest = AnyNumberOf(sections);
  root.Parts.push_back(rest);
  const SRequestedElement* const types = m_root.Find("robot_types");
  if (withTypes && types != nullptr) {
    root.Parts.push_back(Element("robot_types", *types, "robot_types", nullptr));
    root.Parts.push_back(rest);
  }
  return root;
}

SSchema CSchemaMaker::Make() {
  AddTypes(m_schema);
  m_schema.Definitions["start"] = {EKind::Choice, "", "", {Root(false), Root(true)}};
  return std::move(m_schema);
}

}  // namespace

bool IsSchemaFormat(const std::string& format) {
  return format == "rng" || format == "rnc";
}

std::string MakeSchema(const std::string& format) {
  const std::vector<SPluginKind> kinds = ListPluginKinds();
  CDeviceCatalogue catalogue(kinds);
  CRecordedGrammar grammar(catalogue);
  grammar.RecordAll();
  const SSchema schema = CSchemaMaker(grammar, kinds).Make();
  return format == "rnc" ? WriteRelaxNgCompact(schema) : WriteRelaxNg(schema);
}

}  // namespace argos
