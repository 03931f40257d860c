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
 * "device_user": uses every device that it has, of whatever robot.
 *
 * In each step it reads all sensors into one number, the signal, and gives an order to each
 * actuator that depends on it: so every bit that is read moves the robot, lights its LEDs, ...
 *
 *   <params reads="true" radio_bytes="8" />
 *
 *   reads        false: no sensor is read, and orders depend on the number of the step alone.
 *   radio_bytes  of the message that each simple radio sends in each step; with 0 a controller need
 *                not ask for memory to send it.
 */
class CDeviceUser : public CCI_Controller {
 public:
  /** @throws CARGoSException if it does not know how to use a device that it has. */
  void Init(TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

  /** Digest of every reading since the start. */
  UInt64 GetFelt() const { return m_felt.GetValue(); }
  /** How many blobs, packets, messages, ... there are to read: all lists whose length varies. */
  size_t CountSeen();

 private:
  template <typename SENSOR, typename FEEL>
  void Sense(const std::string& tag, FEEL feel);
  template <typename SENSOR>
  void SenseNumbers(const std::string& tag);
  template <typename SENSOR>
  void SenseValues(const std::string& tag);
  template <typename ACTUATOR, typename ORDER>
  void Order(const std::string& tag, ORDER order);
  void UseRings();
  void UseCameras();
  void UseRadios();
  void UseTraces();
  void UseBodySensors();
  void UseMotors();
  void UseGrips();
  void UseLights();
  void CheckAllUsed() const;
  void Feel(Real reading);

  bool m_reads = true;
  CByteArray m_radioMessage;
  CByteArray m_tagData;
  std::vector<std::function<void()>> m_senses, m_orders;
  CDigest m_felt;
  Real m_sum = 0.0;  // of what is read in this step
  Real m_signal = 0.0;  // in [-1,1]
  size_t m_seen = 0;  // in this step
  UInt32 m_step = 0;
};

}  // namespace argos

#endif
