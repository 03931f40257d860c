#include "rab_chat.h"

#include <argos3/core/utility/math/general.h>

using namespace argos;

namespace {

constexpr size_t kMessageSize = 2;  // bytes
constexpr UInt8 kMaxHops = 255;

// white for 0 hops; then once through the spectrum
CColor ColorOf(UInt8 hops) {
  static const CColor kSpectrum[] = {CColor::RED,  CColor::ORANGE, CColor::YELLOW, CColor::GREEN,
                                     CColor::CYAN, CColor::BLUE,   CColor::PURPLE, CColor::MAGENTA};
  constexpr size_t kNum = std::size(kSpectrum);
  return hops == 0 ? CColor::WHITE : kSpectrum[Min<size_t>(hops - 1, kNum - 1)];
}

}  // namespace

void CRABChat::Init(TConfigurationNode&) {
  m_mouth = GetActuator<CCI_RangeAndBearingActuator>("range_and_bearing");
  m_ears = GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
  if (HasActuator("leds")) {
    m_leds = GetActuator<CCI_LEDsActuator>("leds");
  }
  if (m_mouth->GetSize() < kMessageSize) {
    THROW_ARGOSEXCEPTION("messages have " << m_mouth->GetSize() << " bytes; " << kMessageSize
                                          << " are needed (attribute rab_data_size of the robot)");
  }
  m_rng = CRandom::CreateRNG("argos");
  Reset();
}

void CRABChat::Reset() {
  m_own = static_cast<UInt8>(m_rng->Uniform(CRange<UInt32>(0, 256)));
  m_greatest = m_own;
  m_hops = 0;
}

void CRABChat::ControlStep() {
  for (const CCI_RangeAndBearingSensor::SPacket& packet : m_ears->GetReadings()) {
    const UInt8 number = packet.Data[0];
    const UInt8 hops = packet.Data[1];
    const bool greater = number > m_greatest;
    const bool nearer = number == m_greatest && hops + 1 < m_hops;
    if ((greater || nearer) && hops < kMaxHops) {
      m_greatest = number;
      m_hops = static_cast<UInt8>(hops + 1);
    }
  }
  Say();
}

void CRABChat::Say() {
  m_mouth->SetData(0, m_greatest);
  m_mouth->SetData(1, m_hops);
  if (m_leds != nullptr) {
    m_leds->SetAllColors(ColorOf(m_hops));
  }
}

REGISTER_CONTROLLER(CRABChat, "rab_chat_controller")
