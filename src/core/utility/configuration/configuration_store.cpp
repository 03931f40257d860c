#include <argos3/core/utility/configuration/configuration_store.h>

#include <argos3/core/utility/configuration/attribute_text.h>
#include <argos3/core/utility/configuration/configuration_error.h>
#include <argos3/core/utility/configuration/request_recorder.h>
#include <argos3/core/utility/configuration/single_element.h>
#include <argos3/core/utility/configuration/value_range.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/core/utility/text/utf8.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

namespace argos {

CConfigurationStore::CConfigurationStore(const std::string& name)
    : m_name(std::make_shared<const std::string>(name)),
      m_xml(true, tinyxml2::COLLAPSE_WHITESPACE) {}

SConfigurationEntry& CConfigurationStore::EntryOf(tinyxml2::XMLElement& element) {
  if (element.GetUserData() == nullptr) {
    SConfigurationEntry& entry = m_entries.emplace_back();
    entry.Element = &element;
    entry.Store = this;
    entry.Line = element.GetLineNum();
    entry.File = m_name;
    element.SetUserData(&entry);
  }
  return *static_cast<SConfigurationEntry*>(element.GetUserData());
}

CConfigurationNode* CConfigurationStore::HandleOf(tinyxml2::XMLElement* element) {
  if (element == nullptr) {
    return nullptr;
  }
  SConfigurationEntry& entry = EntryOf(*element);
  entry.IsVisited = true;
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteVisit(entry);
  }
  if (entry.Handle == nullptr) {
    CConfigurationNode& handle = m_handles.emplace_back();
    handle.m_entry = &entry;
    handle.m_heldByDocument = true;
    entry.Handle = &handle;
  }
  return entry.Handle;
}

CConfigurationAttribute* CConfigurationStore::KeepAttribute(
    const CConfigurationAttribute& attribute) {
  m_attributes.push_back(attribute);
  return &m_attributes.back();
}

// modification

void CConfigurationStore::SetText(CConfigurationNode& node, const std::string& name,
                                  const std::string& text) {
  node.SetAttributeText(name, text);
}

void SetAttributeText(CConfigurationNode& node, const std::string& name, const std::string& text) {
  CConfigurationStore::SetText(node, name, text);
}

tinyxml2::XMLElement& CConfigurationStore::CopyOf(tinyxml2::XMLElement& original) {
  tinyxml2::XMLElement& copy = *original.DeepClone(&m_xml)->ToElement();
  InheritOrigin(copy, original);
  return copy;
}

void CConfigurationStore::InheritOrigin(tinyxml2::XMLElement& copy,
                                        tinyxml2::XMLElement& original) {
  SConfigurationEntry& entry = EntryOf(copy);
  const auto* originalRecord = static_cast<const SConfigurationEntry*>(original.GetUserData());
  if (CRequestRecorder::Current() != nullptr) {
    entry.OriginPath =
        std::make_shared<const std::vector<SElementName>>(CRequestRecorder::PathOf(original));
  }
  if (originalRecord != nullptr) {
    entry.Origin = originalRecord->Origin;
    entry.File = originalRecord->File;
    entry.Leniency = originalRecord->Store->LeniencyOf(*originalRecord);
    entry.Line = originalRecord->Line;
  } else {
    // all ancestors of the original have entries, which give its file
    entry.Line = original.GetLineNum();
    for (auto* parent = original.Parent(); parent != nullptr; parent = parent->Parent()) {
      if (parent->GetUserData() != nullptr) {
        const auto* ancestor = static_cast<const SConfigurationEntry*>(parent->GetUserData());
        entry.File = ancestor->File;
        entry.Leniency = ancestor->Store->LeniencyOf(*ancestor);
        break;
      }
    }
  }
  tinyxml2::XMLElement* copyChild = copy.FirstChildElement();
  tinyxml2::XMLElement* originalChild = original.FirstChildElement();
  while (copyChild != nullptr && originalChild != nullptr) {
    InheritOrigin(*copyChild, *originalChild);
    copyChild = copyChild->NextSiblingElement();
    originalChild = originalChild->NextSiblingElement();
  }
}

void CConfigurationStore::Forget(tinyxml2::XMLElement& element) {
  if (element.GetUserData() != nullptr) {
    static_cast<SConfigurationEntry*>(element.GetUserData())->Element = nullptr;
  }
  for (auto* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    Forget(*child);
  }
}

void CConfigurationStore::Delete(tinyxml2::XMLNode& node) {
  if (node.ToElement() != nullptr) {
    Forget(*node.ToElement());
  }
  m_xml.DeleteNode(&node);
}

// unread content

