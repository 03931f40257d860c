#ifndef ARGOS3_PROGRAM_CATALOGUE_SAMPLES_H
#define ARGOS3_PROGRAM_CATALOGUE_SAMPLES_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/configuration/element_name.h>
#include <argos3/core/utility/non_copyable.h>
#include <argos3/program/catalogue/plugin_kinds.h>
#include <argos3/support/scratch_folder.h>

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace argos {

class CSimulator;

/** An element of experiment files, as XML. */
struct SSample {
  std::string Section; /**< "arena", "sensors", "overlays", ...; empty: it is a whole section */
  SElementName Name;
  std::string Text;

  bool operator==(const SSample&) const = default;
};

/** A small experiment: whole sections by tag, as XML; those that are needed have defaults. */
struct SSampleExperiment {
  std::map<std::string, std::string> Sections;
  std::string Devices; /**< contents of each controller: <actuators> and <sensors> */

  /** An arena in which sensors of the ground see a floor. @param robots  as XML. */
  void SetRobots(const std::string& robots);
  /** Each robot has a controller in Lua with the devices, whatever its "config" is. */
  std::string ToXml() const;
};

/** The values of all attributes of that name. @param xml  as SSample::Text. */
std::set<std::string> ValuesIn(const std::string& xml, const std::string& attribute);

/** "<tag>contents</tag>" */
std::string WithTag(const std::string& tag, const std::string& contents);

/** The elements of all examples in the manuals of the plug-ins. */
class CSamples {
 public:
  explicit CSamples(const std::vector<SPluginKind>& kinds);

  /** At least one of each plug-in: a plug-in without example has an element without attributes. */
  const std::vector<SSample>& GetAll() const { return m_samples; }
  std::vector<SSample> Of(const std::string& section, const SElementName& name) const;
  /** Elements inside robots that examples of other plug-ins have, by tag: <magnets>. */
  const std::map<std::string, std::string>& GetParts() const { return m_parts; }

  /** An experiment that contains the element, with one medium for each id of the examples. */
  SSampleExperiment MakeExperiment(const SSample& sample) const;

 private:
  void AddExample(const SPluginKind& kind, TConfigurationNode& root);
  void AddChildren(const std::string& section, TConfigurationNode& parent);
  void Add(const std::string& section, TConfigurationNode& element);
  void AddMissing(const SPluginKind& kind, const SPluginText& plugin);

  std::vector<SSample> m_samples;
  std::map<std::string, std::string> m_sections;  // indexed by label of a plug-in
  std::map<std::string, std::string> m_parts;
  std::set<std::string> m_mediaIds;
  std::string m_media;
  std::string m_viewWithOverlays;
};

/**
 * Loads sample experiments in a temporary folder, which is the working directory until the loader
 * is destroyed, without messages. So files that parts write disappear.
 */
class CSampleLoader : private CNonCopyable {
 public:
  CSampleLoader();
  ~CSampleLoader();

  /**
   * Loads an experiment, calls @p use, and destroys it.
   * @param sample  without engines, the first engine that accepts what is in its arena is used; it
   *   is then in the sample.
   * @return the error; "" if there was none.
   */
  std::string Load(SSampleExperiment& sample,
                   const std::function<void(CSimulator&)>& use = nullptr);

 private:
  CScratchFolder m_folder;
  std::filesystem::path m_previous;  // working directory
  std::vector<std::string> m_engines;  // sections; the one that was used last is the first
};

}  // namespace argos

#endif
