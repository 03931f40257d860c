#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_grips.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/cylinder_contacts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_model.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// contacts of a sensing disc with one solid
constexpr int kMaxContacts = 4;
constexpr Real kRounding = 1e-9;  // share of a force

CEmbodiedEntity& EntityOf(const SRigidBody& body) {
  return body.Source.Owner->GetEmbodiedEntity();
}

const std::optional<STurretDescription>& TurretOf(const SRigidBody& body) {
  return body.Source.Description->Turret;
}

bool HasTurret(const SRigidBody& body) {
  return body.Turret != nullptr && TurretOf(body).has_value();
}

bool IsNear(const SRigidBody& body, const CVector3& centre, Real radius) {
  for (UInt32 axis = 0; axis < 3; ++axis) {
    if (centre[axis] + radius < body.Low[axis] || centre[axis] - radius > body.High[axis]) {
      return false;
    }
  }
  return true;
}

}  // namespace

CRigidGrips::CRigidGrips(dWorldID world) : m_world(world), m_probe(dCreateSphere(nullptr, 1.0)) {}

CRigidGrips::~CRigidGrips() {
  // the robots may have been destroyed before
  for (const auto& each : m_manipulators) {
    if (each->Held != nullptr) {
      Detach(*each);
    }
  }
  dGeomDestroy(m_probe);
}

CRigidGrips::SManipulator* CRigidGrips::Find(const SRigidBody& body) const {
  const auto found = std::find_if(m_manipulators.begin(), m_manipulators.end(),
                                  [&body](const auto& each) { return each->Robot == &body; });
  return found != m_manipulators.end() ? found->get() : nullptr;
}

void CRigidGrips::SetManipulator(SRigidBody& body) {
  const bool isOne = body.Gripper != nullptr || body.Turret != nullptr;
  if (!body.HasManipulator && isOne) {
    m_manipulators.push_back(std::make_unique<SManipulator>());
    m_manipulators.back()->Robot = &body;
  } else if (body.HasManipulator) {
    SManipulator* const manipulator = Find(body);
    ARGOS_ASSERT(manipulator != nullptr, "a robot has a manipulator that is not tracked");
    // the held body was attached to another arm
    Release(*manipulator);
    if (!isOne) {
      std::erase_if(m_manipulators, [&body](const auto& each) { return each->Robot == &body; });
    }
  }
  body.HasManipulator = isOne;
}

void CRigidGrips::ReleaseAllOf(const SRigidBody& body) {
  for (const auto& each : m_manipulators) {
    if (each->Held != nullptr && (each->Robot == &body || each->Held == &body)) {
      Release(*each);
    }
  }
}

void CRigidGrips::Detach(SManipulator& manipulator) {
  SRigidBody& robot = *manipulator.Robot;
  dJointDestroy(manipulator.Hold);
  if (manipulator.Pivot != nullptr) {
    dJointDestroy(manipulator.Pivot);
    dBodyDestroy(robot.TurretBody);
    robot.TurretBody = nullptr;
    dBodySetMass(robot.Body, &manipulator.Mass);
  }
  manipulator.Hold = manipulator.Pivot = nullptr;
}

void CRigidGrips::Release(SManipulator& manipulator) {
  if (manipulator.Held == nullptr) {
    return;
  }
  SRigidBody& robot = *manipulator.Robot;
  Detach(manipulator);
  WakeRigidBody(robot);
  WakeRigidBody(*manipulator.Held);
  manipulator.Held = nullptr;
  if (robot.Gripper != nullptr) {
    robot.Gripper->ClearGrippedEntity();
  }
}

