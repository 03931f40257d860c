// Built-in metrics of the robots of a space.

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/geometry/grown_body.h>
#include <argos3/core/simulator/space/built_in_metric.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/threads/thread_pool.h>

#include <atomic>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace argos {

namespace {

CEmbodiedEntity* FindBody(CEntity& root) {
  if (auto* const composable = dynamic_cast<CComposableEntity*>(&root)) {
    for (CEntity* component : composable->GetExistingComponents()) {
      if (auto* const body = dynamic_cast<CEmbodiedEntity*>(component)) {
        return body;
      }
    }
  }
  return nullptr;
}

/* The bodies of the robots of a space, in the order of the robots. */
class CRobotBodies {
 public:
  void Init(CSpace& space) { m_space = &space; }

  // calls visit(CEmbodiedEntity&, number) for each one that is not disabled
  template <typename VISIT>
  void ForEach(size_t begin, size_t end, VISIT&& visit) const {
    for (size_t i = begin; i < end; ++i) {
      if (m_bodies[i]->GetRootEntity().IsEnabled()) {
        visit(*m_bodies[i], i);
      }
    }
  }
  template <typename VISIT>
  void ForEach(VISIT&& visit) const {
    ForEach(0, m_bodies.size(), visit);
  }

  // follows robots that come and go. @return true if the list has changed
  bool Update() {
    const UInt64 version = m_space->GetVersionOfControllableEntities();
    if (m_version == version) {
      return false;
    }
    m_version = version;
    m_bodies.clear();
    for (CControllableEntity* robot : m_space->GetControllableEntities()) {
      if (CEmbodiedEntity* const body = FindBody(robot->GetRootEntity())) {
        m_bodies.push_back(body);
      }
    }
    return true;
  }

  size_t GetSize() const { return m_bodies.size(); }
  CSpace& GetSpace() const { return *m_space; }

 private:
  CSpace* m_space = nullptr;
  std::optional<UInt64> m_version;  // version of the list of robots
  std::vector<CEmbodiedEntity*> m_bodies;
};

class CDispersion : public CBuiltInMetric {
 public:
  void Init(CSpace& space) override { m_bodies.Init(space); }
  std::string GetUnit() const override { return "m"; }

  Real Compute() override {
    m_bodies.Update();
    const SPeriodicity& period = m_bodies.GetSpace().GetContext().Arena.Period;
    CVector3 sum;
    Real count = 0.0;
    m_bodies.ForEach([&](const CEmbodiedEntity& body, size_t) {
      sum += body.GetOriginAnchor().Position;
      count += 1.0;
    });
    if (count == 0.0) {
      return CMetrics::kNone;
    }
    CVector3 centroid = sum / count;
    if (period.X.IsOn()) {
      centroid.SetX(ComputeCircularMean(period.X, 0));
    }
    if (period.Y.IsOn()) {
      centroid.SetY(ComputeCircularMean(period.Y, 1));
    }
    Real squares = 0.0;
    m_bodies.ForEach([&](const CEmbodiedEntity& body, size_t) {
      squares += period.Shorten(body.GetOriginAnchor().Position - centroid).SquareLength();
    });
    return std::sqrt(squares / count);
  }

 private:
  // a periodic axis is a circle: the direction of the mean of the robots' places on it, m
  Real ComputeCircularMean(const SPeriodicAxis& axis, UInt32 number) const {
    const Real radiansPerMeter = 2.0 * ARGOS_PI / axis.Period;
    Real cosines = 0.0;
    Real sines = 0.0;
    m_bodies.ForEach([&](const CEmbodiedEntity& body, size_t) {
      const Real angle = radiansPerMeter * (body.GetOriginAnchor().Position[number] - axis.Min);
      cosines += std::cos(angle);
      sines += std::sin(angle);
    });
    return axis.Min + std::atan2(sines, cosines) / radiansPerMeter;
  }

  CRobotBodies m_bodies;
};

class CCollisions : public CBuiltInMetric {
 public:
  void Init(CSpace& space) override { m_bodies.Init(space); }

