#ifndef ARGOS3_PLUGINS_ENTITIES_OMNIDIRECTIONAL_CAMERA_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_OMNIDIRECTIONAL_CAMERA_EQUIPPED_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/**
 * A camera that views the ground all around its robot through a mirror above it.
 *
 * Starts disabled; a sensor that uses it enables it.
 */
class COmnidirectionalCameraEquippedEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  /** A camera at the origin, with an aperture of 70 degrees. */
  explicit COmnidirectionalCameraEquippedEntity(CComposableEntity* parent);
  /**
   * @param aperture  see SetAperture().
   * @param offset    see SetOffset().
   */
  COmnidirectionalCameraEquippedEntity(CComposableEntity* parent, const std::string& id,
                                       const CRadians& aperture, const CVector3& offset);

  std::string GetTypeDescription() const override { return "omnidirectional_camera"; }

  const CVector3& GetOffset() const { return m_offset; }
  /** @param offset  of the camera from the origin of the body, m; turns with the body's yaw. */
  void SetOffset(const CVector3& offset) {
    KeepForReset(m_offset);
    m_offset = offset;
  }
  const CRadians& GetAperture() const { return m_aperture; }
  /**
   * @param aperture  half angle of the view from the downward vertical, in (0, PI/2).
   * @throws CARGoSException if the angle is out of range.
   */
  void SetAperture(const CRadians& aperture);

 private:
  CVector3 m_offset;  // m
  CRadians m_aperture;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/math/quaternion.h>
#endif

#endif
