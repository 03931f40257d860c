#ifndef ARGOS3_PROGRAM_CATALOGUE_CATALOGUE_H
#define ARGOS3_PROGRAM_CATALOGUE_CATALOGUE_H

#include <argos3/program/catalogue/grammar.h>

#include <optional>
#include <string>
#include <vector>

namespace argos {

/** An element of experiment files, or one of its attributes. */
struct SElementMatch {
  TElementPath Path;
  const SElement* Element;
  std::string Attribute; /**< empty: the element is meant */
};

/** What a question to the catalogue finds. */
struct SAnswer {
  std::vector<const SPluginKind*> Lists; /**< whole kinds */
  std::vector<SMatch> Matches; /**< plug-ins to describe */
  std::vector<SElementMatch> Elements; /**< have that tag, or that attribute */
  std::vector<std::string> Others; /**< tags of others that may be meant */
  std::vector<std::string> Suggestions; /**< are given if nothing else was found */

  bool IsFound() const { return !Lists.empty() || !Matches.empty() || !Elements.empty(); }
};

/** The registered plug-ins, with what they offer and read; made when a question needs it. */
class CCatalogue {
 public:
  CCatalogue() : m_kinds(ListPluginKinds()) {}

  /**
   * Finds what the word of a query stands for: "all" or a kind; else the plug-ins with this label,
   * tag or control interface; else those whose label contains it, and elements and attributes of
   * experiment files with this name; else similar names, also by the initials of the words of a
   * name: "rab" for "range_and_bearing".
   */
  SAnswer Find(const std::string& query);

  const std::vector<SPluginKind>& GetKinds() const { return m_kinds; }
  CDevices& GetDevices();
  /** The element <argos-configuration>. */
  const SElement& GetElements();
  /** The element of a plug-in; null if it has none. */
  const SElement* FindElement(const SMatch& match);

 private:
  bool IsMeant(const SMatch& match, const std::string& query) const;
  std::vector<std::string> Suggest(const std::string& query);

  std::vector<SPluginKind> m_kinds;
  std::optional<CDevices> m_devices;
  std::optional<SElement> m_elements;
};

}  // namespace argos

#endif
