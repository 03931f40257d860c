#include <argos3/core/utility/configuration/configuration_store.h>

#include <argos3/core/utility/configuration/configuration_error.h>

#include <algorithm>
#include <cctype>

namespace argos {

CConfigurationStore::CConfigurationStore(const std::string& name)
    : m_name(std::make_shared<const std::string>(name)),
      m_xml(true, tinyxml2::COLLAPSE_WHITESPACE) {}

SConfigurationRecord& CConfigurationStore::RecordOf(tinyxml2::XMLElement& element) {
  if (element.GetUserData() == nullptr) {
    SConfigurationRecord& record = m_records.emplace_back();
    record.Element = &element;
    record.Store = this;
    record.Line = element.GetLineNum();
    record.File = m_name;
    element.SetUserData(&record);
  }
  return *static_cast<SConfigurationRecord*>(element.GetUserData());
}

CConfigurationNode* CConfigurationStore::HandleOf(tinyxml2::XMLElement* element) {
  if (element == nullptr) {
    return nullptr;
  }
  SConfigurationRecord& record = RecordOf(*element);
  record.IsVisited = true;
  if (record.Handle == nullptr) {
    CConfigurationNode& handle = m_handles.emplace_back();
    handle.m_record = &record;
    handle.m_heldByDocument = true;
    record.Handle = &handle;
  }
  return record.Handle;
}

CConfigurationAttribute* CConfigurationStore::KeepAttribute(
    const CConfigurationAttribute& attribute) {
  m_attributes.push_back(attribute);
  return &m_attributes.back();
}

/****************************************/
// modification
/****************************************/

tinyxml2::XMLElement& CConfigurationStore::CopyOf(tinyxml2::XMLElement& original) {
  tinyxml2::XMLElement& copy = *original.DeepClone(&m_xml)->ToElement();
  InheritOrigin(copy, original);
  return copy;
}

void CConfigurationStore::InheritOrigin(tinyxml2::XMLElement& copy,
                                        tinyxml2::XMLElement& original) {
  SConfigurationRecord& record = RecordOf(copy);
  const auto* originalRecord = static_cast<const SConfigurationRecord*>(original.GetUserData());
  if (originalRecord != nullptr) {
    record.File = originalRecord->File;
    record.Leniency = originalRecord->Store->LeniencyOf(*originalRecord);
    record.Line = originalRecord->Line;
  } else {
    // all ancestors of the original have records, which give its file
    record.Line = original.GetLineNum();
    for (auto* parent = original.Parent(); parent != nullptr; parent = parent->Parent()) {
      if (parent->GetUserData() != nullptr) {
        const auto* ancestor = static_cast<const SConfigurationRecord*>(parent->GetUserData());
        record.File = ancestor->File;
        record.Leniency = ancestor->Store->LeniencyOf(*ancestor);
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
    static_cast<SConfigurationRecord*>(element.GetUserData())->Element = nullptr;
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

/****************************************/
// error messages
/****************************************/

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