  Real Compute() override {
    Grow();
    std::atomic<size_t> count{0};
    constexpr size_t kGrain = 64;  // robots
    m_bodies.GetSpace().GetContext().Pool->ParallelFor(
        m_bodies.GetSize(), kGrain, [&](size_t begin, size_t end, UInt32) {
          size_t touching = 0;
          m_bodies.ForEach(begin, end, [&](const CEmbodiedEntity& body, size_t i) {
            touching += m_grown[i] != nullptr && IsTouching(body, *m_grown[i]) ? 1 : 0;
          });
          count += touching;
        });
    // models of users may use memory of their own
    m_bodies.ForEach([&](const CEmbodiedEntity& body, size_t i) {
      count += m_grown[i] == nullptr && body.IsCollidingWithSomething() ? 1 : 0;
    });
    return static_cast<Real>(count);
  }

 private:
  // robots of a type share their description
  struct SGrown {
    std::shared_ptr<const SBodyDescription> Original;  // keeps its address from being used again
    SBodyDescription Description;
  };

  void Grow() {
    const bool isNew = m_bodies.Update();
    if (isNew) {
      m_originals.assign(m_bodies.GetSize(), nullptr);
      m_grown.assign(m_bodies.GetSize(), nullptr);
    }
    m_bodies.ForEach([&](const CEmbodiedEntity& body, size_t i) {
      const std::shared_ptr<const SBodyDescription>& original = body.GetSharedBodyDescription();
      if (original.get() == m_originals[i]) {
        return;
      }
      m_originals[i] = original.get();
      m_grown[i] = original != nullptr && !original->Shapes.empty() ? &GetGrown(original) : nullptr;
    });
  }

  const SBodyDescription& GetGrown(const std::shared_ptr<const SBodyDescription>& original) {
    const auto [found, isNew] = m_descriptions.try_emplace(original.get());
    if (isNew) {
      found->second = {original, GrowBody(*original, kTouchDistance)};
    }
    return found->second.Description;
  }

  bool IsTouching(const CEmbodiedEntity& body, const SBodyDescription& grown) const {
    const SAnchor& origin = body.GetOriginAnchor();
    return m_bodies.GetSpace().GetBodyIndex().FindOverlap(
               grown, origin.Position, origin.Orientation, body.GetBodyNumber(),
               body.GetLinkPoses()) != CBodyIndex::kNoBody;
  }

  CRobotBodies m_bodies;
  std::vector<const SBodyDescription*> m_originals;  // are indexed by body
  std::vector<const SBodyDescription*> m_grown;  // are indexed by body; null without a description
  std::map<const SBodyDescription*, SGrown> m_descriptions;  // keyed by original; never iterated
};

}  // namespace

REGISTER_BUILT_IN_METRIC(
    CDispersion, "dispersion", "the authors of this project", "1.0",
    "How far robots are spread: their rms distance from their centroid, m.",
    R"(The square root of the mean square of the distances of the robots' origins from their mean, in space.
Robots that have a body and are not disabled (quarantined) count; without any there is no value. Along a periodic axis of
the arena, which is a circle, their mean is that of directions, and distances are the shortest ones.

  <metrics file="metrics.csv" builtin="dispersion" />
)",
    "Usable")
REGISTER_BUILT_IN_METRIC(
    CCollisions, "collisions", "the authors of this project", "1.0",
    "The number of robots that touch another body at the end of the tick.",
    R"(A robot counts once, whatever it touches: robots, walls, objects, and one that it grips; the ground is no body.
Two robots that touch each other are two. To touch is to be closer than 1 mm, or to overlap: engines keep
small gaps between bodies that press against each other. It is found from the solids that describe the bodies, at their
poses when PostStep() is done, in the same way for all engines, and for IsCollidingWithSomething(). For a body without a description, which a model of a
user's library represents, its model's IsCollidingWithSomething() decides.
Robots that have a body and are not disabled (quarantined) count.

  <metrics file="metrics.csv" builtin="collisions" />
)",
    "Usable")

}  // namespace argos