void CRigidGrips::StartTick(const std::vector<SRigidBody*>& movables, Real tick) {
  for (const auto& each : m_manipulators) {
    SRigidBody& robot = *each->Robot;
    each->Rate = robot.Turret != nullptr ? robot.Turret->AdvanceControl(tick) : 0.0;
    if (each->Held != nullptr) {
      // other code may have changed what the gripper holds
      const bool stillHolds = robot.Gripper->IsLocked() && robot.Gripper->IsGripping() &&
                              &robot.Gripper->GetGrippedEntity() == &EntityOf(*each->Held);
      if (!stillHolds) {
        Release(*each);
      }
    }
    if (each->Held == nullptr && robot.Gripper != nullptr && robot.Gripper->IsLocked() &&
        robot.Source.Description->Gripper) {
      Seek(*each, movables);
    }
    if (each->Pivot != nullptr) {
      const bool driven = robot.Turret->IsDriven();
      dJointSetHingeParam(each->Pivot, dParamVel, each->Rate);
      dJointSetHingeParam(each->Pivot, dParamFMax,
                          driven ? TurretOf(robot)->MaxTorque : TurretOf(robot)->FreeTorque);
      if (driven) {
        WakeRigidBody(robot);
      }
    }
  }
}

CQuaternion CRigidGrips::GetArmOrientation(const SManipulator& manipulator,
                                           const SRigidPose& pose) {
  const CTurretEntity* const turret = manipulator.Robot->Turret;
  return turret != nullptr ? pose.Orientation * CQuaternion(turret->GetRotation(), CVector3::Z)
                           : pose.Orientation;
}

// Grips the body that reaches deepest into the sensing disc; among equals, that of the entity with
// the lowest index.
void CRigidGrips::Seek(SManipulator& manipulator, const std::vector<SRigidBody*>& movables) {
  SRigidBody& robot = *manipulator.Robot;
  const SRigidPose pose = GetRigidPose(robot);
  const CQuaternion arm = GetArmOrientation(manipulator, pose);
  const CVector3 centre = pose.Position + Rotated(robot.Gripper->GetOffset(), arm);
  const Real radius = robot.Source.Description->Gripper->SensorRadius;
  dGeomSphereSetRadius(m_probe, radius);
  dGeomSetPosition(m_probe, centre.GetX(), centre.GetY(), centre.GetZ());

  SRigidBody* best = nullptr;
  Real depth = 0.0;
  CVector3 point;
  for (SRigidBody* body : movables) {
    if (body == &robot || !body->Source.Description->Grippable || !IsNear(*body, centre, radius)) {
      continue;
    }
    for (const dGeomID solid : body->Solids) {
      dContactGeom contacts[kMaxContacts];
      const int count = FindContacts(m_probe, solid, kMaxContacts, contacts, sizeof(dContactGeom));
      for (int i = 0; i < count; ++i) {
        const bool isBetter =
            best == nullptr || contacts[i].depth > depth ||
            (contacts[i].depth == depth && EntityOf(*body).GetIndex() < EntityOf(*best).GetIndex());
        if (isBetter) {
          best = body;
          depth = contacts[i].depth;
          point = FromODE(contacts[i].pos);
        }
      }
    }
  }
  if (best != nullptr) {
    Grip(robot, *best, Rotated(point - pose.Position, arm.Inverse()));
  }
}

void CRigidGrips::Grip(SRigidBody& holder, SRigidBody& held, const CVector3& arm) {
  SManipulator* const manipulator = Find(holder);
  if (manipulator == nullptr || manipulator->Held != nullptr || holder.Gripper == nullptr) {
    return;
  }
  WakeRigidBody(holder);
  WakeRigidBody(held);
  manipulator->Held = &held;
  manipulator->Arm = arm;
  if (HasTurret(holder)) {
    MakeTurret(*manipulator);
  }
  const SRigidPose pose = GetRigidPose(holder);
  const CVector3 end = pose.Position + Rotated(arm, GetArmOrientation(*manipulator, pose));
  manipulator->Force = CVector3();
  manipulator->Torque = 0.0;
  manipulator->Hold = dJointCreateBall(m_world, nullptr);
  dJointAttach(manipulator->Hold, holder.TurretBody != nullptr ? holder.TurretBody : holder.Body,
               held.Body);
  dJointSetBallAnchor(manipulator->Hold, end.GetX(), end.GetY(), end.GetZ());
  dJointSetFeedback(manipulator->Hold, &manipulator->Pull);
  holder.Gripper->SetGrippedEntity(EntityOf(held));
}

