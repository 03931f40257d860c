#include <argos3/plugins/simulator/entities/box_entity.h>

#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/simulator/entities/passive_body_manual.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

namespace argos {

CBoxEntity::CBoxEntity() = default;

CBoxEntity::CBoxEntity(const std::string& id, const CVector3& position,
                       const CQuaternion& orientation, bool movable, const CVector3& size,
                       Real mass)
    : CPassiveBodyEntity(id, position, orientation, movable, mass), m_size(size) {
  const std::string owner = "box \"" + id + "\"";
  RequireEachIn(kSolidLength, size, owner, "size");
  if (movable) {
    RequireIn(kMass, mass, owner, "mass");
  }
  Describe();
}

void CBoxEntity::Init(TConfigurationNode& tree) {
  GetNodeAttribute(tree, "size", m_size);
  RequireEachIn(kSolidLength, m_size, OwnerOf(tree), "attribute \"size\"");
  InitBody(tree);
  Describe();
}

void CBoxEntity::Resize(const CVector3& size) {
  CRobotsCode::CheckShared(*this, "Resize()");
  RequireEachIn(kSolidLength, size, "box \"" + GetId() + "\"", "size");
  KeepForReset(&m_size, [this, start = m_size] {
    ReturnBodyToStart();
    Resize(start);
  });
  m_size = size;
  Describe();
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CBoxEntity)

REGISTER_ENTITY(
    CBoxEntity, "box", "the authors of this project", "1.0", "A box, fixed or movable.",
    R"(A rectangular solid that stands on its base. Fixed boxes are walls and obstacles; movable ones
are pushed by robots and rub on the ground.

REQUIRED XML

  <arena size="10,10,2">
    <box id="wall" size="4,0.1,0.5" movable="false">
      <body position="0,2,0" orientation="0,0,0" />
    </box>
    <box id="crate" size="0.3,0.2,0.2" movable="true" mass="2.5">
      <body position="0.4,0.3,0" orientation="45,0,0" />
    </box>
  </arena>

ATTRIBUTES

  id                text, required: unique among the entities of the arena.
  size              "x,y,z", m, required, each from 1e-5 to 1e5: extents along the local axes.
)" + PassiveBodyManual("box", R"(<box id="beacon" size="0.3,0.3,0.2" movable="false">)",
                       "0.15,0,0.1"),
    "Usable")

}  // namespace argos
