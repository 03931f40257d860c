#include <argos3/program/catalogue/recorded_grammar.h>

#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/program/catalogue/manual.h>
#include <argos3/program/catalogue/sample_elements.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <sstream>
#include <string_view>

namespace argos {

namespace {

constexpr const char* kRoot = "argos-configuration";
constexpr const char* kNoValue = "no_such_value";

// what the core reads: its elements have no manuals, and these are their variants
constexpr const char* kCoreFramework =
    R"(<system threads="0" /><experiment length="1" ticks_per_second="10" random_seed="1" />
<profiling file="profile.txt" format="human_readable" />)";
// each with one entity
constexpr const char* kMethods[] = {
    "method=\"uniform\" min=\"-4,-4,0\" max=\"4,4,0\"",
    "method=\"gaussian\" mean=\"0,0,0\" std_dev=\"1,1,0\"", "method=\"constant\" values=\"6,0,0\"",
    "method=\"grid\" center=\"-6,0,0\" distances=\"1,1,0\" layout=\"1,1,1\""};

// all elements of a tree; the order does not change while attributes are removed
void CollectElements(TConfigurationNode& element, std::vector<TConfigurationNode>& all) {
  all.push_back(element);
  TConfigurationNodeIterator it;
  for (it = it.begin(&element); it != it.end(); ++it) {
    CollectElements(*it, all);
  }
}

std::vector<TConfigurationNode> ParseElements(CConfigurationDocument& document,
                                              const std::string& text) {
  document.Parse(text, "(example)");
  std::vector<TConfigurationNode> all;
  CollectElements(document.GetRoot(), all);
  return all;
}

std::string TextOf(CConfigurationDocument& document) {
  std::ostringstream text;
  text << document.GetRoot();
  return text.str();
}

bool IsWord(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalpha(c) != 0 || c == '_';
  });
}

// words in quotation marks, and those of a list after "known: ", each once
std::set<std::string> ListedWords(const std::string& error) {
  std::set<std::string> words;
  constexpr std::string_view kKnown = "; known: ";
  const size_t list = error.rfind(kKnown);
  if (list != std::string::npos) {
    std::istringstream items(error.substr(list + kKnown.size()));
    for (std::string item; items >> item;) {
      item.erase(item.find_last_not_of(',') + 1);
      if (IsWord(item)) {
        words.insert(item);
      }
    }
  }
  for (size_t begin = error.find('"'); begin != std::string::npos;) {
    const size_t end = error.find('"', begin + 1);
    if (end == std::string::npos) {
      break;
    }
    const std::string word = error.substr(begin + 1, end - begin - 1);
    if (IsWord(word) && word != kNoValue) {
      words.insert(word);
      begin = error.find('"', end + 1);
    } else {
      begin = end;  // it may begin a word, if marks are not paired
    }
  }
  return words;
}

// an attribute whose absence was an error
void FindMissed(const SRequestedElement& element, std::string& name, SRequestedAttribute& missed) {
  for (const auto& [key, attribute] : element.Attributes) {
    if (attribute.IsMissed) {
      name = key;
      missed = attribute;
    }
  }
  for (const auto& [key, child] : element.Children) {
    FindMissed(*child, name, missed);
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

// loads a sample again without each of its attributes; load(xml of the element)
template <typename LOAD>
void CRecordedGrammar::RecordWithout(const std::string& text, const LOAD& load) {
  CConfigurationDocument whole;
  const std::vector<TConfigurationNode> elements = ParseElements(whole, text);
  for (size_t i = 0; i < elements.size(); ++i) {
    for (const std::string& name : elements[i].GetAttributeNames()) {
      CConfigurationDocument document;
      ParseElements(document, text)[i].RemoveAttribute(name);
      const CRequestRecorder recorder;
      load(TextOf(document));
      const SRequestedElement* const root = recorder.GetRequests().Find(kRoot);
      if (name != "implementation" && root != nullptr) {
        NoteMissed(*root, "");
      }
    }
  }
}

// Loads it again with the other values that the error of a wrong one lists: a model of noise, for
// example, decides which other attributes are read.
void CRecordedGrammar::RecordVariants(const SSampleElement& element) {
  CConfigurationDocument whole;
  const std::vector<TConfigurationNode> elements = ParseElements(whole, element.Text);
  for (size_t i = 0; i < elements.size(); ++i) {
    for (const std::string& name : elements[i].GetAttributeNames()) {
      const std::string value = elements[i].GetAttribute(name);
      if (!IsWord(value) || name == "id" || name == "config" || name == "implementation") {
        continue;
      }
      CConfigurationDocument wrong;
      ParseElements(wrong, element.Text)[i].SetAttribute(name, std::string(kNoValue));
      const std::string error =
          m_catalogue.GetLoader().Load(MakeSample({element.Section, element.Key, TextOf(wrong)}));
      for (const std::string& other : ListedWords(error)) {
        if (other != value && other != name) {
          RecordVariant(element, i, name, other);
        }
      }
    }
  }
}

void CRecordedGrammar::RecordVariant(const SSampleElement& element, size_t index,
                                     const std::string& name, const std::string& value) {
  constexpr int kMostAdditions = 4;
  CConfigurationDocument document;
  TConfigurationNode changed = ParseElements(document, element.Text)[index];
  changed.SetAttribute(name, value);
  for (int i = 0; i < kMostAdditions; ++i) {
    const SSampleExperiment sample = MakeSample({element.Section, element.Key, TextOf(document)});
    SRequestedAttribute missed;
    std::string missedName;
    {
      const CRequestRecorder recorder;
      const std::string error = m_catalogue.GetLoader().Load(sample);
      m_requests.Merge(recorder.GetRequests());
      if (error.empty()) {
        NoteAlways(sample.ToXml(sample.Engines));
        return;
      }
      FindMissed(recorder.GetRequests(), missedName, missed);
    }
    if (missedName.empty() || missed.Sample.empty() || changed.HasAttribute(missedName)) {
      return;
    }
    changed.SetAttribute(missedName, missed.Sample);
  }
}

void CRecordedGrammar::Record(const std::string& section, const std::string& key) {
  bool isFirst = true;
  for (const std::string& text : m_catalogue.GetElements().Of(section, key)) {
    const SSampleElement element = {section, key, text};
    RecordElement(element);
    RecordVariants(element);
    if (isFirst) {
      RecordWithout(text, [&](const std::string& changed) {
        m_catalogue.GetLoader().Load(MakeSample({section, key, changed}));
      });
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
  RecordSample(sample);
  sample.Engines = m_catalogue.GetLoader().GetEngine();
  RecordWithout(sample.ToXml(sample.Engines),
                [&](const std::string& changed) { m_catalogue.GetLoader().LoadXml(changed); });
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
