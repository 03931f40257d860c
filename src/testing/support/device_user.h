#ifndef ARGOS3_TESTING_SUPPORT_DEVICE_USER_H
#define ARGOS3_TESTING_SUPPORT_DEVICE_USER_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/core/utility/math/vector2.h>

#include <functional>
#include <string>
#include <vector>

namespace argos {

/**
 * "device_user": uses every device of any robot.
 *
 * In each step it combines all readings into one number, the signal, and gives each actuator an
 * order that depends on it: so every bit of a reading moves the robot, lights its LEDs, ...
 *
 *   <params reads="true" radio_bytes="8" />
 *
 *   reads        if false, no sensor is read, and orders depend on the number of the step only.
 *   radio_bytes  length of the message that each simple radio sends in each step; with 0 the
 *                controller allocates no memory for it.
 */
class CDeviceUser : public CCI_Controller {
 public:
  /** @throws CARGoSException if the robot has a device that this class does not support. */
  void Init(TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

  /** Digest of every reading since the start. */
  UInt64 GetReadingsDigest() const { return m_readingsDigest.GetValue(); }
  /** Number of blobs, packets, messages, ... in all lists of variable length. */
  size_t CountSeen();

 private:
  template <typename SENSOR, typename READ>
  void Sense(const std::string& tag, READ read);
  template <typename SENSOR>
  void SenseNumbers(const std::string& tag);
  template <typename SENSOR>
  void SenseValues(const std::string& tag);
  template <typename ACTUATOR, typename ORDER>
  void Order(const std::string& tag, ORDER order);
  void UseRings();
  void UseCameras();
  void UseRadios();
  void UseTagsAndPheromones();
  void UseBodySensors();
  void UseMotors();
  void UseGrips();
  void UseLights();
  void CheckAllUsed() const;
  void AddReading(Real reading);

  bool m_reads = true;
  CByteArray m_radioMessage;
  CByteArray m_tagData;
  std::vector<std::function<void()>> m_senses, m_orders;
  CDigest m_readingsDigest;
  Real m_sum = 0.0;  // sum over the readings of this step
  Real m_signal = 0.0;  // in [-1,1]
  size_t m_seen = 0;  // length of the lists in this step
  UInt32 m_step = 0;
};

}  // namespace argos

#endif
