#include <argos3/testing/determinism/watchers.h>

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_directional_led_detector_algorithm.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_led_detector_algorithm.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_tag_detector_algorithm.h>
#include <argos3/testing/support/arena_text.h>
#include <argos3/testing/support/robot_world.h>

#include <cmath>

namespace argos {

namespace {

constexpr Real kSpeed = 10.0;  // cm/s
constexpr Real kSpacing = 0.35;  // m, between robots

std::string Controller(bool moving, bool noisy) {
  const std::string noise =
      noisy ? "<noise model='gaussian' std_dev='0.02' relative='true' />" : "";
  const std::string shift = noisy ? "noise_std_dev='0.05'" : "";
  return R"(
  <watcher id='watcher'>
    <actuators>
      <differential_steering implementation='default' />
      <leds implementation='default' medium='leds' />
      <directional_leds implementation='default' />
      <tags implementation='default' />
      <pan_tilt_camera implementation='default' max_speed='90'>)" +
         noise + R"(</pan_tilt_camera>
    </actuators>
    <sensors>
      <colored_blob_omnidirectional_camera implementation='rot_z_only' medium='leds' )" +
         shift + ">" + noise + R"(</colored_blob_omnidirectional_camera>
      <colored_blob_perspective_camera implementation='default' medium='leds' )" +
         shift + ">" + noise + R"(</colored_blob_perspective_camera>
      <cameras implementation='default'>
        <camera id='rear' anchor='origin' position='-0.09,0,0.17' orientation='90,-90,0' range='0.05:2'
                focal_length='300,300' principal_point='320,240' resolution='640,480'>
          <led_detector medium='leds'>)" +
         noise + R"(</led_detector>
          <directional_led_detector medium='directional_leds'>)" +
         noise + R"(</directional_led_detector>
          <tag_detector medium='tags'>)" +
         noise + R"(</tag_detector>
        </camera>
      </cameras>
    </sensors>
    <params moving=')" +
         (moving ? "true" : "false") + R"(' />
  </watcher>)";
}

// components of every robot
const char* const kMounted = R"(
  <directional_leds medium='directional_leds'>
    <directional_led position='0.09,0,0.2' orientation='0,90,0' anchor='origin' observable_angle='70' color='red' />
    <directional_led position='-0.09,0,0.2' orientation='0,-90,0' anchor='turret' observable_angle='70' />
  </directional_leds>
  <tags medium='tags'>
    <tag position='0.1,0,0.2' orientation='90,90,0' anchor='origin' observable_angle='60' side_length='0.03' />
  </tags>)";

template <typename ALGORITHM>
const auto& ReadingsOf(const CCI_CameraSensor& cameras, size_t algorithm) {
  return dynamic_cast<const ALGORITHM&>(*cameras.GetInterfaces()[0].Algorithms[algorithm])
      .GetReadings();
}

const auto& LEDsIn(const CCI_CameraSensor& cameras) {
  return ReadingsOf<CCI_CameraSensorLEDDetectorAlgorithm>(cameras, 0);
}

const auto& SignalsIn(const CCI_CameraSensor& cameras) {
  return ReadingsOf<CCI_CameraSensorDirectionalLEDDetectorAlgorithm>(cameras, 1);
}

const auto& TagsIn(const CCI_CameraSensor& cameras) {
  return ReadingsOf<CCI_CameraSensorTagDetectorAlgorithm>(cameras, 2);
}

}  // namespace

void CWatcher::Init(TConfigurationNode& params) {
  GetNodeAttribute(params, "moving", m_moving);
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_leds = GetActuator<CCI_LEDsActuator>("leds");
  m_signals = GetActuator<CCI_DirectionalLEDsActuator>("directional_leds");
  m_tags = GetActuator<CCI_TagsActuator>("tags");
  m_head = GetActuator<CCI_PanTiltCameraActuator>("pan_tilt_camera");
  m_allAround =
      GetSensor<CCI_ColoredBlobOmnidirectionalCameraSensor>("colored_blob_omnidirectional_camera");
  m_ahead = GetSensor<CCI_ColoredBlobPerspectiveCameraSensor>("colored_blob_perspective_camera");
  m_cameras = GetSensor<CCI_CameraSensor>("cameras");
  m_allAround->Enable();
  m_ahead->Enable();
  m_cameras->Enable();
}

