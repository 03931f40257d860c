#include <argos3/core/utility/configuration/configuration_node.h>

#include <argos3/core/utility/configuration/attribute_repairs.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/configuration/configuration_error.h>
#include <argos3/core/utility/configuration/configuration_iterator.h>
#include <argos3/core/utility/configuration/configuration_store.h>
#include <argos3/core/utility/configuration/request_recorder.h>
#include <argos3/core/utility/configuration/value_range.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <algorithm>
#include <cstring>
#include <iterator>

namespace argos {

namespace {

constexpr const char* kMadeByProgram = "(made by the program)";

// bit of an attribute in ReadAttributes; 0 for attributes that are not tracked
UInt64 AttributeBit(UInt32 index) {
  return index < kTrackedAttributes ? UInt64(1) << index : UInt64(0);
}

}  // namespace

/****************************************/
// handles
/****************************************/

CConfigurationNode::CConfigurationNode(const std::string& tag) {
  CheckXmlName(tag);
  auto store = std::make_shared<CConfigurationStore>(kMadeByProgram);
  tinyxml2::XMLElement* element = store->GetXml().NewElement(tag.c_str());
  store->GetXml().InsertEndChild(element);
  m_record = &store->RecordOf(*element);
  m_owner = std::move(store);
}

CConfigurationNode::CConfigurationNode(const CConfigurationNode& other)
    : m_record(other.m_record),
      m_owner(other.m_record == nullptr ? nullptr : other.m_record->Store->shared_from_this()) {}

CConfigurationNode& CConfigurationNode::operator=(const CConfigurationNode& other) {
  if (this == &other) {
    return *this;
  }
  CConfigurationStore* ownStore = m_record != nullptr ? m_record->Store : nullptr;
  // reassigning the document's own handle of an element: the next GetNode() creates a new one
  if (m_record != nullptr && m_record->Handle == this) {
    m_record->Handle = nullptr;
  }
  SConfigurationRecord* record = other.m_record;
  std::shared_ptr<CConfigurationStore> owner;
  // the document must not own itself
  if (record != nullptr && !(m_heldByDocument && record->Store == ownStore)) {
    owner = record->Store->shared_from_this();
  }
  m_record = record;
  m_owner = std::move(owner);
  return *this;
}

CConfigurationNode::~CConfigurationNode() = default;

SConfigurationRecord& CConfigurationNode::Record() const {
  if (m_record == nullptr) {
    THROW_CONFIGURATION_ERROR(
        "An empty configuration node was used: assign an element to it first");
  }
  if (m_record->Element == nullptr) {
    THROW_CONFIGURATION_ERROR(
        LocationText(*m_record->File, m_record->Line)
        << ": a configuration node was used after it was removed from its parent");
  }
  return *m_record;
}

bool CConfigurationNode::IsLasting() const {
  return m_heldByDocument && m_record != nullptr && m_record->Store->IsLasting();
}

std::string CConfigurationNode::Value() const {
  return Record().Element->Value();
}

void CConfigurationNode::SetTag(const std::string& tag) {
  CheckXmlName(tag);
  Record().Element->SetValue(tag.c_str());
}

UInt32 CConfigurationNode::GetLine() const {
  return static_cast<UInt32>(Record().Line);
}

const std::string& CConfigurationNode::GetFileName() const {
  return *Record().File;
}

std::string CConfigurationNode::GetLocation() const {
  return LocationText(*Record().File, Record().Line);
}

/****************************************/
// errors
/****************************************/

namespace {

// the end of a message about a missing name: similar names that are there are misspellings of it
std::string DescribePresent(const std::string& missing, const std::vector<std::string>& present) {
  const std::string near = NearestNames(missing, present, 1);
  if (!near.empty()) {
    return "; is \"" + near + "\" a misspelling of it?";
  }
  std::string list;
  for (const std::string& name : present) {
    list += (list.empty() ? "; it has: " : ", ") + name;
  }
  return list.empty() ? "; it has none" : list;
}

}  // namespace

void CConfigurationNode::ThrowMissingAttribute(const std::string& name) const {
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteMissed(Record(), name);
  }
  THROW_CONFIGURATION_ERROR(GetLocation()
                            << ": <" << Value() << ">: attribute \"" << name << "\" is missing"
                            << DescribePresent(name, AttributeNames(*Record().Element)));
}

