#include <argos3/plugins/simulator/entities/omnidirectional_camera_equipped_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

namespace argos {

namespace {

constexpr Real kOmnidirectionalAperture = 70.0;  // degrees, as in ARGoS 3

}  // namespace

COmnidirectionalCameraEquippedEntity::COmnidirectionalCameraEquippedEntity(
    CComposableEntity* parent)
    : COmnidirectionalCameraEquippedEntity(
          parent, std::string(), ToRadians(CDegrees(kOmnidirectionalAperture)), CVector3()) {}

COmnidirectionalCameraEquippedEntity::COmnidirectionalCameraEquippedEntity(
    CComposableEntity* parent, const std::string& id, const CRadians& aperture,
    const CVector3& offset)
    : CEntity(parent, id), m_offset(offset) {
  SetAperture(aperture);
  CEntity::SetEnabled(false);
}

void COmnidirectionalCameraEquippedEntity::SetAperture(const CRadians& aperture) {
  CRobotsCode::CheckOwn(*this, "SetAperture()");
  RequireAperture(aperture, "camera \"" + GetContext() + GetId() + "\"", "aperture");
  KeepForReset(m_aperture);
  m_aperture = aperture;
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(COmnidirectionalCameraEquippedEntity)

}  // namespace argos
