#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_ATTRIBUTE_SEARCH_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_ATTRIBUTE_SEARCH_H

#include <argos3/core/utility/non_copyable.h>

#include <memory>

namespace tinyxml2 {
class XMLAttribute;
class XMLElement;
}  // namespace tinyxml2

namespace argos {

/**
 * While it exists, the XML library finds attributes of the calling thread's documents in constant
 * time. Attributes may only be appended meanwhile, as parsing does.
 */
class CAttributeSearch : private CNonCopyable {
 public:
  CAttributeSearch();
  ~CAttributeSearch();

  /** For the XML library. @return null if the element has no attribute of that name. */
  static const tinyxml2::XMLAttribute* Find(const tinyxml2::XMLElement& element, const char* name);

 private:
  struct SNames;

  const tinyxml2::XMLAttribute* FindInNames(const tinyxml2::XMLElement& element, const char* name);

  CAttributeSearch* m_previous;
  std::unique_ptr<SNames> m_names;
};

}  // namespace argos

#endif
