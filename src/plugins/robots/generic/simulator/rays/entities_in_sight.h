#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_ENTITIES_IN_SIGHT_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_ENTITIES_IN_SIGHT_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/simulator/space/positional_indices/positional_index.h>
#include <argos3/plugins/robots/generic/simulator/sight_lines.h>

#include <algorithm>
#include <array>
#include <vector>

namespace argos {

namespace detail {

/** The body that does not hide an entity from below; see CLEDEntity::GetBodyOpenBeneath(). */
template <class ENTITY>
auto FindBodyOpenBeneath(const ENTITY& entity, int) -> decltype(entity.GetBodyOpenBeneath()) {
  return entity.GetBodyOpenBeneath();
}
template <class ENTITY>
const CEmbodiedEntity* FindBodyOpenBeneath(const ENTITY&, long) {
  return nullptr;
}

}  // namespace detail

/**
 * Detects the entities of a medium, such as LEDs and tags, that are visible to a camera.
 *
 * Ignores entities of the camera's own robot. Keeps its memory allocated between images.
 * @tparam NUM_POINTS  number of points of an entity that must all be visible.
 */
template <class ENTITY, size_t NUM_POINTS = 1>
class CEntitiesInSight {
 public:
  /** @throws CARGoSException if the robot has no "body" or "controller". */
  void SetRobot(CComposableEntity& robot) {
    m_robot = &robot.GetRootEntity();
    m_lines.SetRobot(robot);
    m_lines.Reserve(kInitialCapacity * NUM_POINTS);
    m_candidates.reserve(kInitialCapacity);
  }

  /**
   * Processes one image.
   * @param index  of the medium.
   * @param eye    position of the camera, m, world frame.
   * @param field  a box around the field of view, m, world frame.
   * @param locate bool(ENTITY&, CVector3* points): false if the entity is not in the field of view;
   *               else writes its NUM_POINTS points, m, world frame.
   * @param see    void(ENTITY&, const CVector3* points): called for every visible entity, in order
   *               of creation.
   * @param show   true: records the lines of sight for visualizations.
   */
  template <typename LOCATE, typename SEE>
  void Detect(CPositionalIndex<ENTITY>& index, const CVector3& eye, const SBoundingBox& field,
              LOCATE&& locate, SEE&& see, bool show = false) {
    Collect(index, field, locate);
    m_lines.Start(eye);
    for (const SCandidate& candidate : m_candidates) {
      for (const CVector3& point : candidate.Points) {
        m_lines.Add(point, detail::FindBodyOpenBeneath(*candidate.Entity, 0));
      }
    }
    m_lines.Trace();
    for (size_t i = 0; show && i < m_lines.GetNumPoints(); ++i) {
      m_lines.Show(i);
    }
    for (size_t i = 0; i < m_candidates.size(); ++i) {
      bool clear = true;
      for (size_t point = 0; point < NUM_POINTS; ++point) {
        clear = clear && m_lines.IsClear(i * NUM_POINTS + point);
      }
      if (clear) {
        see(*m_candidates[i].Entity, m_candidates[i].Points.data());
      }
    }
  }

 private:
  static constexpr size_t kInitialCapacity = 64;  // entities in the field of view

  // an entity in the field of view
  struct SCandidate {
    ssize_t Index;  // of the entity
    ENTITY* Entity;
    std::array<CVector3, NUM_POINTS> Points;  // m, world frame
  };

  // collects the entities in the field of view, in order of creation: the index visits them in
  // another order, and may visit one twice
  template <typename LOCATE>
  void Collect(CPositionalIndex<ENTITY>& index, const SBoundingBox& field, LOCATE&& locate) {
    class CCollect : public CPositionalIndex<ENTITY>::COperation {
     public:
      CCollect(CEntitiesInSight& sight, LOCATE& locate) : m_sight(sight), m_locate(locate) {}
      bool operator()(ENTITY& entity) override {
        SCandidate candidate{entity.GetIndex(), &entity, {}};
        if (m_locate(entity, candidate.Points.data()) &&
            &entity.GetRootEntity() != m_sight.m_robot) {
          m_sight.m_candidates.push_back(candidate);
        }
        return true;
      }

     private:
      CEntitiesInSight& m_sight;
      LOCATE& m_locate;
    };
    m_candidates.clear();
    CCollect collect(*this, locate);
    index.ForEntitiesInBoxRange((field.MinCorner + field.MaxCorner) * 0.5,
                                (field.MaxCorner - field.MinCorner) * 0.5, collect);
    std::sort(m_candidates.begin(), m_candidates.end(),
              [](const SCandidate& a, const SCandidate& b) { return a.Index < b.Index; });
    m_candidates.erase(
        std::unique(m_candidates.begin(), m_candidates.end(),
                    [](const SCandidate& a, const SCandidate& b) { return a.Entity == b.Entity; }),
        m_candidates.end());
  }

  const CEntity* m_robot = nullptr;  // the root
  CSightLines m_lines;
  std::vector<SCandidate> m_candidates;  // entities are not owned; valid within Detect()
};

}  // namespace argos

#endif
