#ifndef ARGOS3_CORE_SIMULATOR_PLACEMENT_PLANNED_BODIES_H
#define ARGOS3_CORE_SIMULATOR_PLACEMENT_PLANNED_BODIES_H

#include <argos3/core/simulator/context/arena.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/utility/math/range.h>

#include <deque>
#include <memory>

namespace argos {

/** Bodies at the poses that they will have at the start of a run. */
class CPlannedBodies {
 public:
  explicit CPlannedBodies(const SArena& arena) : m_period(arena.Period) {
    m_index.SetArea(arena.Limits, arena.Period);
  }

  /** @param body  null if it does not exist (any more): it takes its place nevertheless. */
  void Add(CEmbodiedEntity* body, std::shared_ptr<const SBodyDescription> description,
           const SBodyPose& pose) {
    m_bodies.push_back({std::move(description), {m_period.Wrap(pose.Position), pose.Orientation}});
    m_index.Add(body != nullptr ? *body : m_nobody, m_bodies.back().Pose,
                *m_bodies.back().Description, true);
  }
  const CBodyIndex& GetIndex() const { return m_index; }

 private:
  struct SBody {
    std::shared_ptr<const SBodyDescription> Description;
    SBodyPose Pose;
  };

  CEmbodiedEntity m_nobody{nullptr};
  std::deque<SBody> m_bodies;  // the index refers to them
  SPeriodicity m_period;
  CBodyIndex m_index;
};

}  // namespace argos

#endif
