#ifndef ARGOS3_PROGRAM_CATALOGUE_ELEMENTS_H
#define ARGOS3_PROGRAM_CATALOGUE_ELEMENTS_H

#include <argos3/core/utility/configuration/request_recorder.h>

#include <map>
#include <string>
#include <vector>

namespace argos {

/** Names from below the root: framework, experiment. */
using TElementPath = std::vector<SElementName>;

/** The path of an element inside another one. */
TElementPath operator/(TElementPath path, const SElementName& name);

/** How the text of an attribute is read. */
enum class EValueType : UInt8 {
  Unknown, /**< it was only looked for */
  Text,
  AnyNumber, /**< it was absent: real or whole is not known */
  RealNumber,
  WholeNumber,
  NaturalNumber,
  Boolean,
  Colour,
  XY,
  XYZ,
  ZYX,
  Range
};

/** "real", "x,y,z", ... */
const char* NameOf(EValueType type);

/** What a manual says of an attribute. */
struct SAttributeText {
  std::string Unit; /**< "m"; empty: none is stated */
  std::string Default; /**< empty: none is stated */
  std::string Text; /**< all of it */
};

/** An attribute of an element of experiment files. */
struct SAttribute {
  EValueType Type = EValueType::Unknown;
  bool IsRequired = false;
  SAttributeText Manual;
};

/**
 * An element of experiment files: what code reads of it. Readings are merged: what one file
 * contains, another one may contain, too.
 */
struct SElement {
  std::map<std::string, SAttribute> Attributes;
  std::map<SElementName, SElement> Children;
  bool IsVisited = false; /**< there was such an element; otherwise it was only looked for */
  bool HasText = false;
  bool IsOpen = false; /**< any attributes and elements are read */

  SElement() = default;
  /** @param request  what was read of it. */
  explicit SElement(const SRequestedElement& request);

  /** Null if there is none. */
  SElement* Find(const SElementName& name);
  const SElement* Find(const SElementName& name) const;
  /** The element at a path from here; null if there is none. */
  const SElement* FindAt(const TElementPath& path) const;
  /** The path of a child of such a section, at any depth; empty if there is none. */
  TElementPath FindIn(const std::string& section, const SElementName& name) const;
  /** Adds what is read of another one; required are the attributes of this one. */
  void Merge(const SElement& other);
};

}  // namespace argos

#endif
