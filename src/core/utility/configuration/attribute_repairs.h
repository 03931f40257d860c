#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_ATTRIBUTE_REPAIRS_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_ATTRIBUTE_REPAIRS_H

#include <argos3/core/utility/non_copyable.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

class CConfigurationStore;
struct SConfigurationEntry;

/**
 * Finds further errors of an element: during its lifetime, an attribute that a reader has refused
 * can be replaced by a value of its type, so that reading the element again gets to the next error.
 *
 * The destructor restores the attributes. At most one exists per thread.
 */
class CAttributeRepairs : private CNonCopyable {
 public:
  CAttributeRepairs();
  ~CAttributeRepairs();

  /**
   * Replaces the attribute that this thread has requested last, which may be missing.
   * @return false if there is none, if it is a text, or if it was replaced before.
   */
  bool RepairLast();

 private:
  friend class CConfigurationNode;

  struct SRequest {
    std::weak_ptr<CConfigurationStore> Store;
    SConfigurationEntry* Entry = nullptr;
    std::string Attribute;
    const char* Sample = nullptr;  // a valid text of the requested type; null for strings
  };
  struct SRepaired {
    SRequest Request;
    bool WasThere;
    std::string Text;
  };

  // notes that an element requests an attribute
  static void Note(SConfigurationEntry& entry, const std::string& attribute, const char* sample);

  SRequest m_last;
  std::vector<SRepaired> m_repaired;
};

}  // namespace argos

#endif