void CRigidGrips::MakeTurret(SManipulator& manipulator) {
  SRigidBody& robot = *manipulator.Robot;
  const STurretDescription& turret = *TurretOf(robot);
  manipulator.RotationAtGrip = robot.Turret->GetRotation().GetValue();
  dBodyGetMass(robot.Body, &manipulator.Mass);
  // the turret takes its own mass from the robot, but at most half of it
  const Real mass = std::min<Real>(turret.Mass, 0.5 * manipulator.Mass.mass);
  dMass rest = manipulator.Mass;
  rest.mass -= mass;
  dBodySetMass(robot.Body, &rest);

  dMass own;
  dMassSetSphereTotal(&own, mass, 1.0);
  own.I[0] = own.I[5] = own.I[10] = turret.PlanarInertia;
  robot.TurretBody = dBodyCreate(m_world);
  dBodySetMass(robot.TurretBody, &own);
  dBodySetGyroscopicMode(robot.TurretBody, 0);
  const dReal* const position = dBodyGetPosition(robot.Body);
  const dReal* const velocity = dBodyGetLinearVel(robot.Body);
  const dReal* const turn = dBodyGetAngularVel(robot.Body);
  dBodySetPosition(robot.TurretBody, position[0], position[1], position[2]);
  dBodySetQuaternion(robot.TurretBody, dBodyGetQuaternion(robot.Body));
  dBodySetLinearVel(robot.TurretBody, velocity[0], velocity[1], velocity[2]);
  dBodySetAngularVel(robot.TurretBody, turn[0], turn[1], turn[2]);

  const CVector3 up = Rotated(CVector3::Z, QuaternionFromODE(dBodyGetQuaternion(robot.Body)));
  manipulator.Pivot = dJointCreateHinge(m_world, nullptr);
  dJointAttach(manipulator.Pivot, robot.TurretBody, robot.Body);
  dJointSetHingeAnchor(manipulator.Pivot, position[0], position[1], position[2]);
  dJointSetHingeAxis(manipulator.Pivot, up.GetX(), up.GetY(), up.GetZ());
}

void CRigidGrips::EndTick(Real tick) {
  for (const auto& each : m_manipulators) {
    SRigidBody& robot = *each->Robot;
    if (each->Pivot != nullptr) {
      robot.Turret->SetRotation(CRadians(each->RotationAtGrip + dJointGetHingeAngle(each->Pivot)));
    } else if (robot.Turret != nullptr && each->Rate != 0.0) {
      robot.Turret->SetRotation(robot.Turret->GetRotation() + CRadians(each->Rate * tick));
    }
  }
}

void CRigidGrips::BreakOverloadedGrips() {
  for (const auto& each : m_manipulators) {
    if (each->Held != nullptr &&
        FromODE(each->Pull.f1).Length() >=
            (1.0 - kRounding) * each->Robot->Source.Description->Gripper->MaxForce) {
      Release(*each);
    }
  }
}

void CRigidGrips::FindCluster(CEmbodiedEntity& body, std::vector<CEmbodiedEntity*>& cluster) const {
  cluster.assign(1, &body);
  const auto contains = [&cluster](const CEmbodiedEntity& each) {
    return std::find(cluster.begin(), cluster.end(), &each) != cluster.end();
  };
  bool grows = true;
  while (grows) {
    grows = false;
    ForEachGrip([&](const SRigidBody& holder, const SRigidBody& held) {
      CEmbodiedEntity& first = EntityOf(holder);
      CEmbodiedEntity& second = EntityOf(held);
      if (contains(first) != contains(second)) {
        cluster.push_back(contains(first) ? &second : &first);
        grows = true;
      }
    });
  }
}

void CRigidGrips::CopyGrips(const std::vector<CEmbodiedEntity*>& cluster,
                            std::vector<SGripTransfer>& grips) const {
  grips.clear();
  for (const auto& each : m_manipulators) {
    if (each->Held == nullptr) {
      continue;
    }
    CEmbodiedEntity& holder = EntityOf(*each->Robot);
    if (std::find(cluster.begin(), cluster.end(), &holder) != cluster.end()) {
      // the joint is at the end of the arm, and the turret keeps its rotation
      grips.push_back({&holder, &EntityOf(*each->Held), each->Arm, CVector3(), 0.0});
    }
  }
}

}  // namespace argos
