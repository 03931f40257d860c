#ifndef ARGOS3_PROGRAM_CATALOGUE_DEVICE_FACTS_H
#define ARGOS3_PROGRAM_CATALOGUE_DEVICE_FACTS_H

#include <argos3/program/catalogue/lua_listing.h>
#include <argos3/program/catalogue/public_headers.h>
#include <argos3/program/catalogue/sample_elements.h>
#include <argos3/program/catalogue/sample_experiment.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace argos {

class CSimulator;

/** A robot that a device fits. */
struct SFit {
  std::string Robot;
  std::string Part; /**< tag of the element inside the robot that the device needs; "" for none */
};

/** What controllers, and authors of experiments, must know of a device. */
struct SDeviceFacts {
  std::string Interface; /**< "CCI_LEDsActuator" */
  std::string Library; /**< the file that contains the interface */
  SClassText Class;
  std::vector<SLuaEntry> Lua;
  std::vector<SFit> Robots;
  std::string Example; /**< a robot that it fits, if that is not made of parts */
  std::string Problem; /**< why it does not fit the first robot, if it fits none */
};

/** Finds facts about devices by creating each of them, on each robot. */
class CDeviceCatalogue {
 public:
  explicit CDeviceCatalogue(const std::vector<SPluginKind>& kinds);

  /** @param section  "sensors" or "actuators". @param label  "leds (default)" */
  const SDeviceFacts& GetFacts(const std::string& section, const std::string& label);

  /** Labels of the entities that can have a controller. */
  const std::vector<std::string>& GetRobots();

  /** An experiment with the element of a device on a robot that it fits; on any if none. */
  SSampleExperiment MakeSample(const SSampleElement& device);

  const CSampleElements& GetElements() const { return m_elements; }
  CSampleLoader& GetLoader() { return m_loader; }

 private:
  bool IsRobot(const std::string& label);
  void NoteBody(const std::string& label);
  SDeviceFacts FindFacts(const std::string& section, const std::string& label);
  void FindClass(const std::string& section, const std::string& label, SDeviceFacts& facts) const;
  void TryOn(const std::string& robot, const std::vector<SSampleElement>& examples,
             SDeviceFacts& facts);
  std::string TryWith(const std::string& robot, const std::string& parts,
                      const SSampleElement& device, SDeviceFacts& facts);
  void TryOnExamples(const std::string& robot, const std::string& error,
                     const SSampleElement& device, SDeviceFacts& facts);
  std::string TryInArena(const std::string& arena, const SSampleElement& device,
                         SDeviceFacts& facts);
  std::string Robot(const std::string& label, const std::string& id, const std::string& position,
                    const std::string& parts) const;

  CSampleElements m_elements;
  CPublicHeaders m_headers;
  CSampleLoader m_loader;  // after the headers: it changes the working directory
  std::vector<std::string> m_entities;
  bool m_areRobotsKnown = false;
  std::vector<std::string> m_robots;
  std::map<std::string, std::string> m_bodies;  // contents of robots that need some, by label
  std::map<std::string, SDeviceFacts> m_facts;  // by section and label
};

}  // namespace argos

#endif
