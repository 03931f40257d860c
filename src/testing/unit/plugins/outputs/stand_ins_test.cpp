// What stands for the entities of a recording in a replay.

#include <argos3/plugins/simulator/outputs/recording/stand_ins.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <memory>
#include <tuple>
#include <vector>

namespace stand_ins_test {

using namespace argos;

TEST_CASE("stand-ins: a body has the recorded poses, colours, and a box that moves with it",
          "[recording]") {
  // whose simulator the entities use
  const CRobotWorld world{SRobotExperiment()};
  SRecordedType type;
  type.Kind = SRecordedType::EKind::Body;
  type.Tag = "foot-bot";
  type.IsRobot = type.IsMovable = true;
  type.NumLEDs = 2;
  type.Box.MinCorner = CVector3(-0.1, -0.2, -0.3);
  type.Box.MaxCorner = CVector3(0.4, 0.5, 0.6);
  type.Anchors = {"turret"};
  CStandInEntity entity("fb", std::make_shared<const SRecordedType>(type));
  REQUIRE(entity.GetRobot() != nullptr);
  REQUIRE(entity.GetLEDs() != nullptr);
  CHECK(entity.GetTypeDescription() == "foot-bot");
  CHECK(entity.GetAppearance() == nullptr);
  CHECK(entity.GetBody().IsMovable());
  const CQuaternion turned(CRadians(0.5), CVector3::Z);
  const std::vector<SBodyPose> poses = {{CVector3(1.0, 2.0, 3.0), turned},
                                        {CVector3(1.0, 2.0, 3.5), turned * turned}};
  const std::vector<UInt32> words = {0, 0xff0000ff, 0xff00ff00};
  entity.SetState({poses, words});
  const CEmbodiedEntity& body = entity.GetBody();
  CHECK(body.GetOriginAnchor().Position == poses[0].Position);
  CHECK(body.GetOriginAnchor().Orientation == poses[0].Orientation);
  const SAnchor& turret = entity.GetBody().GetAnchor("turret");
  CHECK(turret.Position == poses[1].Position);
  CHECK(turret.Orientation == poses[1].Orientation);
  CHECK(Distance(body.GetBoundingBox().MinCorner, CVector3(0.9, 1.8, 2.7)) < 1e-15);
  CHECK(Distance(body.GetBoundingBox().MaxCorner, CVector3(1.4, 2.5, 3.6)) < 1e-15);
  CHECK(entity.GetLEDs()->GetLED(0).GetColor() != entity.GetLEDs()->GetLED(1).GetColor());
  for (const auto& [word, isQuarantined, isStopped] :
       {std::tuple(0, false, false), std::tuple<int, bool, bool>(ENTITY_IS_QUARANTINED, true, true),
        std::tuple<int, bool, bool>(ENTITY_IS_STOPPED, false, true)}) {
    CAPTURE(word);
    const std::vector<UInt32> states = {static_cast<UInt32>(word), 0, 0};
    entity.SetState({poses, states});
    CHECK(entity.GetRobot()->IsQuarantined() == isQuarantined);
    CHECK(entity.GetRobot()->IsStopped() == isStopped);
  }
}

}  // namespace stand_ins_test
