#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_ATTRIBUTE_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_ATTRIBUTE_H

#include <argos3/core/utility/configuration/configuration_parsing.h>

#include <string>

namespace tinyxml2 {
class XMLAttribute;
}

namespace argos {

class CConfigurationNode;
class CConfigurationStore;
struct SConfigurationEntry;

/**
 * Handle of an attribute of an element, valid as long as the document. Obtained from the element.
 */
class CConfigurationAttribute {
 public:
  CConfigurationAttribute() = default;

  std::string Name() const;
  std::string Value() const;
  template <typename T>
  void GetName(T* name) const {
    Convert(Name(), *name);
  }
  /** @throws CARGoSException if the text is not a T. */
  template <typename T>
  void GetValue(T* value) const {
    Convert(Value(), *value);
  }
  template <typename T>
  void SetValue(const T& value) {
    SetText(detail::FormatText(value));
  }

  /**
   * Returns the next attribute in the file; owned by the document.
   * @return null if this is the last and throwIfMissing is false.
   * @throws CARGoSException if this is the last and throwIfMissing is true.
   */
  CConfigurationAttribute* Next(bool throwIfMissing = true) const;

 private:
  friend class CConfigurationNode;
  friend class CConfigurationAttributeIterator;

  CConfigurationAttribute(SConfigurationEntry* entry, const tinyxml2::XMLAttribute* attribute);

  template <typename T>
  void Convert(const std::string& text, T& value) const {
    std::string reason;
    if (!detail::ParseText(text.c_str(), value, reason)) {
      const std::string expected = detail::ExpectedText(static_cast<const T*>(nullptr));
      const bool isLoose = detail::ParseLoosely(text.c_str(), value);
      if (!IsLenient() || !isLoose) {
        ThrowUnparsable(text, expected, reason, isLoose);
      }
      WarnOfLooseText(text, expected);
    }
  }
  bool IsLenient() const;
  void WarnOfLooseText(const std::string& text, const std::string& expected) const;
  [[noreturn]] void ThrowUnparsable(const std::string& text, const std::string& expected,
                                    const std::string& reason, bool isLoose) const;
  const tinyxml2::XMLAttribute& Checked() const;
  CConfigurationAttribute Successor() const;
  void SetText(const std::string& text);

  SConfigurationEntry* m_entry = nullptr;
  const tinyxml2::XMLAttribute* m_attribute = nullptr;
};

}  // namespace argos

#endif
