#ifndef ARGOS3_CORE_UTILITY_PLUGINS_REGISTERED_LABELS_H
#define ARGOS3_CORE_UTILITY_PLUGINS_REGISTERED_LABELS_H

#include <argos3/core/utility/non_copyable.h>
#include <argos3/core/utility/plugins/label_index.h>

#include <map>
#include <string>
#include <vector>

namespace argos {

/**
 * The labels that were registered, each with the library that did so last. The caller holds the
 * mutex of registrations.
 */
const std::map<SPluginLabel, std::string>& GetRegisteredLabels();

/** @return the labels that a library, given by its file name, has registered. */
std::vector<SPluginLabel> ListLabelsOf(const std::string& libraryName);

/**
 * What this thread registers during the lifetime of this object counts as registered before
 * everything else: libraries that are opened when they are needed register later than users'
 * libraries, whose registrations are to replace theirs.
 */
class CLateRegistrations : private CNonCopyable {
 public:
  CLateRegistrations();
  ~CLateRegistrations();

 private:
  bool m_wasLate;
};

}  // namespace argos

#endif
