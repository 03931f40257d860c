#ifndef ARGOS3_CORE_SIMULATOR_PLACEMENT_DISTRIBUTION_H
#define ARGOS3_CORE_SIMULATOR_PLACEMENT_DISTRIBUTION_H

#include <argos3/core/simulator/context/load_errors.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_pose.h>
#include <argos3/core/simulator/placement/vector_generator.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace argos {

class CBodyIndex;
class CEmbodiedEntity;
class CPlannedBodies;
class CSpace;

/**
 * A `<distribute>` element: makes entities from a template and finds a free place for each.
 *
 * Places are tested against the space's index before any robot is created, so a controller is
 * initialised once per robot and the time is in proportion to the number of trials.
 *
 * If there are many entities, all places are found first, and the entities are created in the order
 * of their places on the ground: those that are near each other are then also near in memory, which
 * a tick needs (doc/internals/architecture.md). Ids, places, and the order of the space's lists are
 * the same as if they were created one after the other.
 */
class CDistribution {
 public:
  /** Reads the element. @param errors  receives what is missing or out of range. */
  CDistribution(CSpace& space, TConfigurationNode& node, CLoadErrors& errors);

  /**
   * Places all entities; after an error of the constructor only creates one, to find errors of the
   * entity, and destroys it.
   * @throws CARGoSException if there is no room for all, or no free place for one: with its id, the
   * area, and the number of trials.
   */
  void Place();
  /** Initialises the entity without its controller. @throws CARGoSException if that fails. */
  void TryTemplate();

  /**
   * Chooses the places again, as Place() does, but among @p bodies, to which it adds its own.
   * @throws CARGoSException as Place(), and if only an engine knows the shape of the body.
   */
  void ChooseAgain(CPlannedBodies& bodies);
  /** Makes the places of ChooseAgain() the initial poses of the entities. */
  void TakeChosen();

 private:
  void ReadEntity();
  void CallStep(const std::function<void()>& step);
  void PlaceAll();
  void Probe();
  void TryEntity();
  void CheckRoom() const;
  void PlaceOneByOne();
  void PlaceOnGround();
  struct SPlaces {
    std::vector<CVector3> Positions;  // m
    std::vector<CVector3> Angles;  // degrees: z, y, x
  };
  SPlaces ChoosePlaces();
  std::shared_ptr<const SBodyDescription> FindDescription() const;
  template <typename TAKE>
  void FindPlace(UInt64 number, TAKE&& take);
  std::string MakeId(UInt64 number) const;
  bool IsFree(const CVector3& position, const CQuaternion& orientation);
  bool TryToCreate(const std::string& id);
  void WriteIntoTemplate(const std::string& id, const CVector3& position,
                         const CVector3& anglesInDegrees);
  std::string DescribeObstacle() const;
  [[noreturn]] void GiveUp(const std::string& id, UInt64 trials) const;

  CSpace& m_space;
  TConfigurationNode& m_node;
  TConfigurationNode* m_template = nullptr;  // the entity's own element
  TConfigurationNode* m_poseNode = nullptr;  // element that gets its position and orientation
  std::unique_ptr<CVectorGenerator> m_positions;  // m
  std::unique_ptr<CVectorGenerator> m_orientations;  // degrees: z, y, x
  std::string m_baseId;
  UInt64 m_baseNumber = 0;
  UInt64 m_quantity = 0;
  UInt64 m_maxTrials = 0;
  bool m_isValid = true;  // the constructor has found no error

  const CBodyIndex* m_obstacles;  // places must be free of these
  struct SChosen {
    UInt64 Number;
    SBodyPose Pose;
  };
  std::vector<SChosen> m_chosen;  // is filled by ChooseAgain()

  // set by Probe()
  std::shared_ptr<const SBodyDescription> m_body;  // null: none, or one that its engine must test
  bool m_hasBody = false;
  // the last place that was taken
  CVector3 m_lastPosition;
  UInt32 m_lastObstacle = ~UInt32(0);  // number of a body; kNoBody: only an engine knows it
  bool m_isLastPlanned = false;  // the obstacle is an entity of this element, by number
};

}  // namespace argos

#endif
