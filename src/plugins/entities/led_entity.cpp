#include <argos3/plugins/simulator/entities/led_entity.h>

#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/datatypes/digest.h>

namespace argos {

CLEDEntity::CLEDEntity(CComposableEntity* parent) : CMediumMember(parent) {}

CLEDEntity::CLEDEntity(CComposableEntity* parent, const std::string& id, const CVector3& position,
                       const CColor& color)
    : CMediumMember(parent, id, position), m_color(color), m_initColor(color) {}

CLEDEntity::~CLEDEntity() {
  ClearMedium();
}

void CLEDEntity::Init(TConfigurationNode& tree) {
  CPositionalEntity::Init(tree);
  GetNodeAttribute(tree, "color", m_initColor);
  m_color = m_initColor;
}

void CLEDEntity::Reset() {
  CPositionalEntity::Reset();
  SetColor(m_initColor);
}

void CLEDEntity::UpdateDigest(CDigest& digest) const {
  CPositionalEntity::UpdateDigest(digest);
  digest.Add(m_color.GetRed());
  digest.Add(m_color.GetGreen());
  digest.Add(m_color.GetBlue());
  digest.Add(m_color.GetAlpha());
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CLEDEntity)

}  // namespace argos
