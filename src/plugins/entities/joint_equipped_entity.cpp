#include <argos3/plugins/simulator/entities/joint_equipped_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <cmath>
#include <utility>

namespace argos {

CJointEquippedEntity::CJointEquippedEntity(CComposableEntity* parent, const std::string& id,
                                           std::shared_ptr<const SArticulation> articulation)
    : CEntity(parent, id),
      m_articulation(std::move(articulation)),
      m_joints(m_articulation->Joints.size()) {
  CEntity::SetEnabled(false);  // engines move the joints; there is nothing to update
}

void CJointEquippedEntity::Reset() {
  for (SJoint& joint : m_joints) {
    joint = SJoint();
  }
  m_hasChanged = true;
}

void CJointEquippedEntity::CheckIndex(size_t index) const {
  if (index >= m_joints.size()) {
    THROW_ARGOSEXCEPTION("\"" << GetContext() << GetId() << "\": no joint " << index
                              << "; there are " << m_joints.size() << ", numbered from 0");
  }
}

const CJointEquippedEntity::SJoint& CJointEquippedEntity::GetJoint(size_t index) const {
  CheckIndex(index);
  return m_joints[index];
}

const SJointDescription& CJointEquippedEntity::GetDescription(size_t index) const {
  CheckIndex(index);
  return m_articulation->Joints[index];
}

size_t CJointEquippedEntity::FindJoint(const std::string& id) const {
  std::vector<std::string> known;
  for (size_t i = 0; i < m_joints.size(); ++i) {
    const SJointDescription& joint = m_articulation->Joints[i];
    const bool isBall = joint.Kind == SJointDescription::EKind::Ball;
    if (joint.Id == id) {
      if (isBall) {
        THROW_ARGOSEXCEPTION("joint \"" << id << "\" of \"" << GetParent().GetId()
                                        << "\" is spherical: it has no motor and no encoder");
      }
      return i;
    }
    if (!isBall) {
      known.push_back(joint.Id);
    }
  }
  THROW_ARGOSEXCEPTION("\"" << GetParent().GetId() << "\" has no revolute or prismatic joint \""
                            << id << "\"" << DidYouMean(id, known));
}

void CJointEquippedEntity::SetCommand(size_t index, const SCommand& command) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, "SetCommand()");
  }
  CheckIndex(index);
  if (!std::isfinite(command.Target) || !(command.MaxImpulse >= 0.0)) {
    THROW_ARGOSEXCEPTION("joint \"" << m_articulation->Joints[index].Id << "\" of \""
                                    << GetParent().GetId() << "\": the target " << command.Target
                                    << " must be finite, and the greatest impulse "
                                    << command.MaxImpulse << " must be >= 0");
  }
  m_hasChanged = m_hasChanged || command != m_joints[index].Command;
  m_joints[index].Command = command;
}

void CJointEquippedEntity::SetState(size_t index, Real position, Real velocity) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, "SetState()");
  }
  CheckIndex(index);
  m_joints[index].Position = position;
  m_joints[index].Velocity = velocity;
}

bool CJointEquippedEntity::TakeChange() {
  return std::exchange(m_hasChanged, false);
}

void CJointEquippedEntity::UpdateDigest(CDigest& digest) const {
  CEntity::UpdateDigest(digest);
  for (const SJoint& joint : m_joints) {
    digest.Add(static_cast<SInt64>(joint.Command.Mode));
    digest.Add(joint.Command.Target);
    digest.Add(joint.Position);
    digest.Add(joint.Velocity);
  }
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CJointEquippedEntity)

}  // namespace argos
