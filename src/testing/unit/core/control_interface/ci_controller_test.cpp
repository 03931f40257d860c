// Uses this header of the core only, without "using" before the macros: users may rely on both.
#include <argos3/core/control_interface/ci_controller.h>

#include <catch2/catch.hpp>

#include <memory>

// without a namespace, which would be part of its name in messages
class CCI_TestNoseSensor : public argos::CCI_Sensor {};

namespace argosTest {

struct SSimulatedPart {
  virtual ~SSimulatedPart() = default;
};

// two bases, as simulated devices have
class CTestNose : public SSimulatedPart, public CCI_TestNoseSensor {};

}  // namespace argosTest

namespace ci_controller_test {

using Catch::Contains;

namespace {

int numDeleted = 0;

class CTestWheels : public argos::CCI_Actuator {
 public:
  ~CTestWheels() override { ++numDeleted; }
  int Speed = 0;
};

class CTestLEDs : public argos::CCI_Actuator {};

// Overrides the Lua functions, as devices of users do.
class CTestEyes : public argos::CCI_Sensor {
 public:
  ~CTestEyes() override { ++numDeleted; }
  void CreateLuaState(lua_State*) override { ++LuaCalls; }
  void ReadingsToLuaState(lua_State*) override { ++LuaCalls; }
  int LuaCalls = 0;
};

}  // namespace

class CTestBrain : public argos::CCI_Controller {
 public:
  void Init(argos::TConfigurationNode& node) override {
    argos::GetNodeAttributeOrDefault(node, "speed", Speed, Speed);
  }
  void ControlStep() override { ++Steps; }
  argos::Real Speed = 1.0;
  int Steps = 0;
};

REGISTER_CONTROLLER(CTestBrain, "test_brain_controller")

using namespace argos;

TEST_CASE("controller: its header brings what controllers use", "[core][control_interface]") {
  char buffer[4];
  memset(buffer, 'x', sizeof(buffer));
  memcpy(buffer, "abc", 3);
  CHECK(std::string(buffer, 4) == "abcx");
  std::ostringstream stream;
  stream << std::vector<int>{1, 2}.size() << std::map<int, int>{}.size();
  CHECK(stream.str() == "20");
  CHECK_THROWS_AS([] { THROW_ARGOSEXCEPTION("x") }(), CARGoSException);
}

TEST_CASE("controller: a class registered at global scope is created by its label",
          "[core][control_interface]") {
  const std::unique_ptr<CCI_Controller> controller(
      CFactory<CCI_Controller>::New("test_brain_controller"));
  auto* brain = dynamic_cast<CTestBrain*>(controller.get());
  REQUIRE(brain != nullptr);
  TConfigurationNode params("params");
  SetNodeAttribute(params, "speed", 2.5);
  controller->Init(params);
  CHECK(brain->Speed == 2.5);
  controller->ControlStep();
  CHECK(brain->Steps == 1);
  controller->Reset();
  controller->Destroy();
}

TEST_CASE("controller: default hooks do nothing", "[core][control_interface]") {
  CCI_Controller controller;
  TConfigurationNode params("params");
  controller.Init(params);
  controller.ControlStep();
  controller.Reset();
  controller.Destroy();
  CHECK(controller.GetId().empty());
  controller.SetId("fb3");
  CHECK(controller.GetId() == "fb3");
}

TEST_CASE("controller: devices are found by type and deleted with it",
          "[core][control_interface]") {
  numDeleted = 0;
  {
    CCI_Controller controller;
    auto* wheels = new CTestWheels;
    auto* eyes = new CTestEyes;
    controller.AddActuator("wheels", wheels);
    controller.AddSensor("eyes", eyes);
    CHECK(controller.HasActuator("wheels"));
    CHECK_FALSE(controller.HasActuator("eyes"));
    CHECK(controller.HasSensor("eyes"));
    CHECK_FALSE(controller.HasSensor("wheels"));
    CHECK(controller.GetActuator<CTestWheels>("wheels") == wheels);
    CHECK(controller.GetSensor<CCI_Sensor>("eyes") == eyes);
    CHECK(controller.GetAllActuators().size() == 1);
    CHECK(controller.GetAllSensors().begin()->first == "eyes");
  }
  CHECK(numDeleted == 2);
}

TEST_CASE("controller: a second device of a type replaces the first", "[core][control_interface]") {
  numDeleted = 0;
  CCI_Controller controller;
  controller.AddActuator("wheels", new CTestWheels);
  auto* later = new CTestWheels;
  controller.AddActuator("wheels", later);
  CHECK(numDeleted == 1);
  controller.AddActuator("wheels", later);
  CHECK(numDeleted == 1);
  CHECK(controller.GetActuator<CTestWheels>("wheels") == later);
}

TEST_CASE("controller: the error on a missing device lists the devices that exist",
          "[core][control_interface]") {
  CCI_Controller controller;
  controller.SetId("fb3");
  CHECK_THROWS_WITH(
      controller.GetSensor<CTestEyes>("eyes"),
      "[FATAL] Robot \"fb3\": its controller requests the sensor \"eyes\", which is not in "
      "the <sensors> section of the controller's XML; the section contains: nothing");
  controller.AddActuator("wheels", new CTestWheels);
  controller.AddActuator("leds", new CTestLEDs);
  CHECK_THROWS_WITH(controller.GetActuator<CTestWheels>("wheel"),
                    Contains("did you mean \"wheels\"?; the section contains: leds, wheels"));
}

TEST_CASE("controller: the error on a device of another type names both types",
          "[core][control_interface]") {
  CCI_Controller controller;
  controller.SetId("fb3");
  controller.AddActuator("leds", new CTestLEDs);
  CHECK_THROWS_WITH(
      controller.GetActuator<CTestWheels>("leds"),
      Contains("Robot \"fb3\": its controller requests the actuator \"leds\" as a ") &&
          Contains("CTestWheels, but the device in the XML is a ") && Contains("CTestLEDs"));
}

TEST_CASE("sensor: starts disabled", "[core][control_interface]") {
  CTestEyes eyes;
  CCI_Sensor& sensor = eyes;
  CHECK(sensor.IsDisabled());
  sensor.Enable();
  CHECK(sensor.IsEnabled());
  CHECK_FALSE(sensor.IsDisabled());
  sensor.Disable();
  CHECK_FALSE(sensor.IsEnabled());
}

TEST_CASE("devices: all hooks have empty defaults, and those for Lua can be overridden",
          "[core][control_interface]") {
  TConfigurationNode node("node");
  CTestLEDs leds;
  CCI_Actuator& actuator = leds;
  actuator.Init(node);
  actuator.Reset();
  actuator.Destroy();
  actuator.CreateLuaState(nullptr);
  CTestEyes eyes;
  CCI_Sensor& sensor = eyes;
  sensor.Init(node);
  sensor.Reset();
  sensor.Destroy();
  sensor.CreateLuaState(nullptr);
  sensor.ReadingsToLuaState(nullptr);
  CHECK(eyes.LuaCalls == 2);
  CCI_Sensor plain;
  plain.CreateLuaState(nullptr);
  plain.ReadingsToLuaState(nullptr);
}

TEST_CASE("controller: the error on a device of another type names its interface and header",
          "[core][control_interface]") {
  CCI_Controller controller;
  controller.SetId("fb3");
  controller.AddSensor("test_nose", new argosTest::CTestNose);
  CHECK_THROWS_WITH(controller.GetSensor<CTestEyes>("test_nose"),
                    Contains("but the device in the XML is a CCI_TestNoseSensor "
                             "(argosTest::CTestNose), whose header is ci_test_nose_sensor.h"));
}

}  // namespace ci_controller_test
