#include <argos3/testing/determinism/comms_swarm.h>

#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/math/vector2.h>

#include <cmath>
#include <sstream>

namespace argos {

namespace {

constexpr Real kSpeed = 8.0;  // cm/s

std::string Controller(bool noisy, bool withRadio) {
  return std::string(R"(
  <chatter id='chatter'>
    <actuators>
      <differential_steering implementation='default' />
      <range_and_bearing implementation='default' />
      <simple_radios implementation='default' />
      <rfid implementation='medium' medium='rfid' range='0.3' />
      <pheromone implementation='medium' medium='scents' />
    </actuators>
    <sensors>
      <range_and_bearing implementation='medium' medium='rab' )") +
         (noisy ? R"(noise_std_dev='0.01' packet_drop_prob='0.1'>
        <noise on='horizontal_bearing' model='gaussian' std_dev='0.05' />
      </range_and_bearing>)"
                : "/>") +
         R"(
      <simple_radios implementation='default' />
      <rfid implementation='medium' medium='rfid' range='0.4' )" +
         (noisy ? "miss_prob='0.1'" : "") + R"(/>
      <pheromone implementation='medium' medium='scents' layers='trail'>
        <point offset='0.05,0.03' /><point offset='0.05,-0.03' />)" +
         (noisy ? "<noise on='value' model='gaussian' std_dev='0.1' relative='true' />" : "") + R"(
      </pheromone>
    </sensors>
    <params radio=')" +
         (withRadio ? "true" : "false") + R"(' />
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
  distribute(robots / 10 + 1,
             "<box id='box' size='0.2,0.1,0.2' movable='false'><rfid_tags medium='rfid'>"
             "<rfid_tag memory='4'/></rfid_tags></box>");
  const std::string parts =
      "<controller config='chatter'/><simple_radios><simple_radio id='wifi' medium='radios' "
      "range='0.7'/></simple_radios>";
  distribute(robots / 2,
             "<foot-bot id='fb' rab_range='0.8' rab_data_size='4'>" + parts + "</foot-bot>");
  distribute(robots - robots / 2,
             "<e-puck id='ep' rab_range='1.0' rab_data_size='4'>" + parts + "</e-puck>");
  CRandomStream random(1, "test", "comms swarm", "tags");
  for (UInt32 i = 0; i < robots / 2; ++i) {
    xml << "<rfid_tag id='tag_" << i << "' medium='rfid' memory='4' position='"
        << random.Uniform(-reach, reach) << "," << random.Uniform(-reach, reach) << ",0'/>\n";
  }
  return xml.str();
}

}  // namespace

void CChatter::Init(TConfigurationNode& params) {
  GetNodeAttribute(params, "radio", m_withRadio);
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_rabActuator = GetActuator<CCI_RangeAndBearingActuator>("range_and_bearing");
  m_rabSensor = GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
  m_radioActuator = GetActuator<CCI_SimpleRadiosActuator>("simple_radios");
  m_radioSensor = GetSensor<CCI_SimpleRadiosSensor>("simple_radios");
  m_tagActuator = GetActuator<CCI_RFIDActuator>("rfid");
  m_tagSensor = GetSensor<CCI_RFIDSensor>("rfid");
  m_scentActuator = GetActuator<CCI_PheromoneActuator>("pheromone");
  m_scents = &GetSensor<CCI_PheromoneSensor>("pheromone")->GetReadings("trail");
  m_message = CByteArray(2);
}

void CChatter::ControlStep() {
  CVector2 way(0.2, 0.0);
  const UInt32 sum = Listen(way);
  Speak(sum);
  const Real turn = Sin(way.Angle());
  m_wheels->SetLinearVelocity(kSpeed * (1.0 - turn), kSpeed * (1.0 + turn));
}

// combines all packets, messages, tags and concentrations into one
// number that depends on their order
UInt32 CChatter::Listen(CVector2& way) const {
  UInt32 sum = static_cast<UInt32>(m_rabSensor->GetReadings().size());
  for (const auto& packet : m_rabSensor->GetReadings()) {
    const Real weight = (packet.Data[1] % 5 - 1.5) * 20.0 / (packet.Range + 1.0);
    way += CVector2(weight, packet.HorizontalBearing);
    sum = sum * 31 + packet.Data[0] + packet.Data[3];
  }
  for (const CByteArray& message : m_radioSensor->GetInterfaces()[0].Messages) {
    sum = sum * 31 + message[0];
  }
  for (const auto& tag : m_tagSensor->GetReadings()) {
    way += CVector2(0.01 * (tag.Data[0] % 3), tag.Angle);
    sum = sum * 31 + tag.Data[1] + static_cast<UInt32>(tag.Distance * 1000.0);
  }
  const Real left = (*m_scents)[0].Value;
  const Real right = (*m_scents)[1].Value;
  way += CVector2(0.0, 0.3 * (left - right) / (left + right + 1.0));
  return sum;
}

void CChatter::Speak(UInt32 sum) {
  m_rabActuator->SetData(0, static_cast<UInt8>(sum));
  m_rabActuator->SetData(1, static_cast<UInt8>(sum >> 8));
  m_rabActuator->SetData(3, static_cast<UInt8>(m_rabSensor->GetReadings().size()));
  m_message[0] = static_cast<UInt8>(sum >> 3);
  m_message[1] = static_cast<UInt8>(sum >> 11);
  if (m_withRadio && sum % 3 == 0) {
    m_radioActuator->GetInterfaces()[0].Messages.push_back(m_message);
  }
  m_tagActuator->Write(m_message, sum % 3);
  for (CCI_PheromoneActuator::SInterface& layer : m_scentActuator->GetInterfaces()) {
    layer.Rate = 0.01 * (sum % 7);
  }
}

REGISTER_CONTROLLER(CChatter, "chatter")

SExperiment CommsSwarm(UInt32 robots, bool noisy, const std::string& mediaAttributes,
                       bool withRadio) {
  const Real side = 0.4 * std::sqrt(static_cast<Real>(robots)) + 0.5;
  SExperiment experiment;
  experiment.Controllers = Controller(noisy, withRadio);
  experiment.Engines = "<dynamics2d id='engine'/>";
  experiment.Media =
      "<range_and_bearing id='rab' " + mediaAttributes + "/><simple_radio id='radios' " +
      mediaAttributes + "/><rfid id='rfid' " + mediaAttributes +
      "/><pheromone id='scents'><layer id='trail' evaporation='0.2' "
      "diffusion='0.002'/><layer id='haze' diffusion='0.5' maximum='2'/></pheromone>";
  std::ostringstream size;
  size << side + 2.0 << "," << side + 2.0 << ",1";
  experiment.ArenaSize = size.str();
  experiment.Arena = Arena(robots, side);
  return experiment;
}

}  // namespace argos
