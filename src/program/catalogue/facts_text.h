#ifndef ARGOS3_PROGRAM_CATALOGUE_FACTS_TEXT_H
#define ARGOS3_PROGRAM_CATALOGUE_FACTS_TEXT_H

#include <argos3/program/catalogue/answer.h>

#include <string>
#include <vector>

namespace argos {

class CDeviceCatalogue;

/** A heading, and two lines for each plug-in. */
std::string DescribeList(const SPluginKind& kind);

/**
 * All facts of a plug-in, in lines of 80 columns.
 * @param kinds  all: those whose plug-ins belong to this one are listed below it.
 */
std::string DescribePlugin(const SMatch& match, const std::vector<SPluginKind>& kinds,
                           CDeviceCatalogue& catalogue);

/** The sentence about a word that stands for nothing. */
std::string DescribeNothing(const std::string& query, const SAnswer& answer);

}  // namespace argos

#endif
