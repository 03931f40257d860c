#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <memory>

namespace controllable_entity_test {

using namespace argos;
using Catch::Contains;

namespace {

std::string Controller(const std::string& id, const std::string& content) {
  return "<toy_controller id='" + id + "'>" + content + "</toy_controller>";
}

const char* const kDevices = R"(
  <actuators> <toy_drive implementation='default' /> </actuators>
  <sensors> <toy_range implementation='default' /> </sensors>)";

std::string Robot(const std::string& controller) {
  return "<toy-robot id='r'> <body position='0,0,0' /> " + controller + " </toy-robot>";
}

SExperiment Experiment(const std::string& controllers, const std::string& arena) {
  return SExperiment{
      .Controllers = controllers, .Engines = "<toy_engine id='toy' />", .Arena = arena};
}

CToyController& ControllerOf(CTestWorld& world) {
  return dynamic_cast<CToyController&>(
      world.Get<CToyRobotEntity>("r").GetControllableEntity().GetController());
}

}  // namespace

TEST_CASE("controllable entity: creates the controller with its devices, then calls its Init()",
          "[core][entity][controller]") {
  CTestWorld world(
      Experiment(Controller("c", std::string(kDevices) + "<params velocity='1,2,3' />"),
                 Robot("<controller config='c' />")));
  CToyController& controller = ControllerOf(world);
  CHECK(controller.GetId() == "r");
  CHECK(controller.Velocity == CVector3(1.0, 2.0, 3.0));
  auto& entity = world.Get<CControllableEntity>("r.controller_0");
  CHECK(entity.GetActuators().count("toy_drive") == 1);
  CHECK(entity.GetSensors().count("toy_range") == 1);
  CHECK(dynamic_cast<CCI_Sensor*>(entity.GetSensors().at("toy_range")) ==
        controller.GetAllSensors().at("toy_range"));
  CHECK(&entity.GetSpace() == &world.GetSpace());
}

TEST_CASE("controllable entity: the robot's own params replace the controller's",
          "[core][entity][controller]") {
  CTestWorld world(
      Experiment(Controller("c", std::string(kDevices) + "<params velocity='1,2,3' />"),
                 Robot("<controller config='c'> <params /> </controller>")));
  CHECK(ControllerOf(world).Velocity == CVector3());
  CHECK_THAT(TakeLogErr(), Contains("is not used by anything"));
}

TEST_CASE("controllable entity: devices and params may be left out", "[core][entity][controller]") {
  CTestWorld world(Experiment(Controller("c", ""), Robot("<controller config='c' />")));
  world.Step();
  CHECK(ControllerOf(world).Steps == 1);
}

TEST_CASE("controllable entity: errors on unknown names give the line and the nearest name",
          "[core][entity][controller]") {
  const std::string good = Robot("<controller config='c' />");
  CHECK_THAT(LoadError(Experiment(Controller("c", kDevices), Robot("<controller config='d' />"))),
             Contains("\"d\"") && Contains("known: c") && Contains("test.argos:"));
  CHECK_THAT(LoadError(Experiment("<toy_controler id='c' />", good)),
             Contains("toy_controler") && Contains("toy_controller"));
  CHECK_THAT(
      LoadError(Experiment(
          Controller("c", "<actuators> <toy_driv implementation='default' /> </actuators>"), good)),
      Contains("toy_driv (default)") && Contains("toy_drive (default)"));
  CHECK_THAT(
      LoadError(Experiment(
          Controller("c", "<sensors> <toy_range implementation='defualt' /> </sensors>"), good)),
      Contains("toy_range (defualt)") && Contains("toy_range (default)"));
  CHECK_THAT(LoadError(Experiment(Controller("c", "<sensors> <toy_range /> </sensors>"), good)),
             Contains("implementation") && Contains("test.argos:"));
  CHECK_THAT(LoadError(Experiment(Controller("c", "<params fails='true' />"), good)),
             Contains("\"r\"") && Contains("told to fail"));
  CHECK_THAT(LoadError(Experiment(Controller("c", "<params velocity='fast' />"), good)),
             Contains("velocity") && Contains("fast"));
}