CWatcher::SSights CWatcher::CountSights() const {
  return {m_allAround->GetReadings().BlobList.size() + m_ahead->GetReadings().BlobList.size() +
              LEDsIn(*m_cameras).size(),
          SignalsIn(*m_cameras).size(), TagsIn(*m_cameras).size()};
}

// direction to the lights, weighted by colour, and mean positions in
// the images of the other cameras
CVector2 CWatcher::SumUpSights() const {
  CVector2 sum;
  for (const auto* blob : m_allAround->GetReadings().BlobList) {
    const Real weight = blob->Color == CColor::RED ? 1.0 : -0.5;
    sum += CVector2(weight / (1.0 + blob->Distance), blob->Angle);
  }
  for (const auto* blob : m_ahead->GetReadings().BlobList) {
    sum += CVector2(0.01, 1e-5 * (320 - blob->X));
  }
  for (const auto& led : LEDsIn(*m_cameras)) {
    sum += CVector2(-0.01, 1e-5 * (led.Center.GetX() - 320.0));
  }
  for (const auto& led : SignalsIn(*m_cameras)) {
    sum += CVector2(-0.1, 1e-4 * (led.Center.GetX() - 320.0));
  }
  for (const auto& tag : TagsIn(*m_cameras)) {
    const Real weight = tag.Payload == "left" ? 1.0 : 2.0;
    sum += CVector2(-0.1, weight * 1e-4 * (tag.Corners[1].GetX() - 320.0));
  }
  return sum;
}

void CWatcher::Show(const CVector2& sum) {
  static const std::string kLeft = "left";
  static const std::string kRight = "to the right, with a long text";
  const bool left = sum.GetY() > 0.0;
  m_leds->SetAllColors(left ? CColor::RED : CColor::GREEN);
  m_signals->SetAllColors(left ? CColor::BLUE : CColor::YELLOW);
  m_tags->SetAllPayloads(left ? kLeft : kRight);
  m_head->SetPan(CRadians(std::atan(sum.GetY())));
  m_head->SetTilt(CRadians(left ? 0.1 : 0.0));
}

void CWatcher::ControlStep() {
  const CVector2 sum = SumUpSights();
  Show(sum);
  if (m_moving) {
    const Real turn = 0.5 * kSpeed * std::tanh(sum.GetY());
    m_wheels->SetLinearVelocity(0.5 * kSpeed - turn, 0.5 * kSpeed + turn);
  } else {
    m_wheels->SetLinearVelocity(-0.3 * kSpeed, 0.3 * kSpeed);
  }
}

SExperiment Watchers(UInt32 robots, bool moving, bool noisy) {
  const auto perRow = static_cast<UInt32>(std::ceil(std::sqrt(static_cast<Real>(robots))));
  SExperiment experiment;
  experiment.Controllers = Controller(moving, noisy);
  experiment.Engines = "<dynamics2d id='engine' />";
  experiment.Media = "<led id='leds' /><directional_led id='directional_leds' /><tag id='tags' />";
  const Real middle = 0.5 * kSpacing * (perRow - 1);
  for (UInt32 i = 0; i < robots; ++i) {
    const CVector3 place(kSpacing * (i % perRow) - middle,
                         kSpacing * static_cast<UInt32>(i / perRow) - middle, 0.0);
    experiment.Arena += "<foot-bot id='fb" + std::to_string(i) + "'><body " +
                        PoseText(place, 37.0 * i) + "/><controller config='watcher'/>" + kMounted +
                        "</foot-bot>";
  }
  experiment.Arena += LightText("lamp", CVector3(middle + 0.5, 0.0, 0.2), "yellow") +
                      BoxText("wall", CVector3(0.05, 1.0, 0.2), CVector3(middle + 0.3, 0.4, 0.0));
  return experiment;
}

}  // namespace argos

using argos::CWatcher;
REGISTER_CONTROLLER(CWatcher, "watcher")
