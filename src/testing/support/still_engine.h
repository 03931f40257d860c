#ifndef ARGOS3_TESTING_SUPPORT_STILL_ENGINE_H
#define ARGOS3_TESTING_SUPPORT_STILL_ENGINE_H

#include <argos3/core/simulator/physics_engine/physics_engine.h>

#include <memory>
#include <vector>

namespace argos::testing {

/**
 * A physics engine in which nothing moves by itself: label "still".
 *
 * Takes every body, at any pose, tilted ones too; poses stay exactly as given. So what sensors read
 * can be told from geometry alone.
 */
class CStillEngine : public CPhysicsEngine {
 public:
  void Update() override;
  size_t GetNumPhysicsModels() override { return m_models.size(); }
  bool AddEntity(CEntity& entity) override;
  bool RemoveEntity(CEntity& entity) override;
  void CheckIntersectionWithRay(TEmbodiedEntityIntersectionData&, const CRay3&) const override {}

 private:
  std::vector<std::unique_ptr<CPhysicsModel>> m_models;
};

}  // namespace argos::testing

#endif
