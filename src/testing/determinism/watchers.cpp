#include <argos3/testing/determinism/watchers.h>

#include <argos3/core/utility/configuration/argos_configuration.h>
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
    </actuators>
    <sensors>
      <colored_blob_omnidirectional_camera implementation='rot_z_only' medium='leds' )" +
         shift + ">" + noise + R"(</colored_blob_omnidirectional_camera>
    </sensors>
    <params moving=')" +
         (moving ? "true" : "false") + R"(' />
  </watcher>)";
}

}  // namespace

void CWatcher::Init(TConfigurationNode& params) {
  GetNodeAttribute(params, "moving", m_moving);
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_leds = GetActuator<CCI_LEDsActuator>("leds");
  m_allAround =
      GetSensor<CCI_ColoredBlobOmnidirectionalCameraSensor>("colored_blob_omnidirectional_camera");
  m_allAround->Enable();
}

CVector2 CWatcher::SumUpSights() const {
  CVector2 sum;
  for (const auto* blob : m_allAround->GetReadings().BlobList) {
    const Real weight = blob->Color == CColor::RED ? 1.0 : -0.5;
    sum += CVector2(weight / (1.0 + blob->Distance), blob->Angle);
  }
  return sum;
}

void CWatcher::ControlStep() {
  const CVector2 sum = SumUpSights();
  const bool left = sum.GetY() > 0.0;
  m_leds->SetAllColors(left ? CColor::RED : CColor::GREEN);
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
  // one cell: LEDs that move change no list
  experiment.Media = moving ? "<led id='leds' />" : "<led id='leds' grid_size='1,1,1' />";
  const Real middle = 0.5 * kSpacing * (perRow - 1);
  for (UInt32 i = 0; i < robots; ++i) {
    const CVector3 place(kSpacing * (i % perRow) - middle,
                         kSpacing * static_cast<UInt32>(i / perRow) - middle, 0.0);
    experiment.Arena += "<foot-bot id='fb" + std::to_string(i) + "'><body " +
                        PoseText(place, 37.0 * i) + "/><controller config='watcher'/></foot-bot>";
  }
  experiment.Arena += LightText("lamp", CVector3(middle + 0.5, 0.0, 0.2), "yellow") +
                      BoxText("wall", CVector3(0.05, 1.0, 0.2), CVector3(middle + 0.3, 0.4, 0.0));
  return experiment;
}

}  // namespace argos

using argos::CWatcher;
REGISTER_CONTROLLER(CWatcher, "watcher")
