#ifndef ARGOS3_CORE_UTILITY_PLUGINS_LABEL_INDEX_H
#define ARGOS3_CORE_UTILITY_PLUGINS_LABEL_INDEX_H

#include <compare>
#include <optional>
#include <string>
#include <vector>

namespace argos {

/** A label of a factory. */
struct SPluginLabel {
  std::string Kind; /**< typeid(BASE).name() of the factory's base class */
  std::string Label;

  // NOLINTNEXTLINE(modernize-use-nullptr): it takes what the compiler writes for a 0
  auto operator<=>(const SPluginLabel& other) const = default;
};

/*
 * The index of a library: the labels that it registers, in a file beside it. The build writes it
 * for each library of plug-ins of this project, so that the library is opened only when one of its
 * labels is needed. It has the build id of the library, and does not count for any other file that
 * has replaced that.
 */

/** @return the path of the index of a library: "libx.labels" beside "libx.so". */
std::string GetIndexPath(const std::string& library);

/** @return the labels; nothing if the library has no index, or one that belongs to another file. */
std::optional<std::vector<SPluginLabel>> ReadLabelIndex(const std::string& library);

/**
 * Writes the index of a library.
 * @throws CARGoSException if the library has no build id, or the file cannot be written.
 */
void WriteLabelIndex(const std::string& library, const std::vector<SPluginLabel>& labels);

}  // namespace argos

#endif
