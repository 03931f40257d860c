#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/logging/argos_log.h>

#include "ci_microphone_sensor.h"

using namespace argos;

/* Prints what it hears. */
class CListener : public CCI_Controller {
 public:
  CListener() : m_pcMicrophone(NULL) {}
  virtual void Init(TConfigurationNode& t_node) {
    m_pcMicrophone = GetSensor<CCI_MicrophoneSensor>("microphone");
  }
  virtual void ControlStep() {
    LOG << "heard_by_" << GetId() << " " << m_pcMicrophone->GetLoudness() << std::endl;
  }

 private:
  CCI_MicrophoneSensor* m_pcMicrophone;
};

REGISTER_CONTROLLER(CListener, "listener")