TEST_CASE("controllable entity: a broken controller is reported once, not for each robot",
          "[core][entity][controller]") {
  const std::string error =
      LoadError(Experiment(Controller("c", "<params fails='true' />"),
                           R"(<toy-robot id='r1'> <body /> <controller config='c' /> </toy-robot>
         <toy-robot id='r2'> <body position='1,0,0' /> <controller config='c' /> </toy-robot>)"));
  CHECK_THAT(error, Contains("r1") && !Contains("r2"));
}

TEST_CASE("controllable entity: without a controller, access is an error and a tick does nothing",
          "[core][entity][controller]") {
  CTestWorld world(Experiment("", ""));
  const CSimulator::CScope scope(world.GetSimulator());
  CControllableEntity entity(nullptr, "controller_0");
  CHECK_THROWS_WITH(entity.GetController(), Contains("controller"));
  entity.Sense();
  entity.ControlStep();
  entity.Act();
  entity.Reset();
}

TEST_CASE("controllable entity: a disabled robot does nothing", "[core][entity][controller]") {
  CTestWorld world(
      Experiment(Controller("c", std::string(kDevices) + "<params velocity='1,0,0' />"),
                 Robot("<controller config='c' />")));
  auto& entity = world.Get<CControllableEntity>("r.controller_0");
  world.Step();
  entity.Disable();
  world.Step(5);
  CHECK(ControllerOf(world).Steps == 1);
  entity.Enable();
  world.Step(1);
  CHECK(ControllerOf(world).Steps == 2);
}

TEST_CASE("controllable entity: a disabled sensor keeps its reading",
          "[core][entity][controller]") {
  CTestWorld world(Experiment(
      Controller("c", std::string(kDevices) + "<params velocity='1,0,0' />"),
      Robot("<controller config='c' />") + "<toy-block id='b' size='0.1,1,1' movable='false'> "
                                           "<body position='1,0,0' /> </toy-block>"));
  CToyController& controller = ControllerOf(world);
  world.Step();
  // from the rim at 0.05 m to the face at 0.95 m
  CHECK_THAT(controller.LastRange, Catch::WithinAbs(0.9, 1e-15));
  controller.GetSensor<CCI_ToyRangeSensor>("toy_range")->Disable();
  world.Step(2);
  CHECK_THAT(controller.LastRange, Catch::WithinAbs(0.9, 1e-15));
  controller.GetSensor<CCI_ToyRangeSensor>("toy_range")->Enable();
  world.Step();
  // three ticks at 1 m/s; ten substeps each
  CHECK_THAT(controller.LastRange, Catch::WithinAbs(0.6, 1e-14));
}

TEST_CASE("controllable entity: a second controller replaces the first",
          "[core][entity][controller]") {
  const int alive = CToyController::NumAlive;
  {
    CTestWorld world(
        Experiment(Controller("c", std::string(kDevices) + "<params velocity='1,0,0' />") +
                       Controller("d", std::string(kDevices) + "<params velocity='0,2,0' />"),
                   Robot("<controller config='c' />")));
    // the warning is about the second controller, which no robot uses yet
    CHECK_THAT(TakeLogErr(), Contains("no robot has the controller \"d\""));
    const CSimulator::CScope scope(world.GetSimulator());
    auto& entity = world.Get<CControllableEntity>("r.controller_0");
    world.Step(2);
    entity.SetController("d");
    CHECK(CToyController::NumAlive == alive + 1);
    CHECK(ControllerOf(world).Velocity == CVector3(0.0, 2.0, 0.0));
    CHECK(entity.GetActuators().size() == 1);
    const CVector3 before =
        world.Get<CToyRobotEntity>("r").GetEmbodiedEntity().GetOriginAnchor().Position;
    world.Step(3);
    const CVector3 moved =
        world.Get<CToyRobotEntity>("r").GetEmbodiedEntity().GetOriginAnchor().Position - before;
    // the new drive stands still until its first command acts, one tick later; sums of 20 steps
    CHECK_THAT(moved.GetX(), Catch::WithinAbs(0.0, 1e-14));
    CHECK_THAT(moved.GetY(), Catch::WithinAbs(0.4, 1e-14));
  }
  CHECK(CToyController::NumAlive == alive);
}

namespace {

/** Replaces an actuator that the simulator has created with its own one. */
class CSelfEquippingController : public CCI_Controller {
 public:
  void Init(TConfigurationNode&) override {
    AddActuator("toy_drive", std::make_unique<CCI_Actuator>().release());
  }
};

}  // namespace

REGISTER_CONTROLLER(CSelfEquippingController, "self_equipping_controller")

TEST_CASE("controllable entity: a controller may replace its devices",
          "[core][entity][controller]") {
  CTestWorld world(Experiment(
      "<self_equipping_controller id='c'>" + std::string(kDevices) + "</self_equipping_controller>",
      Robot("<controller config='c' />")));
  // the deleted drive is not called any more
  world.Step(2);
  auto& entity = world.Get<CControllableEntity>("r.controller_0");
  CHECK(entity.GetActuators().empty());
  CHECK(entity.GetSensors().size() == 1);
}

TEST_CASE("controllable entity: recorded rays are kept until the next sensing",
          "[core][entity][controller]") {
  CTestWorld world(Experiment(Controller("c", ""), Robot("<controller config='c' />")));
  auto& entity = world.Get<CControllableEntity>("r.controller_0");
  const CRay3 ray(CVector3(0.0, 0.0, 0.0), CVector3(2.0, 4.0, 0.0));
  entity.AddCheckedRay(true, ray);
  entity.AddIntersectionPoint(ray, 0.25);
  REQUIRE(entity.GetCheckedRays().size() == 1);
  CHECK(entity.GetCheckedRays()[0].first);
  CHECK(entity.GetCheckedRays()[0].second.GetEnd() == CVector3(2.0, 4.0, 0.0));
  REQUIRE(entity.GetIntersectionPoints().size() == 1);
  CHECK(entity.GetIntersectionPoints()[0] == CVector3(0.5, 1.0, 0.0));
  world.Step();
  CHECK(entity.GetCheckedRays().empty());
  CHECK(entity.GetIntersectionPoints().empty());
}

}  // namespace controllable_entity_test
