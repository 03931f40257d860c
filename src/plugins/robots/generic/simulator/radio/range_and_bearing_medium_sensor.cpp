#include <argos3/plugins/robots/generic/simulator/range_and_bearing_medium_sensor.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/memory/load_ahead.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/medium_attribute.h>
#include <argos3/plugins/robots/generic/simulator/units.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>
#include <argos3/plugins/simulator/media/rab_medium.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <typeinfo>

namespace argos {

namespace {

// number of packets by which the data of a sender are loaded ahead
constexpr std::ptrdiff_t kSendersAhead = 12;

}  // namespace

CRangeAndBearingMediumSensor::CRangeAndBearingMediumSensor()
    : m_pcControllableEntity(m_robot), m_cSpace(CurrentSpace()) {}

void CRangeAndBearingMediumSensor::FindParts(CComposableEntity& robot) {
  m_pcRangeAndBearingEquippedEntity = &robot.GetComponent<CRABEquippedEntity>("rab");
}

void CRangeAndBearingMediumSensor::Configure(TConfigurationNode& tree) {
  m_medium = &ReadMedium<CRABMedium>(tree, m_robot->GetSimulator(), "a range and bearing medium");
  GetNodeAttributeOrDefault(tree, "show_rays", m_bShowRays, m_bShowRays);
  GetNodeAttributeOrDefault(tree, "noise_std_dev", m_fDistanceNoiseStdDev, m_fDistanceNoiseStdDev);
  RequireNotNegative(m_fDistanceNoiseStdDev, OwnerOf(tree), "attribute \"noise_std_dev\" (m)");
  GetNodeAttributeOrDefault(tree, "packet_drop_prob", m_fPacketDropProb, m_fPacketDropProb);
  if (!(m_fPacketDropProb >= 0.0 && m_fPacketDropProb <= 1.0)) {
    THROW_ARGOSEXCEPTION(OwnerOf(tree) << ": attribute \"packet_drop_prob\" must be in [0,1], got "
                                       << m_fPacketDropProb);
  }
  if (m_fDistanceNoiseStdDev > 0.0 || m_fPacketDropProb > 0.0) {
    GetStream();
    if (typeid(*this) != typeid(CRangeAndBearingMediumSensor)) {
      m_pcRNG = CRandom::CreateRNG("argos");
    }
  }
  m_noise.Init(tree, *m_robot, {"range", "horizontal_bearing", "vertical_bearing"});
  m_pcRangeAndBearingEquippedEntity->SetMedium(*m_medium);
  m_pcRangeAndBearingEquippedEntity->Enable();
}

void CRangeAndBearingMediumSensor::Update() {
  const CRABMedium::SNumbers senders = m_medium->GetSenders(*m_pcRangeAndBearingEquippedEntity);
  const CRABEquippedEntity* const* const devices = m_medium->GetDevices();
  const CQuaternion toReceiver = m_pcRangeAndBearingEquippedEntity->GetOrientation().Inverse();
  const auto loadAhead = [&](UInt32 number) {
    if (const CRABEquippedEntity* const sender = devices[number]) {
      LoadAhead(sender->GetPosition());
      LoadAhead(sender->GetData());
    }
  };
  const auto ahead = std::min<std::ptrdiff_t>(kSendersAhead, senders.Last - senders.First);
  std::for_each(senders.First, senders.First + ahead, loadAhead);
  // packets of the last tick are overwritten: their bytes remain allocated
  size_t numPackets = 0;
  for (const UInt32* number = senders.First; number != senders.Last; ++number) {
    if (senders.Last - number > ahead) {
      loadAhead(number[ahead]);
    }
    const CRABEquippedEntity* const sender = devices[*number];
    if (sender == nullptr ||
        (m_fPacketDropProb > 0.0 && GetStream().Bernoulli(m_fPacketDropProb))) {
      continue;
    }
    if (numPackets == m_tReadings.size()) {
      m_spare.Append(m_tReadings, [this](SPacket& packet) {
        packet.Data.Resize(m_pcRangeAndBearingEquippedEntity->GetMsgSize());
      });
    }
    ReadFrom(*sender, toReceiver, m_tReadings[numPackets++]);
  }
  m_spare.Shrink(m_tReadings, numPackets);
}

void CRangeAndBearingMediumSensor::ReadFrom(const CRABEquippedEntity& sender,
                                            const CQuaternion& toReceiver, SPacket& packet) {
  packet.Data = sender.GetData();
  const CVector3& place = m_pcRangeAndBearingEquippedEntity->GetPosition();
  const CVector3 senderPlace =
      m_cSpace.GetContext().Arena.Period.FindNearest(sender.GetPosition(), place);
  CVector3 way = senderPlace - place;
  if (m_bShowRays) {
    m_robot->AddCheckedRay(false, CRay3(senderPlace, place));
  }
  if (m_fDistanceNoiseStdDev > 0.0) {
    way += DrawError();
  }
  way.Rotate(toReceiver);
  packet.Range = way.Length() * kCentimetersPerMeter;
  packet.HorizontalBearing = ATan2(way.GetY(), way.GetX());
  // common case: both robots are on the same plane
  packet.VerticalBearing =
      way.GetZ() == 0.0
          ? CRadians()
          : ATan2(way.GetZ(), std::sqrt(way.GetX() * way.GetX() + way.GetY() * way.GetY()));
  if (m_noise.IsOn()) {
    AddNoise(packet);
  }
}

// a vector of random length and direction, m
CVector3 CRangeAndBearingMediumSensor::DrawError() {
  CRandomStream& stream = GetStream();
  const Real length = stream.Gaussian(m_fDistanceNoiseStdDev);
  const CRadians inclination(stream.Uniform(0.0, ARGOS_PI));
  const CRadians azimuth(stream.Uniform(0.0, 2.0 * ARGOS_PI));
  CVector3 error;
  error.FromSphericalCoords(length, inclination, azimuth);
  return error;
}

void CRangeAndBearingMediumSensor::AddNoise(SPacket& packet) {
  packet.Range = std::max(0.0, m_noise.Apply(RANGE, packet.Range));
  packet.HorizontalBearing =
      CRadians(m_noise.Apply(HORIZONTAL_BEARING, packet.HorizontalBearing.GetValue()))
          .SignedNormalize();
  const Real elevation = m_noise.Apply(VERTICAL_BEARING, packet.VerticalBearing.GetValue());
  packet.VerticalBearing = CRadians(std::clamp(elevation, -0.5 * ARGOS_PI, 0.5 * ARGOS_PI));
}

void CRangeAndBearingMediumSensor::ResetReading() {
  m_spare.Shrink(m_tReadings, 0);
  if (m_stream != nullptr) {
    m_stream.reset();
    GetStream();
  }
}

CRandomStream& CRangeAndBearingMediumSensor::GetStream() {
  if (m_stream == nullptr) {
    m_stream = std::make_unique<CRandomStream>(m_robot->GetSimulator().GetRandomSeed(), "argos",
                                               m_robot->GetRootEntity().GetId(),
                                               "range and bearing sensor");
  }
  return *m_stream;
}

REGISTER_SENSOR(
    CRangeAndBearingMediumSensor, "range_and_bearing", "medium", "the authors of this project",
    "1.0", "Receives messages from robots nearby, with range and bearing of the senders.",
    R"(In each tick, the robot receives the messages that its medium delivers from the robots around it, in the order
in which the robots were added to the arena. A packet contains the bytes of the message, the range of the sender in cm,
its horizontal bearing (in (-PI,PI], 0 ahead, counter-clockwise) and its vertical bearing (in [-PI/2,PI/2], positive
if the sender is above the robot's xy plane). A robot that has the sensor and no actuator sends zeros.
)" + RequiredSensorXML(R"(<range_and_bearing implementation="medium" medium="rab" />)") +
        MediumXML(R"(<range_and_bearing id="rab" />)", "a medium for range and bearing") +
        OptionalXML(
            R"(<range_and_bearing implementation="medium" medium="rab" show_rays="true" noise_std_dev="0.1"
                     packet_drop_prob="0.2">
    <noise on="range" model="gaussian" std_dev="2" />
    <noise on="horizontal_bearing" model="uniform" level="0.05" />
  </range_and_bearing>)") +
        R"(
  show_rays         "true" or "false", default "false": visualizations show lines to the senders.
  noise_std_dev     m, s >= 0, default 0: a random vector is added to the vector from the robot to the sender: its
                    length is drawn from N(0,s), its inclination from U[0,PI] and its azimuth from U[0,2 PI].
  packet_drop_prob  in [0,1], default 0: probability that a packet is lost.
)" +
        NoiseManual("range|horizontal_bearing|vertical_bearing",
                    "the range (cm) and the bearings (rad)."),
    "Usable")

}  // namespace argos
