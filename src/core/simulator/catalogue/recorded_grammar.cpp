#include <argos3/core/simulator/catalogue/recorded_grammar.h>

#include <argos3/core/simulator/catalogue/manual.h>
#include <argos3/core/utility/configuration/configuration_document.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>

namespace argos {

namespace {

constexpr const char* kRoot = "argos-configuration";

// what the core reads: its elements have no manuals, and these are their variants
constexpr const char* kCoreFramework =
    R"(<system threads="0" /><experiment length="1" ticks_per_second="10" random_seed="1" />
<profiling file="profile.txt" format="human_readable" />)";
// each with one entity
constexpr const char* kMethods[] = {
    "method=\"uniform\" min=\"-4,-4,0\" max=\"4,4,0\"",
    "method=\"gaussian\" mean=\"0,0,0\" std_dev=\"1,1,0\"", "method=\"constant\" values=\"6,0,0\"",
    "method=\"grid\" center=\"-6,0,0\" distances=\"1,1,0\" layout=\"1,1,1\""};
constexpr const char* kCoreLoopFunctions = R"(<loop_functions label="lua" />)";

std::string KeyOf(TConfigurationNode& element) {
  const std::string tag = element.Value();
  return NodeAttributeExists(element, "implementation")
             ? tag + " (" + element.GetAttribute("implementation") + ")"
             : tag;
}

// all elements of a tree; the order does not change while attributes are removed
void CollectElements(TConfigurationNode& element, std::vector<TConfigurationNode>& all) {
  all.push_back(element);
  TConfigurationNodeIterator it;
  for (it = it.begin(&element); it != it.end(); ++it) {
    CollectElements(*it, all);
  }
}

}  // namespace

std::string TypeOf(const SRequestedAttribute& attribute) {
  static const std::map<std::string, std::string> types = {{"red", "colour"},  {"false", "boolean"},
                                                           {"1,1", "x,y"},     {"1,1,1", "x,y,z"},
                                                           {"0,0,0", "z,y,x"}, {"0:1", "min:max"}};
  if (attribute.Sample == "1") {
    return attribute.Expected.rfind("an integer from 0", 0) == 0 ? "natural"
           : attribute.Expected.rfind("an integer", 0) == 0      ? "integer"
                                                                 : "real";
  }
  const auto found = types.find(attribute.Sample);
  return found == types.end() ? "text" : found->second;
}

std::string PathOf(const std::string& section, const std::string& key) {
  if (section == "sensors" || section == "actuators") {
    return "controllers/lua_controller/" + section + '/' + key;
  }
  return section.empty() ? key : section + '/' + key;
}

CRecordedGrammar::CRecordedGrammar(CDeviceCatalogue& catalogue) : m_catalogue(catalogue) {}

SSampleExperiment CRecordedGrammar::MakeSample(const SSampleElement& element) {
  return element.Section == "sensors" || element.Section == "actuators"
             ? m_catalogue.MakeSample(element)
             : m_catalogue.GetElements().MakeSample(element);
}

bool CRecordedGrammar::RecordSample(const SSampleExperiment& sample) {
  bool isGood = false;
  std::string xml;
  {
    const CRequestRecorder recorder;
    isGood = m_catalogue.GetLoader().Load(sample).empty();
    m_requests.Merge(recorder.GetRequests());
  }
  if (isGood) {
    NoteAlways(sample.ToXml(sample.Engines));
  }
  return isGood;
}

void CRecordedGrammar::NoteAlways(const std::string& xml) {
  CConfigurationDocument document;
  document.Parse(xml, "sample.argos");
  NoteAlwaysOf(document.GetRoot(), "");
}

void CRecordedGrammar::NoteAlwaysOf(TConfigurationNode& element, const std::string& path) {
  std::set<std::string> names;
  for (const std::string& name : element.GetAttributeNames()) {
    names.insert(name);
  }
  const auto [known, isNew] = m_always.emplace(path, names);
  if (!isNew) {
    std::set<std::string> both;
    std::set_intersection(names.begin(), names.end(), known->second.begin(), known->second.end(),
                          std::inserter(both, both.end()));
    known->second = both;
  }
  TConfigurationNodeIterator it;
  for (it = it.begin(&element); it != it.end(); ++it) {
    NoteAlwaysOf(*it, (path.empty() ? "" : path + '/') + KeyOf(*it));
  }
}

