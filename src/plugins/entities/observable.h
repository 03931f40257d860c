#ifndef ARGOS3_PLUGINS_ENTITIES_OBSERVABLE_H
#define ARGOS3_PLUGINS_ENTITIES_OBSERVABLE_H

#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/angles.h>

#include <string>

namespace argos {

/*
 * Visibility from one side only, for the sources of entities.
 */

/** @throws CARGoSException unless @p angle is in (0, PI]. @param owner for the message. */
CRadians RequireObservableAngle(const CRadians& angle, const std::string& owner);
/**
 * Reads the required attribute `observable_angle`, degrees. @throws CARGoSException if it is
 * invalid.
 */
CRadians ReadObservableAngle(TConfigurationNode& tree);
/** @return true if the direction to a point (m, world frame) is within that angle of the z axis. */
bool IsObservableFrom(const CPositionalEntity& entity, const CRadians& angle,
                      const CVector3& point);

}  // namespace argos

#endif
