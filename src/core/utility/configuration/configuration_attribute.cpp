#include <argos3/core/utility/configuration/configuration_attribute.h>

#include <argos3/core/utility/configuration/configuration_error.h>
#include <argos3/core/utility/configuration/configuration_iterator.h>
#include <argos3/core/utility/configuration/configuration_node.h>
#include <argos3/core/utility/configuration/configuration_store.h>
#include <argos3/core/utility/configuration/request_recorder.h>

namespace argos {

namespace {

// as a look-up by name does; only the first attributes are searched, so that a loop over many takes
// linear time
void MarkRead(SConfigurationEntry& entry, const tinyxml2::XMLAttribute& attribute) {
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteAttribute(entry, attribute.Name());
  }
  const auto* each = entry.Element->FirstAttribute();
  for (std::size_t index = 0; index < kTrackedAttributes && each != nullptr; ++index) {
    if (each == &attribute) {
      entry.ReadAttributes |= UInt64(1) << index;
      return;
    }
    each = each->Next();
  }
}

}  // namespace

CConfigurationAttribute::CConfigurationAttribute(SConfigurationEntry* entry,
                                                 const tinyxml2::XMLAttribute* attribute)
    : m_entry(entry), m_attribute(attribute) {}

const tinyxml2::XMLAttribute& CConfigurationAttribute::Checked() const {
  if (m_attribute == nullptr) {
    THROW_CONFIGURATION_ERROR("A configuration attribute that does not exist was used");
  }
  return *m_attribute;
}

std::string CConfigurationAttribute::Name() const {
  return Checked().Name();
}

std::string CConfigurationAttribute::Value() const {
  return Checked().Value();
}

void CConfigurationAttribute::SetText(const std::string& text) {
  m_entry->Element->SetAttribute(Checked().Name(), text.c_str());
}

CConfigurationAttribute CConfigurationAttribute::Successor() const {
  CConfigurationAttribute next(m_entry, Checked().Next());
  if (next.m_attribute != nullptr) {
    MarkRead(*m_entry, *next.m_attribute);
  }
  return next;
}

CConfigurationAttribute* CConfigurationAttribute::Next(bool throwIfMissing) const {
  const CConfigurationAttribute next = Successor();
  if (next.m_attribute == nullptr) {
    if (throwIfMissing) {
      THROW_CONFIGURATION_ERROR(LocationText(*m_entry->File, m_entry->Line)
                                << ": no attribute follows \"" << Name() << "\"");
    }
    return nullptr;
  }
  return m_entry->Store->KeepAttribute(next);
}

bool CConfigurationAttribute::IsLenient() const {
  return m_entry->Store->HandleOf(m_entry->Element)->IsLenient();
}

void CConfigurationAttribute::WarnOfLooseText(const std::string& text,
                                              const std::string& expected) const {
  m_entry->Store->HandleOf(m_entry->Element)
      ->WarnOfLooseText("attribute \"" + Name() + '"', text.c_str(), expected);
}

void CConfigurationAttribute::ThrowUnparsable(const std::string& text, const std::string& expected,
                                              const std::string& reason, bool isLoose) const {
  m_entry->Store->HandleOf(m_entry->Element)
      ->ThrowUnparsable("attribute \"" + Name() + '"', text.c_str(), expected, reason, isLoose);
}

CConfigurationAttributeIterator CConfigurationAttributeIterator::begin(
    const CConfigurationNode* node) const {
  SConfigurationEntry& entry = node->Entry();
  entry.ReadAttributes |= 1;
  if (CRequestRecorder* const recorder = CRequestRecorder::Current()) {
    recorder->NoteOpen(entry);
  }
  return CConfigurationAttributeIterator(
      CConfigurationAttribute(&entry, entry.Element->FirstAttribute()));
}

CConfigurationAttributeIterator& CConfigurationAttributeIterator::operator++() {
  m_attribute = m_attribute.Successor();
  return *this;
}

}  // namespace argos
