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

// handles

CConfigurationNode::CConfigurationNode(const std::string& tag) {
  CheckXmlName(tag);
  auto store = std::make_shared<CConfigurationStore>(kMadeByProgram);
  tinyxml2::XMLElement* element = store->GetXml().NewElement(tag.c_str());
  store->GetXml().InsertEndChild(element);
  m_entry = &store->EntryOf(*element);
  m_owner = std::move(store);
}

CConfigurationNode::CConfigurationNode(const CConfigurationNode& other)
    : m_entry(other.m_entry),
      m_owner(other.m_entry == nullptr ? nullptr : other.m_entry->Store->shared_from_this()) {}

CConfigurationNode& CConfigurationNode::operator=(const CConfigurationNode& other) {
  if (this == &other) {
    return *this;
  }
  CConfigurationStore* ownStore = m_entry != nullptr ? m_entry->Store : nullptr;
  // reassigning the document's own handle of an element: the next GetNode() creates a new one
  if (m_entry != nullptr && m_entry->Handle == this) {
    m_entry->Handle = nullptr;
  }
  SConfigurationEntry* entry = other.m_entry;
  std::shared_ptr<CConfigurationStore> owner;
  // the document must not own itself
  if (entry != nullptr && !(m_heldByDocument && entry->Store == ownStore)) {
    owner = entry->Store->shared_from_this();
  }
  m_entry = entry;
  m_owner = std::move(owner);
  return *this;
}

CConfigurationNode::~CConfigurationNode() = default;

SConfigurationEntry& CConfigurationNode::Entry() const {
  if (m_entry == nullptr) {
    THROW_CONFIGURATION_ERROR(
        "An empty configuration node was used: assign an element to it first");
  }
  if (m_entry->Element == nullptr) {
    THROW_CONFIGURATION_ERROR(
        LocationText(*m_entry->File, m_entry->Line)
        << ": a configuration node was used after it was removed from its parent");
  }
  return *m_entry;
}

bool CConfigurationNode::IsLasting() const {
  return m_heldByDocument && m_entry != nullptr && m_entry->Store->IsLasting();
}

std::string CConfigurationNode::Value() const {
  return Entry().Element->Value();
}

void CConfigurationNode::SetTag(const std::string& tag) {
  CheckXmlName(tag);
  Entry().Element->SetValue(tag.c_str());
}

UInt32 CConfigurationNode::GetLine() const {
  return static_cast<UInt32>(Entry().Line);
}

const std::string& CConfigurationNode::GetFileName() const {
  return *Entry().File;
}

std::string CConfigurationNode::GetLocation() const {
  return LocationText(*Entry().File, Entry().Line);
}

// errors

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
    recorder->NoteMissed(Entry(), name);
  }
  THROW_CONFIGURATION_ERROR(GetLocation()
                            << ": <" << Value() << ">: attribute \"" << name << "\" is missing"
                            << DescribePresent(name, AttributeNames(*Entry().Element)));
}

void CConfigurationNode::ThrowMissingChild(const std::string& tag) const {
  THROW_CONFIGURATION_ERROR(GetLocation()
                            << ": <" << Value() << ">: element <" << tag << "> is missing inside it"
                            << DescribePresent(tag, ChildTags(*Entry().Element)));
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
  CAttributeRepairs::Note(Entry(), name, sample);
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteType(Entry(), name, sample);
  }
}

bool CConfigurationNode::IsLenient() const {
  const SConfigurationEntry& entry = Entry();
  return entry.Store->LeniencyOf(entry) != nullptr || CRequestRecorder::Current() != nullptr;
}

void CConfigurationNode::WarnOfLooseText(const std::string& what, const char* text,
                                         const std::string& expected) const {
  const SConfigurationEntry& entry = Entry();
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteExpected(entry, what, expected);
    return;
  }
  const std::string warning = GetLocation() + ": <" + Value() + ">: " + what + ": found \"" + text +
                              "\", expected " + expected;
  if (entry.Store->LeniencyOf(entry)->Reported.insert(warning).second) {
    LOGERR << "[WARNING] " << warning << "; read as ARGoS 3 reads it" << std::endl;
  }
}

