#include <argos3/testing/support/sight_reference.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/entities/led_entity.h>
#include <argos3/testing/support/solid_reference.h>

#include <algorithm>

namespace argos {

bool ReferenceInSight(CSpace& space, const CVector3& eye, const CVector3& point,
                      const std::string& viewer) {
  constexpr Real kTouch = 1e-8;  // m; bodies in tests occlude by more
  for (CEntity* root : space.GetRootEntityVector()) {
    auto* composable = dynamic_cast<CComposableEntity*>(root);
    if (composable == nullptr || root->GetId() == viewer || !composable->HasComponent("body")) {
      continue;
    }
    const auto& body = composable->GetComponent<CEmbodiedEntity>("body");
    const SAnchor& origin = body.GetOriginAnchor();
    const auto hit = ReferenceHit({body.GetBodyDescription(), origin.Position, origin.Orientation},
                                  CRay3(eye, point));
    if (hit && (1.0 - *hit) * Distance(eye, point) > kTouch) {
      return false;
    }
  }
  return true;
}

std::vector<CLEDEntity*> ReferenceLitLEDs(CSpace& space) {
  std::vector<CLEDEntity*> leds;
  for (CEntity* entity : space.GetEntityVector()) {
    auto* led = dynamic_cast<CLEDEntity*>(entity);
    if (led != nullptr && led->IsEnabled() && led->IsLit()) {
      leds.push_back(led);
    }
  }
  std::sort(leds.begin(), leds.end(), SEntityComparator());
  return leds;
}

}  // namespace argos