void CRecordedGrammar::NoteMissed(const SRequestedElement& element, const std::string& path) {
  for (const auto& [name, attribute] : element.Attributes) {
    if (attribute.IsMissed) {
      m_missed[path].insert(name);
    }
  }
  for (const auto& [key, child] : element.Children) {
    NoteMissed(*child, (path.empty() ? "" : path + '/') + key);
  }
}

bool CRecordedGrammar::IsRequired(const std::string& path, const std::string& attribute) const {
  const auto missed = m_missed.find(path);
  const auto always = m_always.find(path);
  return missed != m_missed.end() && missed->second.count(attribute) > 0 &&
         always != m_always.end() && always->second.count(attribute) > 0;
}

void CRecordedGrammar::RecordElement(const SSampleElement& element) {
  if (RecordSample(MakeSample(element))) {
    m_known.insert(element.Section + '/' + element.Key);
  }
}

// loads it again without each of its attributes
void CRecordedGrammar::RecordWithout(const SSampleElement& element) {
  const auto parse = [&element](CConfigurationDocument& document) {
    document.Parse(element.Text, "(example)");
    std::vector<TConfigurationNode> all;
    CollectElements(document.GetRoot(), all);
    return all;
  };
  CConfigurationDocument whole;
  std::vector<TConfigurationNode> elements = parse(whole);
  for (size_t i = 0; i < elements.size(); ++i) {
    for (const std::string& name : elements[i].GetAttributeNames()) {
      if (name == "implementation") {
        continue;
      }
      CConfigurationDocument document;
      parse(document)[i].RemoveAttribute(name);
      std::ostringstream text;
      text << document.GetRoot();
      const CRequestRecorder recorder;
      m_catalogue.GetLoader().Load(MakeSample({element.Section, element.Key, text.str()}));
      const SRequestedElement* const root = recorder.GetRequests().Find(kRoot);
      if (root != nullptr) {
        NoteMissed(*root, "");
      }
    }
  }
}

void CRecordedGrammar::Record(const std::string& section, const std::string& key) {
  bool isFirst = true;
  for (const std::string& text : m_catalogue.GetElements().Of(section, key)) {
    const SSampleElement element = {section, key, text};
    RecordElement(element);
    if (isFirst) {
      RecordWithout(element);
    }
    isFirst = false;
  }
}

void CRecordedGrammar::RecordCore() {
  SSampleExperiment sample;
  sample.Framework = kCoreFramework;
  sample.Media = m_catalogue.GetElements().GetMedia();
  const std::vector<std::string>& robots = m_catalogue.GetRobots();
  for (size_t i = 0; i < std::size(kMethods) && !robots.empty(); ++i) {
    sample.Arena += fmt::format(
        "<distribute><position {0} /><orientation {0} />"
        "<entity quantity=\"1\" max_trials=\"1000\" base_num=\"{1}\"><{2} id=\"r\">"
        "<controller config=\"c1\"><params /></controller></{2}></entity></distribute>",
        kMethods[i], i, robots.front());
  }
  sample.Sections = kCoreLoopFunctions;
  RecordSample(sample);
}

void CRecordedGrammar::RecordAll() {
  RecordCore();
  std::set<std::string> done;
  for (const SSampleElement& element : m_catalogue.GetElements().GetAll()) {
    if (done.insert(element.Section + '/' + element.Key).second) {
      Record(element.Section, element.Key);
    }
  }
}

const SRequestedElement& CRecordedGrammar::GetRoot() {
  return m_requests.Child(kRoot);
}

bool CRecordedGrammar::IsUnknown(const std::string& section, const std::string& key) const {
  return m_known.count(section + '/' + key) == 0;
}

void CRecordedGrammar::List(const SRequestedElement& element, const std::string& path,
                            const std::string& shown, std::vector<SAttributeFacts>& facts) const {
  for (const auto& [name, attribute] : element.Attributes) {
    // it is a part of the label
    if (name != "implementation") {
      facts.push_back({shown, name, TypeOf(attribute), IsRequired(path, name)});
    }
  }
  for (const auto& [key, child] : element.Children) {
    List(*child, path + '/' + key, shown + '/' + key, facts);
  }
}

std::vector<SAttributeFacts> CRecordedGrammar::ListAttributes(const std::string& section,
                                                              const std::string& key) {
  const std::string path = PathOf(section, key);
  const SRequestedElement* element = &GetRoot();
  std::istringstream parts(path);
  for (std::string part; element != nullptr && std::getline(parts, part, '/');) {
    element = element->Find(part);
  }
  std::vector<SAttributeFacts> facts;
  if (element != nullptr) {
    List(*element, path, key.substr(0, key.find(" (")), facts);
  }
  return facts;
}

}  // namespace argos
