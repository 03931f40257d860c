#ifndef ARGOS3_PROGRAM_CATALOGUE_GRAMMAR_H
#define ARGOS3_PROGRAM_CATALOGUE_GRAMMAR_H

#include <argos3/program/catalogue/devices.h>
#include <argos3/program/catalogue/elements.h>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace argos {

/** The path of the element of a plug-in. @param section  empty: it is one. */
TElementPath PathOf(const std::string& section, const SElementName& name);

/** "framework/experiment"; of devices "sensors/leds (default)". */
std::string DescribePath(const TElementPath& path);

/**
 * What the parts of the program read of experiments, recorded while the samples of their manuals
 * are loaded. So there is no list of attributes that could differ from the code.
 */
class CGrammar {
 public:
  explicit CGrammar(CDevices& devices) : m_devices(devices) {}

  /** Loads the samples of one plug-in, also without each of its attributes, if it is required. */
  void Record(const std::string& section, const SElementName& name);
  /** Those of all plug-ins and sections. */
  void RecordAll();

  /**
   * The element <argos-configuration>, with the texts of manuals. What is distributed is in the
   * arena.
   */
  SElement MakeRoot();
  /** True if no sample of the plug-in could be loaded: what it reads is not known. */
  bool IsUnknown(const std::string& section, const SElementName& name) const;

  CDevices& GetDevices() { return m_devices; }

 private:
  struct SRequirements {
    std::optional<std::set<std::string>> Always; /**< attributes of all such elements of samples */
    std::set<std::string> Missed; /**< whose absence is an error */
  };
  using TUse = std::function<void(const SRequestedElement&)>;

  // path of the element of a sample
  TElementPath PlaceOf(const SSample& sample) const;
  EValueType TypeOf(const TElementPath& path, const std::string& name) const;
  std::string Load(SSampleExperiment& experiment, const TUse& use);
  std::string RecordSample(const SSample& sample, const TUse& use = nullptr);
  void RecordWithout(const SSample& sample);
  void RecordVariants(const SSample& sample);
  std::optional<std::set<std::string>> ListValues(const SSample& sample, std::size_t index,
                                                  const std::string& name, EValueType type);
  void RecordVariant(const SSample& sample, std::size_t index, const std::string& name,
                     const std::string& value);
  void NoteAlways(TConfigurationNode& element, const TElementPath& path);
  void NoteMissed(const SRequestedElement& element, const TElementPath& path);
  void MergeEntities(SElement& root);
  void MarkRequired(SElement& element, const TElementPath& path) const;

  CDevices& m_devices;
  SElement m_root;
  std::set<TElementPath> m_known;  // plug-ins of which a sample was loaded
  std::map<TElementPath, SRequirements> m_requirements;
  // attributes of elements that were loaded with all values
  std::set<std::pair<TElementPath, std::string>> m_varied;
};

}  // namespace argos

#endif
