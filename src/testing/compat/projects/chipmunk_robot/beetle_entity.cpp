#include "beetle_entity.h"

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/math/matrix/rotationmatrix3.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>

namespace argos {

CBeetleEntity::CBeetleEntity()
    : CComposableEntity(NULL),
      m_pcControllableEntity(NULL),
      m_pcEmbodiedEntity(NULL),
      m_pcWheeledEntity(NULL) {}

CBeetleEntity::CBeetleEntity(const std::string& str_id, const std::string& str_controller_id,
                             const CVector3& c_position, const CQuaternion& c_orientation)
    : CComposableEntity(NULL, str_id),
      m_pcControllableEntity(NULL),
      m_pcEmbodiedEntity(NULL),
      m_pcWheeledEntity(NULL) {
  try {
    m_pcEmbodiedEntity = new CEmbodiedEntity(this, "body_0", c_position, c_orientation);
    AddComponent(*m_pcEmbodiedEntity);
    AddWheels();
    m_pcControllableEntity = new CControllableEntity(this, "controller_0");
    AddComponent(*m_pcControllableEntity);
    m_pcControllableEntity->SetController(str_controller_id);
    UpdateComponents();
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED("Failed to initialize entity \"" << GetId() << "\".", ex);
  }
}

void CBeetleEntity::Init(TConfigurationNode& t_tree) {
  try {
    CComposableEntity::Init(t_tree);
    m_pcEmbodiedEntity = new CEmbodiedEntity(this);
    AddComponent(*m_pcEmbodiedEntity);
    m_pcEmbodiedEntity->Init(GetNode(t_tree, "body"));
    AddWheels();
    m_pcControllableEntity = new CControllableEntity(this);
    AddComponent(*m_pcControllableEntity);
    m_pcControllableEntity->Init(GetNode(t_tree, "controller"));
    UpdateComponents();
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED("Failed to initialize entity \"" << GetId() << "\".", ex);
  }
}

void CBeetleEntity::AddWheels() {
  m_pcWheeledEntity = new CWheeledEntity(this, "wheels_0", 2);
  AddComponent(*m_pcWheeledEntity);
  m_pcWheeledEntity->SetWheel(0, CVector3(0.0f, BEETLE_WHEEL_DISTANCE * 0.5f, 0.0f),
                              BEETLE_WHEEL_RADIUS);
  m_pcWheeledEntity->SetWheel(1, CVector3(0.0f, -BEETLE_WHEEL_DISTANCE * 0.5f, 0.0f),
                              BEETLE_WHEEL_RADIUS);
}

void CBeetleEntity::Reset() {
  CComposableEntity::Reset();
  UpdateComponents();
}

#define UPDATE(COMPONENT)     \
  if (COMPONENT->IsEnabled()) \
    COMPONENT->Update();

void CBeetleEntity::UpdateComponents() {
  UPDATE(m_pcEmbodiedEntity);
}

REGISTER_ENTITY(CBeetleEntity, "beetle", "A researcher", "1.0", "A small round robot.",
                "It has two wheels.", "Usable");

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CBeetleEntity);

}  // namespace argos
