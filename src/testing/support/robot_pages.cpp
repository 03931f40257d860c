#include <argos3/testing/support/robot_pages.h>

#include <argos3/core/simulator/actuator.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/core/simulator/simulator.h>

#include <memory>
#include <sstream>

namespace argos {

namespace {

constexpr char kFence[] = "```\n";

// one device after the other on a robot of its own: some exclude each other
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

struct SDevice {
  std::string Label, Kind, Brief, Long;
};

template <typename DEVICE>
void AppendDevices(std::vector<SDevice>& devices, const std::string& kind,
                   const std::string& robot) {
  for (const auto& [label, info] : CFactory<DEVICE>::GetTypeMap()) {
    // tests register devices of their own
    if (info->Author == "the authors of this project" && Fits<DEVICE>(label, robot)) {
      devices.push_back({label, kind, info->BriefDescription, info->LongDescription});
    }
  }
}

// as in an address within a page: letters and digits in lower case, blanks as hyphens
std::string Anchor(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-') {
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (c == ' ') {
      anchor += '-';
    }
  }
  return anchor;
}

std::string Heading(const SDevice& device) {
  return device.Kind + " " + device.Label;
}

std::string Fenced(const std::string& text) {
  return kFence + text + (text.empty() || text.back() == '\n' ? "" : "\n") + kFence;
}

}  // namespace

std::vector<std::string> RobotsWithPages() {
  return {"e-puck", "eye-bot", "foot-bot"};
}

std::string MakeRobotPage(const std::string& label) {
  CSimulator simulator;
  const CSimulator::CScope scope(simulator);
  const auto& robot = *CFactory<CEntity>::GetTypeMap().at(label);
  std::vector<SDevice> devices;
  AppendDevices<CSimulatedActuator>(devices, "actuator", label);
  AppendDevices<CSimulatedSensor>(devices, "sensor", label);

  std::ostringstream page;
  page << "# " << label << "\n\n<!-- Made from what the plug-ins say of themselves: cmake --build "
       << "<build folder> --target robot_pages -->\n\n"
       << robot.BriefDescription << "\n\n"
       << Fenced(robot.LongDescription) << "\n## Devices\n\n"
       << "An element's name is what stands before the parentheses, its attribute "
          "`implementation` what stands in them.\nLengths that controllers see are in cm and "
          "angles in rad unless a device says otherwise.\n\n| Device | | |\n|---|---|---|\n";
  for (const SDevice& device : devices) {
    page << "| [`" << device.Label << "`](#" << Anchor(Heading(device)) << ") | " << device.Kind
         << " | " << device.Brief << " |\n";
  }
  for (const SDevice& device : devices) {
    page << "\n### " << Heading(device) << "\n\n" << Fenced(device.Long);
  }
  return page.str();
}

}  // namespace argos
