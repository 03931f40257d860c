#include <argos3/plugins/simulator/physics_engines/dynamics3d/articulated_body.h>

#include <argos3/core/simulator/geometry/articulation.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/entities/joint_equipped_entity.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

using EJoint = SJointDescription::EKind;
using EMode = CJointEquippedEntity::EMode;

// share of the distance to the target that a motor covers in a substep
constexpr Real kApproach = 0.2;

const std::vector<SJointDescription>& JointsOf(const SRigidBody& body) {
  return body.Source.Description->Articulation->Joints;
}

dBodyID PartOf(const SRigidBody& body, UInt32 link) {
  return link == 0 ? body.Body : body.Links[link - 1].Part;
}

void SetParameter(dJointID joint, EJoint kind, int parameter, Real value) {
  if (kind == EJoint::Hinge) {
    dJointSetHingeParam(joint, parameter, value);
  } else if (kind == EJoint::Slider) {
    dJointSetSliderParam(joint, parameter, value);
  }
}

dJointID MakeJoint(const SRigidBody& body, const SJointDescription& description,
                   const SRigidPose& pose, dWorldID world) {
  const CVector3 pivot = pose.Position + Rotated(description.Pivot, pose.Orientation);
  const CVector3 axis = Rotated(description.Axis, pose.Orientation);
  const dBodyID child = PartOf(body, description.Child);
  const dBodyID parent = PartOf(body, description.Parent);
  dJointID joint = nullptr;
  switch (description.Kind) {
    case EJoint::Hinge:
      joint = dJointCreateHinge(world, nullptr);
      dJointAttach(joint, child, parent);
      dJointSetHingeAnchor(joint, pivot.GetX(), pivot.GetY(), pivot.GetZ());
      dJointSetHingeAxis(joint, axis.GetX(), axis.GetY(), axis.GetZ());
      break;
    case EJoint::Slider:
      joint = dJointCreateSlider(world, nullptr);
      dJointAttach(joint, child, parent);
      dJointSetSliderAxis(joint, axis.GetX(), axis.GetY(), axis.GetZ());
      break;
    case EJoint::Ball:
      joint = dJointCreateBall(world, nullptr);
      dJointAttach(joint, child, parent);
      dJointSetBallAnchor(joint, pivot.GetX(), pivot.GetY(), pivot.GetZ());
      break;
  }
  if (description.Limits) {
    SetParameter(joint, description.Kind, dParamLoStop, description.Limits->GetMin());
    SetParameter(joint, description.Kind, dParamHiStop, description.Limits->GetMax());
  }
  return joint;
}

bool Collide(const SArticulation& articulation, UInt32 first, UInt32 second) {
  return first != second &&
         std::none_of(articulation.Joints.begin(), articulation.Joints.end(),
                      [=](const SJointDescription& joint) {
                        return !joint.LinksCollide &&
                               std::minmax(joint.Parent, joint.Child) == std::minmax(first, second);
                      });
}

}  // namespace

void MountLinks(SRigidBody& body, const SRigidPose& pose, dWorldID world) {
  for (size_t i = 0; i < body.Links.size(); ++i) {
    body.Links[i].Joint = MakeJoint(body, JointsOf(body)[i], pose, world);
  }
}

void ListSelfPairs(SRigidBody& body) {
  const std::vector<SShapeDescription>& shapes = body.Source.Description->Shapes;
  const SArticulation& articulation = *body.Source.Description->Articulation;
  for (UInt32 i = 0; i < shapes.size(); ++i) {
    for (UInt32 j = i + 1; j < shapes.size(); ++j) {
      if (Collide(articulation, shapes[i].Link, shapes[j].Link)) {
        body.SelfPairs.emplace_back(i, j);
      }
    }
  }
}

void StartJointTick(SRigidBody& body, Real substep) {
  CJointEquippedEntity& joints = *body.Source.Joints;
  const bool hasChanged = joints.TakeChange();
  if (!hasChanged && body.AreMotorsSet) {
    return;
  }
  body.AreMotorsSet = true;
  WakeRigidBody(body);
  for (size_t i = 0; i < body.Links.size(); ++i) {
    const CJointEquippedEntity::SCommand& command = joints.GetJoint(i).Command;
    const Real force = command.Mode == EMode::Disabled ? 0.0 : command.MaxImpulse / substep;
    SetParameter(body.Links[i].Joint, JointsOf(body)[i].Kind, dParamFMax, force);
  }
}

void DriveJoints(const SRigidBody& body, Real substep) {
  for (size_t i = 0; i < body.Links.size(); ++i) {
    const CJointEquippedEntity::SJoint& joint = body.Source.Joints->GetJoint(i);
    Real speed = joint.Command.Target;
    if (joint.Command.Mode == EMode::Position) {
      speed = kApproach * (joint.Command.Target - joint.Position) / substep;
    }
    SetParameter(body.Links[i].Joint, JointsOf(body)[i].Kind, dParamVel, speed);
  }
}

void ReadJoints(SRigidBody& body) {
  CJointEquippedEntity& joints = *body.Source.Joints;
  for (size_t i = 0; i < body.Links.size(); ++i) {
    const dJointID joint = body.Links[i].Joint;
    switch (JointsOf(body)[i].Kind) {
      case EJoint::Hinge: {
        // ODE's angle is in (-pi, pi]
        const Real before = joints.GetJoint(i).Position;
        const Real change = std::remainder(dJointGetHingeAngle(joint) - before, 2.0 * ARGOS_PI);
        joints.SetState(i, before + change, dJointGetHingeAngleRate(joint));
        break;
      }
      case EJoint::Slider:
        joints.SetState(i, dJointGetSliderPosition(joint), dJointGetSliderPositionRate(joint));
        break;
      case EJoint::Ball:
        break;
    }
  }
}

SBodyPose GetLinkFrame(const SRigidBody& body, UInt32 link) {
  const SRigidLink& moved = body.Links[link - 1];
  const CQuaternion orientation = QuaternionFromODE(dBodyGetQuaternion(moved.Part));
  return {FromODE(dBodyGetPosition(moved.Part)) - Rotated(moved.CentreOfMass, orientation),
          orientation};
}

std::string FindFlawOfJoints(const SBodyDescription& description) {
  for (const SShapeDescription& shape : description.Shapes) {
    if (shape.Link >= description.Articulation->GetNumLinks() || !(shape.Mass > 0.0) ||
        !std::isfinite(shape.Mass)) {
      return "each solid of an articulated body needs the number of a link, and a mass > 0 (kg)";
    }
  }
  for (const SJointDescription& joint : description.Articulation->Joints) {
    if (joint.Kind == EJoint::Hinge && joint.Limits &&
        std::max(-joint.Limits->GetMin(), joint.Limits->GetMax()) > ARGOS_PI) {
      return "the limits of joint \"" + joint.Id + "\" must be within -180 and 180 degrees";
    }
  }
  return "";
}

}  // namespace argos
