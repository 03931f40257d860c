#ifndef ARGOS3_PROGRAM_CATALOGUE_RECORDED_GRAMMAR_H
#define ARGOS3_PROGRAM_CATALOGUE_RECORDED_GRAMMAR_H

#include <argos3/core/utility/configuration/request_recorder.h>
#include <argos3/program/catalogue/device_facts.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace argos {

/** An attribute that a plug-in reads. */
struct SAttributeFacts {
  std::string Element; /**< from the plug-in's own element: "leds", "cameras/camera" */
  std::string Name;
  std::string Type; /**< "real", "integer", "boolean", "colour", "x,y,z", ... or "text" */
  bool IsRequired = false;
};

/**
 * What the parts of the program read of experiments, recorded while the samples of their manuals
 * are loaded. So there is no list of attributes that could differ from the code.
 */
class CRecordedGrammar {
 public:
  explicit CRecordedGrammar(CDeviceCatalogue& catalogue);

  /** Loads the samples of one plug-in, also without each of its attributes, if it is required. */
  void Record(const std::string& section, const std::string& key);
  /** Those of all plug-ins, and the samples of the core. */
  void RecordAll();

  /** The element <argos-configuration>. */
  const SRequestedElement& GetRoot();
  /** True if no sample of the plug-in could be loaded: what it reads is not known. */
  bool IsUnknown(const std::string& section, const std::string& key) const;
  /** @param path  of tags, from below the root: "arena/foot-bot". */
  bool IsRequired(const std::string& path, const std::string& attribute) const;

  /** All attributes of a plug-in that was recorded. */
  std::vector<SAttributeFacts> ListAttributes(const std::string& section, const std::string& key);

  CDeviceCatalogue& GetCatalogue() { return m_catalogue; }

 private:
  bool RecordSample(const SSampleExperiment& sample);
  void RecordElement(const SSampleElement& element);
  template <typename LOAD>
  void RecordWithout(const std::string& text, const LOAD& load);
  void RecordVariants(const SSampleElement& element);
  void RecordVariant(const SSampleElement& element, std::size_t index, const std::string& name,
                     const std::string& value);
  void RecordCore();
  SSampleExperiment MakeSample(const SSampleElement& element);
  void NoteAlways(const std::string& xml);
  void NoteAlwaysOf(TConfigurationNode& element, const std::string& path);
  void NoteMissed(const SRequestedElement& element, const std::string& path);
  void List(const SRequestedElement& element, const std::string& path, const std::string& shown,
            std::vector<SAttributeFacts>& facts) const;

  CDeviceCatalogue& m_catalogue;
  SRequestedElement m_requests;
  std::set<std::string> m_known;  // section and key of plug-ins of which a sample was loaded
  std::map<std::string, std::set<std::string>> m_always;  // attributes of all elements of a path
  std::map<std::string, std::set<std::string>> m_missed;  // whose absence is an error
};

/** @return "real", "integer", "boolean", "colour", "x,y", "x,y,z", "z,y,x", "min:max", "text". */
std::string TypeOf(const SRequestedAttribute& attribute);

/** The path below <argos-configuration> of the element of a plug-in. */
std::string PathOf(const std::string& section, const std::string& key);

}  // namespace argos

#endif
