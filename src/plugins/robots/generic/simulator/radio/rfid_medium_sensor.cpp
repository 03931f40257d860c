#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/datatypes/spare_elements.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/generic/control_interface/ci_rfid_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/robots/generic/simulator/rfid_antenna.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace argos {

namespace {

constexpr Real kCentimetersPerMeter = 100.0;

/** Reads the tags that a medium finds near the robot. */
class CRFIDMediumSensor : public CSimulatedSensor, public CCI_RFIDSensor {
 public:
  void SetRobot(CComposableEntity& robot) override;
  /** Reads what CRFIDAntenna::Init() does, `miss_prob` and `<noise>`. @throws CARGoSException. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** No readings; noise starts over. */
  void Reset() override;

 private:
  enum EQuantity : UInt8 { DISTANCE, ANGLE };

  void Fill(SReading& reading, const CRFIDTagEntity& tag);
  void MakeStream();

  CRFIDAntenna m_antenna;
  Real m_missProbability = 0.0;
  std::unique_ptr<CRandomStream> m_stream;  // only if tags may be missed
  CDeviceNoise m_noise;  // on EQuantity
  std::vector<CRFIDMedium::SFound> m_found;
  CSpareElements<SReading> m_spare;
};

}  // namespace

void CRFIDMediumSensor::SetRobot(CComposableEntity& robot) {
  m_antenna.SetRobot(robot);
}

void CRFIDMediumSensor::Init(TConfigurationNode& tree) {
  CCI_RFIDSensor::Init(tree);
  m_antenna.Init(tree);
  GetNodeAttributeOrDefault(tree, "miss_prob", m_missProbability, m_missProbability);
  if (!(m_missProbability >= 0.0 && m_missProbability <= 1.0)) {
    THROW_ARGOSEXCEPTION(OwnerOf(tree) << ": attribute \"miss_prob\" must be in [0,1], got "
                                       << m_missProbability);
  }
  MakeStream();
  m_noise.Init(tree, m_antenna.GetRobot(), {"distance", "angle"});
  Enable();
}

void CRFIDMediumSensor::MakeStream() {
  if (m_missProbability > 0.0) {
    const CControllableEntity& robot = m_antenna.GetRobot();
    m_stream = std::make_unique<CRandomStream>(robot.GetSimulator().GetRandomSeed(), "argos",
                                               robot.GetRootEntity().GetId(), "rfid sensor");
  }
}

void CRFIDMediumSensor::Update() {
  m_antenna.GetMedium().FindTags(m_found, m_antenna.ComputePlace(), m_antenna.GetRange(),
                                 m_antenna.GetRobot().GetRootEntity());
  // readings of the last tick are overwritten, so that what they own stays allocated
  size_t numReadings = 0;
  for (const CRFIDMedium::SFound& found : m_found) {
    if (m_stream != nullptr && m_stream->Bernoulli(m_missProbability)) {
      continue;
    }
    if (numReadings == m_tReadings.size()) {
      m_spare.Append(m_tReadings);
    }
    Fill(m_tReadings[numReadings++], *found.Tag);
  }
  m_spare.Shrink(m_tReadings, numReadings);
}

void CRFIDMediumSensor::Fill(SReading& reading, const CRFIDTagEntity& tag) {
  reading.Id = tag.GetTagId();
  reading.Data = tag.GetData();
  const SAnchor& origin = m_antenna.GetBody().GetOriginAnchor();
  CVector3 way = tag.GetPosition() - origin.Position;
  way.Rotate(origin.Orientation.Inverse());
  const Real distance = kCentimetersPerMeter * std::hypot(way.GetX(), way.GetY());
  const CRadians angle = ATan2(way.GetY(), way.GetX());
  reading.Distance = std::max(0.0, m_noise.Apply(DISTANCE, distance));
  reading.Angle =
      m_noise.IsOn() ? CRadians(m_noise.Apply(ANGLE, angle.GetValue())).SignedNormalize() : angle;
}

void CRFIDMediumSensor::Reset() {
  m_spare.Shrink(m_tReadings, 0);
  MakeStream();
  m_noise.Reset();
}

REGISTER_SENSOR(
    CRFIDMediumSensor, "rfid", "medium", "the authors of this project", "1.0",
    "Reads the RFID tags near the robot.",
    R"(In each tick, after the robots have moved, every tag whose distance from the reader is at most the range is read,
through whatever is between, in the order in which tags were put into the arena; tags that the robot carries itself are
not. A reading has the tag's id and its whole memory, its distance from the robot's centre along the robot's xy plane in
cm, and its angle (0 ahead, counter-clockwise). Works on any robot with a body.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators />
      <sensors>
        <rfid implementation="medium" medium="rfid" />
      </sensors>
      <params />
    </my_controller>
  </controllers>

with the medium that it names:

  <media>
    <rfid id="rfid" />
  </media>

  medium  text, required: the id of an RFID medium.

OPTIONAL XML

  <rfid implementation="medium" medium="rfid" range="0.1" position="0.02,0,0" miss_prob="0.1">
    <noise on="distance" model="gaussian" std_dev="1" />
    <noise on="angle" model="uniform" level="0.2" />
  </rfid>

  range      m, >= 0, default 0.1: how far the reader reaches.
  position   "x,y,z", m, default "0,0,0": where the reader is, in the robot's frame.
  miss_prob  in [0,1], default 0: probability that a tag in reach is not read in a tick.
  noise      on="distance" (cm), "angle" (rad), or both without `on`; model="uniform" level, "gaussian" std_dev or
             "rayleigh" sigma; bias, relative="true".
)",
    "Usable")

}  // namespace argos
