#ifndef ARGOS3_CAMPAIGN_DESIGN_ELEMENT_READING_H
#define ARGOS3_CAMPAIGN_DESIGN_ELEMENT_READING_H

// private: how the elements of a campaign file are read

#include <argos3/core/simulator/context/load_errors.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace argos {

/** Throws a CARGoSException: "file:line: <tag>: " and the message. */
[[noreturn]] void ThrowAt(const TConfigurationNode& node, const std::string& message);

/**
 * Reads one element. An exception is recorded, and the element is then marked as read, so that its
 * other attributes are not reported as unused.
 */
void ReadElement(CLoadErrors& errors, TConfigurationNode& node,
                 const std::function<void(TConfigurationNode&)>& read);

/** Readers of children, by tag. */
typedef std::map<std::string, std::function<void(TConfigurationNode&)>> TChildReaders;

/**
 * Reads the children of an element, in the order of the file; one with another tag is an error.
 * @param single  tags that may be there only once.
 */
void ReadChildren(CLoadErrors& errors, TConfigurationNode& node, const TChildReaders& readers,
                  const std::vector<std::string>& single = {});

/** @throws CARGoSException if the attribute is missing or empty. */
std::string ReadText(TConfigurationNode& node, const std::string& attribute);
/** Empty if the attribute is missing. @throws CARGoSException if it is there and empty. */
std::string ReadOptionalText(TConfigurationNode& node, const std::string& attribute);

/** Reads a name: letters, digits and '_', beginning with a letter. */
std::string ReadName(TConfigurationNode& node, const std::string& attribute);

/** @return the index of the attribute's value in @p choices; 0 if it is missing. */
size_t ReadChoice(TConfigurationNode& node, const std::string& attribute,
                  const std::vector<std::string>& choices);

/** A word in the file, and what it stands for. */
template <typename TValue>
struct SChoice {
  std::string Word;
  TValue Value;
};

/** @return what the attribute's value stands for; @p dflt if it is missing. */
template <typename TValue>
TValue ReadChoice(TConfigurationNode& node, const std::string& attribute,
                  const std::vector<SChoice<TValue>>& choices, TValue dflt) {
  if (!NodeAttributeExists(node, attribute)) {
    return dflt;
  }
  std::vector<std::string> words;
  for (const SChoice<TValue>& choice : choices) {
    words.push_back(choice.Word);
  }
  return choices[ReadChoice(node, attribute, words)].Value;
}

/** Reads a whole number of at least @p min. */
UInt32 ReadCount(TConfigurationNode& node, const std::string& attribute, UInt32 min, UInt32 dflt);

/** Reads a size such as "2 GiB", "500 MB" or "1048576" (bytes). */
UInt64 ReadSize(TConfigurationNode& node, const std::string& attribute, UInt64 dflt);

/** The text of an exception without "[FATAL] ", to be put into another one. */
std::string WithoutMark(const CARGoSException& error);

/** Without blanks at both ends. */
std::string TrimBlanks(const std::string& text);

}  // namespace argos

#endif
