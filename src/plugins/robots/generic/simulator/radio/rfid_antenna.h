#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RADIO_RFID_ANTENNA_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RADIO_RFID_ANTENNA_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/simulator/media/rfid_medium.h>

#include <memory>

namespace argos {

class CComposableEntity;
class CControllableEntity;
class CEmbodiedEntity;

/** Position and range of an RFID reader or writer on a robot. */
class CRFIDAntenna {
 public:
  /** @throws CARGoSException if the robot has no "body" or "controller". */
  void SetRobot(CComposableEntity& robot);
  /**
   * Reads `medium`, `range` (m, default 0.1) and `position` (in the robot's frame, m, default the
   * origin).
   * @throws CARGoSException if a value is invalid.
   */
  void Init(TConfigurationNode& tree);

  CControllableEntity& GetRobot() const { return *m_robot; }
  CEmbodiedEntity& GetBody() const { return *m_body; }
  CRFIDMedium& GetMedium() const { return *m_medium; }
  /** @return the record of the device in the medium. */
  CRFIDMedium::CUser& GetUser() const { return *m_user; }
  /** m. */
  Real GetRange() const { return m_range; }
  /** @return the position of the antenna, m, world frame. */
  CVector3 ComputePlace() const;

 private:
  CControllableEntity* m_robot = nullptr;
  CEmbodiedEntity* m_body = nullptr;
  CRFIDMedium* m_medium = nullptr;
  std::unique_ptr<CRFIDMedium::CUser> m_user;
  Real m_range = 0.1;  // m
  CVector3 m_position;  // robot's frame, m
};

}  // namespace argos

#endif
