#include <argos3/testing/support/still_engine.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>

#include <algorithm>

namespace argos::testing {

namespace {

class CStillModel : public CPhysicsModel {
 public:
  CStillModel(CPhysicsEngine& engine, CEmbodiedEntity& body) : CPhysicsModel(engine, body) {
    UpdateEntityStatus();
  }

  void UpdateFromEntityStatus() override {}
  void MoveTo(const CVector3& position, const CQuaternion& orientation) override {
    m_cEmbodiedEntity.SetOriginPose(position, orientation);
    UpdateEntityStatus();
  }
  void CalculateBoundingBox() override {
    m_sBoundingBox.MinCorner = m_cEmbodiedEntity.GetOriginAnchor().Position;
    m_sBoundingBox.MaxCorner = m_cEmbodiedEntity.GetOriginAnchor().Position;
  }
  bool IsCollidingWithSomething() const override { return false; }
};

CEmbodiedEntity& BodyOf(CEntity& entity) {
  return dynamic_cast<CComposableEntity&>(entity).GetComponent<CEmbodiedEntity>("body");
}

}  // namespace

void CStillEngine::Update() {
  for (const auto& model : m_models) {
    model->UpdateEntityStatus();
  }
}

bool CStillEngine::AddEntity(CEntity& entity) {
  CEmbodiedEntity& body = BodyOf(entity);
  m_models.push_back(std::make_unique<CStillModel>(*this, body));
  body.AddPhysicsModel(GetId(), *m_models.back());
  return true;
}

bool CStillEngine::RemoveEntity(CEntity& entity) {
  CEmbodiedEntity& body = BodyOf(entity);
  const auto found = std::find_if(m_models.begin(), m_models.end(), [&body](const auto& model) {
    return &model->GetEmbodiedEntity() == &body;
  });
  if (found == m_models.end()) {
    return false;
  }
  body.RemovePhysicsModel(GetId());
  m_models.erase(found);
  return true;
}

}  // namespace argos::testing

using argos::testing::CStillEngine;
REGISTER_PHYSICS_ENGINE(CStillEngine, "still", "the ARGoS maintainers", "1.0",
                        "Nothing moves by itself.", "For tests: takes every body.", "Testing")
