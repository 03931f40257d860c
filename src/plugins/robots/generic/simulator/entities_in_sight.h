#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ENTITIES_IN_SIGHT_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ENTITIES_IN_SIGHT_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/simulator/space/positional_indices/positional_index.h>
#include <argos3/plugins/robots/generic/simulator/sight_lines.h>

#include <algorithm>
#include <vector>

namespace argos {

/**
 * Finds what a camera sees of the entities that a medium knows: LEDs, tags.
 *
 * Those of the camera's own robot are never seen. Keeps its memory from picture to picture.
 * @tparam NUM_POINTS  how many points of an entity must all be in sight.
 */
template <class ENTITY, size_t NUM_POINTS = 1>
class CEntitiesInSight {
 public:
  /** @throws CARGoSException if the robot has no "body" or "controller". */
  void SetRobot(CComposableEntity& robot) {
    m_robot = &robot.GetRootEntity();
    m_lines.SetRobot(robot);
  }

  /**
   * Takes a picture.
   * @param index  of the medium.
   * @param eye    where the camera is, m, world frame.
   * @param field  a box around all that the camera could see, m, world frame.
   * @param locate bool(ENTITY&, CVector3* points): false if the entity is not in the field of view;
   *               else writes its NUM_POINTS points, m, world frame.
   * @param see    void(ENTITY&): called for every entity in sight, in order of creation.
   * @param show   records the lines of sight, to be drawn.
   */
  template <typename LOCATE, typename SEE>
  void Look(CPositionalIndex<ENTITY>& index, const CVector3& eye, const SBoundingBox& field,
            LOCATE&& locate, SEE&& see, bool show = false) {
    Collect(index, field);
    m_lines.Start(eye);
    size_t numLocated = 0;
    for (ENTITY* entity : m_found) {
      CVector3 points[NUM_POINTS];
      if (&entity->GetRootEntity() != m_robot && locate(*entity, points)) {
        m_found[numLocated++] = entity;
        for (const CVector3& point : points) {
          m_lines.Add(point);
        }
      }
    }
    m_found.resize(numLocated);
    m_lines.Trace();
    for (size_t i = 0; show && i < m_lines.GetNumPoints(); ++i) {
      m_lines.Show(i);
    }
    for (size_t i = 0; i < m_found.size(); ++i) {
      bool clear = true;
      for (size_t point = 0; point < NUM_POINTS; ++point) {
        clear = clear && m_lines.IsClear(i * NUM_POINTS + point);
      }
      if (clear) {
        see(*m_found[i]);
      }
    }
  }

 private:
  // the index visits in an order of its own, and some perhaps twice
  void Collect(CPositionalIndex<ENTITY>& index, const SBoundingBox& field) {
    class CCollect : public CPositionalIndex<ENTITY>::COperation {
     public:
      explicit CCollect(std::vector<ENTITY*>& found) : m_found(found) {}
      bool operator()(ENTITY& entity) override {
        m_found.push_back(&entity);
        return true;
      }

     private:
      std::vector<ENTITY*>& m_found;
    };
    m_found.clear();
    CCollect collect(m_found);
    index.ForEntitiesInBoxRange((field.MinCorner + field.MaxCorner) * 0.5,
                                (field.MaxCorner - field.MinCorner) * 0.5, collect);
    std::sort(m_found.begin(), m_found.end(), SEntityComparator());
    m_found.erase(std::unique(m_found.begin(), m_found.end()), m_found.end());
  }

  const CEntity* m_robot = nullptr;  // the root
  CSightLines m_lines;
  std::vector<ENTITY*> m_found;  // not owned; only valid within Look()
};

}  // namespace argos

#endif
