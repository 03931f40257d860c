#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_ENTITIES_IN_SIGHT_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_ENTITIES_IN_SIGHT_H

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/simulator/space/positional_indices/positional_index.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/memory/load_ahead.h>
#include <argos3/plugins/robots/generic/simulator/number_sort.h>
#include <argos3/plugins/robots/generic/simulator/sight_lines.h>
#include <argos3/plugins/simulator/media/entity_points.h>

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

/** A point of an entity. */
struct SSightPoint {
  CVector3 Position; /**< m, world frame */
  CVector2 Pixel; /**< its place in the image, written by the caller */
};

/**
 * Detects the entities of a medium, such as LEDs and tags, that are visible to a camera.
 *
 * Ignores entities of the camera's own robot. All cameras of a thread use the same scratch memory,
 * which stays in the processor's caches and remains allocated.
 * @tparam NUM_POINTS  number of points of an entity that must all be visible.
 */
template <class ENTITY, size_t NUM_POINTS = 1>
class CEntitiesInSight {
 public:
  /** @throws CARGoSException if the robot has no "body" or "controller". */
  void SetRobot(CComposableEntity& robot) {
    m_root = &robot.GetRootEntity();
    m_robot.SetRobot(robot);
    m_period = &m_robot.GetSpace().GetContext().Arena.Period;
  }

  /**
   * In a periodic arena a camera sees the nearest image of each entity. For the functions that are
   * passed to Detect(), and while it runs:
   * @return the displacement of that image from a position, m; 0 in other arenas.
   */
  CVector3 FindImage(const CVector3& position) const {
    return m_period->IsOn() ? m_period->FindImage(position, m_eye) : CVector3();
  }

  /**
   * Processes one image.
   * @param medium a CPositionalMedium that has KeepPoints().
   * @param eye    position of the camera, m, world frame.
   * @param view   contains the field of view.
   * @param locate bool(ENTITY&, SSightPoint*): false if the entity is not in the field of view;
   *               else writes its NUM_POINTS points.
   * @param see    void(ENTITY&, const SSightPoint*): called for every visible entity, in order of
   *               creation.
   * @param show   true: records the lines of sight for visualizations.
   */
  template <class MEDIUM, typename LOCATE, typename SEE>
  void Detect(MEDIUM& medium, const CVector3& eye, const CViewVolume& view, LOCATE&& locate,
              SEE&& see, bool show = false) {
    SScratch& scratch = GetScratch();
    m_eye = eye;
    Collect(scratch, medium, view, locate);
    scratch.Sort();
    if (scratch.Candidates.empty()) {
      return;
    }
    scratch.Lines.Start(m_robot, m_eye, NUM_POINTS);
    const bool mayOcclude = scratch.Lines.FindOccluders(scratch.Enclose(eye)) || show;
    if (mayOcclude) {
      Trace(scratch, show);
    }
    for (size_t i = 0; i < scratch.Order.size(); ++i) {
      if (!mayOcclude || scratch.Lines.IsGroupClear(i)) {
        const SCandidate& candidate = scratch.GetCandidate(i);
        see(*candidate.Entity, candidate.Points.data());
      }
    }
  }

 private:
  static constexpr size_t kInitialCapacity = 64;  // entities in the field of view
  // entities whose positions are prefetched together
  static constexpr size_t kBatch = 16;
  // an index has at most 39 bits
  static constexpr int kNumberBits = 24;
  static constexpr UInt64 kNumberMask = (UInt64(1) << kNumberBits) - 1;

  // an entity in the field of view
  struct SCandidate {
    ENTITY* Entity;
    ssize_t Index;  // its CEntity::GetIndex()
    std::array<SSightPoint, NUM_POINTS> Points;
  };
  // memory for one image
  struct SScratch {
    CSightLines Lines;
    std::vector<SCandidate> Candidates;  // entities are not owned
    // the candidates in order of creation: index plus 1 above kNumberBits, number below
    std::vector<UInt64> Order;

    SScratch() {
      Lines.Reserve(kInitialCapacity, NUM_POINTS);
      Candidates.reserve(kInitialCapacity);
      Order.reserve(kInitialCapacity);
    }
    void Sort();
    const SCandidate& GetCandidate(size_t place) const {
      return Candidates[Order[place] & kNumberMask];
    }
    // a box around all points of the candidates and the eye, m, world frame
    SBoundingBox Enclose(const CVector3& eye) const;
  };

  static SScratch& GetScratch() {
    static thread_local SScratch scratch;
    return scratch;
  }

