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

/** A cone around the z axis of an entity, from whose inside it is visible. */
class CObservableCone {
 public:
  /** All directions. */
  CObservableCone() = default;
  /** @param angle  from the axis, see RequireObservableAngle(). */
  explicit CObservableCone(const CRadians& angle);

  const CRadians& GetAngle() const { return m_angle; }
  /** @return true if a point, m, world frame, is in the cone of @p entity. */
  bool Contains(const CPositionalEntity& entity, const CVector3& point) const;

 private:
  CRadians m_angle = CRadians::PI;
  Real m_cosine = -1.0;  // of the angle
};

}  // namespace argos

#endif
