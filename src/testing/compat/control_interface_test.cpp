// The control interface from the view of controllers and of authors of devices.

#include "user_controller.h"

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_light_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_base_ground_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_light_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_motor_ground_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_battery_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_perspective_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_positioning_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/plugins/robots/generic/simulator/proximity_default_sensor.h>

#include <catch2/catch.hpp>

#include <sstream>
#include <string>

namespace control_interface_test {

using namespace argos;

class CTestActuator : public CCI_Actuator {
 public:
  virtual void Init(TConfigurationNode& t_node) { CCI_Actuator::Init(t_node); }
  virtual void Reset() { CCI_Actuator::Reset(); }
  virtual void Destroy() { CCI_Actuator::Destroy(); }
#ifdef ARGOS_WITH_LUA
  virtual void CreateLuaState(lua_State*) {}
#endif
};

class CTestSensor : public CCI_Sensor {
 public:
  virtual void Init(TConfigurationNode& t_node) { CCI_Sensor::Init(t_node); }
  virtual void Reset() { CCI_Sensor::Reset(); }
  virtual void Destroy() { CCI_Sensor::Destroy(); }
  virtual void Enable() { CCI_Sensor::Enable(); }
  virtual void Disable() { CCI_Sensor::Disable(); }
#ifdef ARGOS_WITH_LUA
  virtual void CreateLuaState(lua_State*) {}
  virtual void ReadingsToLuaState(lua_State*) {}
#endif
};

class CTestController : public CCI_Controller {
 public:
  /* these are declared by a transitive include only */
  CTestController() {
    ::memset(m_pfWeights, 0, sizeof(m_pfWeights));
    ::memcpy(m_pfCopy, m_pfWeights, sizeof(m_pfCopy));
  }
  std::string ProtectedId() { return m_strId; }
  size_t ProtectedDevices() { return m_mapActuators.size() + m_mapSensors.size(); }
  Real m_pfWeights[3], m_pfCopy[3];
};

#ifndef ARGOS_WITH_LUA
#error "users' devices override the Lua functions where this is defined, and it always is"
#endif

TEST_CASE("compat: base classes of the control interface compile and work", "[compat]") {
  CConfigurationDocument cDocument;
  cDocument.Parse("<params />");
  CTestController cController;
  CCI_Controller& cBase = cController;
  cBase.SetId("fb7");
  CHECK(cBase.GetId() == "fb7");
  CHECK(cController.ProtectedId() == "fb7");
  CTestActuator* pcActuator = new CTestActuator;
  CTestSensor* pcSensor = new CTestSensor;
  cBase.AddActuator("act", pcActuator);
  cBase.AddSensor("sens", pcSensor);
  CHECK(cController.ProtectedDevices() == 2);
  const CCI_Controller& cConst = cBase;
  CHECK(cConst.HasActuator("act"));
  CHECK_FALSE(cConst.HasActuator("sens"));
  CHECK(cConst.HasSensor("sens"));
  CHECK(cBase.GetActuator<CTestActuator>("act") == pcActuator);
  CHECK(cBase.GetSensor<CTestSensor>("sens") == pcSensor);
  CHECK_THROWS_AS(cBase.GetActuator<CTestActuator>("none"), CARGoSException);
  CHECK_THROWS_AS(cBase.GetSensor<CCI_ProximitySensor>("sens"), CARGoSException);
  CCI_Actuator::TMap& tActuators = cBase.GetAllActuators();
  for (CCI_Actuator::TMap::iterator it = tActuators.begin(); it != tActuators.end(); ++it)
    CHECK(it->second == pcActuator);
  CCI_Sensor::TMap& tSensors = cBase.GetAllSensors();
  CHECK(tSensors["sens"] == pcSensor);
  CHECK(pcSensor->IsDisabled());
  pcSensor->Enable();
  CHECK(pcSensor->IsEnabled());
  pcSensor->Disable();
  CHECK_FALSE(pcSensor->IsEnabled());
  cBase.Init(cDocument.GetRoot());
  cBase.ControlStep();
  cBase.Reset();
  cBase.Destroy();
  pcActuator->Init(cDocument.GetRoot());
  pcActuator->Reset();
  pcActuator->Destroy();
  pcSensor->Init(cDocument.GetRoot());
  pcSensor->Reset();
  pcSensor->Destroy();
  pcActuator->CreateLuaState(NULL);
  pcSensor->CreateLuaState(NULL);
  pcSensor->ReadingsToLuaState(NULL);
}

/* interfaces, with derived classes as in plug-ins */

class CMySteering : public CCI_DifferentialSteeringActuator {
 public:
  virtual void SetLinearVelocity(Real f_left_velocity, Real f_right_velocity) {
    m_fCurrentVelocity[0] = f_left_velocity * 0.01;
    m_fCurrentVelocity[1] = f_right_velocity * 0.01;
  }
  Real Left() const { return m_fCurrentVelocity[0]; }
};

class CMyLEDs : public CCI_LEDsActuator {
 public:
  CMyLEDs() { m_tSettings.resize(3); }
  virtual void SetSingleColor(UInt32 un_led_number, const CColor& c_color) {
    CCI_LEDsActuator::SetSingleColor(un_led_number, c_color);
  }
  virtual void SetAllColors(const CColor& c_color) { CCI_LEDsActuator::SetAllColors(c_color); }
  virtual void SetAllColors(const TSettings& c_colors) { CCI_LEDsActuator::SetAllColors(c_colors); }
  virtual void SetSingleIntensity(UInt32 un_led_number, UInt8 un_intensity) {
    CCI_LEDsActuator::SetSingleIntensity(un_led_number, un_intensity);
  }
  virtual void SetAllIntensities(UInt8 un_intensity) {
    CCI_LEDsActuator::SetAllIntensities(un_intensity);
  }
  const CColor& Color(size_t un_led) const { return m_tSettings[un_led]; }
};

class CMyProximity : public CCI_ProximitySensor {
 public:
  CMyProximity() { m_tReadings.resize(8, 0.5); }
};

class CMyFootBotProximity : public CCI_FootBotProximitySensor {
 public:
  CMyFootBotProximity() { m_tReadings[0].Value = 0.25; }
};

class CMyEPuckProximity : public CCI_EPuckProximitySensor {
 public:
  CMyEPuckProximity() { m_tReadings[0].Value = 0.25; }
};

/* overrides the documented hook */
class CStepProximity : public CProximityDefaultSensor {
 public:
  virtual Real CalculateReading(Real f_distance) { return f_distance < 0.05 ? 1.0 : 0.0; }
};

/* overloads for the readings of different sensors */
static std::string Kind(const CCI_FootBotProximitySensor::TReadings&) {
  return "proximity";
}
static std::string Kind(const CCI_FootBotLightSensor::TReadings&) {
  return "light";
}
static std::string Kind(const CCI_EyeBotLightSensor::TReadings&) {
  return "eye-bot light";
}
static std::string Kind(const CCI_FootBotBaseGroundSensor::TReadings&) {
  return "base";
}
static std::string Kind(const CCI_FootBotMotorGroundSensor::TReadings&) {
  return "motor";
}
std::ostream& operator<<(std::ostream& c_os, const CCI_FootBotLightSensor::SReading& s_reading) {
  return c_os << s_reading.Value << "@" << s_reading.Angle.GetValue();
}

TEST_CASE("compat: readings of each sensor have their own type", "[compat]") {
  CHECK(Kind(CCI_FootBotProximitySensor().GetReadings()) == "proximity");
  CHECK(Kind(CCI_FootBotLightSensor().GetReadings()) == "light");
  CHECK(Kind(CCI_EyeBotLightSensor().GetReadings()) == "eye-bot light");
  CHECK(Kind(CCI_FootBotBaseGroundSensor().GetReadings()) == "base");
  CHECK(Kind(CCI_FootBotMotorGroundSensor().GetReadings()) == "motor");

  struct CCI_FootBotLightSensor::SReading sReading(0.5, CRadians(0.25));
  std::ostringstream cOut;
  cOut << sReading;
  CHECK(cOut.str() == "0.5@0.25");
}

TEST_CASE("compat: device interfaces work as documented", "[compat]") {
  CMySteering cSteering;
  CCI_DifferentialSteeringActuator& cWheels = cSteering;
  cWheels.SetLinearVelocity(5.0, 10.0f);
  CHECK_THAT(cSteering.Left(), Catch::WithinAbs(0.05, 1e-15));

  CCI_DifferentialSteeringSensor::SReading sReading(1.0, 2.0, 3.0, 4.0, 5.0), sDefault;
  CHECK((sReading.VelocityLeftWheel == 1.0 && sReading.VelocityRightWheel == 2.0 &&
         sReading.CoveredDistanceLeftWheel == 3.0 && sReading.CoveredDistanceRightWheel == 4.0 &&
         sReading.WheelAxisLength == 5.0));
  CHECK(sDefault.WheelAxisLength == 0.0);

  CMyLEDs cMyLEDs;
  CCI_LEDsActuator& cLEDs = cMyLEDs;
  CHECK(cLEDs.GetNumLEDs() == 3);
  cLEDs.SetSingleColor(1, CColor::RED);
  CHECK(cMyLEDs.Color(1) == CColor::RED);
  cLEDs.SetAllColors(CColor::GREEN);
  CCI_LEDsActuator::TSettings tSettings(3, CColor::BLUE);
  cLEDs.SetAllColors(tSettings);
  cLEDs.SetSingleIntensity(0, 100);
  cLEDs.SetAllIntensities(50);
  CHECK(cMyLEDs.Color(2) == CColor(0, 0, 255, 50));

  CMyProximity cProximity;
  const std::vector<Real>& vecReadings = cProximity.GetReadings();
  CHECK(vecReadings.size() == 8);

  CMyFootBotProximity cFootBot;
  const CCI_FootBotProximitySensor::TReadings& tReadings = cFootBot.GetReadings();
  REQUIRE(tReadings.size() == 24);
  CHECK(tReadings[0].Value == 0.25);
  CCI_FootBotProximitySensor::SReading sProximity(0.5, CRadians::PI), sNone;
  CHECK((sProximity.Value == 0.5 && sProximity.Angle == CRadians::PI && sNone.Value == 0.0));
  for (UInt32 i = 0; i < 24; ++i) {
    // 7.5 degrees + 15 degrees each, signed
    const Real fExpected = i < 12 ? 7.5 + 15.0 * i : 7.5 + 15.0 * i - 360.0;
    CHECK_THAT(ToDegrees(tReadings[i].Angle).GetValue(), Catch::WithinAbs(fExpected, 1e-10));
  }

  CMyEPuckProximity cEPuck;
  REQUIRE(cEPuck.GetReadings().size() == 8);
  CHECK(cEPuck.GetReadings()[0].Value == 0.25);
  CHECK_THAT(cEPuck.GetReadings()[0].Angle.GetValue(), Catch::WithinAbs(ARGOS_PI / 10.5884, 1e-10));
  CHECK_THAT(cEPuck.GetReadings()[7].Angle.GetValue(),
             Catch::WithinAbs(ARGOS_PI / 0.5247 - 2.0 * ARGOS_PI, 1e-10));
  CCI_EPuckProximitySensor::SReading sEPuck(0.5, CRadians::PI);
  CCI_EPuckProximitySensor::TReadings tEPuck(1, sEPuck);
  CHECK(tEPuck[0].Angle == CRadians::PI);

  CStepProximity cStep;
  CHECK(cStep.CalculateReading(0.01) == 1.0);
}

template <typename T>
std::string Logged(const T& t_value) {
  std::ostringstream cStream;
  CARGoSLog cLog(cStream, SLogColor(), false);
  cLog << t_value;
  cLog.Flush();
  return cStream.str();
}

TEST_CASE("compat: readings of every sensor can be logged", "[compat]") {
  CMyProximity cProximity;
  CHECK(Logged(cProximity.GetReadings()).substr(0, 7) == "{ 0.5 }");
  CMyFootBotProximity cFootBot;
  CHECK(Logged(cFootBot.GetReadings()).substr(0, 22) == "{ Value=<0.25>, Angle=");
  CHECK(Logged(CCI_FootBotMotorGroundSensor::SReading(0.5, CVector2(1.0, 2.0))) ==
        "Value=<0.5>, Offset=<1,2>");
  CHECK(Logged(CCI_FootBotBaseGroundSensor::TReadings(2)) ==
        "{ Value=<0>, Offset=<0,0> } { Value=<0>, Offset=<0,0> }\n");
  // the operator of the user, above
  CHECK(Logged(CCI_FootBotLightSensor::SReading(0.5, CRadians(0.25))) != "");
  CHECK(Logged(CCI_EyeBotLightSensor::TReadings()) == "\n");
  CHECK(Logged(CCI_EPuckProximitySensor::TReadings(1)).substr(0, 11) == "{ Value=<0>");
  CHECK(Logged(CCI_BatterySensor::SReading(1.0, 2.0)) == "AvailableCharge=<1>, TimeLeft=<2>");
  CHECK(Logged(CCI_PositioningSensor::SReading()) == "Position=<0,0,0>, Orientation=<0,0,0>");
  CHECK(Logged(CCI_DifferentialSteeringSensor::SReading(1.0, 2.0, 3.0, 4.0, 5.0)).substr(0, 21) ==
        "VelocityLeftWheel=<1>");
  CHECK(Logged(CCI_RangeAndBearingSensor::TReadings(1)).substr(0, 11) == "{ Range=<0>");
  CCI_ColoredBlobOmnidirectionalCameraSensor::SBlob sBlob(CColor::RED, CRadians::ZERO, 5.0);
  CCI_ColoredBlobOmnidirectionalCameraSensor::SReadings sReadings;
  sReadings.BlobList.push_back(&sBlob);
  CHECK(Logged(sBlob).substr(0, 11) == "Color=<red>");
  CHECK(Logged(sReadings.BlobList) == "{ " + Logged(sBlob) + " }\n");
  CHECK(Logged(sReadings) == Logged(sReadings.BlobList));
  CHECK(Logged(CCI_ColoredBlobPerspectiveCameraSensor::SBlob(CColor::RED, 1, 2)) ==
        "Color=<red>, X=<1>, Y=<2>");
}

}  // namespace control_interface_test
