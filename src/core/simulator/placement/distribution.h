#ifndef ARGOS3_CORE_SIMULATOR_PLACEMENT_DISTRIBUTION_H
#define ARGOS3_CORE_SIMULATOR_PLACEMENT_DISTRIBUTION_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/placement/vector_generator.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

#include <memory>
#include <string>

namespace argos {

class CSpace;

/**
 * A `<distribute>` element: makes entities from a template and finds a free place for each.
 *
 * Places are tested against the space's index before any robot is created, so a controller is
 * initialised once per robot and the time is in proportion to the number of trials.
 */
class CDistribution {
 public:
  /** Reads the element. @throws CARGoSException if something is missing or out of range. */
  CDistribution(CSpace& space, TConfigurationNode& node);

  /**
   * Places all entities.
   * @throws CARGoSException if there is no free place for one: with its id, the area, and the
   * number of trials.
   */
  void Place();

 private:
  void Probe();
  void PlaceOne(UInt64 number);
  bool IsFree(const CVector3& position, const CQuaternion& orientation);
  bool TryToCreate(const std::string& id);
  void WriteIntoTemplate(const std::string& id, const CVector3& position,
                         const CVector3& anglesInDegrees);
  [[noreturn]] void GiveUp(const std::string& id, UInt64 trials) const;

  CSpace& m_space;
  TConfigurationNode& m_node;
  TConfigurationNode* m_template = nullptr;  // the entity's own element
  TConfigurationNode* m_poseNode = nullptr;  // where its position and orientation are written
  std::unique_ptr<CVectorGenerator> m_positions;  // m
  std::unique_ptr<CVectorGenerator> m_orientations;  // degrees: z, y, x
  std::string m_baseId;
  UInt64 m_baseNumber = 0;
  UInt64 m_quantity = 0;
  UInt64 m_maxTrials = 0;

  // set by Probe()
  std::shared_ptr<const SBodyDescription> m_body;  // null: none, or one that its engine must test
  bool m_hasBody = false;
  // of the last place that was taken
  CVector3 m_lastPosition;
  std::string m_lastObstacle;
};

}  // namespace argos

#endif
