#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>
#include <argos3/testing/unit/plugins/entities/component_checks.h>

#include <catch2/catch.hpp>

#include <limits>
#include <memory>

namespace rab_equipped_entity_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

// a body with a device, without a space; the robot owns both
struct SEquippedBody {
  CComposableEntity Robot{nullptr, "robot"};
  CEmbodiedEntity* Body;
  SAnchor* Mast;
  CRABEquippedEntity* Device = nullptr;

  SEquippedBody() {
    auto body = std::make_unique<CEmbodiedEntity>(&Robot, "body_0", CVector3(1.0, 2.0, 0.0),
                                                  CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z));
    Body = body.get();
    Mast = &Body->AddAnchor("mast", CVector3(0.0, 0.0, 0.5));
    Robot.AddComponent(*body.release());
  }
  void AddDevice(SAnchor& anchor) {
    auto device = std::make_unique<CRABEquippedEntity>(
        &Robot, "rab_0", 3, 2.5, anchor, *Body, CVector3(0.1, 0.0, 0.2),
        CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z));
    Device = device.get();
    Robot.AddComponent(*device.release());
  }
};

// counts devices that are added and removed
class CToyRegistry final : public CRABEquippedEntity::CRegistry {
 public:
  CRABMedium& AsMedium() override { throw CARGoSException("a registry for tests"); }
  int NumDevices = 0;

 private:
  void Insert(CRABEquippedEntity&) override { ++NumDevices; }
  void Erase(CRABEquippedEntity&) override { --NumDevices; }
};

}  // namespace

TEST_CASE("rab entity: stores a message of its size", "[entities]") {
  SEquippedBody world;
  world.AddDevice(world.Body->GetOriginAnchor());
  CRABEquippedEntity& device = *world.Device;
  CHECK(device.GetTypeDescription() == "rab");
  CHECK(device.GetMsgSize() == 3);
  CHECK(device.GetRange() == 2.5);
  CHECK(device.GetData() == CByteArray(3, 0));
  const UInt64 empty = DigestOf(device);
  const UInt8 bytes[3] = {1, 2, 255};
  device.SetData(CByteArray(bytes, 3));
  CHECK(device.GetData() == CByteArray(bytes, 3));
  CHECK(DigestOf(device) != empty);
  device.GetData()[1] = 7;
  CHECK(device.GetData()[1] == 7);
  device.ClearData();
  CHECK(device.GetData() == CByteArray(3, 0));
  device.SetData(CByteArray(bytes, 3));
  device.Reset();
  CHECK(device.GetData() == CByteArray(3, 0));
  CHECK_THROWS_WITH(device.SetData(CByteArray(4)),
                    Contains("3 bytes, got 4") && Contains("robot.rab_0"));
}

TEST_CASE("rab entity: position follows anchor and offset", "[entities]") {
  SEquippedBody world;
  const bool onMast = GENERATE(false, true);
  world.AddDevice(onMast ? *world.Mast : world.Body->GetOriginAnchor());
  CRABEquippedEntity& device = *world.Device;
  CHECK(&device.GetEntityBody() == world.Body);
  device.Update();
  // the body faces along y: 0.1 ahead is 0.1 along y
  CHECK_THAT(Distance(device.GetPosition(), CVector3(1.0, 2.1, onMast ? 0.7 : 0.2)),
             WithinAbs(0.0, 1e-15));
  CVector3 ahead(CVector3::X);
  ahead.Rotate(device.GetOrientation());
  CHECK_THAT(Distance(ahead, CVector3(-1.0, 0.0, 0.0)), WithinAbs(0.0, 1e-15));
}

TEST_CASE("rab entity: is in its medium and uses its anchor while it is enabled", "[entities]") {
  SEquippedBody world;
  world.AddDevice(*world.Mast);
  CRABEquippedEntity& device = *world.Device;
  CToyRegistry first;
  CToyRegistry second;
  CHECK_FALSE(device.IsEnabled());
  CHECK_FALSE(device.HasMedium());
  CHECK_THROWS_WITH(device.GetMedium(), Contains("rab_0") && Contains("has no medium"));
  device.SetMedium(first);
  CHECK(first.NumDevices == 0);
  device.Enable();
  CHECK(first.NumDevices == 1);
  CHECK(world.Body->IsAnchorEnabled("mast"));
  device.SetMedium(second);
  CHECK(first.NumDevices == 0);
  CHECK(second.NumDevices == 1);
  device.Disable();
  CHECK(second.NumDevices == 0);
  CHECK_FALSE(world.Body->IsAnchorEnabled("mast"));
  device.Enable();
  device.Destroy();
  CHECK(second.NumDevices == 0);
  CHECK_FALSE(device.HasMedium());
}

TEST_CASE("rab entity: negative, infinite and NaN ranges are refused", "[entities]") {
  SEquippedBody world;
  world.AddDevice(world.Body->GetOriginAnchor());
  world.Device->SetRange(0.0);
  CHECK(world.Device->GetRange() == 0.0);
  const Real wrong =
      GENERATE(-0.1, std::numeric_limits<Real>::infinity(), std::numeric_limits<Real>::quiet_NaN());
  CHECK_THROWS_WITH(world.Device->SetRange(wrong), Contains("range (m) must be a number"));
  CHECK(world.Device->GetRange() == 0.0);
}

TEST_CASE("rab entity: is initialised from XML", "[entities]") {
  SEquippedBody world;
  auto owned = std::make_unique<CRABEquippedEntity>(&world.Robot);
  CRABEquippedEntity& device = *owned;
  world.Robot.AddComponent(*owned.release());
  CConfigurationDocument document;
  SECTION("all attributes") {
    document.Parse("<rab id='r' anchor='mast' range='1.5' msg_size='4' position='0.1,0,0'/>", "t");
    device.Init(document.GetRoot());
    CHECK(device.GetId() == "r");
    CHECK(&device.GetAnchor() == world.Mast);
    CHECK(device.GetRange() == 1.5);
    CHECK(device.GetMsgSize() == 4);
    CHECK(device.GetData().Size() == 4);
    CHECK_THAT(Distance(device.GetPosition(), CVector3(1.0, 2.1, 0.5)), WithinAbs(0.0, 1e-15));
  }
  SECTION("an unknown anchor") {
    document.Parse("<rab id='r' anchor='mask' range='1.5' msg_size='4'/>", "t");
    CHECK_THROWS_WITH(device.Init(document.GetRoot()), Contains("mask") && Contains("mast"));
  }
  SECTION("a negative range") {
    document.Parse("<rab id='r' anchor='mast' range='-1' msg_size='4'/>", "t");
    CHECK_THROWS_WITH(device.Init(document.GetRoot()), Contains("range"));
  }
}

}  // namespace rab_equipped_entity_test
