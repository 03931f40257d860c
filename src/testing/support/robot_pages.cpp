#include <argos3/testing/support/robot_pages.h>

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/testing/support/device_list.h>
#include <argos3/testing/support/fitting_devices.h>

#include <sstream>

namespace argos {

namespace {

constexpr char kFence[] = "```\n";

// anchor of a heading in an address: letters and digits in lower case, blanks as hyphens
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

std::string Heading(const SFittingDevice& device) {
  return device.Kind + " " + device.Label;
}

std::string Fenced(const std::string& text) {
  return kFence + text + (text.empty() || text.back() == '\n' ? "" : "\n") + kFence;
}

}  // namespace

std::vector<std::string> RobotsWithPages() {
  std::vector<std::string> robots = ListedRobots();
  // robots as data: which devices one has is up to its element
  robots.push_back("prototype");
  return robots;
}

std::string MakeRobotPage(const std::string& label) {
  CSimulator simulator;
  const CSimulator::CScope scope(simulator);
  const auto& robot = *CFactory<CEntity>::GetTypeMap().at(label);
  const std::vector<SFittingDevice> devices = FittingDevices(label);

  std::ostringstream page;
  page << "# " << label
       << "\n\n<!-- Generated from the descriptions of the plug-ins: cmake --build "
       << "<build folder> --target robot_pages -->\n\n"
       << robot.BriefDescription << "\n\n"
       << Fenced(robot.LongDescription) << "\n## Devices\n\n";
  if (devices.empty()) {
    page << "Those for which its element has the parts; see [robots as "
            "data](../robots_as_data.md).\n";
    return page.str();
  }
  page << "The tag of an element is the text before the parentheses, its attribute "
          "`implementation` is the text in them.\nLengths that controllers see are in cm and "
          "angles in rad unless a device says otherwise.\n\n| Device | | |\n|---|---|---|\n";
  for (const SFittingDevice& device : devices) {
    page << "| [`" << device.Label << "`](#" << Anchor(Heading(device)) << ") | " << device.Kind
         << " | " << device.Brief << " |\n";
  }
  for (const SFittingDevice& device : devices) {
    page << "\n### " << Heading(device) << "\n\n" << Fenced(device.Long);
  }
  return page.str();
}

}  // namespace argos
