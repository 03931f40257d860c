#ifndef ARGOS3_TESTING_UNIT_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_SCENE_H
#define ARGOS3_TESTING_UNIT_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_SCENE_H

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd.h>
#include <argos3/plugins/simulator/physics_engines/planar/disc_pairs.h>

#include <array>
#include <deque>
#include <memory>
#include <string>

namespace argos {

/** Bodies of a planar world without an engine: robots of radius 5 cm, and boxes. */
class CPlanarScene {
 public:
  static constexpr Real kRadius = 0.05;  // m
  static constexpr Real kTick = 0.1;  // s

  /** A body with the handle that its world writes; addresses stay valid. */
  struct SBody {
    SPlanarHandle Handle;
    CEmbodiedEntity Entity;
    std::array<Real, 2> Wheels{};  // m/s, (left, right)

    explicit SBody(const std::string& id) : Entity(nullptr, id) {}
    SPlanarOwner GetOwner() { return {nullptr, &Entity, &Handle}; }
  };

  CPlanarScene() : Store(MakeSettings()) {}

  static SPlanarSettings MakeSettings() {
    SPlanarSettings settings;
    settings.Tick = kTick;
    settings.Substeps = 2;
    settings.SmallestRadius = kRadius;
    return settings;
  }

  static SBodyDescription DescribeRobot() {
    SBodyDescription description;
    description.Shapes.push_back(SShapeDescription::Cylinder(kRadius, 0.1));
    description.Mass = 0.5;
    description.Drive = SDifferentialDriveDescription{0.08, 0.02, 1.0, 1.0};
    description.Grippable = true;
    description.Gripper = SGripperDescription();
    return description;
  }

  static SPlanarPose PoseAt(Real x, Real y) {
    SPlanarPose pose;
    pose.X = x;
    pose.Y = y;
    return pose;
  }

  /** A robot that looks along x. */
  SBody& AddRobot(Real x, Real y, Real left = 0.0, Real right = 0.0,
                  const SBodyDescription& description = DescribeRobot()) {
    SBody& body = Bodies.emplace_back("robot");
    body.Wheels = {left, right};
    Store.AddDriven(body.GetOwner(), description, PoseAt(x, y),
                    CDriveSource(body.Wheels.data(), description.Drive->InterwheelDistance));
    return body;
  }

  /** A cube with an edge of 10 cm. */
  SBody& AddBox(Real x, Real y, bool movable) {
    SBodyDescription description;
    description.Shapes.push_back(SShapeDescription::Box(CVector3(0.1, 0.1, 0.1)));
    description.Mass = 0.5;
    description.GroundFriction = SGroundFrictionDescription();
    description.Grippable = movable;
    SBody& body = Bodies.emplace_back("box");
    if (movable) {
      Store.AddPassive(body.GetOwner(), description, PoseAt(x, y));
    } else {
      Store.AddImmovable(body.GetOwner(), description, PoseAt(x, y));
    }
    return body;
  }

  SDrivenBody& GetDriven(const SBody& body) { return Store.GetDriven()[body.Handle.Slot]; }
  SPassiveBody& GetPassive(const SBody& body) { return Store.GetPassive()[body.Handle.Slot]; }

  /** Finds the discs that can meet within @p reach, m, and starts a tick of the crowd. */
  void StartCrowd(Real reach) {
    Pairs.Start(Store.GetDriven().size());
    for (UInt32 slot = 0; slot < Store.GetDriven().size(); ++slot) {
      const SDrivenBody& body = Store.GetDriven()[slot];
      Pairs.Place(slot, body.Pose.X, body.Pose.Y, body.BoundingRadius);
    }
    Pairs.Find(Pool, reach);
    Crowd.Start(Pairs, reach);
  }

  /** Plans a tick of a robot that meets nothing. */
  static void Plan(SDrivenBody& body) {
    body.NextCommand = body.Drive.Read();
    const SArc arc = FollowArc(body.Pose, body.NextCommand, kTick);
    body.NextPose = arc.End;
    body.NextVelocity = {arc.DX / kTick, arc.DY / kTick, body.NextCommand.YawRate};
  }

  std::deque<SBody> Bodies;
  CThreadPool Pool{0, std::make_unique<CBalanceQuantitySchedule>()};
  CPlanarStore Store;
  CDiscPairs Pairs;
  CCrowd Crowd{Store};
};

}  // namespace argos

#endif
