#include <argos3/plugins/simulator/entities/cylinder_entity.h>

#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/simulator/entities/passive_body_manual.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

namespace argos {

CCylinderEntity::CCylinderEntity() = default;

CCylinderEntity::CCylinderEntity(const std::string& id, const CVector3& position,
                                 const CQuaternion& orientation, bool movable, Real radius,
                                 Real height, Real mass)
    : CPassiveBodyEntity(id, position, orientation, movable, mass) {
  const std::string owner = "cylinder \"" + id + "\"";
  m_radius = RequireIn(kSolidLength, radius, owner, "radius");
  m_height = RequireIn(kSolidLength, height, owner, "height");
  if (movable) {
    RequireIn(kMass, mass, owner, "mass");
  }
  Describe();
}

void CCylinderEntity::Init(TConfigurationNode& tree) {
  ReadIn(kSolidLength, tree, "radius", m_radius);
  ReadIn(kSolidLength, tree, "height", m_height);
  InitBody(tree);
  Describe();
}

void CCylinderEntity::Resize(Real radius, Real height) {
  CRobotsCode::CheckShared(*this, "Resize()");
  const std::string owner = "cylinder \"" + GetId() + "\"";
  RequireIn(kSolidLength, radius, owner, "radius");
  RequireIn(kSolidLength, height, owner, "height");
  KeepForReset(&m_radius, [this, startRadius = m_radius, startHeight = m_height] {
    ReturnBodyToStart();
    Resize(startRadius, startHeight);
  });
  m_radius = radius;
  m_height = height;
  Describe();
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CCylinderEntity)

REGISTER_ENTITY(
    CCylinderEntity, "cylinder", "the authors of this project", "1.0",
    "A cylinder, fixed or movable.",
    R"(An upright cylinder that stands on its base. Fixed cylinders are obstacles; movable ones are
pushed by robots and rub on the ground.

REQUIRED XML

  <arena size="10,10,2">
    <cylinder id="pillar" radius="0.2" height="0.5" movable="false">
      <body position="0,2,0" orientation="0,0,0" />
    </cylinder>
    <cylinder id="puck" radius="0.1" height="0.1" movable="true" mass="0.5">
      <body position="0.4,0.3,0" orientation="0,0,0" />
    </cylinder>
  </arena>

ATTRIBUTES

  id                text, required: unique among the entities of the arena.
  radius, height    m, required, from 1e-5 to 1e5; the axis is vertical.
)" + PassiveBodyManual("cylinder",
                       R"(<cylinder id="beacon" radius="0.1" height="0.2" movable="false">)",
                       "0,0,0.2"),
    "Usable")

}  // namespace argos