void CConfigurationNode::ThrowMissingChild(const std::string& tag) const {
  THROW_CONFIGURATION_ERROR(GetLocation()
                            << ": <" << Value() << ">: element <" << tag << "> is missing inside it"
                            << DescribePresent(tag, ChildTags(*Record().Element)));
}

std::string CConfigurationNode::GetAttributeOrDefault(const std::string& name,
                                                      const std::string& dflt) const {
  NoteRequest(name, nullptr);
  const char* text = FindAttribute(name);
  return text != nullptr ? text : dflt;
}

std::string CConfigurationNode::GetTextOrDefault(const std::string& dflt) const {
  const char* text = FindText(false);
  return text != nullptr ? text : dflt;
}

void CConfigurationNode::NoteRequest(const std::string& name, const char* sample) const {
  CAttributeRepairs::Note(Record(), name, sample);
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteType(Record(), name, sample);
  }
}

bool CConfigurationNode::IsLenient() const {
  const SConfigurationRecord& record = Record();
  return record.Store->LeniencyOf(record) != nullptr || CRequestRecorder::Current() != nullptr;
}

void CConfigurationNode::WarnOfLooseText(const std::string& what, const char* text,
                                         const std::string& expected) const {
  const SConfigurationRecord& record = Record();
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteExpected(record, what, expected);
    return;
  }
  const std::string warning = GetLocation() + ": <" + Value() + ">: " + what + ": found \"" + text +
                              "\", expected " + expected;
  if (record.Store->LeniencyOf(record)->Reported.insert(warning).second) {
    LOGERR << "[WARNING] " << warning << "; read as ARGoS 3 reads it" << std::endl;
  }
}

void CConfigurationNode::ThrowUnparsable(const std::string& what, const char* text,
                                         const std::string& expected, const std::string& reason,
                                         bool isLoose) const {
  std::string details = reason;
  // of other texts, the reason tells what is too much
  const bool isList = std::strchr(text, ',') != nullptr;
  // the reason may be the text of another exception, with its own prefix
  Replace(details, "[FATAL] ", "");
  THROW_CONFIGURATION_ERROR(
      GetLocation() << ": <" << Value() << ">: " << what << ": found \"" << text << "\", expected "
                    << expected << (details.empty() ? "" : " (" + details + ")")
                    << (isLoose && isList ? "; --lenient reads it as ARGoS 3 does" : ""));
}

void CConfigurationNode::ThrowIfHuge(const std::string& name, const char* text) const {
  if (HasHugeNumber(text) && !IsOfUser(*Record().Element)) {
    CTextOutput expected;
    expected << "real numbers from " << -kMostReal << " to " << kMostReal;
    ThrowUnparsable("attribute \"" + name + '"', text, expected.str(), "", false);
  }
}

/****************************************/
// neighbours
/****************************************/

namespace {

void NoteChildRequest(const SConfigurationRecord& record, const std::string& tag) {
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteChild(record, tag);
  }
}

}  // namespace