namespace {

// the attributes that the readers of an element use: those that they have found, or missed
std::vector<std::string> UsedNames(const SConfigurationEntry& entry) {
  std::vector<std::string> names;
  std::size_t index = 0;
  for (const auto* attribute = entry.Element->FirstAttribute(); attribute != nullptr;
       attribute = attribute->Next(), ++index) {
    if (index >= kTrackedAttributes) {
      break;
    }
    if (IsAttributeRead(entry, index)) {
      names.emplace_back(attribute->Name());
    }
  }
  names.insert(names.end(), entry.MissedNames.begin(), entry.MissedNames.end());
  return names;
}

bool IsUnread(const SConfigurationEntry& entry, const std::string& name) {
  std::size_t index = 0;
  for (const auto* attribute = entry.Element->FirstAttribute(); attribute != nullptr;
       attribute = attribute->Next(), ++index) {
    if (name == attribute->Name()) {
      return !IsAttributeRead(entry, index);
    }
  }
  return false;
}

// users' code reads the contents of such elements
bool IsReadByUser(const tinyxml2::XMLElement& element) {
  const std::string_view tag = element.Value();
  return tag == "params" || tag == "loop_functions" || tag == "user_functions";
}

std::string Trimmed(const char* text) {
  constexpr const char* kBlanks = " \t\r\n";
  const std::string whole(text);
  const std::size_t first = whole.find_first_not_of(kBlanks);
  return first == std::string::npos
             ? std::string()
             : whole.substr(first, whole.find_last_not_of(kBlanks) - first + 1);
}

std::string Shortened(const std::string& text) {
  constexpr std::size_t kMaxLength = 60;
  return std::string(CutUtf8(text, kMaxLength)) + (text.size() > kMaxLength ? "..." : "");
}

// 'file:12: <tag>'
std::string DescribeElement(const SConfigurationEntry& entry) {
  return LocationText(*entry.File, entry.Line) + ": <" + entry.Element->Value() + ">";
}

std::string DescribeUnreadAttribute(const SConfigurationEntry& entry, const std::string& name) {
  const std::string hint = DidYouMean(name, UsedNames(entry));
  // if no name is similar, the list of all of them does not help
  const bool hasSimilar = hint.rfind("; did", 0) == 0;
  return DescribeElement(entry) + ": attribute \"" + name + "\" is not used by anything" +
         (hasSimilar ? hint : "");
}

std::string DescribeUnreadText(const SConfigurationEntry& entry, const std::string& text) {
  const std::string tag = entry.Element->Value();
  const std::size_t equals = text.find('=');
  const bool isMisplacedAttribute = equals != std::string::npos && equals > 0 &&
                                    text.find_first_of("'\"", equals) != std::string::npos;
  return DescribeElement(entry) + ": the text '" + Shortened(text) +
         "' inside it is not used by anything" +
         (isMisplacedAttribute
              ? "; attributes belong into the tag: <" + tag + ' ' + Shortened(text) + " />"
              : "");
}

}  // namespace

std::vector<std::string> CConfigurationStore::DescribeUnreadSettings(
    const std::set<const tinyxml2::XMLNode*>& pending) const {
  const auto isPending = [&pending](const SConfigurationEntry& entry) {
    const tinyxml2::XMLNode* node = entry.Element;
    while (node != nullptr && pending.count(node) == 0) {
      node = node->Parent();
    }
    return node != nullptr;
  };
  std::vector<std::string> lines;
  for (const SConfigurationSetting& setting : m_settings) {
    const SConfigurationEntry* unread = nullptr;
    bool isUsed = false;
    for (const SConfigurationEntry* origin : setting.Elements) {
      // an element that was replaced by copies is read through these
      bool isOriginUnread = false;
      for (const SConfigurationEntry& entry : m_entries) {
        if (entry.Origin == origin && entry.Element != nullptr &&
            IsUnread(entry, setting.Attribute) && !isPending(entry)) {
          isOriginUnread = true;
          unread = &entry;
        }
      }
      isUsed = isUsed || !isOriginUnread;
    }
    if (!isUsed) {
      lines.push_back("--set " + setting.Path + '=' + setting.Value + ": " +
                      (unread->IsVisited ? DescribeUnreadAttribute(*unread, setting.Attribute)
                                         : DescribeElement(*unread) +
                                               " is not used by anything, nor is its attribute \"" +
                                               setting.Attribute + '"'));
    }
  }
  return lines;
}

