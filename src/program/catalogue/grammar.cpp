#include <argos3/program/catalogue/grammar.h>

#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/program/catalogue/manual.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>
#include <string_view>
#include <utility>

namespace argos {

namespace {

constexpr const char* kRoot = "argos-configuration";
constexpr const char* kNoValue = "no_such_value";
constexpr const char* kLibraryText = "path or name of the library that contains the plug-in.";

SElementName NameOf(const TConfigurationNode& element) {
  return {element.Value(), element.GetAttribute("implementation")};
}

/* An element of a sample. */
struct SPart {
  TConfigurationNode Element;
  TElementPath Path;
};

// all elements of a tree; the order does not change while attributes are removed
void CollectParts(TConfigurationNode& element, const TElementPath& path,
                  std::vector<SPart>& parts) {
  parts.push_back({element, path});
  TConfigurationNodeIterator it;
  for (it = it.begin(&element); it != it.end(); ++it) {
    CollectParts(*it, path / NameOf(*it), parts);
  }
}

/* The elements of a sample, which can be changed. */
class CChange {
 public:
  // place: path of the sample's element
  explicit CChange(const SSample& sample, const TElementPath& place = {}) : m_sample(sample) {
    m_document.Parse(sample.Text, "(example)");
    CollectParts(m_document.GetRoot(), place, m_parts);
  }

  std::vector<SPart>& GetParts() { return m_parts; }
  TConfigurationNode& GetElement(size_t index) { return m_parts[index].Element; }
  SSample MakeSample() {
    std::ostringstream text;
    text << m_document.GetRoot();
    return {m_sample.Section, m_sample.Name, text.str()};
  }

 private:
  const SSample& m_sample;
  CConfigurationDocument m_document;
  std::vector<SPart> m_parts;
};

bool IsWord(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalpha(c) != 0 || c == '_';
  });
}

// words in quotation marks, and those of a list after "known: ", each once
std::set<std::string> ListedWords(const std::string& error) {
  static const std::regex kQuoted("\"([A-Za-z_]+)\"");
  static const std::regex kListed("(?:^|\\s)([A-Za-z_]+),*(?=\\s|$)");
  constexpr std::string_view kKnown = "; known: ";
  const size_t list = error.rfind(kKnown);
  const std::string known = list == std::string::npos ? "" : error.substr(list + kKnown.size());
  std::set<std::string> words;
  for (const auto& [text, pattern] : {std::pair(known, kListed), std::pair(error, kQuoted)}) {
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
      words.insert((*it)[1]);
    }
  }
  words.erase(kNoValue);
  return words;
}

// an attribute whose absence was an error, and a valid text for it
void FindMissed(const SRequestedElement& element, std::pair<std::string, std::string>& missed) {
  for (const auto& [name, attribute] : element.Attributes) {
    if (attribute.IsMissed) {
      missed = {name, attribute.Sample};
    }
  }
  for (const auto& [name, child] : element.Children) {
    FindMissed(*child, missed);
  }
}

/* The manuals of plug-ins, for the elements that these read. */
class CManuals {
 public:
  explicit CManuals(const std::vector<SPluginKind>& kinds) {
    for (const auto& [kind, plugin] : AllOf(kinds)) {
      const SElementName name = SElementName::FromLabel(plugin->Label);
      if (kind->Word == "elements" || kind->Word == "loop_functions") {
        m_ofTags.emplace(kind->Word == "elements" ? name.Tag : kind->Word, CManual(plugin->Long));
      } else {
        const std::string& part = kind->Of.empty() ? kind->Word : kind->Of;
        m_ofPlugins.emplace(std::pair(kind->Section.empty() ? part : kind->Section, name),
                            CManual(plugin->Long));
      }
    }
  }

  // manuals: of elements around it, the innermost first
  void Describe(SElement& element, const SElementName& name, const std::string& parent,
                std::vector<const CManual*> manuals = {}) const {
    if (const CManual* const manual = Find(name, parent)) {
      manuals.insert(manuals.begin(), manual);
    }
    for (auto& [attribute, facts] : element.Attributes) {
      for (const CManual* const manual : manuals) {
        if (facts.Manual.Text.empty()) {
          facts.Manual = manual->TextOf(name.Tag, attribute);
        }
      }
      if (facts.Manual.Text.empty()) {
        facts.Manual = attribute == "library" ? SAttributeText{"", "", kLibraryText}
                                              : FindElsewhere(parent, name.Tag, attribute);
      }
    }
    for (auto& [child, facts] : element.Children) {
      Describe(facts, child, name.Tag, manuals);
    }
  }

