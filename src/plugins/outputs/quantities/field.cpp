#include <argos3/core/simulator/outputs/field.h>

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace argos {

std::string ToColumnName(const std::string& text) {
  std::string name = text;
  for (char& c : name) {
    const bool isGood = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    c = isGood ? c : '_';
  }
  return name;
}

double CRowTexts::Add(std::string_view text) {
  m_texts.append(text);
  m_ends.push_back(m_texts.size());
  return static_cast<double>(m_ends.size() - 1);
}

double CRowTexts::AddHexadecimal(const unsigned char* bytes, std::size_t count) {
  constexpr const char* kDigits = "0123456789abcdef";
  for (std::size_t i = 0; i < count; ++i) {
    m_texts += kDigits[bytes[i] >> 4];
    m_texts += kDigits[bytes[i] & 0xF];
  }
  return Add({});
}

std::string_view CRowTexts::Get(double number) const {
  if (std::isnan(number)) {
    return {};
  }
  const auto index = static_cast<std::size_t>(number);
  ARGOS_ASSERT(index < m_ends.size(), "there is no text number " << index);
  const std::size_t start = index == 0 ? 0 : m_ends[index - 1];
  return std::string_view(m_texts).substr(start, m_ends[index] - start);
}

void CRowTexts::Clear() {
  m_texts.clear();
  m_ends.clear();
}

void CField::ListNames(CEntity& root, const std::string& label,
                       std::vector<std::string>& names) const {
  if (Bind(root, "").Reader != nullptr) {
    names.push_back(label);
  }
}

void CField::Derive(double* /*numbers*/) const {}

SFieldName::SFieldName(const std::string& name)
    : Name(name), Label(name.substr(0, name.find(':'))) {
  const bool hasArgument = Label.size() < name.size();
  if (hasArgument) {
    Argument = name.substr(Label.size() + 1);
  }
  if (!CFactory<CField>::Exists(Label)) {
    THROW_ARGOSEXCEPTION("there is no field \""
                         << Label << '"' << DidYouMean(Label, CFactory<CField>::GetLabels()));
  }
  Field.reset(CFactory<CField>::New(Label));
  if (Field->NeedsArgument() && Argument.empty()) {
    THROW_ARGOSEXCEPTION("the field \"" << name << "\" needs to say of what: \"" << Label
                                        << ":NAME\"; argos3 -q " << Label << " describes it");
  }
  if (!Field->NeedsArgument() && hasArgument) {
    THROW_ARGOSEXCEPTION("the field \"" << Label << "\" has no \":\", found \"" << name << '"');
  }
}

SBoundField SFieldName::Bind(CEntity& root) const {
  const auto* const source = dynamic_cast<const CFieldSource*>(&root);
  if (source != nullptr && Field->GetNumRaw() == 0) {
    SBoundField bound = source->BindField(Name);
    if (bound.Reader != nullptr) {
      return bound;
    }
  }
  return Field->Bind(root, Argument);
}

std::vector<std::string> ListFieldNames(const std::vector<CEntity*>& roots) {
  std::vector<std::string> all;
  std::set<std::string> known;
  const auto add = [&](const std::vector<std::string>& names) {
    std::copy_if(names.begin(), names.end(), std::back_inserter(all),
                 [&known](const std::string& name) { return known.insert(name).second; });
  };
  for (const std::string& label : CFactory<CField>::GetLabels()) {
    const std::unique_ptr<CField> field(CFactory<CField>::New(label));
    for (CEntity* root : roots) {
      std::vector<std::string> names;
      field->ListNames(*root, label, names);
      add(names);
    }
  }
  for (const CEntity* root : roots) {
    if (const auto* const source = dynamic_cast<const CFieldSource*>(root)) {
      std::vector<std::string> names;
      source->ListFields(names);
      add(names);
    }
  }
  return all;
}

}  // namespace argos
