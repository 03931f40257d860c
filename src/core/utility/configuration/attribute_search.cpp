// Replaces a function of the XML library, which calls it for each attribute that it parses, to find
// names that are given twice. Its own version compares the name with all those before, so that an
// element with 200,000 attributes takes minutes. Where this library is not loaded before the XML
// library, that one uses its own version, and results are the same.

#include <argos3/core/utility/configuration/attribute_search.h>

#include <tinyxml2.h>

#include <cstddef>
#include <cstring>
#include <string_view>
#include <unordered_map>

namespace argos {

namespace {

// most elements have so few that they are compared one by one
constexpr int kFewAttributes = 32;

thread_local CAttributeSearch* currentSearch = nullptr;

}  // namespace

// the names of the attributes of one element, to which more are appended
struct CAttributeSearch::SNames {
  const tinyxml2::XMLElement* Element = nullptr;
  const tinyxml2::XMLAttribute* Last = nullptr;
  std::unordered_map<std::string_view, const tinyxml2::XMLAttribute*> ByName;
};

CAttributeSearch::CAttributeSearch()
    : m_previous(currentSearch), m_names(std::make_unique<SNames>()) {
  currentSearch = this;
}

CAttributeSearch::~CAttributeSearch() {
  currentSearch = m_previous;
}

const tinyxml2::XMLAttribute* CAttributeSearch::Find(const tinyxml2::XMLElement& element,
                                                     const char* name) {
  int number = 0;
  for (const auto* attribute = element.FirstAttribute(); attribute != nullptr;
       attribute = attribute->Next()) {
    if (std::strcmp(attribute->Name(), name) == 0) {
      return attribute;
    }
    if (++number == kFewAttributes && currentSearch != nullptr) {
      return currentSearch->FindInNames(element, name);
    }
  }
  return nullptr;
}

const tinyxml2::XMLAttribute* CAttributeSearch::FindInNames(const tinyxml2::XMLElement& element,
                                                            const char* name) {
  SNames& names = *m_names;
  if (names.Element != &element) {
    names = {&element, nullptr, {}};
  }
  const tinyxml2::XMLAttribute* next =
      names.Last == nullptr ? element.FirstAttribute() : names.Last->Next();
  for (; next != nullptr; next = next->Next()) {
    names.ByName.emplace(next->Name(), next);
    names.Last = next;
  }
  const auto found = names.ByName.find(name);
  return found != names.ByName.end() ? found->second : nullptr;
}

}  // namespace argos

// weak: a statically linked XML library keeps its own version
__attribute__((weak)) const tinyxml2::XMLAttribute* tinyxml2::XMLElement::FindAttribute(
    const char* name) const {
  return argos::CAttributeSearch::Find(*this, name);
}