void CConfigurationStore::DescribeUnread(tinyxml2::XMLElement& element,
                                         std::vector<std::string>& lines) {
  const SConfigurationEntry& entry = EntryOf(element);
  if (!entry.IsVisited) {
    lines.push_back(DescribeElement(entry) + " is not used by anything");
    return;
  }
  std::size_t index = 0;
  for (const auto* attribute = element.FirstAttribute(); attribute != nullptr;
       attribute = attribute->Next(), ++index) {
    if (!IsAttributeRead(entry, index)) {
      lines.push_back(DescribeUnreadAttribute(entry, attribute->Name()));
    }
  }
  for (auto* child = element.FirstChild(); child != nullptr; child = child->NextSibling()) {
    if (child->ToText() != nullptr && !entry.IsTextRead) {
      const std::string text = Trimmed(child->Value());
      if (!text.empty()) {
        lines.push_back(DescribeUnreadText(entry, text));
      }
    } else if (child->ToElement() != nullptr) {
      DescribeUnread(*child->ToElement(), lines);
    }
  }
}

void CConfigurationStore::DescribeRepeated(tinyxml2::XMLElement& element,
                                           std::vector<std::string>& lines) {
  if (m_leniency != nullptr || IsReadByUser(element)) {
    return;
  }
  for (auto* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    const SConfigurationEntry& entry = EntryOf(*child);
    if (entry.IsVisited) {
      DescribeRepeated(*child, lines);
      continue;
    }
    auto* const first = element.FirstChildElement(child->Value());
    const SConfigurationEntry& other = EntryOf(*first);
    if (other.IsVisited) {
      lines.push_back(DescribeElement(entry) + ": " +
                      DescribeRepeat(LocationText(*other.File, other.Line)));
    }
  }
}

bool IsOfUser(const tinyxml2::XMLElement& element) {
  for (const tinyxml2::XMLNode* node = &element; node != nullptr; node = node->Parent()) {
    if (node->ToElement() != nullptr && IsReadByUser(*node->ToElement())) {
      return true;
    }
  }
  return false;
}

// large numbers

namespace {

// false for most texts that have none: with no exponent and few digits before each decimal point
bool MayHaveHugeNumber(const char* text) {
  constexpr int kDigits = 13;
  int digits = 0;
  bool isFraction = false;
  for (const char* next = text; *next != '\0'; ++next) {
    if (*next == 'e' || *next == 'E') {
      return true;
    }
    if (*next < '0' || *next > '9') {
      isFraction = *next == '.';
      digits = 0;
    } else if (!isFraction && ++digits >= kDigits) {
      return true;
    }
  }
  return false;
}

}  // namespace

bool HasHugeNumber(const char* text) {
  if (!MayHaveHugeNumber(text)) {
    return false;
  }
  const std::string_view whole(text);
  constexpr const char* kSeparators = " \t\r\n,:;()";
  std::size_t begin = whole.find_first_not_of(kSeparators);
  while (begin != std::string::npos) {
    const std::size_t end = whole.find_first_of(kSeparators, begin);
    Real value = 0.0;
    if (ParseNumber(whole.substr(begin, end - begin), value) == ENumberParsing::Ok &&
        std::abs(value) > kMaxReal) {
      return true;
    }
    begin = whole.find_first_not_of(kSeparators, std::min(end, whole.size()));
  }
  return false;
}

// error messages

namespace {
void AddOnce(std::vector<std::string>& names, const char* name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    names.emplace_back(name);
  }
}
}  // namespace

std::vector<std::string> ChildTags(const tinyxml2::XMLElement& element) {
  std::vector<std::string> tags;
  for (const auto* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    AddOnce(tags, child->Value());
  }
  return tags;
}

std::vector<std::string> AttributeNames(const tinyxml2::XMLElement& element) {
  std::vector<std::string> names;
  for (const auto* attribute = element.FirstAttribute(); attribute != nullptr;
       attribute = attribute->Next()) {
    names.emplace_back(attribute->Name());
  }
  return names;
}

std::string LocationText(const std::string& file, int line) {
  return line > 0 ? file + ':' + std::to_string(line) : file;
}

void CheckXmlName(const std::string& name) {
  // letters beyond ASCII are bytes >= 128 in UTF-8. Source: XML 1.0, production 5
  const auto isStart = [](unsigned char c) {
    return std::isalpha(c) != 0 || c == '_' || c == ':' || c >= 128;
  };
  const auto isPart = [&isStart](unsigned char c) {
    return isStart(c) || std::isdigit(c) != 0 || c == '-' || c == '.';
  };
  if (name.empty() || !isStart(static_cast<unsigned char>(name[0])) ||
      !std::all_of(name.begin(), name.end(),
                   [&isPart](char c) { return isPart(static_cast<unsigned char>(c)); })) {
    THROW_CONFIGURATION_ERROR("\""
                              << name << "\" cannot be the name of an XML element or attribute: "
                              << "expected a letter, then letters, digits, '-', '_', '.' or ':'");
  }
}

}  // namespace argos
