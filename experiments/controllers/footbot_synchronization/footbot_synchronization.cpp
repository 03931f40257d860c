#include "footbot_synchronization.h"

#include <argos3/core/utility/configuration/argos_configuration.h>

using namespace argos;

namespace {

// a flash is seen one tick after its order: a robot ignores flashes for this time after its own, or
// it would respond to the robots that it has just triggered
constexpr UInt32 kRefractoryTicks = 2;

}  // namespace

void CFootBotSynchronization::Init(TConfigurationNode& params) {
  m_leds = GetActuator<CCI_LEDsActuator>("leds");
  m_camera =
      GetSensor<CCI_ColoredBlobOmnidirectionalCameraSensor>("colored_blob_omnidirectional_camera");
  GetNodeAttributeOrDefault(params, "period", m_period, m_period);
  GetNodeAttributeOrDefault(params, "coupling", m_coupling, m_coupling);
  if (m_period <= kRefractoryTicks) {
    THROW_ARGOSEXCEPTION("period is " << m_period << " ticks; it must be more than "
                                      << kRefractoryTicks);
  }
  if (!(m_coupling > 0.0)) {
    THROW_ARGOSEXCEPTION("coupling is " << m_coupling << "; it must be > 0");
  }
  m_rng = CRandom::CreateRNG("argos");
  Reset();
}

void CFootBotSynchronization::Reset() {
  // cameras start disabled
  m_camera->Enable();
  m_phase = m_rng->Uniform(CRange<Real>(0.0, 1.0));
  m_ticksSinceFlash = m_period;
}

bool CFootBotSynchronization::SeesFlash() const {
  const auto& blobs = m_camera->GetReadings().BlobList;
  return std::any_of(blobs.begin(), blobs.end(),
                     [](const auto* blob) { return blob->Color == CColor::RED; });
}

void CFootBotSynchronization::ControlStep() {
  m_phase += 1.0 / m_period;
  ++m_ticksSinceFlash;
  if (m_ticksSinceFlash > kRefractoryTicks && SeesFlash()) {
    m_phase *= 1.0 + m_coupling;
  }
  const bool flash = m_phase >= 1.0;
  if (flash) {
    m_phase = 0.0;
    m_ticksSinceFlash = 0;
  }
  m_leds->SetAllColors(flash ? CColor::RED : CColor::BLACK);
}

REGISTER_CONTROLLER(CFootBotSynchronization, "footbot_synchronization_controller")
