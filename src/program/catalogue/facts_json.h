#ifndef ARGOS3_PROGRAM_CATALOGUE_FACTS_JSON_H
#define ARGOS3_PROGRAM_CATALOGUE_FACTS_JSON_H

#include <argos3/program/catalogue/catalogue.h>

#include <string>

namespace argos {

/**
 * The facts of what was found as JSON (RFC 8259), with a line for each value: {"query", "plugins":
 * [...], "elements": [...], "suggestions": [...]}. The guide (doc/guide/devices.md) describes the
 * fields. Lists contain all their plug-ins with all facts.
 */
std::string WriteJson(const std::string& query, const SAnswer& answer, CCatalogue& catalogue);

}  // namespace argos

#endif
