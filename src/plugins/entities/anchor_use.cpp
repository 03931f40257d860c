#include <argos3/plugins/simulator/entities/anchor_use.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>

#include <algorithm>

namespace argos {

void CountFollower(CEntity& component, bool enabled) {
  auto* const robot = dynamic_cast<CComposableEntity*>(&component.GetRootEntity());
  if (robot == nullptr) {
    return;
  }
  for (CEntity* part : robot->GetExistingComponents()) {
    if (auto* const body = dynamic_cast<CEmbodiedEntity*>(part)) {
      body->CountFollower(enabled);
      return;
    }
  }
}

void SetFollowerEnabled(CEntity& component, bool enabled) {
  const bool changes = enabled != component.IsEnabled();
  component.CEntity::SetEnabled(enabled);
  if (changes) {
    CountFollower(component, enabled);
  }
}

void MountOnAnchor(SAnchor& anchor, const CEntity& user) {
  if (anchor.Index == 0) {
    return;
  }
  if (user.IsEnabled()) {
    anchor.Enable();
  }
  // Reset() keeps this use of the anchor
  if (user.IsEnabledAtStart()) {
    ++anchor.InUseCountAtStart;
  }
}

UInt32 NumberOfAnchor(TAnchorsInUse& anchors, SAnchor& anchor, const CEntity& user) {
  const auto known = std::find(anchors.begin(), anchors.end(), &anchor);
  if (known != anchors.end()) {
    return static_cast<UInt32>(known - anchors.begin());
  }
  anchors.push_back(&anchor);
  MountOnAnchor(anchor, user);
  return static_cast<UInt32>(anchors.size() - 1);
}

}  // namespace argos
