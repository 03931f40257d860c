#include <argos3/plugins/simulator/entities/directional_led_entity.h>

#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/plugins/simulator/entities/observable.h>

namespace argos {

CDirectionalLEDEntity::CDirectionalLEDEntity(CComposableEntity* parent) : CMediumMember(parent) {}

CDirectionalLEDEntity::CDirectionalLEDEntity(CComposableEntity* parent, const std::string& id,
                                             const CVector3& position,
                                             const CQuaternion& orientation,
                                             const CRadians& observableAngle, const CColor& color)
    : CMediumMember(parent, id, position, orientation), m_color(color), m_initColor(color) {
  SetObservableAngle(observableAngle);
}

CDirectionalLEDEntity::~CDirectionalLEDEntity() {
  ClearMedium();
}

void CDirectionalLEDEntity::Init(TConfigurationNode& tree) {
  CMediumMember::Init(tree);
  m_cone = CObservableCone(ReadObservableAngle(tree));
  GetNodeAttributeOrDefault(tree, "color", m_initColor, CColor());
  m_color = m_initColor;
}

void CDirectionalLEDEntity::Reset() {
  CMediumMember::Reset();
  m_color = m_initColor;
}

void CDirectionalLEDEntity::SetObservableAngle(const CRadians& angle) {
  CRobotsCode::CheckShared(*this, "SetObservableAngle()");
  RequireObservableAngle(angle, "directional LED \"" + GetContext() + GetId() + "\"");
  KeepForReset(m_cone);
  m_cone = CObservableCone(angle);
}

void CDirectionalLEDEntity::UpdateDigest(CDigest& digest) const {
  CMediumMember::UpdateDigest(digest);
  digest.Add(m_color.GetRed());
  digest.Add(m_color.GetGreen());
  digest.Add(m_color.GetBlue());
  digest.Add(m_color.GetAlpha());
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CDirectionalLEDEntity)

}  // namespace argos
