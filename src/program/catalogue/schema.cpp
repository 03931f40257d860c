#include <argos3/program/catalogue/schema.h>

#include <argos3/program/catalogue/grammar.h>
#include <argos3/program/catalogue/relax_ng_compact.h>

#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <fmt/format.h>

namespace argos {

namespace {

// Patterns of RELAX NG are its elements, as XML; an empty text is the pattern of nothing.
using TPatterns = std::vector<std::string>;

// numbers as ParseNumber() reads them
constexpr const char* kReal = "\\s*([+\\-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+\\-]?[0-9]+)?)\\s*";
// whole numbers may be written as 25.0 or 1e3
constexpr const char* kDigits = "[0-9]+(\\.0*)?([eE][+]?[0-9]+)?\\s*";
// what users' code reads
constexpr const char* kAnything =
    "<zeroOrMore><choice><attribute><anyName/><text/></attribute>"
    "<element><anyName/><ref name=\"anything\"/></element><text/></choice></zeroOrMore>";

constexpr const char* kColour = "\\s*([A-Za-z][A-Za-z0-9]*|[0-9]+\\s*(,\\s*[0-9]+\\s*){2,3})\\s*";
constexpr const char* kOrigin =
    "Made by argos3 from what the plug-ins read: the option \"schema\". Do not edit.";
constexpr const char* kGrammar = R"(<?xml version="1.0" encoding="UTF-8"?>
<!-- {} -->
<grammar xmlns="http://relaxng.org/ns/structure/1.0"
  xmlns:a="http://relaxng.org/ns/compatibility/annotations/1.0"
  datatypeLibrary="http://www.w3.org/2001/XMLSchema-datatypes">{}</grammar>
)";

std::string Escaped(std::string text) {
  Replace(text, "&", "&amp;");
  Replace(text, "<", "&lt;");
  Replace(text, ">", "&gt;");
  Replace(text, "\"", "&quot;");
  return text;
}

std::string Reference(const std::string& name) {
  return fmt::format(R"(<ref name="{}"/>)", Escaped(name));
}

std::string Matching(const std::string& pattern) {
  return fmt::format(R"(<data type="string"><param name="pattern">{}</param></data>)", pattern);
}

std::string AnyNumberOf(const TPatterns& choices) {
  return choices.empty()
             ? ""
             : WithTag("zeroOrMore", WithTag("choice", fmt::format("{}", fmt::join(choices, ""))));
}

// an element or attribute. @param contents  empty: none. @param name  empty: any but those in
// except
std::string Named(const std::string& kind, const std::string& name, const std::string& text,
                  const std::string& contents, const TPatterns& except = {}) {
  std::string names;
  for (const std::string& other : except) {
    names += WithTag("name", Escaped(other));
  }
  names = names.empty() ? "<anyName/>" : WithTag("anyName", WithTag("except", names));
  return fmt::format("<{0}{1}>{2}{3}{4}</{0}>", kind,
                     name.empty() ? "" : fmt::format(R"( name="{}")", Escaped(name)),
                     name.empty() ? names : "",
                     text.empty() ? "" : WithTag("a:documentation", Escaped(text)),
                     contents.empty() ? "<empty/>" : contents);
}

std::string ValueOf(EValueType type) {
  // index: EValueType
  static constexpr const char* kDefinitions[] = {nullptr,   nullptr,   "real",    "real",
                                                 "integer", "natural", "boolean", "colour",
                                                 "xy",      "xyz",     "zyx",     "range"};
  const char* const definition = kDefinitions[static_cast<size_t>(type)];
  return definition == nullptr ? "<text/>" : Reference(definition);
}

std::string Attribute(const std::string& name, const SAttribute& facts) {
  const std::string pattern = Named("attribute", name, facts.Manual.Text, ValueOf(facts.Type));
  return facts.IsRequired ? pattern : WithTag("optional", pattern);
}

/* Turns the recorded elements into definitions of a grammar. */
class CSchemaMaker {
 public:
  explicit CSchemaMaker(CGrammar& grammar) : m_grammar(grammar), m_root(grammar.MakeRoot()) {}

