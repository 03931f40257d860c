#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_sensor.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/medium_attribute.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/robots/generic/simulator/units.h>
#include <argos3/plugins/simulator/media/pheromone_medium.h>

#include <algorithm>
#include <vector>

namespace argos {

namespace {

/** Reads the concentrations of a medium under the robot. */
class CPheromoneMediumSensor : public CSimulatedSensor, public CCI_PheromoneSensor {
 public:
  /** @throws CARGoSException if the robot has no "body" or "controller". */
  void SetRobot(CComposableEntity& robot) override {
    m_robot = &robot.GetComponent<CControllableEntity>("controller");
    m_body = &robot.GetComponent<CEmbodiedEntity>("body");
  }
  /** Reads `medium`, `layers`, `<point>` and `<noise>`. */
  void Init(TConfigurationNode& tree) override {
    CCI_PheromoneSensor::Init(tree);
    m_medium = &ReadMedium<CPheromoneMedium>(tree, m_robot->GetSimulator(), "a pheromone medium");
    m_layers = m_medium->ReadLayers(tree);
    TReadings readings;
    const auto addPoint = [&](const CVector2& offset) {
      m_points.emplace_back(offset.GetX(), offset.GetY(), 0.0);
      readings.push_back({0.0, offset * kCentimetersPerMeter});
    };
    TConfigurationNodeIterator child("point");
    for (child = child.begin(&tree); child != child.end(); ++child) {
      CVector2 offset;
      GetNodeAttribute(*child, "offset", offset);
      addPoint(offset);
    }
    if (m_points.empty()) {
      addPoint(CVector2());
    }
    for (const size_t layer : m_layers) {
      m_vecInterfaces.push_back({m_medium->GetLayerId(layer), readings});
    }
    m_noise.Init(tree, *m_robot, {"value"});
    Enable();
  }
  void Update() override {
    const SAnchor& origin = m_body->GetOriginAnchor();
    for (size_t point = 0; point < m_points.size(); ++point) {
      CVector3 place = m_points[point];
      place.Rotate(origin.Orientation);
      place += origin.Position;
      for (size_t i = 0; i < m_layers.size(); ++i) {
        const Real concentration = m_medium->GetConcentration(m_layers[i], place);
        m_vecInterfaces[i].Readings[point].Value = std::max(0.0, m_noise.Apply(0, concentration));
      }
    }
  }
  /** Sets all readings to 0 and restarts the noise. */
  void Reset() override {
    for (SInterface& interface : m_vecInterfaces) {
      for (SReading& reading : interface.Readings) {
        reading.Value = 0.0;
      }
    }
    m_noise.Reset();
  }

 private:
  CControllableEntity* m_robot = nullptr;
  CEmbodiedEntity* m_body = nullptr;
  CPheromoneMedium* m_medium = nullptr;
  std::vector<size_t> m_layers;  // numbers in the medium, (m_vecInterfaces)
  std::vector<CVector3> m_points;  // robot's frame, m
  CDeviceNoise m_noise;  // added to "value"
};

}  // namespace

REGISTER_SENSOR(
    CPheromoneMediumSensor, "pheromone", "medium", "the authors of this project", "1.0",
    "Reads the concentrations of substances on the ground.",
    R"(Reads the concentration of each layer of a pheromone medium, an amount per m^2, under points of the robot, after
the robots have moved and the deposits of this tick have spread. The concentration is interpolated between the centres of
cells. Works on any robot with a body, at any height; outside the medium's region the reading is 0.
)" + RequiredSensorXML(R"(<pheromone implementation="medium" medium="pheromone" />)") +
        MediumXML(R"(<pheromone id="pheromone">
      <layer id="trail" />
    </pheromone>)",
                  "a pheromone medium") +
        OptionalXML(R"(<pheromone implementation="medium" medium="pheromone" layers="trail">
    <point offset="0.04,0.02" />
    <point offset="0.04,-0.02" />
    <noise on="value" model="gaussian" std_dev="0.05" relative="true" />
  </pheromone>)") +
        R"(
  layers        ids of layers, separated by commas; default: all layers of the medium.
  point         any number of children; default: one at the robot's centre.
  point@offset  "x,y", m, required: in the robot's frame.
)" + NoiseManual("value", "each concentration; the sum is at least 0."),
    "Usable")

}  // namespace argos
