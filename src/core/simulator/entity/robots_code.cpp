#include <argos3/core/simulator/entity/robots_code.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/running_code.h>

#include <utility>

namespace argos {

std::atomic<UInt32> CRobotsCode::s_numLoops{0};

namespace {

constexpr char kInHooks[] = "it is possible in PreStep() and PostStep() of the loop functions";

// the robot whose code the thread runs; null if it is not known, as in hooks that robots call
const CControllableEntity* GetRobot(const SRunningCode& code) {
  return code.Describe == &CControllableEntity::Describe
             ? static_cast<const CControllableEntity*>(code.Subject)
             : nullptr;
}

// false for a component that is being created, and for a copy
bool IsInSpace(const CEntity& entity) {
  return entity.GetIndex() >= 0 && !entity.IsCopy();
}

bool IsOfRunningRobot(const CEntity& entity) {
  const CControllableEntity* const robot = GetRobot(SRunningCode::OfThread());
  return robot != nullptr && &robot->GetRootEntity() == &entity.GetRootEntity();
}

[[noreturn]] void Refuse(const char* call, const CEntity* entity, const char* why,
                         const char* hint = kInHooks) {
  const std::string caller = SRunningCode::OfThread().ToText();
  THROW_ARGOSEXCEPTION(caller << ": " << call
                              << (entity != nullptr
                                      ? " of \"" + entity->GetContext() + entity->GetId() + '"'
                                      : std::string())
                              << " must not be called while robots sense and are controlled, "
                                 "because "
                              << why << "; " << hint);
}

constexpr char kOthersReadIt[] = "others read what it changes at the same time";
constexpr char kIsOfAnother[] = "only its own robot may change it then";

}  // namespace

bool CRobotsCode::IsRunning() {
  return MayRun() && SRunningCode::OfThread().IsBesideOthers;
}

void CRobotsCode::CheckShared(const char* call, const char* hint) {
  if (SRunningCode::OfThread().IsBesideOthers) {
    Refuse(call, nullptr, kOthersReadIt, hint != nullptr ? hint : kInHooks);
  }
}

void CRobotsCode::CheckShared(const CEntity& entity, const char* call) {
  if (SRunningCode::OfThread().IsBesideOthers && IsInSpace(entity)) {
    Refuse(call, &entity, kOthersReadIt);
  }
}

void CRobotsCode::CheckOwn(const CEntity& entity, const char* call) {
  static_cast<void>(IsOwner(entity, call));
}

// returns false if everything may be changed now
bool CRobotsCode::IsOwner(const CEntity& entity, const char* call) {
  if (!SRunningCode::OfThread().IsBesideOthers || !IsInSpace(entity)) {
    return false;
  }
  if (!IsOfRunningRobot(entity)) {
    Refuse(call, &entity, kIsOfAnother);
  }
  return true;
}

void CRobotsCode::ChangeLater(std::function<void()> change) {
  CurrentContext().Run.DeferComponentChange(std::move(change));
}

bool EnablesLater(CEntity& entity, bool enabled) {
  return CRobotsCode::ChangesLater(entity, enabled ? "Enable()" : "Disable()",
                                   [&entity, enabled] { entity.SetEnabled(enabled); });
}

std::unique_lock<std::recursive_mutex> CRobotsCode::LockLazy() {
  static std::recursive_mutex mutex;
  return MayRun() ? std::unique_lock<std::recursive_mutex>(mutex)
                  : std::unique_lock<std::recursive_mutex>();
}

}  // namespace argos