 private:
  // null if there is none
  const CManual* Find(const SElementName& name, const std::string& parent) const {
    // the arena contains what is distributed, and outputs may be among the views
    static const std::map<std::string, std::string> kSections = {{"entity", "arena"},
                                                                 {"outputs", "visualization"}};
    const auto section = kSections.find(parent);
    const auto plugin =
        m_ofPlugins.find({section == kSections.end() ? parent : section->second, name});
    const auto tag = m_ofTags.find(name.Tag);
    if (plugin != m_ofPlugins.end()) {
      return &plugin->second;
    }
    return tag != m_ofTags.end() ? &tag->second : nullptr;
  }

  // finds the text in other manuals: that of a plug-in with this tag, those with rows of it, those
  // with examples of it, and those of its section
  SAttributeText FindElsewhere(const std::string& section, const std::string& tag,
                               const std::string& attribute) const {
    SAttributeText texts[4];
    for (const auto& [plugin, manual] : m_ofPlugins) {
      const bool isShown = manual.HasExampleOf(tag);
      const bool applies[4] = {plugin.second.Tag == tag, true, isShown, plugin.first == section};
      for (size_t i = 0; i < 4; ++i) {
        if (applies[i] && texts[i].Text.empty()) {
          texts[i] = i == 1 ? manual.TextOfTag(tag, attribute) : manual.TextOf(tag, attribute);
        }
      }
    }
    for (SAttributeText& text : texts) {
      if (!text.Text.empty()) {
        return text;
      }
    }
    return {};
  }

  std::map<std::pair<std::string, SElementName>, CManual> m_ofPlugins;  // indexed by section
  std::map<std::string, CManual> m_ofTags;
};

std::vector<SElement*> PointersTo(SElement& section) {
  std::vector<SElement*> children;
  for (auto& [name, child] : section.Children) {
    children.push_back(&child);
  }
  return children;
}

// Elements with the same tag inside those of a section, such as <noise>, are read by the same code.
// always: also what samples contain; otherwise what was only looked for
void ShareChildren(const std::vector<SElement*>& elements, bool always) {
  SElement common;
  for (const SElement* const element : elements) {
    for (const auto& [name, child] : element->Children) {
      if (child.IsVisited) {
        common.Children[name].Merge(child);
      }
    }
  }
  for (SElement* const element : elements) {
    for (auto& [name, child] : element->Children) {
      if ((always || !child.IsVisited) && common.Find(name) != nullptr) {
        child.Merge(*common.Find(name));
      }
    }
  }
}

// completes types of attributes that only samples of another implementation have
void ShareTypes(SElement& section) {
  for (auto& [name, element] : section.Children) {
    for (const auto& [other, twin] : section.Children) {
      for (auto& [attribute, facts] : element.Attributes) {
        const auto found = twin.Attributes.find(attribute);
        if (other.Tag == name.Tag && found != twin.Attributes.end() &&
            facts.Type == EValueType::Unknown) {
          facts.Type = found->second.Type;
        }
      }
    }
  }
}

void CollectOverlays(const SElement& element, SElement& all) {
  for (const auto& [name, child] : element.Children) {
    if (name.Tag == "overlays") {
      all.Merge(child);
    }
    CollectOverlays(child, all);
  }
}

}  // namespace

TElementPath PathOf(const std::string& section, const SElementName& name) {
  if (section.empty()) {
    return {name};
  }
  if (section == "sensors" || section == "actuators") {
    return {{"controllers"}, {"lua_controller"}, {section}, name};
  }
  return {{section}, name};
}

std::string DescribePath(const TElementPath& path) {
  // any controller may have the devices
  const bool isOfDevice = path.size() > 3 && path[0].Tag == "controllers";
  std::string text;
  for (size_t i = isOfDevice ? 2 : 0; i < path.size(); ++i) {
    text += (text.empty() ? "" : "/") + path[i].ToLabel();
  }
  return text;
}

// use: of what is read, also if there is an error. @return the error
std::string CGrammar::Load(SSampleExperiment& experiment, const TUse& use) {
  const CRequestRecorder recorder;
  std::string error = m_devices.GetLoader().Load(experiment);
  if (const SRequestedElement* const root = recorder.GetRequests().Find({kRoot})) {
    use(*root);
  }
  return error;
}