CConfigurationNode* CConfigurationNode::Parent(bool throwIfMissing) const {
  tinyxml2::XMLNode* parent = Record().Element->Parent();
  tinyxml2::XMLElement* element = parent != nullptr ? parent->ToElement() : nullptr;
  if (element == nullptr && throwIfMissing) {
    THROW_CONFIGURATION_ERROR(GetLocation() << ": <" << Value() << "> has no parent element");
  }
  return m_record->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::FirstChildElement(bool throwIfMissing) const {
  tinyxml2::XMLElement* element = Record().Element->FirstChildElement();
  if (element == nullptr && throwIfMissing) {
    THROW_CONFIGURATION_ERROR(GetLocation() << ": <" << Value() << "> contains no element");
  }
  return m_record->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::FirstChildElement(const char* tag,
                                                          bool throwIfMissing) const {
  NoteChildRequest(Record(), tag);
  tinyxml2::XMLElement* element = Record().Element->FirstChildElement(tag);
  if (element == nullptr && throwIfMissing) {
    ThrowMissingChild(tag);
  }
  return m_record->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::FirstChildElement(const std::string& tag,
                                                          bool throwIfMissing) const {
  return FirstChildElement(tag.c_str(), throwIfMissing);
}

CConfigurationNode* CConfigurationNode::LastChildElement(bool throwIfMissing) const {
  tinyxml2::XMLElement* element = Record().Element->LastChildElement();
  if (element == nullptr && throwIfMissing) {
    THROW_CONFIGURATION_ERROR(GetLocation() << ": <" << Value() << "> contains no element");
  }
  return m_record->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::LastChildElement(const std::string& tag,
                                                         bool throwIfMissing) const {
  NoteChildRequest(Record(), tag);
  tinyxml2::XMLElement* element = Record().Element->LastChildElement(tag.c_str());
  if (element == nullptr && throwIfMissing) {
    ThrowMissingChild(tag);
  }
  return m_record->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::NextSiblingElement(bool throwIfMissing) const {
  tinyxml2::XMLElement* element = Record().Element->NextSiblingElement();
  if (element == nullptr && throwIfMissing) {
    THROW_CONFIGURATION_ERROR(GetLocation() << ": no element follows <" << Value() << ">");
  }
  return m_record->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::NextSiblingElement(const char* tag,
                                                           bool throwIfMissing) const {
  tinyxml2::XMLElement* element = Record().Element->NextSiblingElement(tag);
  if (element == nullptr && throwIfMissing) {
    THROW_CONFIGURATION_ERROR(GetLocation()
                              << ": no element <" << tag << "> follows <" << Value() << ">");
  }
  return m_record->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::NextSiblingElement(const std::string& tag,
                                                           bool throwIfMissing) const {
  return NextSiblingElement(tag.c_str(), throwIfMissing);
}

CConfigurationNode* CConfigurationNode::PreviousSiblingElement(bool throwIfMissing) const {
  tinyxml2::XMLElement* element = Record().Element->PreviousSiblingElement();
  if (element == nullptr && throwIfMissing) {
    THROW_CONFIGURATION_ERROR(GetLocation() << ": no element precedes <" << Value() << ">");
  }
  return m_record->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::PreviousSiblingElement(const std::string& tag,
                                                               bool throwIfMissing) const {
  tinyxml2::XMLElement* element = Record().Element->PreviousSiblingElement(tag.c_str());
  if (element == nullptr && throwIfMissing) {
    THROW_CONFIGURATION_ERROR(GetLocation()
                              << ": no element <" << tag << "> precedes <" << Value() << ">");
  }
  return m_record->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::IterateChildren(CConfigurationNode* previous) const {
  return previous != nullptr ? previous->NextSiblingElement(false) : FirstChildElement(false);
}

CConfigurationNode* CConfigurationNode::IterateChildren(const std::string& tag,
                                                        CConfigurationNode* previous) const {
  return previous != nullptr ? previous->NextSiblingElement(tag, false)
                             : FirstChildElement(tag, false);
}

bool CConfigurationNode::NoChildren() const {
  for (const auto* child = Record().Element->FirstChild(); child != nullptr;
       child = child->NextSibling()) {
    if (child->ToComment() == nullptr) {
      return false;
    }
  }
  return true;
}

/****************************************/
// changing the tree
/****************************************/

CConfigurationNode* CConfigurationNode::InsertEndChild(const CConfigurationNode& child) {
  CConfigurationStore& store = *Record().Store;
  tinyxml2::XMLElement& copy = store.CopyOf(*child.Record().Element);
  m_record->Element->InsertEndChild(&copy);
  return store.HandleOf(&copy);
}

CConfigurationNode* CConfigurationNode::InsertAfterChild(const CConfigurationNode& before,
                                                         const CConfigurationNode& child) {
  tinyxml2::XMLElement* neighbour = before.Record().Element;
  if (neighbour->Parent() != Record().Element) {
    THROW_CONFIGURATION_ERROR(GetLocation() << ": <" << before.Value() << "> is not a child of <"
                                            << Value() << ">, so nothing can be inserted after it");
  }
  CConfigurationStore& store = *m_record->Store;
  tinyxml2::XMLElement& copy = store.CopyOf(*child.Record().Element);
  m_record->Element->InsertAfterChild(neighbour, &copy);
  return store.HandleOf(&copy);
}

CConfigurationNode* CConfigurationNode::InsertBeforeChild(const CConfigurationNode& after,
                                                          const CConfigurationNode& child) {
  tinyxml2::XMLElement* neighbour = after.Record().Element;
  if (neighbour->Parent() != Record().Element) {
    THROW_CONFIGURATION_ERROR(GetLocation()
                              << ": <" << after.Value() << "> is not a child of <" << Value()
                              << ">, so nothing can be inserted before it");
  }
  CConfigurationStore& store = *m_record->Store;
  tinyxml2::XMLElement& copy = store.CopyOf(*child.Record().Element);
  if (neighbour->PreviousSibling() != nullptr) {
    m_record->Element->InsertAfterChild(neighbour->PreviousSibling(), &copy);
  } else {
    m_record->Element->InsertFirstChild(&copy);
  }
  return store.HandleOf(&copy);
}

CConfigurationNode* CConfigurationNode::LinkEndChild(CConfigurationNode* child) {
  CConfigurationNode* const linked = InsertEndChild(*child);
  *child = *linked;
  return linked;
}

CConfigurationNode* CConfigurationNode::ReplaceChild(CConfigurationNode* child,
                                                     const CConfigurationNode& with) {
  CConfigurationNode* const replacement = InsertAfterChild(*child, with);
  RemoveChild(child);
  return replacement;
}

void CConfigurationNode::RemoveChild(CConfigurationNode* child) {
  tinyxml2::XMLElement* element = child->Record().Element;
  if (element->Parent() != Record().Element) {
    THROW_CONFIGURATION_ERROR(GetLocation() << ": <" << child->Value() << "> is not a child of <"
                                            << Value() << ">, so it cannot be removed from it");
  }
  m_record->Store->Delete(*element);
}

void CConfigurationNode::Clear() {
  while (Record().Element->FirstChild() != nullptr) {
    m_record->Store->Delete(*m_record->Element->FirstChild());
  }
}

std::unique_ptr<CConfigurationNode> CConfigurationNode::Clone() const {
  auto store = std::make_shared<CConfigurationStore>(GetFileName());
  tinyxml2::XMLElement& copy = store->CopyOf(*Record().Element);
  store->GetXml().InsertEndChild(&copy);
  auto clone = std::make_unique<CConfigurationNode>();
  clone->m_record = &store->RecordOf(copy);
  clone->m_owner = std::move(store);
  return clone;
}

/****************************************/
// attributes and texts
/****************************************/

namespace {

// notes what it finds
const tinyxml2::XMLAttribute* SearchAttribute(SConfigurationRecord& record,
                                              const std::string& name) {
  const tinyxml2::XMLAttribute* const next =
      record.LastFound != nullptr ? record.LastFound->Next() : nullptr;
  if (next != nullptr && name == next->Name()) {
    record.LastFound = next;
    ++record.LastFoundIndex;
    return next;
  }
  UInt32 index = 0;
  for (const auto* attribute = record.Element->FirstAttribute(); attribute != nullptr;
       attribute = attribute->Next(), ++index) {
    if (name == attribute->Name()) {
      record.LastFound = attribute;
      record.LastFoundIndex = index;
      return attribute;
    }
  }
  return nullptr;
}

}  // namespace

const char* CConfigurationNode::FindAttribute(const std::string& name) const {
  SConfigurationRecord& record = Record();
  CRequestRecorder* const recorder = CRequestRecorder::Current();
  if (recorder != nullptr) {
    recorder->NoteAttribute(record, name);
  }
  if (const tinyxml2::XMLAttribute* const attribute = SearchAttribute(record, name)) {
    record.ReadAttributes |= AttributeBit(record.LastFoundIndex);
    return recorder != nullptr ? recorder->TextOf(name, attribute->Value()) : attribute->Value();
  }
  std::vector<std::string>& missed = record.MissedNames;
  if (std::find(missed.begin(), missed.end(), name) == missed.end()) {
    missed.push_back(name);
  }
  return nullptr;
}

std::string CConfigurationNode::GetAttribute(const std::string& name) const {
  NoteRequest(name, nullptr);
  const char* text = FindAttribute(name);
  return text != nullptr ? text : "";
}

void CConfigurationNode::SetAttributeText(const std::string& name, const std::string& text) {
  CheckXmlName(name);
  Record().Element->SetAttribute(name.c_str(), text.c_str());
  // a written attribute counts as read
  FindAttribute(name);
}

void CConfigurationNode::RemoveAttribute(const std::string& name) {
  SConfigurationRecord& record = Record();
  UInt32 index = 0;
  for (const auto* attribute = record.Element->FirstAttribute(); attribute != nullptr;
       attribute = attribute->Next(), ++index) {
    if (name != attribute->Name()) {
      continue;
    }
    // the bits of later attributes move down by one
    if (index < kTrackedAttributes) {
      const UInt64 before = AttributeBit(index) - 1;
      record.ReadAttributes =
          (record.ReadAttributes & before) | ((record.ReadAttributes >> 1) & ~before);
    }
    record.LastFound = nullptr;
    record.Element->DeleteAttribute(name.c_str());
    return;
  }
}

CConfigurationAttribute* CConfigurationNode::FirstAttribute(bool throwIfMissing) const {
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteOpen(Record());
  }
  const tinyxml2::XMLAttribute* attribute = Record().Element->FirstAttribute();
  if (attribute == nullptr) {
    if (throwIfMissing) {
      THROW_CONFIGURATION_ERROR(GetLocation() << ": <" << Value() << "> has no attributes");
    }
    return nullptr;
  }
  m_record->ReadAttributes |= AttributeBit(0);
  return m_record->Store->KeepAttribute(CConfigurationAttribute(m_record, attribute));
}

std::vector<std::string> CConfigurationNode::GetAttributeNames() const {
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteOpen(Record());
  }
  return AttributeNames(*Record().Element);
}

std::vector<std::pair<std::string, std::string>> CConfigurationNode::CopyAttributes() const {
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteOpen(Record());
  }
  std::vector<std::pair<std::string, std::string>> attributes;
  for (const auto* attribute = Record().Element->FirstAttribute(); attribute != nullptr;
       attribute = attribute->Next()) {
    attributes.emplace_back(attribute->Name(), attribute->Value());
  }
  return attributes;
}

const char* CConfigurationNode::FindText(bool throwIfMissing) const {
  SConfigurationRecord& record = Record();
  record.IsTextRead = true;
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteText(record);
  }
  const char* text = record.Element->GetText();
  if (text == nullptr && throwIfMissing) {
    THROW_CONFIGURATION_ERROR(GetLocation() << ": <" << Value() << "> contains no text");
  }
  return text;
}

std::string CConfigurationNode::GetText(bool throwIfMissing) const {
  const char* text = FindText(throwIfMissing);
  return text != nullptr ? text : "";
}

void CConfigurationNode::SetTextContent(const std::string& text) {
  Record().Element->SetText(text.c_str());
}

/****************************************/
// streams, marking as read
/****************************************/

std::ostream& operator<<(std::ostream& stream, const CConfigurationNode& node) {
  tinyxml2::XMLPrinter printer;
  node.Record().Element->Accept(&printer);
  return stream << printer.CStr();
}

std::istream& operator>>(std::istream& stream, CConfigurationNode& node) {
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  CConfigurationDocument document;
  document.Parse(text, "(stream)");
  node = document.GetRoot();
  return stream;
}

void MarkSubtreeRead(CConfigurationNode& node) {
  SConfigurationRecord& record = node.Record();
  record.IsVisited = true;
  record.IsTextRead = true;
  record.ReadAttributes = ~UInt64(0);
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteOpen(record);
  }
  for (auto* child = node.FirstChildElement(false); child != nullptr;
       child = child->NextSiblingElement(false)) {
    MarkSubtreeRead(*child);
  }
}

}  // namespace argos
