#ifndef ARGOS3_PROGRAM_CATALOGUE_FACTS_JSON_H
#define ARGOS3_PROGRAM_CATALOGUE_FACTS_JSON_H

#include <argos3/program/catalogue/answer.h>

#include <string>
#include <vector>

namespace argos {

/**
 * The facts of what was found as JSON: {"query", "plugins": [...], "suggestions": [...]}. The guide
 * (doc/guide/devices.md) describes the fields. Lists contain all their plug-ins with all facts.
 */
std::string WriteJson(const std::string& query, const SAnswer& answer,
                      const std::vector<SPluginKind>& kinds);

}  // namespace argos

#endif