std::string CGrammar::RecordSample(const SSample& sample, const TUse& use) {
  SSampleExperiment experiment = m_devices.MakeExperiment(sample);
  std::string error = Load(experiment, [&](const SRequestedElement& root) {
    m_root.Merge(SElement(root));
    if (use) {
      use(root);
    }
  });
  if (error.empty()) {
    CConfigurationDocument document;
    document.Parse(experiment.ToXml(), "sample.argos");
    NoteAlways(document.GetRoot(), {});
  }
  return error;
}

void CGrammar::NoteAlways(TConfigurationNode& element, const TElementPath& path) {
  std::optional<std::set<std::string>>& always = m_requirements[path].Always;
  std::set<std::string> names;
  for (const std::string& name : element.GetAttributeNames()) {
    if (!always || always->count(name) > 0) {
      names.insert(name);
    }
  }
  always = std::move(names);
  TConfigurationNodeIterator it;
  for (it = it.begin(&element); it != it.end(); ++it) {
    NoteAlways(*it, path / NameOf(*it));
  }
}

void CGrammar::NoteMissed(const SRequestedElement& element, const TElementPath& path) {
  for (const auto& [name, attribute] : element.Attributes) {
    if (attribute.IsMissed) {
      m_requirements[path].Missed.insert(name);
    }
  }
  for (const auto& [name, child] : element.Children) {
    NoteMissed(*child, path / name);
  }
}

void CGrammar::MarkRequired(SElement& element, const TElementPath& path) const {
  const auto known = m_requirements.find(path);
  for (auto& [name, attribute] : element.Attributes) {
    attribute.IsRequired = known != m_requirements.end() && known->second.Always &&
                           known->second.Always->count(name) > 0 &&
                           known->second.Missed.count(name) > 0;
  }
  for (auto& [name, child] : element.Children) {
    MarkRequired(child, path / name);
  }
}

TElementPath CGrammar::PlaceOf(const SSample& sample) const {
  TElementPath path = PathOf(sample.Section, sample.Name);
  // overlays are in a view
  return m_root.FindAt(path) != nullptr ? path : m_root.FindIn(sample.Section, sample.Name);
}

// loads a sample again without each of the attributes that all samples have
void CGrammar::RecordWithout(const SSample& sample) {
  CChange whole(sample, PlaceOf(sample));
  for (size_t i = 0; i < whole.GetParts().size(); ++i) {
    const auto known = m_requirements.find(whole.GetParts()[i].Path);
    if (known == m_requirements.end() || !known->second.Always) {
      continue;
    }
    for (const std::string& name : whole.GetElement(i).GetAttributeNames()) {
      if (name != "implementation" && known->second.Always->count(name) > 0) {
        CChange change(sample);
        change.GetElement(i).RemoveAttribute(name);
        SSampleExperiment experiment = m_devices.MakeExperiment(change.MakeSample());
        Load(experiment, [this](const SRequestedElement& root) { NoteMissed(root, {}); });
      }
    }
  }
}

// unknown if it was not read
EValueType CGrammar::TypeOf(const TElementPath& path, const std::string& name) const {
  const SElement* const element = m_root.FindAt(path);
  const bool isKnown = element != nullptr && element->Attributes.count(name) > 0;
  return isKnown ? element->Attributes.at(name).Type : EValueType::Unknown;
}

// Loads it again with the other values of its attributes, each attribute once for all samples: a
// model of noise, for example, decides which other attributes are read. Colours, and ids of other
// elements, decide nothing.
void CGrammar::RecordVariants(const SSample& sample) {
  const std::set<std::string> ids = ValuesIn(m_devices.MakeExperiment(sample).ToXml(), "id");
  CChange whole(sample, PlaceOf(sample));
  for (size_t i = 0; i < whole.GetParts().size(); ++i) {
    const TElementPath& path = whole.GetParts()[i].Path;
    for (const std::string& name : whole.GetElement(i).GetAttributeNames()) {
      const std::string value = whole.GetElement(i).GetAttribute(name);
      const EValueType type = TypeOf(path, name);
      if (!IsWord(value) || name == "id" || name == "implementation" || ids.count(value) > 0 ||
          type == EValueType::Colour || m_varied.count({path, name}) > 0) {
        continue;
      }
      const std::optional<std::set<std::string>> values = ListValues(sample, i, name, type);
      if (!values) {
        continue;
      }
      m_varied.insert({path, name});
      for (const std::string& other : *values) {
        if (other != value && other != name && ids.count(other) == 0) {
          RecordVariant(sample, i, name, other);
        }
      }
    }
  }
}

