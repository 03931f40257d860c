#include <argos3/testing/determinism/comms_swarm.h>

#include <argos3/core/utility/math/vector2.h>

#include <cmath>
#include <sstream>

namespace argos {

namespace {

constexpr Real kSpeed = 8.0;  // cm/s

std::string Controller(bool noisy) {
  return std::string(R"(
  <chatter id='chatter'>
    <actuators>
      <differential_steering implementation='default' />
      <range_and_bearing implementation='default' />
    </actuators>
    <sensors>
      <range_and_bearing implementation='medium' medium='rab' )") +
         (noisy ? R"(noise_std_dev='0.01' packet_drop_prob='0.1'>
        <noise on='horizontal_bearing' model='gaussian' std_dev='0.05' />
      </range_and_bearing>)"
                : "/>") +
         R"(
    </sensors>
  </chatter>)";
}

std::string Arena(UInt32 robots, Real side) {
  std::ostringstream xml;
  const Real reach = 0.5 * side;
  const auto distribute = [&](UInt32 quantity, const std::string& entity) {
    xml << "<distribute><position method='uniform' min='" << -reach << "," << -reach << ",0' max='"
        << reach << "," << reach << ",0'/><orientation method='uniform' min='-180,0,0' "
        << "max='180,0,0'/><entity quantity='" << quantity << "' max_trials='1000'>" << entity
        << "</entity></distribute>\n";
  };
  distribute(robots / 10 + 1, "<box id='box' size='0.2,0.1,0.2' movable='false'/>");
  distribute(robots / 2,
             "<foot-bot id='fb' rab_range='0.8' rab_data_size='4'><controller config='chatter'/>"
             "</foot-bot>");
  distribute(robots - robots / 2,
             "<e-puck id='ep' rab_range='1.0' rab_data_size='4'><controller config='chatter'/>"
             "</e-puck>");
  return xml.str();
}

}  // namespace

void CChatter::Init(TConfigurationNode&) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_rabActuator = GetActuator<CCI_RangeAndBearingActuator>("range_and_bearing");
  m_rabSensor = GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
}

void CChatter::ControlStep() {
  CVector2 way(0.2, 0.0);
  UInt32 sum = static_cast<UInt32>(m_rabSensor->GetReadings().size());
  for (const auto& packet : m_rabSensor->GetReadings()) {
    const Real weight = (packet.Data[1] % 5 - 1.5) * 20.0 / (packet.Range + 1.0);
    way += CVector2(weight, packet.HorizontalBearing);
    // the order of the senders matters too
    sum = sum * 31 + packet.Data[0] + packet.Data[3];
  }
  m_rabActuator->SetData(0, static_cast<UInt8>(sum));
  m_rabActuator->SetData(1, static_cast<UInt8>(sum >> 8));
  m_rabActuator->SetData(3, static_cast<UInt8>(m_rabSensor->GetReadings().size()));
  const Real turn = Sin(way.Angle());
  m_wheels->SetLinearVelocity(kSpeed * (1.0 - turn), kSpeed * (1.0 + turn));
}

REGISTER_CONTROLLER(CChatter, "chatter")

SExperiment CommsSwarm(UInt32 robots, bool noisy, const std::string& rabAttributes) {
  const Real side = 0.4 * std::sqrt(static_cast<Real>(robots)) + 0.5;
  SExperiment experiment;
  experiment.Controllers = Controller(noisy);
  experiment.Engines = "<dynamics2d id='engine'/>";
  experiment.Media = "<range_and_bearing id='rab' " + rabAttributes + "/>";
  std::ostringstream size;
  size << side + 2.0 << "," << side + 2.0 << ",1";
  experiment.ArenaSize = size.str();
  experiment.Arena = Arena(robots, side);
  return experiment;
}

}  // namespace argos
