#ifndef ARGOS3_PROGRAM_CATALOGUE_SAMPLE_ELEMENTS_H
#define ARGOS3_PROGRAM_CATALOGUE_SAMPLE_ELEMENTS_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/program/catalogue/plugin_kinds.h>
#include <argos3/program/catalogue/sample_experiment.h>

#include <map>
#include <string>
#include <vector>

namespace argos {

/** "leds (default)" of `<leds implementation="default" />`; the tag of an element without it. */
std::string KeyOf(const TConfigurationNode& element);

/** An element for a section of an experiment, from an example in a manual. */
struct SSampleElement {
  std::string Section; /**< "arena", "media", "sensors", "overlays", ... */
  std::string Key; /**< its tag; of devices the label: "leds (default)" */
  std::string Text;
};

/** The elements of all examples in the manuals of the plug-ins. */
class CSampleElements {
 public:
  explicit CSampleElements(const std::vector<SPluginKind>& kinds);

  /** At least one of each plug-in: a plug-in without example has an element without attributes. */
  const std::vector<SSampleElement>& GetAll() const { return m_elements; }
  std::vector<std::string> Of(const std::string& section, const std::string& key) const;

  /** One medium for each id that an example uses. */
  const std::string& GetMedia() const { return m_media; }
  /** Elements inside robots that examples of other plug-ins have, by tag: <magnets>. */
  const std::map<std::string, std::string>& GetParts() const { return m_parts; }

  /** An experiment that contains the element, with the media of the examples. */
  SSampleExperiment MakeSample(const SSampleElement& element) const;

  /** The section of elements of a kind: "arena" of "entities"; "" if there is none. */
  static std::string SectionOf(const SPluginKind& kind);

 private:
  void NoteLabels(const std::vector<SPluginKind>& kinds);
  void AddExamples(const SPluginKind& kind);
  void AddExample(const std::string& ownSection, TConfigurationNode& root);
  void AddChildren(const std::string& section, TConfigurationNode& parent);
  void AddDevices(TConfigurationNode& controllers);
  void Add(const std::string& section, TConfigurationNode& element);
  void AddParts(TConfigurationNode& robot);
  void AddMissing(const SPluginKind& kind);

  std::vector<SSampleElement> m_elements;
  std::map<std::string, std::string> m_sections;  // by label, of all but devices
  std::map<std::string, std::string> m_parts;
  std::map<std::string, bool> m_mediaIds;
  std::string m_media;
  std::string m_viewWithOverlays;
};

}  // namespace argos

#endif