// Those that the error of a wrong value lists; nothing if the sample has another error.
std::optional<std::set<std::string>> CGrammar::ListValues(const SSample& sample, size_t index,
                                                          const std::string& name,
                                                          EValueType type) {
  if (type == EValueType::Boolean) {
    return std::set<std::string>{"false", "true"};
  }
  CChange wrong(sample);
  wrong.GetElement(index).SetAttribute(name, std::string(kNoValue));
  SSampleExperiment experiment = m_devices.MakeExperiment(wrong.MakeSample());
  const std::string error = m_devices.GetLoader().Load(experiment);
  if (!error.empty() && error.find(kNoValue) == std::string::npos) {
    return std::nullopt;
  }
  return ListedWords(error);
}

// adds attributes that the value needs
void CGrammar::RecordVariant(const SSample& sample, size_t index, const std::string& name,
                             const std::string& value) {
  constexpr int kMaxAdditions = 4;
  CChange change(sample);
  TConfigurationNode& element = change.GetElement(index);
  element.SetAttribute(name, value);
  for (int i = 0; i < kMaxAdditions; ++i) {
    std::pair<std::string, std::string> missed;
    const std::string error =
        RecordSample(change.MakeSample(),
                     [&missed](const SRequestedElement& root) { FindMissed(root, missed); });
    if (error.empty() || missed.second.empty() || element.HasAttribute(missed.first)) {
      return;
    }
    element.SetAttribute(missed.first, missed.second);
  }
}

void CGrammar::Record(const std::string& section, const SElementName& name) {
  const std::vector<SSample> samples = m_devices.GetSamples().Of(section, name);
  for (const SSample& sample : samples) {
    if (RecordSample(sample).empty()) {
      m_known.insert(PathOf(section, name));
    }
    RecordVariants(sample);
  }
  if (!samples.empty()) {
    RecordWithout(samples.front());
  }
}

void CGrammar::RecordAll() {
  std::set<std::pair<std::string, SElementName>> done;
  for (const SSample& sample : m_devices.GetSamples().GetAll()) {
    if (done.insert({sample.Section, sample.Name}).second) {
      Record(sample.Section, sample.Name);
    }
  }
}

// robots inside and outside <distribute> are the same; what one entity contains, others can contain
void CGrammar::MergeEntities(SElement& root) {
  SElement& arena = root.Children[{"arena"}];
  std::map<SElementName, SElement> inside;
  inside.swap(arena.Children[{"distribute"}].Children[{"entity"}].Children);
  for (const auto& [name, entity] : inside) {
    arena.Children[name].Merge(entity);
  }
  // settings of a robot for an engine
  std::set<SElementName> engines;
  std::vector<SElement*> robots;
  for (const std::string& label : m_devices.GetRobots()) {
    robots.push_back(&arena.Children[{label}]);
    for (const auto& [name, part] : robots.back()->Children) {
      if (part.IsVisited && root.Children[{"physics_engines"}].Find(name) != nullptr) {
        engines.insert(name);
      }
    }
  }
  for (SElement* const robot : robots) {
    for (const SElementName& engine : engines) {
      robot->Children.try_emplace(engine);
    }
  }
  ShareChildren(robots, true);
  ShareChildren(PointersTo(arena), false);
}

SElement CGrammar::MakeRoot() {
  SElement root = m_root;
  MarkRequired(root, {});
  CManuals(m_devices.GetKinds()).Describe(root, {}, "");
  std::vector<SElement*> devices;
  for (const char* const section : {"actuators", "sensors"}) {
    for (SElement* const controller : PointersTo(root.Children[{"controllers"}])) {
      SElement& list = controller->Children[{section}];
      ShareTypes(list);
      for (SElement* const device : PointersTo(list)) {
        devices.push_back(device);
      }
    }
  }
  ShareChildren(devices, false);
  ShareChildren(PointersTo(root.Children[{"physics_engines"}]), false);
  MergeEntities(root);
  SElement& views = root.Children[{"visualization"}];
  for (auto& [name, output] : root.Children[{"outputs"}].Children) {
    if (const SElement* const view = views.Find(name)) {
      output.Merge(*view);
    }
  }
  // all views have the same overlays
  SElement overlays;
  CollectOverlays(root, overlays);
  for (auto& [name, view] : views.Children) {
    if (view.Find({"overlays"}) != nullptr) {
      view.Children[{"overlays"}].Merge(overlays);
    }
  }
  return root;
}

bool CGrammar::IsUnknown(const std::string& section, const SElementName& name) const {
  return m_known.count(PathOf(section, name)) == 0;
}

}  // namespace argos
