#ifndef ARGOS3_PROGRAM_CATALOGUE_DEVICES_H
#define ARGOS3_PROGRAM_CATALOGUE_DEVICES_H

#include <argos3/program/catalogue/lua_listing.h>
#include <argos3/program/catalogue/public_headers.h>
#include <argos3/program/catalogue/samples.h>

#include <map>
#include <string>
#include <vector>

namespace argos {

/** The class of the control interface that a device implements. */
struct SInterfaceClass {
  std::string Name; /**< "CCI_LEDsActuator"; "" if there is none */
  std::string Library; /**< the file that contains it */
};

/** A robot that a device fits. */
struct SFit {
  std::string Robot;
  std::string Part; /**< tag of the element inside the robot that the device needs; "" for none */
};

/** What controllers, and authors of experiments, must know of a device. */
struct SDeviceFacts {
  SInterfaceClass Interface;
  SClassText Class;
  std::vector<SLuaEntry> Lua; /**< empty if it fits no robot, or adds nothing */
  std::vector<SFit> Robots;
  std::string Problem; /**< why it does not fit the first robot, if it fits none */
  std::string Arena; /**< robots that it fits, as XML; the first robot if it fits none */
  std::size_t NumTried = 0; /**< of the robots */
};

/** A device that fits a robot. */
struct SDeviceOfRobot {
  const SPluginKind* Kind;
  std::string Label;
  std::string Part; /**< as SFit::Part */
};

/** The class of the control interface of a device. @param kind  sensors or actuators. */
SInterfaceClass FindInterface(const SPluginKind& kind, const std::string& label);

/** Finds facts about devices by creating each of them, on each robot. */
class CDevices {
 public:
  /** @param kinds  all; they must exist as long as this. */
  explicit CDevices(const std::vector<SPluginKind>& kinds);

  /** @param kind  sensors or actuators. @param label  "leds (default)" */
  const SDeviceFacts& Describe(const SPluginKind& kind, const std::string& label);
  std::vector<SDeviceOfRobot> ListDevicesOf(const std::string& robot);

  /** Labels of the entities that can have a controller. */
  const std::vector<std::string>& GetRobots();

  /** An experiment with the sample; that of a device is on a robot that it fits. */
  SSampleExperiment MakeExperiment(const SSample& sample);

  const std::vector<SPluginKind>& GetKinds() const { return m_kinds; }
  const CSamples& GetSamples() const { return m_samples; }
  CSampleLoader& GetLoader() { return m_loader; }

 private:
  // @param all  otherwise as many robots as it takes to find one that the device fits
  SDeviceFacts& TryOnRobots(const SPluginKind& kind, const std::string& label, bool all);
  bool IsRobot(const std::string& label);
  std::string Robots(const std::string& label, const std::string& parts) const;
  void TryOn(const std::string& robot, const SSample& device, SDeviceFacts& facts);
  std::string TryIn(const std::string& arena, const SSample& device, SDeviceFacts& facts);

  const std::vector<SPluginKind>& m_kinds;
  CSamples m_samples;
  CPublicHeaders m_headers;
  CSampleLoader m_loader;  // follows the headers: it changes the working directory
  bool m_areRobotsKnown = false;
  std::vector<std::string> m_robots;
  std::map<std::string, std::string> m_contents;  // contents of robots that need some, by label
  std::map<std::pair<std::string, std::string>, SDeviceFacts> m_facts;  // keyed by section, label
};

}  // namespace argos

#endif
