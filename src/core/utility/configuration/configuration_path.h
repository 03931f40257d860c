#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_PATH_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_PATH_H

// private: element search of CConfigurationDocument::SetByPath()

#include <argos3/core/utility/errors/argos_exception.h>

#include <string>
#include <vector>

namespace tinyxml2 {
class XMLElement;
}

namespace argos {

/** A path to an attribute; CConfigurationDocument::SetByPath() describes the syntax. */
class CConfigurationPath {
 public:
  /** @throws CARGoSException if the path is malformed. */
  explicit CConfigurationPath(const std::string& path);

  const std::string& GetAttribute() const { return m_attribute; }

  /**
   * Returns the elements that match the path, in the order of the file.
   * @throws CARGoSException if there is no match, or several without "//" in the path.
   */
  std::vector<tinyxml2::XMLElement*> Find(tinyxml2::XMLElement& root) const;

 private:
  struct SPredicate {
    // [n]; 0 for a predicate on an attribute
    std::size_t Position = 0;
    std::string Attribute;
    std::string Value;
  };
  struct SStep {
    std::string Text;
    std::string Tag;
    bool AnyDepth = false;
    std::vector<SPredicate> Predicates;
  };
  typedef std::vector<tinyxml2::XMLElement*> TElements;

  void ParseStep(const std::string& text, bool anyDepth);
  SPredicate ParsePredicate(const std::string& text) const;
  TElements Walk(const TElements& start, std::size_t firstStep) const;
  [[noreturn]] void ThrowMalformed(const std::string& why) const;
  [[noreturn]] void ThrowNothingFound(const SStep& step, const TElements& parents) const;

  static TElements Filter(const TElements& siblings, const SStep& step);
  static void CollectMatches(tinyxml2::XMLElement& parent, const SStep& step, TElements& matches);

  std::string m_path;
  std::vector<SStep> m_steps;
  std::string m_attribute;
};

}  // namespace argos

#endif
