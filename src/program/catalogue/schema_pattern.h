#ifndef ARGOS3_PROGRAM_CATALOGUE_SCHEMA_PATTERN_H
#define ARGOS3_PROGRAM_CATALOGUE_SCHEMA_PATTERN_H

#include <map>
#include <string>
#include <vector>

namespace argos {

/** A pattern of RELAX NG, of the kinds that schemas of experiments need. */
struct SSchemaPattern {
  enum class EKind {
    Element, /**< Name, Parts; without a name any but those in Except */
    Attribute, /**< the same */
    Optional,
    ZeroOrMore,
    Choice,
    Group,
    Value, /**< Name is the text */
    Reference, /**< Name of a definition */
    Matching, /**< Name is a regular expression of XML Schema */
    Text,
    Empty
  };

  EKind Kind = EKind::Empty;
  std::string Name = "";
  std::string Text = ""; /**< documentation of an element or attribute */
  std::vector<SSchemaPattern> Parts = {};
  std::vector<std::string> Except = {};
};

/** Definitions by name; "start" is the root. */
struct SSchema {
  std::map<std::string, SSchemaPattern> Definitions;
};

/** In the XML syntax of RELAX NG. */
std::string WriteRelaxNg(const SSchema& schema);
/** In its compact syntax. */
std::string WriteRelaxNgCompact(const SSchema& schema);

}  // namespace argos

#endif
