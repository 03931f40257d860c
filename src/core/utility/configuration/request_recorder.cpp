#include <argos3/core/utility/configuration/request_recorder.h>

#include <argos3/core/utility/configuration/configuration_store.h>

#include <cstring>

namespace argos {

namespace {

thread_local CRequestRecorder* currentRecorder = nullptr;

// no number ends with it
constexpr const char* kLooseEnd = " ?";

SElementName NameOf(const tinyxml2::XMLElement& element) {
  const char* const implementation = element.Attribute("implementation");
  return {element.Value(), implementation == nullptr ? "" : implementation};
}

}  // namespace

void SRequestedAttribute::Merge(const SRequestedAttribute& other) {
  if (IsTyped && other.IsTyped && Sample != other.Sample) {
    Sample.clear();
    Expected.clear();
  } else if (other.IsTyped) {
    Sample = other.Sample;
    Expected = Expected.empty() ? other.Expected : Expected;
  }
  IsTyped = IsTyped || other.IsTyped;
  IsMissed = IsMissed || other.IsMissed;
}

SRequestedElement& SRequestedElement::Child(const SElementName& name) {
  std::unique_ptr<SRequestedElement>& child = Children[name];
  if (child == nullptr) {
    child = std::make_unique<SRequestedElement>();
  }
  return *child;
}

const SRequestedElement* SRequestedElement::Find(const SElementName& name) const {
  const auto child = Children.find(name);
  return child == Children.end() ? nullptr : child->second.get();
}

void SRequestedElement::Merge(const SRequestedElement& other) {
  for (const auto& [name, attribute] : other.Attributes) {
    Attributes[name].Merge(attribute);
  }
  for (const auto& [name, child] : other.Children) {
    Child(name).Merge(*child);
  }
  IsVisited = IsVisited || other.IsVisited;
  HasText = HasText || other.HasText;
  IsOpen = IsOpen || other.IsOpen;
}

CRequestRecorder::CRequestRecorder() {
  currentRecorder = this;
}

CRequestRecorder::~CRequestRecorder() {
  currentRecorder = nullptr;
}

CRequestRecorder* CRequestRecorder::Current() {
  return currentRecorder;
}

std::vector<SElementName> CRequestRecorder::PathOf(const tinyxml2::XMLElement& element) {
  const auto* const record = static_cast<const SConfigurationEntry*>(element.GetUserData());
  if (record != nullptr && record->OriginPath != nullptr) {
    return *record->OriginPath;
  }
  std::vector<SElementName> path;
  const tinyxml2::XMLNode* const parent = element.Parent();
  if (parent == nullptr) {
    return path;
  }
  if (parent->ToElement() != nullptr) {
    path = PathOf(*parent->ToElement());
    if (path.empty()) {
      return path;
    }
  }
  path.push_back(NameOf(element));
  return path;
}

SRequestedElement* CRequestRecorder::Find(const SConfigurationEntry& record) {
  const std::vector<SElementName> path = PathOf(*record.Element);
  if (path.empty()) {
    return nullptr;
  }
  SRequestedElement* found = &m_requests;
  for (const SElementName& name : path) {
    found = &found->Child(name);
  }
  found->IsVisited = true;
  return found;
}

void CRequestRecorder::NoteAttribute(const SConfigurationEntry& record, const std::string& name) {
  if (SRequestedElement* const element = Find(record)) {
    element->Attributes[name];
  }
}

void CRequestRecorder::NoteType(const SConfigurationEntry& record, const std::string& name,
                                const char* sample) {
  const std::string form = sample == nullptr ? "" : sample;
  m_number = form == "1" ? name : "";
  if (SRequestedElement* const element = Find(record)) {
    SRequestedAttribute request;
    request.Sample = form;
    request.IsTyped = true;
    element->Attributes[name].Merge(request);
  }
}

const char* CRequestRecorder::TextOf(const std::string& name, const char* text) {
  const bool isNumber = m_number == name;
  m_number.clear();
  if (!isNumber || text == nullptr) {
    return text;
  }
  m_text = std::string(text) + kLooseEnd;
  return m_text.c_str();
}

void CRequestRecorder::NoteExpected(const SConfigurationEntry& record, const std::string& what,
                                    const std::string& expected) {
  SRequestedElement* const element = Find(record);
  // 'attribute "name"'
  const size_t begin = what.find('"') + 1;
  const size_t end = what.rfind('"');
  if (element != nullptr && begin != 0 && end > begin) {
    element->Attributes[what.substr(begin, end - begin)].Expected = expected;
  }
}

void CRequestRecorder::NoteMissed(const SConfigurationEntry& record, const std::string& name) {
  if (SRequestedElement* const element = Find(record)) {
    element->Attributes[name].IsMissed = true;
  }
}

void CRequestRecorder::NoteChild(const SConfigurationEntry& record, const std::string& tag) {
  SRequestedElement* const element = Find(record);
  // an element that exists is noted when something is read of it
  if (element != nullptr && record.Element->FirstChildElement(tag.c_str()) == nullptr) {
    element->Child({tag});
  }
}

void CRequestRecorder::NoteVisit(const SConfigurationEntry& record) {
  Find(record);
}

void CRequestRecorder::NoteText(const SConfigurationEntry& record) {
  if (SRequestedElement* const element = Find(record)) {
    element->HasText = true;
  }
}

void CRequestRecorder::NoteOpen(const SConfigurationEntry& record) {
  if (SRequestedElement* const element = Find(record)) {
    element->IsOpen = true;
  }
}

}  // namespace argos
