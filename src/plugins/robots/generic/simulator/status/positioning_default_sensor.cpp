#include <argos3/plugins/robots/generic/simulator/positioning_default_sensor.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>

namespace argos {

namespace {

enum : size_t { POSITION, ANGLE, AXIS };

}  // namespace

void CPositioningDefaultSensor::FindParts(CComposableEntity& robot) {
  m_body = &robot.GetComponent<CEmbodiedEntity>("body");
  m_sReading.Position = m_body->GetOriginAnchor().Position;
  m_sReading.Orientation = m_body->GetOriginAnchor().Orientation;
}

void CPositioningDefaultSensor::Configure(TConfigurationNode& tree) {
  m_noise.Init(tree, *m_robot, {"position", "angle", "axis"},
               {ReadNoiseRange(tree, "pos_noise_range"), ReadNoiseRange(tree, "angle_noise_range"),
                ReadNoiseRange(tree, "axis_noise_range")});
}

void CPositioningDefaultSensor::Update() {
  const SAnchor& origin = m_body->GetOriginAnchor();
  m_sReading.Position = origin.Position;
  m_sReading.Orientation = origin.Orientation;
  if (m_noise.IsOn()) {
    for (UInt32 axis = 0; axis < 3; ++axis) {
      m_sReading.Position[axis] = m_noise.Apply(POSITION, origin.Position[axis]);
    }
    if (m_noise.IsOn(ANGLE) || m_noise.IsOn(AXIS)) {
      AddNoiseToOrientation();
    }
  }
}

void CPositioningDefaultSensor::AddNoiseToOrientation() {
  CVector3 exactAxis;
  m_sReading.Orientation.ToAngleAxis(m_cAngle, exactAxis);
  m_cAngle.SetValue(m_noise.Apply(ANGLE, m_cAngle.GetValue()));
  for (UInt32 axis = 0; axis < 3; ++axis) {
    m_cAxis[axis] = m_noise.Apply(AXIS, exactAxis[axis]);
  }
  if (m_cAxis.SquareLength() > 0.0) {
    m_cAxis.Normalize();
  } else {
    m_cAxis = exactAxis;
  }
  m_sReading.Orientation.FromAngleAxis(m_cAngle, m_cAxis);
}

void CPositioningDefaultSensor::ResetReading() {
  m_sReading = SReading(m_body->GetInitPosition(), m_body->GetInitOrientation());
}

REGISTER_SENSOR(
    CPositioningDefaultSensor, "positioning", "default", "the authors of this project", "1.0",
    "The position and the orientation of a robot.",
    R"(Reads the position of the centre of the robot's base (m) and the orientation of its body, in the world
frame: exactly, unless noise is configured.
)" + RequiredSensorXML(R"(<positioning implementation="default" />)") +
        OptionalXML(R"(<positioning implementation="default"
               pos_noise_range="-0.1:0.2" angle_noise_range="-0.1:0.1" axis_noise_range="-0.3:0.4" />)") +
        R"(
  pos_noise_range    "min:max", m, default "0:0": a number drawn evenly from it is added to each
                     coordinate of the position in each tick.
  angle_noise_range  "min:max", rad, default "0:0": the orientation is a rotation by an angle about an
                     axis; a number drawn evenly from the range is added to the angle.
  axis_noise_range   "min:max", default "0:0": the same for each component of the axis, which has
                     length 1 before and afterwards.
)" +
        NoiseManual(
            "position|angle|axis",
            "each coordinate of the position (m), the angle (rad), each component of the axis."),
    "Usable")

}  // namespace argos
