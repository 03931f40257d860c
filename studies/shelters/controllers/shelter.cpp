#include "shelter.h"

#include <argos3/core/control_interface/metric_recorder.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/string_utilities.h>

#include <algorithm>
#include <cmath>

using namespace argos;

namespace {

const std::string kPrefix = "shelter";
constexpr UInt32 kDeafTicks = 50;  // longer than a signal runs to and fro between shelters
// image of the camera, pixels; its diagonal spans twice the aperture
constexpr Real kWidth = 640.0;
constexpr Real kHeight = 480.0;

}  // namespace

void CShelter::Init(TConfigurationNode& params) {
  m_ceiling = GetActuator<CCI_CeilingAttachmentActuator>("ceiling_attachment");
  m_leds = GetActuator<CCI_LEDsActuator>("leds");
  m_mouth = GetActuator<CCI_RangeAndBearingActuator>("range_and_bearing");
  m_ears = GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
  m_camera = GetSensor<CCI_ColoredBlobPerspectiveCameraSensor>("colored_blob_perspective_camera");
  m_number = FromString<UInt32>(GetId().substr(kPrefix.size()));
  GetNodeAttributeOrDefault(params, "range", m_range, m_range);
  GetNodeAttributeOrDefault(params, "capacity", m_capacity, m_capacity);
  GetNodeAttributeOrDefault(params, "leave_high", m_leaveHigh, m_leaveHigh);
  GetNodeAttributeOrDefault(params, "leave_low", m_leaveLow, m_leaveLow);
  GetNodeAttributeOrDefault(params, "delta", m_delta, m_delta);
  GetNodeAttributeOrDefault(params, "count_every", m_countEvery, m_countEvery);
  GetNodeAttributeOrDefault(params, "window", m_window, m_window);
  GetNodeAttributeOrDefault(params, "hops", m_hops, m_hops);
  GetNodeAttributeOrDefault(params, "height", m_height, m_height);
  GetNodeAttributeOrDefault(params, "aperture", m_aperture, m_aperture);
  std::string sizes = "25";
  GetNodeAttributeOrDefault(params, "sizes", sizes, sizes);
  ReadSizes(sizes);
  std::string events;
  GetNodeAttributeOrDefault(params, "events", events, events);
  ReadEvents(events);
  Reset();
}

void CShelter::ReadSizes(const std::string& sizes) {
  std::vector<std::string> values;
  Tokenize(sizes, values, ", ");
  if (values.empty()) {
    THROW_ARGOSEXCEPTION("the attribute \"sizes\" has no number");
  }
  m_size = FromString<UInt32>(values[std::min<size_t>(m_number, values.size() - 1)]);
  if (m_size > m_capacity) {
    THROW_ARGOSEXCEPTION("the target size is " << m_size << ", the capacity only " << m_capacity);
  }
}

void CShelter::ReadEvents(const std::string& events) {
  std::vector<std::string> words;
  Tokenize(events, words, " ");
  for (const std::string& word : words) {
    const size_t sign = word.find_first_of("+-");
    if (sign == std::string::npos) {
      THROW_ARGOSEXCEPTION("the event \"" << word << "\" must be like 2+500 or 1-2500");
    }
    if (FromString<UInt32>(word.substr(0, sign)) == m_number) {
      m_events.push_back({FromString<UInt32>(word.substr(sign + 1)), word[sign] == '+'});
    }
  }
  m_startsActive = m_events.empty() || !m_events.front().Activates;
}

void CShelter::Reset() {
  m_tick = 0;
  m_isActive = m_startsActive;
  m_ticksSinceReset = 0;
  m_deafTicks = 0;
  m_hopsToSend = 0;
  m_group = 0;
  m_windowTicks = 0;
  m_windowGroup = 0;
  m_isSteady = true;
  m_hasConverged = false;
  Show();
}

void CShelter::ControlStep() {
  m_ceiling->Attach();
  m_hopsToSend = 0;
  ++m_ticksSinceReset;
  HearResets();
  FollowEvents();
  Count();
  JudgeConvergence();
  Broadcast();
  ++m_tick;
}

void CShelter::FollowEvents() {
  for (const SEvent& event : m_events) {
    if (event.Tick == m_tick) {
      m_isActive = event.Activates;
      Restart(static_cast<UInt8>(std::min<UInt32>(m_hops, 255)));
      Show();
    }
  }
}

void CShelter::HearResets() {
  if (m_deafTicks > 0) {
    --m_deafTicks;
    return;
  }
  for (const CCI_RangeAndBearingSensor::SPacket& packet : m_ears->GetReadings()) {
    const UInt8 hops = SShelterMessage::Read(packet.Data).ResetHops;
    if (hops > 0) {
      Restart(hops - 1);
      return;
    }
  }
}

void CShelter::Restart(UInt8 hops) {
  m_ticksSinceReset = 0;
  m_hopsToSend = hops;
  m_deafTicks = kDeafTicks;
  m_windowTicks = 0;
  m_hasConverged = false;
}

void CShelter::Count() {
  // the camera is on for one tick of each period
  const UInt32 phase = m_tick % m_countEvery;
  if (phase == m_countEvery - 1) {
    m_camera->Enable();
  }
  if (phase != 0) {
    return;
  }
  m_camera->Disable();
  const Real halfDiagonal = std::hypot(kWidth, kHeight) / 2.0;
  const Real focus = halfDiagonal / std::tan(m_aperture * M_PI / 180.0);  // pixels
  const Real radius = focus * m_range / m_height;  // of the disc in the image, pixels
  m_group = 0;
  for (const SPerspectiveBlob* blob : m_camera->GetReadings().BlobList) {
    const Real distance = std::hypot(blob->X + 0.5 - kWidth / 2.0, blob->Y + 0.5 - kHeight / 2.0);
    if (blob->Color == CColor::RED && distance <= radius) {
      ++m_group;
    }
  }
}

void CShelter::JudgeConvergence() {
  if (m_windowTicks == 0) {
    m_windowGroup = m_group;
    m_isSteady = true;
  }
  // standard deviation of the number of robots that leave by chance in a window
  const Real tolerance = std::sqrt(m_window * m_windowGroup * m_leaveLow * (1.0 - m_leaveLow));
  const Real change = std::abs(static_cast<Real>(m_group) - static_cast<Real>(m_windowGroup));
  m_isSteady = m_isSteady && change <= tolerance;
  if (++m_windowTicks == m_window) {
    m_hasConverged = m_isSteady;
    m_windowTicks = 0;
  }
  if (m_isActive) {
    RecordMetric("converged", m_hasConverged ? 1.0 : 0.0);
  }
  Show();
}

void CShelter::Broadcast() {
  SShelterMessage message;
  message.IsActive = m_isActive;
  message.ResetHops = m_hopsToSend;
  if (m_isActive) {
    const Real gamma = std::log(10.0) / m_delta;
    message.Join = m_group < m_size ? static_cast<Real>(m_size) / m_capacity : 0.0;
    message.Leave = (m_leaveHigh - m_leaveLow) * std::exp(-gamma * m_ticksSinceReset) + m_leaveLow;
  }
  m_mouth->SetData(message.Write());
}

void CShelter::Show() {
  m_leds->SetAllColors(!m_isActive      ? CColor::BLACK
                       : m_hasConverged ? CColor::WHITE
                                        : CColor::YELLOW);
}

REGISTER_CONTROLLER(CShelter, "shelter")