  /** The grammar, as XML of RELAX NG. */
  std::string Make();

 private:
  const SPluginText* FindPlugin(const std::string& section, const SElementName& name) const;

  std::string Element(const SElementName& name, const SElement& element, const TElementPath& path,
                      std::string text = "");
  std::string Contents(const SElement& element, const TElementPath& path);
  TPatterns Plugins(const SElement& section, const std::string& name);
  std::string Controllers(const SElement& section);
  std::string Entities(const SElement& arena);
  std::string Root(bool withTypes);

  CGrammar& m_grammar;
  SElement m_root;
  bool m_withTypes = false;
  std::map<std::string, std::string> m_definitions;
};

// null if there is none. Outputs may also be in <visualization>.
const SPluginText* CSchemaMaker::FindPlugin(const std::string& section,
                                            const SElementName& name) const {
  for (const auto& [kind, plugin] : AllOf(m_grammar.GetDevices().GetKinds())) {
    const bool isThere = kind->Section == section || kind->Word == section ||
                         (section == "outputs" && kind->Section == "visualization");
    if (isThere && plugin->Label == name.ToLabel()) {
      return plugin;
    }
  }
  return nullptr;
}

std::string CSchemaMaker::Element(const SElementName& name, const SElement& element,
                                  const TElementPath& path, std::string text) {
  const SPluginText* const known = FindPlugin("elements", name);
  text = text.empty() && known != nullptr ? known->Brief : text;
  // users' code reads these, and others were only looked for
  static const std::set<std::string> kOpen = {"params", "loop_functions", "user_functions"};
  if (!element.IsVisited || kOpen.count(name.Tag) > 0) {
    return Named("element", name.Tag, text, Reference("anything"));
  }
  std::string parts;
  TPatterns names;
  for (const auto& [attribute, facts] : element.Attributes) {
    const bool isLabel = attribute == "implementation" && !name.Implementation.empty();
    parts += isLabel ? Named("attribute", attribute, "", WithTag("value", name.Implementation))
                     : Attribute(attribute, facts);
    names.push_back(attribute);
  }
  if (element.IsOpen) {
    parts += WithTag("zeroOrMore", Named("attribute", "", "", "<text/>", names));
  }
  return Named("element", name.Tag, text, parts + Contents(element, path));
}

std::string CSchemaMaker::Contents(const SElement& element, const TElementPath& path) {
  static const std::set<std::string> kSections = {"physics_engines", "media", "visualization",
                                                  "outputs", "robot_types"};
  const std::string& tag = path.back().Tag;
  const bool isSection = path.size() == 1;
  if (isSection && tag == "controllers") {
    return Controllers(element);
  }
  if (isSection && tag == "arena") {
    return Entities(element);
  }
  if (path.size() == 3 && tag == "entity") {
    return Reference(m_withTypes ? "entities_and_robots" : "entities");
  }
  if (tag == "overlays" || (isSection && kSections.count(tag) > 0)) {
    return AnyNumberOf(Plugins(element, tag));
  }
  TPatterns choices;
  for (const auto& [name, child] : element.Children) {
    choices.push_back(Element(name, child, path / name));
  }
  if (element.IsOpen) {
    choices.push_back(Named("element", "", "", Reference("anything")));
  }
  if (element.HasText || element.IsOpen) {
    choices.emplace_back("<text/>");
  }
  return AnyNumberOf(choices);
}

TPatterns CSchemaMaker::Plugins(const SElement& section, const std::string& name) {
  TPatterns references;
  for (const auto& [element, facts] : section.Children) {
    const SPluginText* const plugin = FindPlugin(name, element);
    if (plugin == nullptr) {
      continue;
    }
    SElement known = facts;
    if (m_grammar.IsUnknown(name, element) && name != "outputs") {
      known.IsOpen = true;
      known.IsVisited = true;
    }
    const std::string id =
        fmt::format("{}.{}{}{}", name, element.Tag, element.Implementation.empty() ? "" : ".",
                    element.Implementation);
    m_definitions[id] = Element(element, known, PathOf(name, element), plugin->Brief);
    references.push_back(Reference(id));
  }
  return references;
}

// any name: libraries that a file names may have further controllers
std::string CSchemaMaker::Controllers(const SElement& section) {
  const SElement* const controller = section.Find({"lua_controller"});
  if (controller == nullptr) {
    return "";
  }
  TPatterns parts = {Named("element", "params", "Attributes and elements for the controller.",
                           Reference("anything"))};
  for (const char* const devices : {"actuators", "sensors"}) {
    const SElement* const list = controller->Find({devices});
    parts.push_back(
        Named("element", devices, "", list == nullptr ? "" : AnyNumberOf(Plugins(*list, devices))));
  }
  std::string attributes;
  for (const auto& [name, facts] : controller->Attributes) {
    attributes += Attribute(name, facts);
  }
  return AnyNumberOf({Named("element", "", "A controller of robots: its tag is its label.",
                            attributes + AnyNumberOf(parts))});
}

// what the arena contains
std::string CSchemaMaker::Entities(const SElement& arena) {
  TPatterns choices = Plugins(arena, "arena");
  m_definitions["entities"] = AnyNumberOf(choices);
  if (m_withTypes) {
    TPatterns tags;
    for (const auto& [name, entity] : arena.Children) {
      tags.push_back(name.Tag);
    }
    // the tag of a robot of <robot_types> is the id of its type
    choices.push_back(
        Named("element", "", "A robot of a type in robot_types.", Reference("anything"), tags));
    m_definitions["entities_and_robots"] = AnyNumberOf(choices);
  }
  for (const char* const tag : {"distribute", "walls"}) {
    const SElementName name = {tag};
    if (const SElement* const element = arena.Find(name)) {
      choices.push_back(Element(name, *element, PathOf("arena", name)));
    }
  }
  return AnyNumberOf(choices);
}

std::string CSchemaMaker::Root(bool withTypes) {
  m_withTypes = withTypes;
  TPatterns sections;
  for (const auto& [name, section] : m_root.Children) {
    if (name.Tag != "robot_types") {
      sections.push_back(Element(name, section, {name}));
    }
  }
  std::string contents = AnyNumberOf(sections);
  const SElement* const types = m_root.Find({"robot_types"});
  if (withTypes && types != nullptr) {
    contents += Element({"robot_types"}, *types, {{"robot_types"}}) + contents;
  }
  return Named("element", "argos-configuration", "", contents);
}

std::string CSchemaMaker::Make() {
  const std::string start = WithTag("choice", Root(false) + Root(true));
  m_definitions.insert({{"real", Matching(kReal)},
                        {"integer", Matching("\\s*[+\\-]?" + std::string(kDigits))},
                        {"natural", Matching("\\s*[+]?" + std::string(kDigits))},
                        {"xy", Matching(fmt::format("{0},{0}", kReal))},
                        {"xyz", Matching(fmt::format("{0},{0},{0}", kReal))},
                        {"zyx", Matching(fmt::format("{0},{0},{0}", kReal))},
                        {"range", Matching(fmt::format("{0}:{0}", kReal))},
                        {"colour", Matching(kColour)},
                        {"boolean", "<choice><value>true</value><value>false</value></choice>"},
                        {"anything", kAnything}});
  std::string xml = WithTag("start", start);
  for (const auto& [name, pattern] : m_definitions) {
    xml += fmt::format(R"(<define name="{}">{}</define>)", Escaped(name),
                       pattern.empty() ? "<empty/>" : pattern);
  }
  return fmt::format(kGrammar, kOrigin, xml);
}

}  // namespace

std::string MakeSchema(const std::string& format) {
  const std::vector<SPluginKind> kinds = ListPluginKinds();
  CDevices devices(kinds);
  CGrammar grammar(devices);
  grammar.RecordAll();
  CConfigurationDocument document;
  document.Parse(CSchemaMaker(grammar).Make(), "schema");
  return format == "rnc" ? fmt::format("# {}\n{}", kOrigin, WriteCompactSyntax(document.GetRoot()))
                         : document.ToText();
}

}  // namespace argos
