#ifndef ARGOS3_CORE_UTILITY_PLUGINS_DEFERRED_LIBRARIES_H
#define ARGOS3_CORE_UTILITY_PLUGINS_DEFERRED_LIBRARIES_H

#include <set>
#include <string>
#include <typeinfo>
#include <vector>

namespace argos {

/**
 * The libraries that are opened when one of their labels is needed, by their indices
 * (label_index.h). The functions named Take... remove a library, which the caller then opens.
 *
 * Thread safe: uses the mutex of registrations and does not call the dynamic linker.
 */
class CDeferredLibraries {
 public:
  /**
   * Defers a library, unless it is deferred already.
   * @return false if the library must be opened now: it has no index, or another library has
   *   registered one of its labels.
   */
  static bool Add(const std::string& path);

  /** @return the library with this label, if there is one. */
  static std::vector<std::string> Take(const std::type_info& kind, const std::string& label);
  /** @return the libraries with labels of this kind, in the order of Add(). */
  static std::vector<std::string> TakeKind(const std::type_info& kind);
  /** @return the libraries with one of these labels, of any kind, in the order of Add(). */
  static std::vector<std::string> TakeLabels(const std::set<std::string>& labels);
  /** @return the library with this file name, if there is one. */
  static std::vector<std::string> TakeFile(const std::string& name);
  /** @return the first library; "" if there is none. */
  static std::string TakeFirst();
  static std::vector<std::string> TakeAll();
  /** @return the libraries with labels that another library has registered since Add(). */
  static std::vector<std::string> TakeContested();

  /** The labels of a kind. */
  static std::vector<std::string> ListLabels(const std::type_info& kind);
  /** Removes the labels of a kind, but no library. */
  static void Forget(const std::type_info& kind);
};

}  // namespace argos

#endif
