#include <argos3/program/catalogue/devices.h>

#include <argos3/core/simulator/entity/actuator.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/sensor.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/plugins/registration.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <cxxabi.h>
#include <fmt/format.h>

#include <memory>
#include <sstream>

namespace argos {

namespace {

std::vector<const std::type_info*> BasesOf(const std::type_info& type) {
  if (const auto* single = dynamic_cast<const abi::__si_class_type_info*>(&type)) {
    return {single->__base_type};
  }
  std::vector<const std::type_info*> bases;
  if (const auto* several = dynamic_cast<const abi::__vmi_class_type_info*>(&type)) {
    for (unsigned i = 0; i < several->__base_count; ++i) {
      bases.push_back(several->__base_info[i].__base_type);
    }
  }
  return bases;
}

// drops namespaces
std::string NameOf(const std::type_info& type) {
  const std::string name = DemangledName(type);
  const size_t colons = name.find('<') == std::string::npos ? name.rfind("::") : std::string::npos;
  return colons == std::string::npos ? name : name.substr(colons + 2);
}

// The most derived base class whose name begins with "CCI_". The compiler's type information lists
// bases (Itanium C++ ABI), so that devices need not name their interface. Breadth first: a class is
// nearer than its bases.
SInterfaceClass FindInterfaceClass(const std::type_info& device) {
  std::vector<const std::type_info*> types = {&device};
  for (size_t i = 0; i < types.size(); ++i) {
    const std::string name = NameOf(*types[i]);
    if (name.rfind("CCI_", 0) == 0 && name != "CCI_Sensor" && name != "CCI_Actuator") {
      return {name, GetLibraryOf(types[i])};
    }
    const std::vector<const std::type_info*> bases = BasesOf(*types[i]);
    types.insert(types.end(), bases.begin(), bases.end());
  }
  return {};
}

template <typename DEVICE>
SInterfaceClass InterfaceOf(const std::string& label) {
  CSimulator simulator;
  const CSimulator::CScope scope(simulator);
  const std::unique_ptr<DEVICE> device(CFactory<DEVICE>::New(label));
  const DEVICE& object = *device;
  return FindInterfaceClass(typeid(object));
}

// contents of a robot's example, but for what each robot has
std::string ContentsOf(const SSample& robot) {
  CConfigurationDocument document;
  document.Parse(robot.Text, "(example)");
  std::ostringstream contents;
  TConfigurationNodeIterator it;
  for (it = it.begin(&document.GetRoot()); it != it.end(); ++it) {
    if (it->Value() != "body" && it->Value() != "controller") {
      contents << *it;
    }
  }
  return contents.str();
}

// an error that says what a robot lacks has its name in quotation marks
bool Names(const std::string& error, const std::string& part) {
  return error.find('"' + part + '"') != std::string::npos;
}

}  // namespace

SInterfaceClass FindInterface(const SPluginKind& kind, const std::string& label) {
  return kind.Word == "sensors" ? InterfaceOf<CSimulatedSensor>(label)
                                : InterfaceOf<CSimulatedActuator>(label);
}

CDevices::CDevices(const std::vector<SPluginKind>& kinds) : m_kinds(kinds), m_samples(kinds) {}

// two, so that there are messages to receive
std::string CDevices::Robots(const std::string& label, const std::string& parts) const {
  const auto contents = m_contents.find(label);
  std::string robots;
  for (const char* const place : {"0", "0.5"}) {
    robots += fmt::format(
        R"(<{0} id="r{1}"><body position="{1},0,0" /><controller config="c1" />{2}{3}</{0}>)",
        label, place, contents == m_contents.end() ? "" : contents->second, parts);
  }
  return robots;
}

bool CDevices::IsRobot(const std::string& label) {
  bool has = false;
  SSampleExperiment sample = m_samples.MakeExperiment({"arena", {label}, Robots(label, "")});
  std::string error = m_loader.Load(sample, [&](CSimulator& simulator) {
    has = !simulator.GetSpace().GetControllableEntities().empty();
  });
  return error.empty() && has;
}

const std::vector<std::string>& CDevices::GetRobots() {
  if (m_areRobotsKnown) {
    return m_robots;
  }
  m_areRobotsKnown = true;
  for (const auto& [kind, plugin] : AllOf(m_kinds)) {
    if (kind->Word != "entities") {
      continue;
    }
    const std::vector<SSample> examples = m_samples.Of("arena", {plugin->Label});
    bool isRobot = IsRobot(plugin->Label);
    if (!isRobot && !examples.empty()) {
      m_contents[plugin->Label] = ContentsOf(examples.front());
      isRobot = IsRobot(plugin->Label);
    }
    if (isRobot) {
      m_robots.push_back(plugin->Label);
    }
  }
  return m_robots;
}

const SDeviceFacts& CDevices::Describe(const SPluginKind& kind, const std::string& label) {
  SDeviceFacts& facts = TryOnRobots(kind, label, true);
  if (facts.Interface.Name.empty()) {
    facts.Interface = FindInterface(kind, label);
    facts.Class = m_headers.Describe(facts.Interface.Name);
  }
  return facts;
}

SDeviceFacts& CDevices::TryOnRobots(const SPluginKind& kind, const std::string& label, bool all) {
  SDeviceFacts& facts = m_facts[{kind.Section, label}];
  const std::vector<std::string>& robots = GetRobots();
  const SSample device = m_samples.Of(kind.Section, SElementName::FromLabel(label)).front();
  for (; facts.NumTried < robots.size() && (all || facts.Robots.empty()); ++facts.NumTried) {
    TryOn(robots[facts.NumTried], device, facts);
  }
  if (facts.Robots.empty() && !robots.empty()) {
    facts.Arena = Robots(robots.front(), "");
  }
  return facts;
}

// tries robots without and with the parts of examples, which may depend on each other
void CDevices::TryOn(const std::string& robot, const SSample& device, SDeviceFacts& facts) {
  const std::string error = TryIn(Robots(robot, ""), device, facts);
  if (error.empty()) {
    facts.Robots.push_back({robot, ""});
    return;
  }
  facts.Problem = facts.Problem.empty() ? error : facts.Problem;
  for (const auto& [tag, part] : m_samples.GetParts()) {
    if (Names(error, tag) && TryIn(Robots(robot, part), device, facts).empty()) {
      facts.Robots.push_back({robot, tag});
      return;
    }
  }
  for (const SSample& example : m_samples.Of("arena", {robot})) {
    for (const auto& [tag, part] : m_samples.GetParts()) {
      if (Names(error, tag) && example.Text.find('<' + tag + '>') != std::string::npos &&
          TryIn(example.Text, device, facts).empty()) {
        facts.Robots.push_back({robot, tag});
        return;
      }
    }
  }
}

std::string CDevices::TryIn(const std::string& arena, const SSample& device, SDeviceFacts& facts) {
  SSampleExperiment experiment = m_samples.MakeExperiment(device);
  experiment.SetRobots(arena);
  std::string error = m_loader.Load(experiment, [&facts](CSimulator& simulator) {
    const auto& robots = simulator.GetSpace().GetControllableEntities();
    if (robots.empty()) {
      THROW_ARGOSEXCEPTION("there is no robot with a controller");
    }
    if (facts.Lua.empty()) {
      simulator.UpdateSpace();
      simulator.UpdateSpace();
      facts.Lua = ListLuaDevices(robots.front()->GetController());
    }
  });
  facts.Arena = error.empty() && facts.Arena.empty() ? arena : facts.Arena;
  return error;
}

std::vector<SDeviceOfRobot> CDevices::ListDevicesOf(const std::string& robot) {
  std::vector<SDeviceOfRobot> devices;
  for (const auto& [kind, plugin] : AllOf(m_kinds)) {
    if (!kind->IsOfDevices()) {
      continue;
    }
    for (const SFit& fit : Describe(*kind, plugin->Label).Robots) {
      if (fit.Robot == robot) {
        devices.push_back({kind, plugin->Label, fit.Part});
      }
    }
  }
  return devices;
}

SSampleExperiment CDevices::MakeExperiment(const SSample& sample) {
  SSampleExperiment experiment = m_samples.MakeExperiment(sample);
  for (const SPluginKind& kind : m_kinds) {
    if (kind.IsOfDevices() && kind.Section == sample.Section) {
      experiment.SetRobots(TryOnRobots(kind, sample.Name.ToLabel(), false).Arena);
    }
  }
  return experiment;
}

}  // namespace argos
