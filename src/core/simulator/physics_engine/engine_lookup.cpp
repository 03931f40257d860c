#include <argos3/core/simulator/physics_engine/engine_lookup.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/text/string_utilities.h>

namespace argos {

namespace {

/** An engine without bodies: only its clock is of use. */
class CStandInEngine : public CPhysicsEngine {
 public:
  explicit CStandInEngine(const std::string& id) {
    SetId(id);
    SetIterations(GetIterations());  // computes the length of a substep
  }
  void Update() override {}
  size_t GetNumPhysicsModels() override { return 0; }
  bool AddEntity(CEntity&) override { return false; }
  bool RemoveEntity(CEntity&) override { return false; }
  void CheckIntersectionWithRay(TEmbodiedEntityIntersectionData&, const CRay3&) const override {}
};

}  // namespace

CEngineLookup::~CEngineLookup() = default;

CPhysicsEngine& CEngineLookup::Get(const std::string& id) {
  for (CPhysicsEngine* engine : m_context.Engines) {
    if (engine->GetId() == id) {
      return *engine;
    }
  }
  const std::scoped_lock lock(m_mutex);
  if (m_reported.insert(id).second) {
    Warn(id);
  }
  if (m_context.Engines.size() == 1) {
    return *m_context.Engines.front();
  }
  if (m_standIn == nullptr) {
    m_standIn = std::make_unique<CStandInEngine>(id);
  }
  return *m_standIn;
}

void CEngineLookup::Warn(const std::string& id) {
  std::vector<std::string> ids;
  for (const CPhysicsEngine* engine : m_context.Engines) {
    ids.push_back(engine->GetId());
  }
  LOGERR << "[WARNING] GetPhysicsEngine(\"" << id << "\"): ";
  if (ids.empty()) {
    LOGERR
        << "the physics engines do not exist yet. An engine without bodies, which only knows the "
           "clock, is used instead; for other purposes call it in Init() of the loop functions";
  } else {
    LOGERR << "there is no such physics engine" << DidYouMean(id, ids) << "; ";
    if (ids.size() == 1) {
      LOGERR << "\"" << ids.front() << "\", the only one, is used instead";
    } else {
      LOGERR << "an engine without bodies, which only knows the clock, is used instead";
    }
  }
  LOGERR << " (reported once)" << std::endl;
}

}  // namespace argos
