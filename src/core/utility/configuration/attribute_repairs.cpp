#include <argos3/core/utility/configuration/attribute_repairs.h>

#include <argos3/core/utility/configuration/configuration_store.h>

#include <algorithm>

namespace argos {

namespace {

thread_local CAttributeRepairs* currentRepairs = nullptr;

}  // namespace

CAttributeRepairs::CAttributeRepairs() {
  currentRepairs = this;
}

CAttributeRepairs::~CAttributeRepairs() {
  currentRepairs = nullptr;
  for (const SRepaired& repaired : m_repaired) {
    const std::shared_ptr<CConfigurationStore> store = repaired.Request.Store.lock();
    tinyxml2::XMLElement* const element =
        store != nullptr ? repaired.Request.Entry->Element : nullptr;
    if (element == nullptr) {
      continue;
    }
    if (repaired.WasThere) {
      element->SetAttribute(repaired.Request.Attribute.c_str(), repaired.Text.c_str());
    } else {
      repaired.Request.Entry->LastFound = nullptr;
      element->DeleteAttribute(repaired.Request.Attribute.c_str());
    }
  }
}

void CAttributeRepairs::Note(SConfigurationEntry& entry, const std::string& attribute,
                             const char* sample) {
  if (currentRepairs != nullptr) {
    currentRepairs->m_last = {entry.Store->weak_from_this(), &entry, attribute, sample};
  }
}

bool CAttributeRepairs::RepairLast() {
  const SRequest request = m_last;
  m_last = SRequest();
  const std::shared_ptr<CConfigurationStore> store = request.Store.lock();
  if (store == nullptr || request.Sample == nullptr || request.Entry->Element == nullptr ||
      std::any_of(m_repaired.begin(), m_repaired.end(), [&request](const SRepaired& repaired) {
        return repaired.Request.Entry == request.Entry &&
               repaired.Request.Attribute == request.Attribute;
      })) {
    return false;
  }
  tinyxml2::XMLElement& element = *request.Entry->Element;
  const char* const text = element.Attribute(request.Attribute.c_str());
  m_repaired.push_back({request, text != nullptr, text != nullptr ? text : ""});
  element.SetAttribute(request.Attribute.c_str(), request.Sample);
  return true;
}

}  // namespace argos
