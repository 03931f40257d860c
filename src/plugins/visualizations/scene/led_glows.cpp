#include <argos3/plugins/simulator/visualizations/scene/led_glows.h>

#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/core/utility/math/eigen_bridge.h>
#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>

#include <algorithm>

namespace argos {

namespace {

constexpr float kHaloScale = 3.6f;  // radii
constexpr float kLampHaloScale = 4.5f;  // radii
constexpr SRgba kDark = {46, 48, 54, 255};
constexpr double kUndeclaredDiameter = 0.01;  // m; between those of the e-puck and the foot-bot

bool IsDeclared(const SAppearance& appearance, size_t number) {
  return std::any_of(appearance.Parts.begin(), appearance.Parts.end(),
                     [number](const SVisualPart& part) {
                       return part.Kind == SVisualPart::EKind::LED && part.LED == number;
                     });
}

}  // namespace

CColor GetLEDColorOrBlack(const CLEDEquippedEntity* leds, UInt32 number) {
  return leds != nullptr && number < leds->GetNumLEDs() ? leds->GetLEDColor(number) : CColor();
}

CColor GetLEDColorOrBlack(const CDirectionalLEDEquippedEntity* leds, UInt32 number) {
  return leds != nullptr && number < leds->GetNumLEDs() ? leds->GetLED(number).GetColor()
                                                        : CColor();
}

SGlow MakeLEDGlow(const SPose& pose, double diameter, const CColor& color) {
  SGlow glow;
  glow.Position = ToFloats(pose.Translation);
  glow.Radius = static_cast<float>(0.5 * diameter);
  glow.Color = kDark;
  if (color != CColor()) {
    glow.Color = ToRgba(color);
    glow.HaloScale = kHaloScale;
    glow.IsSignal = 1.0f;
  }
  return glow;
}

SGlow MakeLampGlow(const SPose& pose, double diameter, const CColor& color, Real intensity) {
  if (intensity <= 0.0) {
    return MakeLEDGlow(pose, diameter, CColor());
  }
  SGlow glow;
  glow.Position = ToFloats(pose.Translation);
  glow.Radius = static_cast<float>(0.5 * diameter);
  glow.Color = ToRgba(color);
  glow.HaloScale = kLampHaloScale;
  glow.IsLamp = true;
  return glow;
}

void AddUndeclaredLEDs(const SAppearance& appearance, const CLEDEquippedEntity& leds,
                       SScene& scene) {
  for (size_t i = 0; i < leds.GetNumLEDs(); ++i) {
    if (IsDeclared(appearance, i)) {
      continue;
    }
    const SPose place =
        ComputeAnchorPose(leds.GetLEDAnchor(i)) * ToPose(leds.GetLEDOffset(i), CQuaternion());
    scene.Glows.push_back(MakeLEDGlow(place, kUndeclaredDiameter, leds.GetLEDColor(i)));
  }
}

}  // namespace argos
