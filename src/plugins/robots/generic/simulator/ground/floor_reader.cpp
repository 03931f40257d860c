#include <argos3/plugins/robots/generic/simulator/floor_reader.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/simulator/entities/ground_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>

namespace argos {

namespace {

constexpr Real kWhite = 255.0;  // CColor::ToGrayScale() of white
constexpr Real kThreshold = 0.5;  // divides black from white

}  // namespace

void RequireFloor(const CControllableEntity& robot, TConfigurationNode& device) {
  CSpace& space = robot.GetSpace();
  if (!space.HasFloorEntity()) {
    // the floor may follow the robot in the file, or be created by the loop functions
    robot.GetSimulator().CheckWhenLoaded([&space, owner = OwnerOf(device)] {
      if (!space.HasFloorEntity()) {
        THROW_ARGOSEXCEPTION(owner << " needs a floor: add a <floor> element to <arena>");
      }
    });
  }
}

void CFloorReader::SetRobot(CComposableEntity& robot) {
  m_sensors = &robot.GetComponent<CGroundSensorEquippedEntity>("ground_sensors");
  m_space = &robot.GetComponent<CControllableEntity>("controller").GetSpace();
  m_sensors->Enable();
}

CControllableEntity& CFloorReader::GetRobot() const {
  return m_sensors->GetParent().GetComponent<CControllableEntity>("controller");
}

void CFloorReader::Init(TConfigurationNode& tree) {
  const CControllableEntity& robot = GetRobot();
  m_noise.Init(tree, robot, {"reading"},
               {m_readsNoiseLevel ? ReadNoiseLevel(tree) : CRange<Real>()});
  RequireFloor(robot, tree);
}

size_t CFloorReader::GetNumSensors() const {
  return m_sensors->GetNumSensors();
}

CFloorReader::CView CFloorReader::ViewFloor() {
  return CView(*this, m_sensors->GetLayout(), m_space->GetFloorEntity());
}

Real CFloorReader::CView::Read(size_t sensor, Real error) {
  const SGroundSensorPlace& place = m_layout.Places[sensor];
  const SAnchor& anchor = *m_reader.m_sensors->GetAnchors()[place.Anchor];
  CVector3 position(place.Offset.GetX(), place.Offset.GetY(), 0.0);
  position.Rotate(anchor.Orientation);
  position += anchor.Position;
  const CColor color = m_floor.GetColorAtPoint(position.GetX(), position.GetY());
  const Real reading = m_reader.m_noise.Apply(0, color.ToGrayScale() / kWhite) + error;
  if (place.Type == SGroundSensorPlace::TYPE_BLACK_WHITE) {
    return reading < kThreshold ? 0.0 : 1.0;
  }
  return std::clamp(reading, 0.0, 1.0);
}

}  // namespace argos
