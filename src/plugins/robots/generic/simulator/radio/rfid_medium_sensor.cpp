#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/generic/control_interface/ci_rfid_sensor.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/robots/generic/simulator/rfid_antenna.h>
#include <argos3/plugins/robots/generic/simulator/units.h>
#include <argos3/plugins/simulator/entities/spare_elements.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace argos {

namespace {

/** Reads the tags that the medium finds near the robot. */
class CRFIDMediumSensor : public CSimulatedSensor, public CCI_RFIDSensor {
 public:
  void SetRobot(CComposableEntity& robot) override { m_antenna.SetRobot(robot); }
  /** Reads the attributes of CRFIDAntenna::Init(), `miss_prob` and `<noise>`. */
  void Init(TConfigurationNode& tree) override {
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
  void Update() override {
    m_antenna.GetMedium().FindTags(m_found, m_antenna.ComputePlace(), m_antenna.GetRange(),
                                   m_antenna.GetRobot().GetRootEntity());
    // readings of the last tick are overwritten: their memory remains allocated
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
  /** Clears the readings and restarts the noise. */
  void Reset() override {
    m_spare.Shrink(m_tReadings, 0);
    MakeStream();
    m_noise.Reset();
  }

 private:
  enum EQuantity : UInt8 { DISTANCE, ANGLE };

  void Fill(SReading& reading, const CRFIDTagEntity& tag) {
    reading.Id = tag.GetTagId();
    reading.Data = tag.GetData();
    const SAnchor& origin = m_antenna.GetBody().GetOriginAnchor();
    CVector3 way = m_antenna.GetRobot().GetSpace().GetContext().Arena.Period.Shorten(
        tag.GetPosition() - origin.Position);
    way.Rotate(origin.Orientation.Inverse());
    const Real distance = kCentimetersPerMeter * std::hypot(way.GetX(), way.GetY());
    const CRadians angle = ATan2(way.GetY(), way.GetX());
    reading.Distance = std::max(0.0, m_noise.Apply(DISTANCE, distance));
    reading.Angle =
        m_noise.IsOn() ? CRadians(m_noise.Apply(ANGLE, angle.GetValue())).SignedNormalize() : angle;
  }
  void MakeStream() {
    if (m_missProbability > 0.0) {
      const CControllableEntity& robot = m_antenna.GetRobot();
      m_stream = std::make_unique<CRandomStream>(robot.GetSimulator().GetRandomSeed(), "argos",
                                                 robot.GetRootEntity().GetId(), "rfid sensor");
    }
  }

  CRFIDAntenna m_antenna;
  Real m_missProbability = 0.0;
  std::unique_ptr<CRandomStream> m_stream;  // null if no tag may be missed
  CDeviceNoise m_noise;  // added to EQuantity
  std::vector<CRFIDMedium::SFound> m_found;
  CSpareElements<SReading> m_spare;
};

}  // namespace

REGISTER_SENSOR(
    CRFIDMediumSensor, "rfid", "medium", "the authors of this project", "1.0",
    "Reads the RFID tags near the robot.",
    R"(In each tick, after the robots have moved, the sensor reads every tag within the range of the reader, also
through bodies, in the order in which the tags were added to the arena. It does not read tags on the robot itself. A
reading contains the tag's id and its whole memory, its distance from the robot's centre along the robot's xy plane in
cm, and its angle (0 ahead, counter-clockwise). Works on any robot with a body.
)" + RequiredSensorXML(R"(<rfid implementation="medium" medium="rfid" />)") +
        MediumXML(R"(<rfid id="rfid" />)", "an RFID medium") +
        OptionalXML(
            R"(<rfid implementation="medium" medium="rfid" range="0.1" position="0.02,0,0" miss_prob="0.1">
    <noise on="distance" model="gaussian" std_dev="1" />
    <noise on="angle" model="uniform" level="0.2" />
  </rfid>)") +
        R"(
  range      m, >= 0, default 0.1: range of the reader.
  position   "x,y,z", m, default "0,0,0": position of the reader in the robot's frame.
  miss_prob  in [0,1], default 0: probability that a tag within range is not read in a tick.
)" + NoiseManual("distance|angle", "the distance (cm) and the angle (rad)."),
    "Usable")

}  // namespace argos
