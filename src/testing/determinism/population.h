#ifndef ARGOS3_TESTING_DETERMINISM_POPULATION_H
#define ARGOS3_TESTING_DETERMINISM_POPULATION_H

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/testing/support/device_user.h>
#include <argos3/testing/support/experiment.h>

#include <deque>
#include <string>
#include <vector>

namespace argos {

/**
 * Adds robots to a device world and removes them during a run, and tracks the expected ids.
 *
 * Foot-bots have ids that start with "fb", e-pucks with "ep", and eye-bots with "eb". The world has
 * the controllers "user_<robot>" and "bare_<robot>".
 */
class CPopulation {
 public:
  /** Includes the robots that are in the world already. */
  explicit CPopulation(CTestWorld& world);

  /** Adds a robot from XML, with all components that it can carry. @param yaw degrees. */
  void AddFromText(const std::string& id, const CVector3& position, Real yaw);
  /** Adds a robot by the constructor of its class. @param yaw degrees. */
  void AddFromProgram(const std::string& id, const CVector3& position, Real yaw);
  void Remove(const std::string& id);

  /** Ids of all root entities, in order. */
  const std::vector<std::string>& GetIds() const { return m_ids; }
  std::vector<std::string> GetRobotIds() const;
  CDeviceUser& GetUser(const std::string& id);

  /**
   * Checks that the space's lists, the body index, the engines and the media
   * contain exactly the expected robots.
   */
  void CheckViews();

 private:
  void CheckSpace();
  void CheckBodies();
  void CheckMedia();
  CEntity& Root(const std::string& id);

  CTestWorld& m_world;
  CSimulator::CScope m_scope;
  std::vector<std::string> m_ids;
  std::vector<std::string> m_gone;  // ids of some removed robots
  std::deque<CConfigurationDocument> m_documents;  // these outlive the entities created from them
};

/** Type of the robot with that id; empty for other entities. */
std::string RobotOf(const std::string& id);

}  // namespace argos

#endif
