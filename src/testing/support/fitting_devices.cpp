#include <argos3/testing/support/fitting_devices.h>

#include <argos3/core/simulator/actuator.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/sensor.h>

#include <memory>

namespace argos {

namespace {

// each device is tried on a new robot, because some exclude each other
template <typename DEVICE>
bool Fits(const std::string& device, const std::string& robotLabel) {
  const std::unique_ptr<CEntity> robot(CFactory<CEntity>::New(robotLabel));
  const std::unique_ptr<DEVICE> simulated(CFactory<DEVICE>::New(device));
  try {
    simulated->SetRobot(dynamic_cast<CComposableEntity&>(*robot));
  } catch (const CARGoSException&) {
    return false;
  }
  return true;
}

template <typename DEVICE>
void AppendDevices(std::vector<SFittingDevice>& devices, const std::string& kind,
                   const std::string& robot) {
  for (const auto& [label, info] : CFactory<DEVICE>::GetTypeMap()) {
    // excludes devices that tests register
    if (info->Author == "the authors of this project" && Fits<DEVICE>(label, robot)) {
      devices.push_back({label, kind, info->BriefDescription, info->LongDescription});
    }
  }
}

}  // namespace

std::vector<SFittingDevice> FittingDevices(const std::string& robot) {
  std::vector<SFittingDevice> devices;
  AppendDevices<CSimulatedActuator>(devices, "actuator", robot);
  AppendDevices<CSimulatedSensor>(devices, "sensor", robot);
  return devices;
}

}  // namespace argos
