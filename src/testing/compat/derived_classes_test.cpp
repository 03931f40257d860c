// Classes derived from those of the simulator, written as for ARGoS 3: they use protected members
// by their names, and set in SetRobot() what the base class would have set.

#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor.h>
#include <argos3/plugins/robots/generic/simulator/camera_sensor_algorithm.h>
#include <argos3/plugins/robots/generic/simulator/ground_rotzonly_sensor.h>
#include <argos3/plugins/robots/generic/simulator/light_default_sensor.h>
#include <argos3/plugins/robots/generic/simulator/proximity_default_sensor.h>
#include <argos3/plugins/robots/generic/simulator/range_and_bearing_medium_sensor.h>
#include <argos3/plugins/simulator/entities/box_entity.h>
#include <argos3/plugins/simulator/entities/cylinder_entity.h>
#include <argos3/plugins/simulator/entities/ground_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/plugins/simulator/entities/light_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/proximity_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>
#include <argos3/plugins/simulator/entities/tag_entity.h>
#include <argos3/plugins/simulator/media/led_medium.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

namespace derived_classes_test {

using namespace argos;
using Catch::Contains;
using Catch::Matchers::WithinAbs;

class COwnProximity : public CProximityDefaultSensor {
 public:
  virtual void SetRobot(CComposableEntity& c_entity) {
    m_pcEmbodiedEntity = &(c_entity.GetComponent<CEmbodiedEntity>("body"));
    m_pcControllableEntity = &(c_entity.GetComponent<CControllableEntity>("controller"));
    m_pcProximityEntity =
        &(c_entity.GetComponent<CProximitySensorEquippedEntity>("proximity_sensors"));
    m_pcProximityEntity->Enable();
    m_bShowRays = true;
  }
  /* the constant noise is easy to see */
  virtual void Init(TConfigurationNode& t_tree) {
    CCI_ProximitySensor::Init(t_tree);
    Real fShift = 0.0;
    GetNodeAttributeOrDefault(t_tree, "shift", fShift, fShift);
    if (fShift > 0.0) {
      m_bAddNoise = true;
      m_cNoiseRange.Set(fShift, 1.001 * fShift);
      m_pcRNG = CRandom::CreateRNG("argos");
    }
    m_tReadings.resize(m_pcProximityEntity->GetNumSensors());
    Enable();
  }
  virtual Real CalculateReading(Real f_distance) { return 0.5 - 10.0 * f_distance; }
  CSpace& Space() { return m_cSpace; }
};

REGISTER_SENSOR(COwnProximity, "proximity", "own_set_robot", "", "", "", "", "")

/* leaves everything to its base, and looks at what that has done */
class CKnowingProximity : public CProximityDefaultSensor {
 public:
  virtual void Init(TConfigurationNode& t_tree) {
    CProximityDefaultSensor::Init(t_tree);
    CHECK(m_pcEmbodiedEntity == &m_pcProximityEntity->GetParent().GetComponent("body"));
    CHECK(m_pcControllableEntity == &m_pcProximityEntity->GetParent().GetComponent("controller"));
    CHECK(m_bShowRays);
    CHECK(m_bAddNoise);
    CHECK(m_cNoiseRange.GetMin() == -0.1);
    CHECK(m_cNoiseRange.GetMax() == 0.1);
    REQUIRE(m_pcRNG != NULL);
    m_pcRNG->Uniform(m_cNoiseRange);
  }
};

REGISTER_SENSOR(CKnowingProximity, "proximity", "knowing", "", "", "", "", "")

static SRobotExperiment EPuckAtBox(const std::string& str_sensor) {
  SRobotExperiment sExperiment;
  sExperiment.Sensors = str_sensor;
  /* the box begins at y = 0.06, ray 2 at 0.035 */
  sExperiment.Arena =
      Robot("e-puck", "r", "position=\"0,0,0\"") +
      "<box id=\"b\" size=\"0.1,0.1,0.1\" movable=\"false\"><body position=\"0,0.11,0\"/></box>";
  return sExperiment;
}

TEST_CASE("compat: a derived proximity sensor finds the robot's parts itself", "[compat]") {
  CRobotWorld cWorld(EPuckAtBox("<proximity implementation=\"own_set_robot\"/>"));
  cWorld.Step();
  auto& cSensor = cWorld.GetSensor<COwnProximity>("r", "proximity");
  REQUIRE(cSensor.GetReadings().size() == 8);
  CHECK_THAT(cSensor.GetReadings()[2], WithinAbs(0.25, 1e-13));
  CHECK(cSensor.GetReadings()[6] == 0.0);
  CHECK(&cSensor.Space() == &cWorld.GetSimulator().GetSpace());
  CHECK(cWorld.GetRobot("r").GetCheckedRays().size() == 8);
}

TEST_CASE("compat: noise that a derived proximity sensor sets is added", "[compat]") {
  CRobotWorld cWorld(EPuckAtBox("<proximity implementation=\"own_set_robot\" shift=\"0.5\"/>"));
  cWorld.Step();
  const auto& vecReadings = cWorld.GetSensor<CCI_ProximitySensor>("r", "proximity").GetReadings();
  /* the range of the noise */
  CHECK_THAT(vecReadings[2], WithinAbs(0.75025, 0.00025));
  CHECK_THAT(vecReadings[6], WithinAbs(0.50025, 0.00025));
}

TEST_CASE("compat: a derived proximity sensor sees what its base has read", "[compat]") {
  CRobotWorld cWorld(
      EPuckAtBox("<proximity implementation=\"knowing\" show_rays=\"true\" noise_level=\"0.1\"/>"));
  const auto& vecReadings = cWorld.GetSensor<CCI_ProximitySensor>("r", "proximity").GetReadings();
  Real fMin = 1.0, fMax = 0.0;
  for (int i = 0; i < 200; ++i) {
    cWorld.Step();
    fMin = std::min(fMin, vecReadings[2]);
    fMax = std::max(fMax, vecReadings[2]);
  }
  /* the level once, not twice: exp(-0.025) - 0.1, and 1, where it is clamped */
  CHECK(fMin >= 0.8753);
  CHECK(fMin < 0.885);
  CHECK(fMax == 1.0);
}

class COwnLight : public CLightDefaultSensor {
 public:
  virtual void SetRobot(CComposableEntity& c_entity) {
    m_pcEmbodiedEntity = &(c_entity.GetComponent<CEmbodiedEntity>("body"));
    m_pcControllableEntity = &(c_entity.GetComponent<CControllableEntity>("controller"));
    m_pcLightEntity = &(c_entity.GetComponent<CLightSensorEquippedEntity>("light_sensors"));
    m_pcLightEntity->Enable();
    m_bShowRays = true;
  }
  virtual void Init(TConfigurationNode& t_tree) {
    CLightDefaultSensor::Init(t_tree);
    CHECK(&m_cSpace == &CSimulator::GetInstance().GetSpace());
    m_bAddNoise = true;
    m_cNoiseRange.Set(0.25, 0.2500001);
    m_pcRNG = CRandom::CreateRNG("argos");
  }
};

REGISTER_SENSOR(COwnLight, "light", "own_set_robot", "", "", "", "", "")

static std::vector<Real> LightReadings(const std::string& str_implementation, size_t un_rays) {
  SRobotExperiment sExperiment;
  sExperiment.Sensors = "<light implementation=\"" + str_implementation + "\"/>";
  sExperiment.Arena =
      Robot("e-puck", "r", "position=\"0,0,0\"") +
      "<light id=\"l\" position=\"1,0.5,0.4\" intensity=\"0.4\" color=\"yellow\" medium=\"leds\"/>";
  CRobotWorld cWorld(sExperiment);
  cWorld.Step();
  CHECK((cWorld.GetRobot("r").GetCheckedRays().size() > 0) == (un_rays > 0));
  return cWorld.GetSensor<CCI_LightSensor>("r", "light").GetReadings();
}

TEST_CASE("compat: a derived light sensor finds the robot's parts itself", "[compat]") {
  const std::vector<Real> vecDefault = LightReadings("default", 0);
  const std::vector<Real> vecOwn = LightReadings("own_set_robot", 1);
  REQUIRE(vecOwn.size() == 8);
  REQUIRE(vecDefault.size() == 8);
  CHECK(vecDefault[0] > 0.05);
  for (size_t i = 0; i < 8; ++i) {
    /* the range of the noise */
    CHECK_THAT(vecOwn[i], WithinAbs(vecDefault[i] + 0.25, 2e-7));
  }
}

class COwnGround : public CGroundRotZOnlySensor {
 public:
  virtual void SetRobot(CComposableEntity& c_entity) {
    m_pcEmbodiedEntity = &(c_entity.GetComponent<CEmbodiedEntity>("body"));
    m_pcGroundSensorEntity =
        &(c_entity.GetComponent<CGroundSensorEquippedEntity>("ground_sensors"));
    m_pcGroundSensorEntity->Enable();
    m_pcFloorEntity = &m_cSpace.GetFloorEntity();
  }
  virtual void Update() {
    CGroundRotZOnlySensor::Update();
    /* as those do that replace the algorithm */
    const CVector3& cPosition = m_pcEmbodiedEntity->GetOriginAnchor().Position;
    m_fBelow = m_pcFloorEntity->GetColorAtPoint(cPosition.GetX(), cPosition.GetY()).ToGrayScale();
  }
  Real m_fBelow = 0.0;
};

REGISTER_SENSOR(COwnGround, "ground", "own_set_robot", "", "", "", "", "")

class CGreyFloor : public CLoopFunctions {
 public:
  virtual CColor GetFloorColor(const CVector2&) { return CColor::GRAY50; }
};

REGISTER_LOOP_FUNCTIONS(CGreyFloor, "compat_grey_floor")

TEST_CASE("compat: a derived ground sensor finds the robot's parts itself", "[compat]") {
  SRobotExperiment sExperiment;
  sExperiment.LoopFunctions = "<loop_functions label=\"compat_grey_floor\"/>";
  sExperiment.Sensors = "<ground implementation=\"own_set_robot\" noise_level=\"0.1\"/>";
  sExperiment.Arena = "<floor id=\"floor\" source=\"loop_functions\" pixels_per_meter=\"10\"/>" +
                      Robot("e-puck", "r", "position=\"0,0,0\"");
  CRobotWorld cWorld(sExperiment);
  auto& cSensor = cWorld.GetSensor<COwnGround>("r", "ground");
  const Real fGrey = CColor::GRAY50.ToGrayScale();
  Real fLargest = 0.0;
  for (int i = 0; i < 100; ++i) {
    cWorld.Step();
    REQUIRE(cSensor.GetReadings().size() == 3);
    fLargest = std::max(fLargest, std::abs(cSensor.GetReadings()[1] - fGrey / 255.0));
  }
  CHECK(cSensor.m_fBelow == fGrey);
  /* the level once, not twice */
  CHECK(fLargest <= 0.1);
  CHECK(fLargest > 0.08);
}

class COwnRABSensor : public CRangeAndBearingMediumSensor {
 public:
  virtual void SetRobot(CComposableEntity& c_entity) {
    m_pcRangeAndBearingEquippedEntity = &(c_entity.GetComponent<CRABEquippedEntity>("rab"));
    m_pcControllableEntity = &(c_entity.GetComponent<CControllableEntity>("controller"));
    m_bShowRays = true;
  }
  virtual void Init(TConfigurationNode& t_tree) {
    CRangeAndBearingMediumSensor::Init(t_tree);
    CHECK(&m_cSpace == &CSimulator::GetInstance().GetSpace());
    CHECK((m_pcRNG != NULL) == (m_fDistanceNoiseStdDev > 0.0));
  }
  /* turned on without an attribute of the file */
  void LoseAll() { m_fPacketDropProb = 1.0; }
};

REGISTER_SENSOR(COwnRABSensor, "range_and_bearing", "own_set_robot", "", "", "", "", "")

TEST_CASE("compat: a derived range-and-bearing sensor finds the robot's parts itself", "[compat]") {
  SRobotExperiment sExperiment;
  sExperiment.Media = "<range_and_bearing id=\"rab\"/>";
  sExperiment.Sensors = "<range_and_bearing implementation=\"own_set_robot\" medium=\"rab\"/>";
  sExperiment.Arena =
      Robot("e-puck", "a", "position=\"0,0,0\"") + Robot("e-puck", "b", "position=\"0.5,0,0\"");
  CRobotWorld cWorld(sExperiment);
  cWorld.Step();
  auto& cSensor = cWorld.GetSensor<COwnRABSensor>("a", "range_and_bearing");
  REQUIRE(cSensor.GetReadings().size() == 1);
  CHECK_THAT(cSensor.GetReadings()[0].Range, WithinAbs(50.0, 1e-11));
  CHECK(cWorld.GetRobot("a").GetCheckedRays().size() == 1);
  cSensor.LoseAll();
  cWorld.Step();
  CHECK(cSensor.GetReadings().empty());
}

/* a device that another one carries, as far from the anchor as it is told */
class COwnRAB : public CRABEquippedEntity {
 public:
  COwnRAB(CComposableEntity& c_robot, Real f_height) : CRABEquippedEntity(&c_robot) {
    m_pcEntityBody = &c_robot.GetComponent<CEmbodiedEntity>("body");
    m_psAnchor = &m_pcEntityBody->GetOriginAnchor();
    m_cPosOffset.Set(0.0, 0.0, f_height);
    m_cRotOffset.FromAngleAxis(CRadians::PI_OVER_TWO, CVector3::Z);
    m_unMsgSize = 2;
    m_cData.Resize(2);
    m_fRange = 1.5;
  }
};

TEST_CASE("compat: a derived range-and-bearing device sets its members itself", "[compat]") {
  CRobotWorld cWorld(EPuckAtBox(""));
  CComposableEntity& cRobot = cWorld.GetRobot("r").GetParent();
  COwnRAB cRAB(cRobot, 0.3);
  cRAB.Update();
  CHECK(cRAB.GetPosition() == CVector3(0.0, 0.0, 0.3));
  CVector3 cAhead(CVector3::X);
  cAhead.Rotate(cRAB.GetOrientation());
  /* roundings of a rotation */
  CHECK_THAT(cAhead.GetY(), WithinAbs(1.0, 1e-14));
  CHECK(cRAB.GetRange() == 1.5);
  CHECK(cRAB.GetMsgSize() == 2);
  CHECK(&cRAB.GetEntityBody() == &cRobot.GetComponent("body"));
  CHECK(&cRAB.GetAnchor() == &cRAB.GetEntityBody().GetOriginAnchor());
}

TEST_CASE("compat: components of robots can be copied", "[compat]") {
  CRobotWorld cWorld(EPuckAtBox(""));
  CLEDMedium& cMedium = cWorld.GetSimulator().GetMedium<CLEDMedium>("leds");
  CComposableEntity& cRobot = cWorld.GetRobot("r").GetParent();

  CLEDEntity cLED(&cRobot, "led", CVector3(1.0, 2.0, 3.0), CColor::RED);
  cLED.SetMedium(cMedium);
  cLED.Enable();
  {
    std::vector<CLEDEntity> vecCopies(2, cLED);
    CHECK(vecCopies[1].GetColor() == CColor::RED);
    CHECK(vecCopies[1].GetPosition() == CVector3(1.0, 2.0, 3.0));
    CHECK(vecCopies[1].GetId() == "led");
    CHECK(&vecCopies[1].GetParent() == &cRobot);
    CHECK_FALSE(vecCopies[1].HasMedium());
    CHECK_FALSE(vecCopies[1].IsEnabled());
    vecCopies[0].SetColor(CColor::BLUE);
    vecCopies[0].SetMedium(cMedium);
    vecCopies[0].Enable();
  }
  /* the medium contains the original, and none of the copies */
  CHECK(cLED.GetColor() == CColor::RED);
  CHECK(cLED.IsEnabled());
  CHECK(&cLED.GetMedium() == &cMedium);
  struct SCount : CPositionalIndex<CLEDEntity>::COperation {
    virtual bool operator()(CLEDEntity& c_led) {
      ++Num;
      CHECK(&c_led == Original);
      return true;
    }
    const CLEDEntity* Original = NULL;
    int Num = 0;
  } sCount;
  sCount.Original = &cLED;
  cMedium.Update();
  cMedium.GetIndex().ForEntitiesInSphereRange(CVector3(1.0, 2.0, 3.0), 0.01, sCount);
  CHECK(sCount.Num == 1);

  CTagEntity cTag(&cRobot, "tag", CVector3(), CQuaternion(), CRadians::PI, 0.1, "payload");
  CTagEntity cTagCopy = cTag;
  cTagCopy.SetPayload("other");
  CHECK(cTag.GetPayload() == "payload");

  CRABEquippedEntity& cRAB = cRobot.GetComponent<CRABEquippedEntity>("rab");
  CRABEquippedEntity cRABCopy = cRAB;
  CHECK(cRABCopy.GetIndex() == cRAB.GetIndex());
  cRABCopy.SetRange(7.0);
  cRABCopy.GetData()[0] = 9;
  CHECK(cRAB.GetRange() != 7.0);
  CHECK(cRAB.GetData()[0] == 0);

  cTagCopy = cTag;
  CHECK(cTagCopy.GetPayload() == "payload");

  CEmbodiedEntity& cBody = cRobot.GetComponent<CEmbodiedEntity>("body");
  SAnchor sAnchor = cBody.GetOriginAnchor();
  sAnchor.Position.SetX(5.0);
  CHECK(sAnchor.Id == "origin");
  CHECK(&sAnchor.Body == &cBody);
  CHECK(cBody.GetOriginAnchor().Position.GetX() == 0.0);
}

/* what loop functions do that keep their objects in a vector of values */
TEST_CASE("compat: copies of bodies and lights refer to the originals and own nothing",
          "[compat]") {
  SRobotExperiment sExperiment;
  sExperiment.Engine = "<dynamics2d id=\"engine\"/>";
  CRobotWorld cWorld(sExperiment);
  CSpace& cSpace = cWorld.GetSimulator().GetSpace();
  std::vector<CCylinderEntity> vecFood;
  for (const Real fX : {0.0, 1.0, 2.0}) {
    vecFood.push_back(cWorld.Add(std::make_unique<CCylinderEntity>(
        "food" + ToString(fX), CVector3(fX, 0.0, 0.0), CQuaternion(), true, 0.1, 0.2, 1.0)));
  }
  auto& cFirst = dynamic_cast<CCylinderEntity&>(cSpace.GetEntity("food0"));
  CHECK(vecFood[0].GetId() == "food0");
  CHECK(vecFood[0].GetIndex() == cFirst.GetIndex());
  CHECK(vecFood[0].GetRadius() == 0.1);
  CHECK(&vecFood[0].GetEmbodiedEntity() == &cFirst.GetEmbodiedEntity());
  CHECK(&vecFood[0].GetComponent("body") == &cFirst.GetEmbodiedEntity());
  /* live values */
  CHECK(cFirst.GetEmbodiedEntity().MoveTo(CVector3(0.0, 1.0, 0.0), CQuaternion()));
  CHECK(vecFood[0].GetEmbodiedEntity().GetOriginAnchor().Position == CVector3(0.0, 1.0, 0.0));
  /* erase() assigns */
  vecFood.erase(vecFood.begin());
  CHECK(vecFood[0].GetId() == "food1");
  CHECK(vecFood[0].GetEmbodiedEntity().GetOriginAnchor().Position.GetX() == 1.0);
  /* one that was never added becomes a copy, too; one in the arena stays what it is */
  CCylinderEntity cSpare("spare", CVector3(), CQuaternion(), false, 0.3, 0.2);
  cSpare = vecFood[1];
  CHECK(&cSpare.GetEmbodiedEntity() == &vecFood[1].GetEmbodiedEntity());
  CHECK_THROWS_WITH(cFirst = vecFood[0], Contains("\"food0\" is in use"));
  CHECK_THROWS_WITH(cSpare.RemoveComponent("leds"), Contains("\"food2\" (cylinder) is a copy"));
  vecFood.clear();
  cWorld.Step(2);
  CHECK(cFirst.GetEmbodiedEntity().GetOriginAnchor().Position.GetY() == 1.0);

  auto& cLight = cWorld.Add(
      std::make_unique<CLightEntity>("lamp", CVector3(1.0, 1.0, 1.0), CColor::YELLOW, 2.0));
  std::vector<CLightEntity> vecLights(2, cLight);
  vecLights[0] = cLight;
  CHECK(vecLights[0].GetIntensity() == 2.0);
  STATIC_REQUIRE(std::is_copy_constructible_v<CBoxEntity>);
  STATIC_REQUIRE(std::is_copy_assignable_v<CBoxEntity>);
}

class CCounting : public CCI_Controller {
 public:
  int Count = 0;
};

TEST_CASE("compat: copies of controllers use the devices of the original and delete none",
          "[compat]") {
  class CDevice : public CCI_Sensor {
   public:
    explicit CDevice(int& n_deleted) : m_nDeleted(n_deleted) {}
    virtual ~CDevice() { ++m_nDeleted; }

   private:
    int& m_nDeleted;
  };
  int nDeleted = 0;
  {
    CCounting cOriginal;
    cOriginal.SetId("robot");
    cOriginal.AddSensor("device", new CDevice(nDeleted));
    cOriginal.Count = 3;
    {
      CCounting cCopy = cOriginal;
      CHECK(cCopy.GetId() == "robot");
      CHECK(cCopy.GetSensor<CDevice>("device") == cOriginal.GetSensor<CDevice>("device"));
      CHECK_THROWS_WITH(cCopy.AddSensor("other", nullptr), Contains("a copy of its controller"));
      CCounting cAssigned;
      cAssigned = cOriginal;
      CHECK(cAssigned.HasSensor("device"));
      CHECK(cAssigned.Count == 3);
    }
    CHECK(nDeleted == 0);
    /* a robot's controller keeps its devices */
    CCounting cOther;
    cOther.SetId("other");
    cOther.Count = 8;
    cOriginal = cOther;
    CHECK(cOriginal.Count == 8);
    CHECK(cOriginal.GetId() == "robot");
    CHECK(cOriginal.HasSensor("device"));
  }
  CHECK(nDeleted == 1);
}

/* which points are in the image, and a ray to each of those */
class CPointFinder : public CCameraSensorSimulatedAlgorithm, public CCI_CameraSensorAlgorithm {
 public:
  virtual void SetCamera(CComposableEntity&, const std::string&) {}
  virtual void Init(TConfigurationNode&) {}
  virtual void Update(const CPinholeCamera&) {
    m_vecFound.clear();
    for (Real fX = -1.0; fX < 4.0; fX += 1.0) {
      const CVector3 cPoint(fX, 0.0, 0.1);
      if (IsPointInsideFrustum(cPoint)) {
        m_vecFound.push_back(fX);
        m_vecCheckedRays.push_back(std::make_pair(false, CRay3(CVector3(), cPoint)));
      }
    }
  }
  virtual CCI_CameraSensorAlgorithm& GetCIAlgorithm() { return *this; }
  virtual const char* GetLabel() const { return "point_finder"; }
  std::vector<Real> m_vecFound;
};

REGISTER_CAMERA_SENSOR_ALGORITHM(CPointFinder, "point_finder", "", "", "", "", "")

TEST_CASE("compat: an algorithm of a camera tests points and records rays", "[compat]") {
  SRobotExperiment sExperiment;
  sExperiment.Sensors =
      "<cameras implementation=\"default\"><camera id=\"front\" anchor=\"origin\" "
      "position=\"0,0,0.1\" orientation=\"-90,90,0\" range=\"0.5:2.5\" focal_length=\"500,500\" "
      "principal_point=\"320,240\" resolution=\"640,480\"><point_finder/></camera></cameras>";
  sExperiment.Arena = Robot("e-puck", "r", "position=\"0,0,0\"");
  CRobotWorld cWorld(sExperiment);
  auto& cCameras = cWorld.GetSensor<CCI_CameraSensor>("r", "cameras");
  cCameras.Enable();
  cWorld.Step(2);
  auto& cFinder = dynamic_cast<CPointFinder&>(*cCameras.GetInterfaces()[0].Algorithms[0]);
  CHECK(cFinder.m_vecFound == std::vector<Real>{1.0, 2.0});
  REQUIRE(cWorld.GetRobot("r").GetCheckedRays().size() == 2);
  CHECK(cWorld.GetRobot("r").GetCheckedRays()[1].second.GetEnd() == CVector3(2.0, 0.0, 0.1));
}

}  // namespace derived_classes_test