void CConfigurationNode::ThrowUnparsable(const std::string& what, const char* text,
                                         const std::string& expected, const std::string& reason,
                                         bool isLoose) const {
  std::string details = reason;
  // for texts other than lists, the reason tells what is too much
  const bool isList = std::strchr(text, ',') != nullptr;
  // the reason may be the text of another exception, with its own prefix
  Replace(details, "[FATAL] ", "");
  THROW_CONFIGURATION_ERROR(
      GetLocation() << ": <" << Value() << ">: " << what << ": found \"" << text << "\", expected "
                    << expected << (details.empty() ? "" : " (" + details + ")")
                    << (isLoose && isList ? "; --lenient reads it as ARGoS 3 does" : ""));
}

void CConfigurationNode::ThrowIfHuge(const std::string& name, const char* text) const {
  if (HasHugeNumber(text) && !IsOfUser(*Entry().Element)) {
    CTextOutput expected;
    expected << "real numbers from " << -kMaxReal << " to " << kMaxReal;
    ThrowUnparsable("attribute \"" + name + '"', text, expected.str(), "", false);
  }
}

// neighbours

namespace {

void NoteChildRequest(const SConfigurationEntry& entry, const std::string& tag) {
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteChild(entry, tag);
  }
}

}  // namespace

CConfigurationNode* CConfigurationNode::Parent(bool throwIfMissing) const {
  tinyxml2::XMLNode* parent = Entry().Element->Parent();
  tinyxml2::XMLElement* element = parent != nullptr ? parent->ToElement() : nullptr;
  if (element == nullptr && throwIfMissing) {
    THROW_CONFIGURATION_ERROR(GetLocation() << ": <" << Value() << "> has no parent element");
  }
  return m_entry->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::FirstChildElement(bool throwIfMissing) const {
  tinyxml2::XMLElement* element = Entry().Element->FirstChildElement();
  if (element == nullptr && throwIfMissing) {
    THROW_CONFIGURATION_ERROR(GetLocation() << ": <" << Value() << "> contains no element");
  }
  return m_entry->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::FirstChildElement(const char* tag,
                                                          bool throwIfMissing) const {
  NoteChildRequest(Entry(), tag);
  tinyxml2::XMLElement* element = Entry().Element->FirstChildElement(tag);
  if (element == nullptr && throwIfMissing) {
    ThrowMissingChild(tag);
  }
  return m_entry->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::FirstChildElement(const std::string& tag,
                                                          bool throwIfMissing) const {
  return FirstChildElement(tag.c_str(), throwIfMissing);
}

CConfigurationNode* CConfigurationNode::LastChildElement(bool throwIfMissing) const {
  tinyxml2::XMLElement* element = Entry().Element->LastChildElement();
  if (element == nullptr && throwIfMissing) {
    THROW_CONFIGURATION_ERROR(GetLocation() << ": <" << Value() << "> contains no element");
  }
  return m_entry->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::LastChildElement(const std::string& tag,
                                                         bool throwIfMissing) const {
  NoteChildRequest(Entry(), tag);
  tinyxml2::XMLElement* element = Entry().Element->LastChildElement(tag.c_str());
  if (element == nullptr && throwIfMissing) {
    ThrowMissingChild(tag);
  }
  return m_entry->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::NextSiblingElement(bool throwIfMissing) const {
  tinyxml2::XMLElement* element = Entry().Element->NextSiblingElement();
  if (element == nullptr && throwIfMissing) {
    THROW_CONFIGURATION_ERROR(GetLocation() << ": no element follows <" << Value() << ">");
  }
  return m_entry->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::NextSiblingElement(const char* tag,
                                                           bool throwIfMissing) const {
  tinyxml2::XMLElement* element = Entry().Element->NextSiblingElement(tag);
  if (element == nullptr && throwIfMissing) {
    THROW_CONFIGURATION_ERROR(GetLocation()
                              << ": no element <" << tag << "> follows <" << Value() << ">");
  }
  return m_entry->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::NextSiblingElement(const std::string& tag,
                                                           bool throwIfMissing) const {
  return NextSiblingElement(tag.c_str(), throwIfMissing);
}

CConfigurationNode* CConfigurationNode::PreviousSiblingElement(bool throwIfMissing) const {
  tinyxml2::XMLElement* element = Entry().Element->PreviousSiblingElement();
  if (element == nullptr && throwIfMissing) {
    THROW_CONFIGURATION_ERROR(GetLocation() << ": no element precedes <" << Value() << ">");
  }
  return m_entry->Store->HandleOf(element);
}

CConfigurationNode* CConfigurationNode::PreviousSiblingElement(const std::string& tag,
                                                               bool throwIfMissing) const {
  tinyxml2::XMLElement* element = Entry().Element->PreviousSiblingElement(tag.c_str());
  if (element == nullptr && throwIfMissing) {
    THROW_CONFIGURATION_ERROR(GetLocation()
                              << ": no element <" << tag << "> precedes <" << Value() << ">");
  }
  return m_entry->Store->HandleOf(element);
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
  for (const auto* child = Entry().Element->FirstChild(); child != nullptr;
       child = child->NextSibling()) {
    if (child->ToComment() == nullptr) {
      return false;
    }
  }
  return true;
}

// changing the tree

CConfigurationNode* CConfigurationNode::InsertEndChild(const CConfigurationNode& child) {
  CConfigurationStore& store = *Entry().Store;
  tinyxml2::XMLElement& copy = store.CopyOf(*child.Entry().Element);
  m_entry->Element->InsertEndChild(&copy);
  return store.HandleOf(&copy);
}

CConfigurationNode* CConfigurationNode::InsertAfterChild(const CConfigurationNode& before,
                                                         const CConfigurationNode& child) {
  tinyxml2::XMLElement* neighbour = before.Entry().Element;
  if (neighbour->Parent() != Entry().Element) {
    THROW_CONFIGURATION_ERROR(GetLocation() << ": <" << before.Value() << "> is not a child of <"
                                            << Value() << ">, so nothing can be inserted after it");
  }
  CConfigurationStore& store = *m_entry->Store;
  tinyxml2::XMLElement& copy = store.CopyOf(*child.Entry().Element);
  m_entry->Element->InsertAfterChild(neighbour, &copy);
  return store.HandleOf(&copy);
}

CConfigurationNode* CConfigurationNode::InsertBeforeChild(const CConfigurationNode& after,
                                                          const CConfigurationNode& child) {
  tinyxml2::XMLElement* neighbour = after.Entry().Element;
  if (neighbour->Parent() != Entry().Element) {
    THROW_CONFIGURATION_ERROR(GetLocation()
                              << ": <" << after.Value() << "> is not a child of <" << Value()
                              << ">, so nothing can be inserted before it");
  }
  CConfigurationStore& store = *m_entry->Store;
  tinyxml2::XMLElement& copy = store.CopyOf(*child.Entry().Element);
  if (neighbour->PreviousSibling() != nullptr) {
    m_entry->Element->InsertAfterChild(neighbour->PreviousSibling(), &copy);
  } else {
    m_entry->Element->InsertFirstChild(&copy);
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
  tinyxml2::XMLElement* element = child->Entry().Element;
  if (element->Parent() != Entry().Element) {
    THROW_CONFIGURATION_ERROR(GetLocation() << ": <" << child->Value() << "> is not a child of <"
                                            << Value() << ">, so it cannot be removed from it");
  }
  m_entry->Store->Delete(*element);
}

void CConfigurationNode::Clear() {
  while (Entry().Element->FirstChild() != nullptr) {
    m_entry->Store->Delete(*m_entry->Element->FirstChild());
  }
}

std::unique_ptr<CConfigurationNode> CConfigurationNode::Clone() const {
  auto store = std::make_shared<CConfigurationStore>(GetFileName());
  tinyxml2::XMLElement& copy = store->CopyOf(*Entry().Element);
  store->GetXml().InsertEndChild(&copy);
  auto clone = std::make_unique<CConfigurationNode>();
  clone->m_entry = &store->EntryOf(copy);
  clone->m_owner = std::move(store);
  return clone;
}

// attributes and texts

namespace {

// notes what it finds
const tinyxml2::XMLAttribute* SearchAttribute(SConfigurationEntry& entry, const std::string& name) {
  const tinyxml2::XMLAttribute* const next =
      entry.LastFound != nullptr ? entry.LastFound->Next() : nullptr;
  if (next != nullptr && name == next->Name()) {
    entry.LastFound = next;
    ++entry.LastFoundIndex;
    return next;
  }
  UInt32 index = 0;
  for (const auto* attribute = entry.Element->FirstAttribute(); attribute != nullptr;
       attribute = attribute->Next(), ++index) {
    if (name == attribute->Name()) {
      entry.LastFound = attribute;
      entry.LastFoundIndex = index;
      return attribute;
    }
  }
  return nullptr;
}

}  // namespace

const char* CConfigurationNode::FindAttribute(const std::string& name) const {
  SConfigurationEntry& entry = Entry();
  CRequestRecorder* const recorder = CRequestRecorder::Current();
  if (recorder != nullptr) {
    recorder->NoteAttribute(entry, name);
  }
  if (const tinyxml2::XMLAttribute* const attribute = SearchAttribute(entry, name)) {
    entry.ReadAttributes |= AttributeBit(entry.LastFoundIndex);
    return recorder != nullptr ? recorder->TextOf(name, attribute->Value()) : attribute->Value();
  }
  std::vector<std::string>& missed = entry.MissedNames;
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
  Entry().Element->SetAttribute(name.c_str(), text.c_str());
  // a written attribute counts as read
  FindAttribute(name);
}

void CConfigurationNode::RemoveAttribute(const std::string& name) {
  SConfigurationEntry& entry = Entry();
  UInt32 index = 0;
  for (const auto* attribute = entry.Element->FirstAttribute(); attribute != nullptr;
       attribute = attribute->Next(), ++index) {
    if (name != attribute->Name()) {
      continue;
    }
    // the bits of later attributes move down by one
    if (index < kTrackedAttributes) {
      const UInt64 before = AttributeBit(index) - 1;
      entry.ReadAttributes =
          (entry.ReadAttributes & before) | ((entry.ReadAttributes >> 1) & ~before);
    }
    entry.LastFound = nullptr;
    entry.Element->DeleteAttribute(name.c_str());
    return;
  }
}

CConfigurationAttribute* CConfigurationNode::FirstAttribute(bool throwIfMissing) const {
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteOpen(Entry());
  }
  const tinyxml2::XMLAttribute* attribute = Entry().Element->FirstAttribute();
  if (attribute == nullptr) {
    if (throwIfMissing) {
      THROW_CONFIGURATION_ERROR(GetLocation() << ": <" << Value() << "> has no attributes");
    }
    return nullptr;
  }
  m_entry->ReadAttributes |= AttributeBit(0);
  return m_entry->Store->KeepAttribute(CConfigurationAttribute(m_entry, attribute));
}

std::vector<std::string> CConfigurationNode::GetAttributeNames() const {
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteOpen(Entry());
  }
  return AttributeNames(*Entry().Element);
}

std::vector<std::pair<std::string, std::string>> CConfigurationNode::CopyAttributes() const {
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteOpen(Entry());
  }
  std::vector<std::pair<std::string, std::string>> attributes;
  for (const auto* attribute = Entry().Element->FirstAttribute(); attribute != nullptr;
       attribute = attribute->Next()) {
    attributes.emplace_back(attribute->Name(), attribute->Value());
  }
  return attributes;
}

const char* CConfigurationNode::FindText(bool throwIfMissing) const {
  SConfigurationEntry& entry = Entry();
  entry.IsTextRead = true;
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteText(entry);
  }
  const char* text = entry.Element->GetText();
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
  Entry().Element->SetText(text.c_str());
}

// streams, marking as read

std::ostream& operator<<(std::ostream& stream, const CConfigurationNode& node) {
  tinyxml2::XMLPrinter printer;
  node.Entry().Element->Accept(&printer);
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
  SConfigurationEntry& entry = node.Entry();
  entry.IsVisited = true;
  entry.IsTextRead = true;
  entry.ReadAttributes = ~UInt64(0);
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteOpen(entry);
  }
  for (auto* child = node.FirstChildElement(false); child != nullptr;
       child = child->NextSiblingElement(false)) {
    MarkSubtreeRead(*child);
  }
}

}  // namespace argos