  // the entities near the camera are scattered in memory: gathers some, to prefetch their positions
  template <typename LOCATE>
  class CCollect final : public CPositionalIndex<ENTITY>::COperation {
   public:
    CCollect(const CEntity& root, SScratch& scratch, LOCATE& locate)
        : m_root(root), m_scratch(scratch), m_locate(locate) {}
    bool operator()(ENTITY& entity) override {
      Add(entity, entity.GetRootEntity(), entity.GetIndex());
      return true;
    }
    void Add(ENTITY& entity, const CEntity& root, ssize_t index) {
      if (&root == &m_root) {
        return;
      }
      LoadAhead(entity.GetPosition());
      m_batch[m_size++] = {&entity, index};
      if (m_size == kBatch) {
        Finish();
      }
    }
    void Finish() {
      for (size_t i = 0; i < m_size; ++i) {
        SCandidate& candidate = m_scratch.Candidates.emplace_back();
        candidate.Entity = m_batch[i].Entity;
        candidate.Index = m_batch[i].Index;
        if (!m_locate(*candidate.Entity, candidate.Points.data())) {
          m_scratch.Candidates.pop_back();
        }
      }
      m_size = 0;
    }

   private:
    struct SGathered {
      ENTITY* Entity;
      ssize_t Index;
    };

    const CEntity& m_root;  // of the camera's robot
    SScratch& m_scratch;
    LOCATE& m_locate;
    std::array<SGathered, kBatch> m_batch;
    size_t m_size = 0;  // number in the batch
  };

  template <class MEDIUM, typename LOCATE>
  void Collect(SScratch& scratch, MEDIUM& medium, const CViewVolume& view, LOCATE&& locate) const {
    scratch.Candidates.clear();
    CCollect<LOCATE> collect(*m_root, scratch, locate);
    if (!m_period->IsOn()) {
      CollectIn(medium, view, collect);
    } else {
      const CVector3& min = view.GetBox().MinCorner;
      const CVector3& max = view.GetBox().MaxCorner;
      m_period->ForDisplacements({min.GetX(), min.GetY(), max.GetX(), max.GetY()},
                                 [&](Real dx, Real dy) {
                                   CViewVolume image = view;
                                   image.Move(CVector3(dx, dy, 0.0));
                                   CollectIn(medium, image, collect);
                                 });
    }
    collect.Finish();
  }

  template <class MEDIUM, class COLLECT>
  void CollectIn(MEDIUM& medium, const CViewVolume& view, COLLECT& collect) const {
    const CEntityPoints<ENTITY>* const points = medium.GetPoints();
    if (points == nullptr || m_robot.GetSpace().GetBodyIndex().HasMovedBodies()) {
      const SBoundingBox& box = view.GetBox();
      medium.GetIndex().ForEntitiesInBoxRange((box.MinCorner + box.MaxCorner) * 0.5,
                                              (box.MaxCorner - box.MinCorner) * 0.5, collect);
    } else {
      points->ForPointsInside(view, [&](const typename CEntityPoints<ENTITY>::SPoint& point) {
        collect.Add(*point.Entity, *point.Root, point.Index);
      });
    }
  }

  // computes which candidates are visible, in their order
  void Trace(SScratch& scratch, bool show) const {
    CSightLines& lines = scratch.Lines;
    for (size_t i = 0; i < scratch.Order.size(); ++i) {
      const SCandidate& candidate = scratch.GetCandidate(i);
      for (const SSightPoint& point : candidate.Points) {
        lines.Add(point.Position, detail::FindBodyOpenBeneath(*candidate.Entity, 0));
      }
    }
    lines.Trace(show);
    for (size_t i = 0; show && i < lines.GetNumPoints(); ++i) {
      lines.Show(i);
    }
  }

  const CEntity* m_root = nullptr;  // the robot
  CRayCaster m_robot;
  const SPeriodicity* m_period = nullptr;  // joined sides of the arena
  CVector3 m_eye;  // m, world frame; of the present image
};

// the index visits entities in another order than that of creation, and may visit one twice
template <class ENTITY, size_t NUM_POINTS>
void CEntitiesInSight<ENTITY, NUM_POINTS>::SScratch::Sort() {
  Order.clear();
  for (const SCandidate& candidate : Candidates) {
    Order.push_back((static_cast<UInt64>(candidate.Index + 1) << kNumberBits) | Order.size());
  }
  SortNumbers(Order);
  const auto isSame = [this](UInt64 a, UInt64 b) {
    return a >> kNumberBits == b >> kNumberBits &&
           Candidates[a & kNumberMask].Entity == Candidates[b & kNumberMask].Entity;
  };
  Order.erase(std::unique(Order.begin(), Order.end(), isSame), Order.end());
}

template <class ENTITY, size_t NUM_POINTS>
SBoundingBox CEntitiesInSight<ENTITY, NUM_POINTS>::SScratch::Enclose(const CVector3& eye) const {
  SBoundingBox box{eye, eye};
  for (const SCandidate& candidate : Candidates) {
    for (const SSightPoint& point : candidate.Points) {
      for (UInt32 axis = 0; axis < 3; ++axis) {
        box.MinCorner[axis] = std::min(box.MinCorner[axis], point.Position[axis]);
        box.MaxCorner[axis] = std::max(box.MaxCorner[axis], point.Position[axis]);
      }
    }
  }
  return box;
}

}  // namespace argos

#endif
