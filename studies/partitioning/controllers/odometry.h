#ifndef ODOMETRY_H
#define ODOMETRY_H

#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_encoder_sensor.h>

/** Dead reckoning: where a robot believes it is, from the distances that its wheels rolled. */
class COdometry {
 public:
  /** The place and the heading of now become the origin and the x axis. */
  void Restart() {
    m_position = argos::CVector2();
    m_heading = argos::CRadians::ZERO;
  }

  /** Call it once per step. */
  void Update(const argos::CCI_FootBotEncoderSensor::SReading& reading) {
    const argos::Real left = reading.CoveredDistanceLeftWheel;
    const argos::Real right = reading.CoveredDistanceRightWheel;
    const argos::CRadians turn((right - left) / reading.WheelAxisLength);
    m_position += argos::CVector2((left + right) / 2.0, m_heading + turn / 2.0);
    m_heading += turn;
  }

  const argos::CVector2& GetPosition() const { return m_position; }  // cm
  argos::CRadians GetHeading() const { return m_heading; }

  /** Vector from the robot to a point of the plane of dead reckoning, in the robot's frame, cm. */
  argos::CVector2 To(const argos::CVector2& point) const {
    argos::CVector2 offset = point - m_position;
    return offset.Rotate(-m_heading);
  }

 private:
  argos::CVector2 m_position;  // cm
  argos::CRadians m_heading;
};

#endif
