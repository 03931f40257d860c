#include <argos3/core/control_interface/ci_controller.h>

namespace argos {

CCI_Controller::~CCI_Controller() {
  for (auto& actuator : m_mapActuators) {
    delete actuator.second;
  }
  for (auto& sensor : m_mapSensors) {
    delete sensor.second;
  }
}

void CCI_Controller::Init(TConfigurationNode&) {}

void CCI_Controller::ControlStep() {}

void CCI_Controller::Reset() {}

void CCI_Controller::Destroy() {}

namespace {
template <typename MAP, typename DEVICE>
void AddDevice(MAP& devices, const std::string& type, DEVICE* device) {
  DEVICE*& place = devices[type];
  if (place != device) {
    delete place;
    place = device;
  }
}
}  // namespace

void CCI_Controller::AddActuator(const std::string& type, CCI_Actuator* actuator) {
  AddDevice(m_mapActuators, type, actuator);
}

void CCI_Controller::AddSensor(const std::string& type, CCI_Sensor* sensor) {
  AddDevice(m_mapSensors, type, sensor);
}

void CCI_Controller::ThrowDeviceMissing(const std::string& kind, const std::string& type,
                                        const std::vector<std::string>& types) const {
  std::string all;
  for (const std::string& known : types) {
    all += (all.empty() ? "" : ", ") + known;
  }
  const std::string near = NearestNames(type, types);
  THROW_ARGOSEXCEPTION("Robot \"" << m_strId << "\": its controller requests the " << kind << " \""
                                  << type << "\", which is not in the <" << kind
                                  << "s> section of the controller's XML"
                                  << (near.empty() ? "" : DidYouMean(type, types))
                                  << "; the section contains: " << (all.empty() ? "nothing" : all));
}

void CCI_Controller::ThrowDeviceOfOtherType(const std::string& kind, const std::string& type,
                                            const std::type_info& found,
                                            const std::type_info& expected) const {
  THROW_ARGOSEXCEPTION("Robot \"" << m_strId << "\": its controller requests the " << kind << " \""
                                  << type << "\" as a " << DemangledName(expected)
                                  << ", but the device in the XML is a " << DemangledName(found));
}

}  // namespace argos
