#include <argos3/plugins/robots/pi-puck/simulator/pipuck_imu_default_sensor.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_differential_drive_entity.h>

namespace argos {

namespace {

constexpr Real kGravity = 9.81;  // m/s^2

}  // namespace

void CPiPuckImuDefaultSensor::SetRobot(CComposableEntity& robot) {
  // throws unless the robot is a Pi-Puck
  robot.GetComponent<CPiPuckDifferentialDriveEntity>("differential_drive");
  m_motion.SetBody(robot.GetComponent<CEmbodiedEntity>("body"));
  Enable();
}

void CPiPuckImuDefaultSensor::Update() {
  const SAnchor& origin = m_motion.GetBody().GetOriginAnchor();
  const Real tick = m_tick.GetTickLength();
  const CQuaternion toBody = origin.Orientation.Inverse();
  CVector3 velocity = m_motion.ComputeStep() / tick;
  const CQuaternion turn = m_motion.ComputeTurn();
  // the step is in the frame of the last tick
  velocity.Rotate(origin.Orientation * turn.Inverse());
  m_cAccelerometer = (velocity - m_velocity) / tick + CVector3(0.0, 0.0, kGravity);
  m_cAccelerometer.Rotate(toBody);
  CRadians angle;
  CVector3 axis;
  turn.ToAngleAxis(angle, axis);
  m_cGryoscope = axis * (angle.SignedNormalize().GetValue() / tick);
  m_velocity = velocity;
  m_motion.Remember();
}

void CPiPuckImuDefaultSensor::Reset() {
  m_cAccelerometer = CVector3();
  m_cGryoscope = CVector3();
  m_velocity = CVector3();
  m_motion.RememberStart();
}

REGISTER_SENSOR(
    CPiPuckImuDefaultSensor, "pipuck_imu", "default", "the authors of this project", "1.0",
    "The inertial unit of the Pi-Puck.",
    R"(Reads the specific force, in m/s^2, which is (0,0,9.81) for a robot at rest on level ground, and the angular velocity, in
rad/s, both in the frame of the robot and from the motion of its body in the last two ticks. The magnetometer reads 0.
)" + RequiredSensorXML(R"(<pipuck_imu implementation="default" />)"),
    "Usable")

}  // namespace argos
