#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/text/lists.h>

#include <cxxabi.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <typeinfo>

namespace argos {

CCI_Controller::CCI_Controller(const CCI_Controller& other)
    : CBaseConfigurableResource(other),
      CSlabObject(other),
      m_mapActuators(other.m_mapActuators),
      m_mapSensors(other.m_mapSensors),
      m_strId(other.m_strId),
      m_isCopy(true) {}

CCI_Controller& CCI_Controller::operator=(const CCI_Controller& other) {
  if (this != &other && (m_isCopy || (m_mapActuators.empty() && m_mapSensors.empty()))) {
    m_mapActuators = other.m_mapActuators;
    m_mapSensors = other.m_mapSensors;
    m_strId = other.m_strId;
    m_isCopy = true;
  }
  return *this;
}

CCI_Controller::~CCI_Controller() {
  if (m_isCopy) {
    return;
  }
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

// the class of a control interface from which a device derives; null if there is none
const std::type_info* FindInterface(const std::type_info& type) {
  const std::string name = DemangledName(type);
  if (name == "CCI_Sensor" || name == "CCI_Actuator") {
    return nullptr;
  }
  if (name.rfind("CCI_", 0) == 0) {
    return &type;
  }
  if (const auto* const single = dynamic_cast<const abi::__si_class_type_info*>(&type)) {
    return FindInterface(*single->__base_type);
  }
  if (const auto* const multiple = dynamic_cast<const abi::__vmi_class_type_info*>(&type)) {
    for (unsigned int i = 0; i < multiple->__base_count; ++i) {
      const std::type_info* const found = FindInterface(*multiple->__base_info[i].__base_type);
      if (found != nullptr) {
        return found;
      }
    }
  }
  return nullptr;
}

// CCI_FootBotProximitySensor (CFootBotProximityDefaultSensor)
std::string DescribeClass(const std::type_info& type) {
  const std::type_info* const interface = FindInterface(type);
  const std::string name = DemangledName(type);
  return interface == nullptr || *interface == type ? name
                                                    : DemangledName(*interface) + " (" + name + ")";
}

std::string WithoutUnderscores(std::string name) {
  name.erase(std::remove(name.begin(), name.end(), '_'), name.end());
  return StringToLowerCase(name);
}

// the header of the interface, if its name follows from the tag, as for all devices of this project
std::string DescribeHeader(const std::type_info& type, const std::string& tag,
                           const std::string& kind) {
  const std::type_info* const interface = FindInterface(type);
  const std::string header = "ci_" + tag + '_' + kind;
  return interface != nullptr &&
                 WithoutUnderscores("c" + header) == WithoutUnderscores(DemangledName(*interface))
             ? ", whose header is " + header + ".h"
             : "";
}

template <typename MAP, typename DEVICE>
void AddDevice(MAP& devices, const std::string& type, DEVICE* device) {
  DEVICE*& place = devices[type];
  if (place != device) {
    delete place;
    place = device;
  }
}
}  // namespace

void CCI_Controller::RecordValue(std::string_view name, Real value) {
  for (auto& [known, last] : m_recordedValues) {
    if (known == name) {
      last = value;
      return;
    }
  }
  const auto isOther = [](unsigned char c) { return std::isalnum(c) == 0 && c != '_'; };
  if (name.empty() || std::isalpha(static_cast<unsigned char>(name[0])) == 0 ||
      std::any_of(name.begin(), name.end(), isOther)) {
    THROW_ARGOSEXCEPTION("RecordValue(): \"" << name
                                             << "\" is no name: expected letters, digits and '_', "
                                                "beginning with a letter");
  }
  m_recordedValues.emplace_back(name, value);
}

Real CCI_Controller::GetRecordedValue(std::string_view name) const {
  for (const auto& [known, last] : m_recordedValues) {
    if (known == name) {
      return last;
    }
  }
  return std::numeric_limits<Real>::quiet_NaN();
}

void CCI_Controller::CheckOwnsDevices() const {
  if (m_isCopy) {
    THROW_ARGOSEXCEPTION("Robot \"" << m_strId
                                    << "\": a copy of its controller cannot get devices");
  }
}

void CCI_Controller::AddActuator(const std::string& type, CCI_Actuator* actuator) {
  CheckOwnsDevices();
  AddDevice(m_mapActuators, type, actuator);
}

void CCI_Controller::AddSensor(const std::string& type, CCI_Sensor* sensor) {
  CheckOwnsDevices();
  AddDevice(m_mapSensors, type, sensor);
}

void CCI_Controller::ThrowDeviceMissing(const std::string& kind, const std::string& type,
                                        const std::vector<std::string>& types) const {
  const std::string all = JoinItems(types);
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
                                  << ", but the device in the XML is a " << DescribeClass(found)
                                  << DescribeHeader(found, type, kind));
}

}  // namespace argos
