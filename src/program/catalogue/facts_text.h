#ifndef ARGOS3_PROGRAM_CATALOGUE_FACTS_TEXT_H
#define ARGOS3_PROGRAM_CATALOGUE_FACTS_TEXT_H

#include <argos3/program/catalogue/catalogue.h>

#include <string>

namespace argos {

/** What was found, in lines of 80 columns: lists, or all facts of each plug-in and element. */
std::string WriteText(const std::string& query, const SAnswer& answer, CCatalogue& catalogue);

}  // namespace argos

#endif
