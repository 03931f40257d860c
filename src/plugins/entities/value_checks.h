#ifndef ARGOS3_PLUGINS_ENTITIES_VALUE_CHECKS_H
#define ARGOS3_PLUGINS_ENTITIES_VALUE_CHECKS_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/configuration/value_range.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/vector3.h>

#include <cmath>
#include <string>

namespace argos {

/*
 * Range checks of user-supplied values of entities and devices, for the sources of plug-ins.
 *
 * owner: owner of the value, for the message: 'box "b1"'.
 * what:  name of the value, with its unit: "height (m)".
 */

/** @throws CARGoSException unless @p value is > 0 and in kPositive. */
inline Real RequirePositive(Real value, const std::string& owner, const std::string& what) {
  if (!(value > 0.0)) {
    THROW_ARGOSEXCEPTION(owner << ": " << what << " must be a number > 0, got " << value);
  }
  return RequireIn(kPositive, value, owner, what);
}

/** @throws CARGoSException unless @p value is >= 0 and in kNotNegative. */
inline Real RequireNotNegative(Real value, const std::string& owner, const std::string& what) {
  if (!(value >= 0.0)) {
    THROW_ARGOSEXCEPTION(owner << ": " << what << " must be a number >= 0, got " << value);
  }
  return RequireIn(kNotNegative, value, owner, what);
}

/** @throws CARGoSException unless each component of @p vector is in the range. */
inline void RequireEachIn(const SValueRange& range, const CVector3& vector,
                          const std::string& owner, const std::string& what) {
  for (UInt32 axis = 0; axis < 3; ++axis) {
    RequireIn(range, vector[axis], owner, what + ", component " + "xyz"[axis]);
  }
}

/** @throws CARGoSException unless @p value is in [least,most]. */
inline void RequireCount(UInt64 value, UInt64 least, UInt64 most, const std::string& owner,
                         const std::string& what) {
  if (value < least || value > most) {
    THROW_ARGOSEXCEPTION(owner << ": " << what << " must be an integer from " << least << " to "
                               << most << ", got " << value);
  }
}

/** @throws CARGoSException unless the half angle @p aperture is in (0, PI/2). */
inline CRadians RequireAperture(const CRadians& aperture, const std::string& owner,
                                const std::string& what) {
  const Real degrees = ToDegrees(aperture).GetValue();
  if (!(degrees > 0.0 && degrees < 90.0)) {
    THROW_ARGOSEXCEPTION(owner << ": " << what << " must be between 0 and 90 degrees, got "
                               << degrees);
  }
  return aperture;
}

/** 'file:line: <tag>', the owner of an attribute of that element. */
inline std::string OwnerOf(const TConfigurationNode& node) {
  return node.GetLocation() + ": <" + node.Value() + ">";
}

/** Reads a required attribute. @throws CARGoSException if it is missing or not in the range. */
inline void ReadIn(const SValueRange& range, TConfigurationNode& node, const std::string& attribute,
                   Real& value) {
  GetNodeAttribute(node, attribute, value);
  RequireIn(range, value, OwnerOf(node), "attribute \"" + attribute + '"');
}

/** Reads a required attribute. @throws CARGoSException if it is missing or not > 0. */
inline void ReadPositive(TConfigurationNode& node, const std::string& attribute,
                         const std::string& unit, Real& value) {
  GetNodeAttribute(node, attribute, value);
  RequirePositive(value, OwnerOf(node), "attribute \"" + attribute + "\" (" + unit + ")");
}

/**
 * Reads an optional attribute; keeps @p value if it is missing. @throws CARGoSException if not > 0.
 */
inline void ReadOptionalPositive(TConfigurationNode& node, const std::string& attribute,
                                 const std::string& unit, Real& value) {
  if (NodeAttributeExists(node, attribute)) {
    ReadPositive(node, attribute, unit, value);
  }
}

}  // namespace argos

#endif
