#include <argos3/core/simulator/physics_engine/border_bundles.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/geometry/shape_overlap.h>
#include <argos3/core/simulator/physics_engine/described_body_engine.h>

#include <algorithm>
#include <typeinfo>

namespace argos {

namespace {

// m; bodies at rest that are nearer may touch in the next tick, because robots start to drive
constexpr Real kNearGap = 0.03;
// limit of how much faster bodies become from one tick to the next
constexpr Real kFaster = 1.5;
// m; fixed bodies in this distance of a body outside of its engine's region are added to the engine
constexpr Real kFixedReach = 0.3;

bool IsObject(const CEmbodiedEntity& body) {
  const SBodyDescription& description = *body.GetBodyDescription();
  return !description.HasDrive() && !description.Propellers;
}

// the longest way of a point of the body in a tick at its present speed, m
Real ComputePath(const CPhysicsEngine& engine, const CEmbodiedEntity& body, Real tick) {
  SBodyMotion motion;
  if (!engine.GetMotion(body, motion)) {
    return 0.0;
  }
  return tick * (motion.Velocity.Length() +
                 motion.Rotation.Length() * body.GetBodyDescription()->ComputeBoundingRadius());
}

bool IsSameType(const CPhysicsEngine& a, const CPhysicsEngine& b) {
  return typeid(a) == typeid(b);
}

SIndexedShape Grown(SIndexedShape shape, Real margin) {
  shape.HalfX += margin;
  shape.HalfY += margin;
  shape.Radius += 2.0 * margin;
  shape.ZMin -= margin;
  shape.ZMax += margin;
  return shape;
}

}  // namespace

bool CBorderBundles::Update() {
  ForgetBundles();
  bool hasMoved = false;
  if (FindSeeds()) {
    for (const UInt32 seed : m_seeds) {
      SMember member;
      if (m_isVisited[seed] == 0 && Find(seed, member)) {
        FindBundle(member);
        hasMoved = MoveBundle() || hasMoved;
      }
    }
    for (const UInt32 number : m_visited) {
      m_isVisited[number] = 0;
    }
    m_visited.clear();
  }
  return ReturnStrays() || hasMoved;
}

void CBorderBundles::ForgetBundles() {
  m_strays.clear();
  for (CPhysicsEngine* engine : m_context.Engines) {
    if (auto* const described = dynamic_cast<CDescribedBodyEngine*>(engine)) {
      for (CEmbodiedEntity* body : described->m_strays) {
        m_strays.push_back({body, described});
      }
      described->ForgetBundles();
    }
  }
}

// Bodies that have left their bundle move to the engine of their region. @return true if one has.
bool CBorderBundles::ReturnStrays() {
  bool hasMoved = false;
  for (const SMember& stray : m_strays) {
    const CDescribedBodyModel* const model = stray.Engine->FindModel(*stray.Body);
    if (model != nullptr && !model->m_isBundled && !stray.Engine->ContainsOriginOf(*stray.Body)) {
      stray.Engine->TransferEntity(*stray.Body);
      hasMoved = true;
    }
  }
  return hasMoved;
}

// Objects near borders, and bodies outside of their engine's region. @return false if none.
bool CBorderBundles::FindSeeds() {
  m_seeds.clear();
  for (const SMember& stray : m_strays) {
    // it may have been moved since
    if (!stray.Engine->ContainsOriginOf(*stray.Body)) {
      m_seeds.push_back(stray.Body->GetBodyNumber());
    }
  }
  m_reach = 0.0;
  for (CPhysicsEngine* engine : m_context.Engines) {
    if (!engine->SeesGhosts()) {
      continue;
    }
    m_reach = std::max(m_reach, engine->GetGhostReach());
    for (const SGhost& ghost : engine->GetGhosts()) {
      if (ghost.IsObject) {
        m_seeds.push_back(ghost.Body->GetBodyNumber());
      }
    }
  }
  std::sort(m_seeds.begin(), m_seeds.end());
  m_seeds.erase(std::unique(m_seeds.begin(), m_seeds.end()), m_seeds.end());
  if (m_seeds.empty()) {
    return false;
  }
  if (m_isVisited.size() < m_context.Index->GetEndOfNumbers()) {
    m_isVisited.resize(m_context.Index->GetEndOfNumbers(), 0);
  }
  return true;
}

// @return false if the body is not movable, or in an engine without ghosts.
bool CBorderBundles::Find(UInt32 number, SMember& member) const {
  CEmbodiedEntity& body = m_context.Index->GetBody(number);
  if (!body.IsMovable() || body.GetPhysicsModelsNum() == 0) {
    return false;
  }
  auto* const engine =
      dynamic_cast<CDescribedBodyEngine*>(&body.GetPhysicsModel(size_t(0)).GetEngine());
  if (engine == nullptr || !engine->SeesGhosts() || engine->FindModel(body) == nullptr) {
    return false;
  }
  member = {&body, engine};
  return true;
}

void CBorderBundles::Include(const SMember& member) {
  const UInt32 number = member.Body->GetBodyNumber();
  m_isVisited[number] = 1;
  m_visited.push_back(number);
  m_bundle.push_back(member);
}

// sets m_bundle to all bodies that are connected to the seed
void CBorderBundles::FindBundle(const SMember& seed) {
  m_bundle.clear();
  Include(seed);
  for (size_t i = 0; i < m_bundle.size(); ++i) {
    const SMember member = m_bundle[i];
    AddNeighbours(member);
    AddGripped(member);
  }
}

void CBorderBundles::AddNeighbours(const SMember& member) {
  const UInt32 number = member.Body->GetBodyNumber();
  const bool isObject = IsObject(*member.Body);
  const Real tick = m_context.TickLength;
  const Real path = ComputePath(*member.Engine, *member.Body, tick);
  const SBoundingBox& box = member.Body->GetBoundingBox();
  const Real far = m_reach + path;
  m_own.clear();
  m_near.clear();
  m_context.Index->ForShapesInArea({box.MinCorner.GetX() - far, box.MinCorner.GetY() - far,
                                    box.MaxCorner.GetX() + far, box.MaxCorner.GetY() + far},
                                   [&](const SIndexedShape& shape) {
                                     if (shape.Body == number) {
                                       m_own.push_back(shape);
                                     } else if (m_isVisited[shape.Body] == 0) {
                                       m_near.push_back(shape);
                                     }
                                   });
  for (const SIndexedShape& shape : m_near) {
    SMember other;
    if (m_isVisited[shape.Body] != 0 || !Find(shape.Body, other) ||
        (!isObject && !IsObject(*other.Body)) || !Meet(member, other)) {
      continue;
    }
    const Real margin = kNearGap + kFaster * (path + ComputePath(*other.Engine, *other.Body, tick));
    const bool isNear =
        std::any_of(m_own.begin(), m_own.end(), [&shape, margin](const SIndexedShape& own) {
          return ShapesOverlap(Grown(own, margin), shape);
        });
    if (isNear) {
      Include(other);
    }
  }
}

// @return false for bodies of two types of engines that share the space where they are.
bool CBorderBundles::Meet(const SMember& a, const SMember& b) {
  if (IsSameType(*a.Engine, *b.Engine)) {
    return true;
  }
  const auto isShared = [&](const CEmbodiedEntity& body) {
    return a.Engine->ContainsOriginOf(body) && b.Engine->ContainsOriginOf(body);
  };
  return !isShared(*a.Body) && !isShared(*b.Body);
}

void CBorderBundles::AddGripped(const SMember& member) {
  member.Engine->FindCluster(*member.Body, m_gripped);
  for (CEmbodiedEntity* body : m_gripped) {
    SMember other;
    if (m_isVisited[body->GetBodyNumber()] == 0 && Find(body->GetBodyNumber(), other)) {
      Include(other);
    }
  }
}

// @return true if a body of m_bundle has changed its engine.
bool CBorderBundles::MoveBundle() {
  if (m_bundle.size() < 2) {
    return false;
  }
  std::sort(m_bundle.begin(), m_bundle.end(), [](const SMember& a, const SMember& b) {
    return a.Body->GetIndex() < b.Body->GetIndex();
  });
  CDescribedBodyEngine& engine = ChooseEngine();
  bool hasMoved = false;
  for (const SMember& member : m_bundle) {
    CEmbodiedEntity& body = *member.Body;
    if (engine.FindModel(body) == nullptr) {
      if (!MayBeIn(engine, member)) {
        continue;
      }
      member.Engine->FindCluster(body, m_gripped);
      engine.AdoptCluster(*member.Engine, m_gripped);
      hasMoved = true;
    } else if (!MayStayIn(engine, body)) {
      continue;
    }
    engine.NoteBundled(*engine.FindModel(body));
    if (!engine.ContainsOriginOf(body)) {
      AddFixedNear(member, engine);
    }
  }
  return hasMoved;
}

// The engine of the first body's region. Where engines of several types meet, the first one, in the
// order of the bodies, that all of them may be in.
CDescribedBodyEngine& CBorderBundles::ChooseEngine() {
  const auto isOfFirstType = [this](const SMember& member) {
    return IsSameType(*member.Engine, *m_bundle.front().Engine);
  };
  CDescribedBodyEngine& first = FindEngineOfPlace(m_bundle.front());
  if (std::all_of(m_bundle.begin(), m_bundle.end(), isOfFirstType)) {
    return first;
  }
  for (const SMember& leader : m_bundle) {
    CDescribedBodyEngine& engine = FindEngineOfPlace(leader);
    if (std::all_of(m_bundle.begin(), m_bundle.end(), [&engine](const SMember& member) {
          return engine.FindModel(*member.Body) != nullptr || MayBeIn(engine, member);
        })) {
      return engine;
    }
  }
  return first;
}

// the engine of the body, or the one that it is going to, if it has left the region
CDescribedBodyEngine& CBorderBundles::FindEngineOfPlace(const SMember& member) {
  if (member.Engine->ContainsOriginOf(*member.Body)) {
    return *member.Engine;
  }
  CDescribedBodyEngine* found = member.Engine;
  member.Engine->FindNextEngine(*member.Body, [&](CPhysicsEngine& next) {
    auto* const described = dynamic_cast<CDescribedBodyEngine*>(&next);
    const bool isFound =
        described != nullptr && described->SeesGhosts() && MayBeIn(*described, member);
    found = isFound ? described : found;
    return isFound;
  });
  return *found;
}

// @return false if a body of another engine cannot be moved to this one.
bool CBorderBundles::MayBeIn(CDescribedBodyEngine& engine, const SMember& member) {
  if (!MayStayIn(engine, *member.Body)) {
    return false;
  }
  if (IsSameType(engine, *member.Engine)) {
    return true;
  }
  // grips end where the type changes
  CDescribedBodyEngine::TBodies gripped;
  member.Engine->FindCluster(*member.Body, gripped);
  return gripped.size() == 1 &&
         member.Engine->MayMoveTo(engine, *member.Engine->FindModel(*member.Body));
}

// @return false if the body is beyond a wall of the engine, or outside of all regions.
bool CBorderBundles::MayStayIn(CDescribedBodyEngine& engine, const CEmbodiedEntity& body) {
  if (!engine.Accepts(body)) {
    return false;
  }
  if (engine.ContainsOriginOf(body)) {
    return true;
  }
  const SFace* const exit = engine.GetVolume().FindExit(body.GetOriginAnchor().Position);
  return (exit == nullptr || !exit->IsWall) && engine.FindNextEngine(body) != nullptr;
}

// Fixed bodies are in the engines whose regions they touch; others move here.
void CBorderBundles::AddFixedNear(const SMember& member, CDescribedBodyEngine& engine) const {
  const SBoundingBox& box = member.Body->GetBoundingBox();
  const CBodyIndex& index = *m_context.Index;
  std::vector<CEmbodiedEntity*> missing;
  index.ForShapesInArea({box.MinCorner.GetX() - kFixedReach, box.MinCorner.GetY() - kFixedReach,
                         box.MaxCorner.GetX() + kFixedReach, box.MaxCorner.GetY() + kFixedReach},
                        [&](const SIndexedShape& shape) {
                          CEmbodiedEntity& body = index.GetBody(shape.Body);
                          if (!body.IsMovable() && engine.FindModel(body) == nullptr &&
                              engine.Accepts(body) &&
                              std::find(missing.begin(), missing.end(), &body) == missing.end()) {
                            missing.push_back(&body);
                          }
                        });
  std::sort(missing.begin(), missing.end(), SEntityComparator());
  for (CEmbodiedEntity* body : missing) {
    engine.AddEntity(body->GetRootEntity());
  }
}

}  // namespace argos
