#include <argos3/program/catalogue/device_facts.h>

#include <argos3/core/simulator/entity/actuator.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/sensor.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/program/catalogue/interface_class.h>

#include <algorithm>
#include <memory>
#include <sstream>

namespace argos {

namespace {

// sensors of the ground need one
constexpr const char* kFloor =
    "<floor id=\"sample_floor\" source=\"loop_functions\" pixels_per_meter=\"1\" />";

template <typename DEVICE>
SInterfaceClass InterfaceOf(const std::string& label) {
  const std::unique_ptr<DEVICE> device(CFactory<DEVICE>::New(label));
  const DEVICE& object = *device;
  return FindInterfaceClass(typeid(object));
}

}  // namespace

CDeviceCatalogue::CDeviceCatalogue(const std::vector<SPluginKind>& kinds) : m_elements(kinds) {
  for (const SPluginKind& kind : kinds) {
    for (const SPluginText& plugin : kind.Plugins) {
      if (kind.Word == "entities") {
        m_entities.push_back(plugin.Label);
      }
    }
  }
}

std::string CDeviceCatalogue::Robot(const std::string& label, const std::string& id,
                                    const std::string& position, const std::string& parts) const {
  const auto body = m_bodies.find(label);
  return "<" + label + " id=\"" + id + "\"><body position=\"" + position +
         "\" /><controller config=\"c1\" />" + (body == m_bodies.end() ? "" : body->second) +
         parts + "</" + label + ">";
}

bool CDeviceCatalogue::IsRobot(const std::string& label) {
  bool has = false;
  SSampleExperiment sample;
  sample.Arena = Robot(label, "r0", "0,0,0", "");
  sample.Media = m_elements.GetMedia();
  const std::string error = m_loader.Load(sample, [&](CSimulator& simulator) {
    has = !simulator.GetSpace().GetControllableEntities().empty();
  });
  return error.empty() && has;
}

// from its first example
void CDeviceCatalogue::NoteBody(const std::string& label) {
  const std::vector<std::string> examples = m_elements.Of("arena", label);
  if (examples.empty()) {
    return;
  }
  CConfigurationDocument document;
  document.Parse(examples.front(), "(example)");
  std::ostringstream contents;
  TConfigurationNodeIterator it;
  for (it = it.begin(&document.GetRoot()); it != it.end(); ++it) {
    if (it->Value() != "body" && it->Value() != "controller") {
      contents << *it;
    }
  }
  m_bodies[label] = contents.str();
}

const std::vector<std::string>& CDeviceCatalogue::GetRobots() {
  if (m_areRobotsKnown) {
    return m_robots;
  }
  m_areRobotsKnown = true;
  for (const std::string& label : m_entities) {
    bool isRobot = IsRobot(label);
    if (!isRobot) {
      NoteBody(label);
      isRobot = m_bodies.count(label) > 0 && IsRobot(label);
    }
    if (isRobot) {
      m_robots.push_back(label);
    }
  }
  return m_robots;
}

const SDeviceFacts& CDeviceCatalogue::GetFacts(const std::string& section,
                                               const std::string& label) {
  const std::string key = section + '/' + label;
  const auto known = m_facts.find(key);
  return known != m_facts.end() ? known->second
                                : m_facts.emplace(key, FindFacts(section, label)).first->second;
}

void CDeviceCatalogue::FindClass(const std::string& section, const std::string& label,
                                 SDeviceFacts& facts) const {
  CSimulator simulator;
  const CSimulator::CScope scope(simulator);
  const SInterfaceClass found = section == "sensors" ? InterfaceOf<CSimulatedSensor>(label)
                                                     : InterfaceOf<CSimulatedActuator>(label);
  facts.Interface = found.Name;
  facts.Library = found.Library;
  facts.Class = m_headers.Describe(found.Name);
}

SDeviceFacts CDeviceCatalogue::FindFacts(const std::string& section, const std::string& label) {
  SDeviceFacts facts;
  FindClass(section, label, facts);
  std::vector<SSampleElement> examples;
  for (const std::string& text : m_elements.Of(section, label)) {
    examples.push_back({section, label, text});
  }
  for (const std::string& robot : GetRobots()) {
    TryOn(robot, examples, facts);
  }
  if (!facts.Robots.empty()) {
    facts.Problem.clear();
  }
  return facts;
}

void CDeviceCatalogue::TryOn(const std::string& robot, const std::vector<SSampleElement>& examples,
                             SDeviceFacts& facts) {
  const SSampleElement& device = examples.front();
  const std::string error = TryWith(robot, "", device, facts);
  if (error.empty()) {
    facts.Robots.push_back({robot, ""});
    return;
  }
  facts.Problem = facts.Problem.empty() ? error : facts.Problem;
  for (const auto& [tag, part] : m_elements.GetParts()) {
    // the part of the error that says what the robot lacks
    if (error.find('"' + tag + '"') != std::string::npos &&
        TryWith(robot, part, device, facts).empty()) {
      facts.Robots.push_back({robot, tag});
      return;
    }
  }
  TryOnExamples(robot, error, device, facts);
}

// for robots whose parts depend on each other
void CDeviceCatalogue::TryOnExamples(const std::string& robot, const std::string& error,
                                     const SSampleElement& device, SDeviceFacts& facts) {
  for (const std::string& example : m_elements.Of("arena", robot)) {
    for (const auto& [tag, part] : m_elements.GetParts()) {
      if (error.find('"' + tag + '"') != std::string::npos &&
          example.find('<' + tag + '>') != std::string::npos &&
          TryInArena(example, device, facts).empty()) {
        facts.Robots.push_back({robot, tag});
        facts.Example = example;
        return;
      }
    }
  }
}

std::string CDeviceCatalogue::TryWith(const std::string& robot, const std::string& parts,
                                      const SSampleElement& device, SDeviceFacts& facts) {
  // two, so that there are messages to receive
  return TryInArena(Robot(robot, "r0", "0,0,0", parts) + Robot(robot, "r1", "0.5,0,0", parts),
                    device, facts);
}

std::string CDeviceCatalogue::TryInArena(const std::string& arena, const SSampleElement& device,
                                         SDeviceFacts& facts) {
  SSampleExperiment sample = m_elements.MakeSample(device);
  sample.Arena = arena + kFloor;
  return m_loader.Load(sample, [&facts](CSimulator& simulator) {
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
}

SSampleExperiment CDeviceCatalogue::MakeSample(const SSampleElement& device) {
  const SDeviceFacts& facts = GetFacts(device.Section, device.Key);
  SSampleExperiment sample = m_elements.MakeSample(device);
  if (!facts.Example.empty()) {
    sample.Arena = facts.Example + kFloor;
  } else if (!facts.Robots.empty()) {
    const SFit& fit = facts.Robots.front();
    const auto part = m_elements.GetParts().find(fit.Part);
    sample.Arena =
        Robot(fit.Robot, "r0", "0,0,0", part == m_elements.GetParts().end() ? "" : part->second) +
        kFloor;
  } else if (!GetRobots().empty()) {
    sample.Arena = Robot(GetRobots().front(), "r0", "0,0,0", "") + kFloor;
  }
  return sample;
}

}  // namespace argos
