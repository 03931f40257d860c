#ifndef ARGOS3_PROGRAM_CATALOGUE_ANSWER_H
#define ARGOS3_PROGRAM_CATALOGUE_ANSWER_H

#include <argos3/program/catalogue/plugin_kinds.h>

#include <string>
#include <vector>

namespace argos {

/** A plug-in, and the kind to which it belongs. */
struct SMatch {
  const SPluginKind* Kind;
  const SPluginText* Plugin;
};

/** What a question to the catalogue of plug-ins finds. */
struct SAnswer {
  std::vector<const SPluginKind*> Lists; /**< whole kinds */
  std::vector<SMatch> Matches; /**< plug-ins to describe */
  std::vector<std::string> Others; /**< tags of others that may be meant */
  std::vector<std::string> Suggestions; /**< if nothing else was found */

  bool IsFound() const { return !Lists.empty() || !Matches.empty(); }
};

/**
 * Finds what the word of a query stands for: "all" or a kind; else the plug-ins with this label,
 * tag or control interface; else those whose label contains it; else similar ones, also by the
 * initials of the words of a name: "rab" for "range_and_bearing".
 * @param kinds  must exist as long as the answer.
 */
SAnswer FindAnswer(const std::string& query, const std::vector<SPluginKind>& kinds);

/** "leds" of "leds (default)"; other labels as they are. */
std::string TagOf(const std::string& label);

/** Texts that plug-ins leave out, such as "undefined" of REGISTER_CONTROLLER. */
bool IsUnsaid(const std::string& text);

/** @return true for the author of the plug-ins that come with the program. */
bool IsOwnAuthor(const std::string& author);

/** How CMake links a library of the program: "ARGoS::genericrobot"; "" for others. */
std::string LinkTargetOf(const std::string& library);

}  // namespace argos

#endif
