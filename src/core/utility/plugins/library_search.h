#ifndef ARGOS3_CORE_UTILITY_PLUGINS_LIBRARY_SEARCH_H
#define ARGOS3_CORE_UTILITY_PLUGINS_LIBRARY_SEARCH_H

#include <filesystem>
#include <string>
#include <vector>

/* Where libraries are searched, and what is there. CDynamicLoading describes the order. */

namespace argos {

/** The path without links, or as it is if it leads nowhere. */
std::filesystem::path ResolvePath(const std::filesystem::path& path);

/** Those of ARGOS_PLUGIN_PATH. */
std::vector<std::string> ListUserDirectories();

/**
 * In the order of the search: the folder of the running core, which is lib/argos3 of its
 * installation or that of all libraries in a build tree; then that of the configured prefix.
 */
std::vector<std::string> ListDefaultDirectories();

/**
 * The libraries in all plug-in folders, each file name once, in the order of loading: this
 * project's before users' libraries, which need symbols of those that they are often not linked
 * with; before all of them those that replace one of this project. Warns of a folder that cannot be
 * read.
 */
std::vector<std::filesystem::path> ListAllLibraries();

/** The paths that a library may have, without suffixes, in the order of the search. */
std::vector<std::string> ListPlaces(const std::string& lib, const std::string& experimentFile);

/** What may follow the name of a library. */
std::vector<std::string> ListSuffixes(const std::string& lib);

/** "[.so]", for messages. */
std::string DescribeSuffixes(const std::string& lib);

/** Names of libraries in these places that are similar, for messages; "" if there are none. */
std::string DescribeSimilar(const std::string& lib, const std::vector<std::string>& places);

/** A file of a searched library, in the working directory or near the experiment. */
struct SNearFile {
  std::string Place;  // has no suffixes
  std::filesystem::path File;
};

/**
 * Libraries of several build trees: in the working directory and beside the experiment. The working
 * directory is nearest: a user who has several trees works in the one that is meant.
 */
std::vector<SNearFile> FindNearFiles(const std::string& lib, const std::string& experimentFile);

/** If there are several near files, puts the place of the nearest before those of the others. */
void PutNearestFirst(std::vector<std::string>& places, const std::vector<SNearFile>& near);

/** Warns of near files that are not loaded, for example because they are of another build tree. */
void WarnOfOthers(const std::string& lib, const std::string& place,
                  const std::vector<SNearFile>& near);

}  // namespace argos

#endif
