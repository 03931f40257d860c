#include <argos3/core/simulator/placement/arena_filling.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/described_body_model.h>
#include <argos3/core/simulator/placement/planned_bodies.h>
#include <argos3/core/simulator/placement/recorded_start.h>
#include <argos3/core/simulator/placement/walls.h>
#include <argos3/core/simulator/space/space.h>

namespace argos {

CArenaFilling::CArenaFilling(CSpace& space, TConfigurationNode& arena, CLoadErrors& errors)
    : m_space(space) {
  errors.Try("", [&] {
    GetNodeAttributeOrDefault(arena, "redistribute", m_isRedistributedByReset, false);
  });
  errors.Try("", [&] { AddWallsAround(space, arena); });
  const std::string distribute = "distribute";
  TConfigurationNodeIterator it;
  for (it = it.begin(&arena); it != it.end(); ++it) {
    if (it->Value() == "walls") {
      errors.Try("", [&] { AddWalls(space, *it); });
    } else if (it->Value() != distribute) {
      if (!errors.Try("", [&] { space.CreateEntity(*it); })) {
        errors.FindFurther([&] { space.TryEntity(*it); });
      }
    }
  }
  if (!space.GetRootEntityVector().empty()) {
    m_endOfSingles = space.GetRootEntityVector().back()->GetIndex() + 1;
  }
  for (it = it.begin(&arena); it != it.end(); ++it) {
    if (it->Value() == distribute) {
      m_distributions.push_back(std::make_unique<CDistribution>(space, *it, errors));
      CDistribution& distribution = *m_distributions.back();
      if (!errors.Try("", [&] { distribution.Place(); })) {
        errors.FindFurther([&] { distribution.TryTemplate(); });
      }
    }
  }
  // a consequence of reported errors would be an error of its own
  if (errors.IsEmpty()) {
    errors.Try("", [&] { PlaceAsRecorded(space, arena); });
  }
}

void CArenaFilling::Redistribute() {
  CPlannedBodies bodies(m_space.GetContext().Arena);
  m_space.ForRootsAsCreated([&](CEntity& root, size_t) {
    CEmbodiedEntity* const body = FindEmbodiedEntity(root);
    if (root.GetIndex() < m_endOfSingles && body != nullptr &&
        body->GetBodyDescription() != nullptr) {
      bodies.Add(body, body->GetSharedBodyDescription(),
                 {body->GetInitPosition(), body->GetInitOrientation()});
    }
  });
  for (const auto& distribution : m_distributions) {
    distribution->ChooseAgain(bodies);
  }
  for (const auto& distribution : m_distributions) {
    distribution->TakeChosen();
  }
}

}  // namespace argos
