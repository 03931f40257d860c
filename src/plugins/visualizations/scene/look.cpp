#include <argos3/plugins/simulator/visualizations/scene/look.h>

#include <argos3/core/utility/configuration/argos_exception.h>

namespace argos {

namespace {

SLook MakeLightLook() {
  SLook look;
  look.Background = {252, 252, 252, 255};
  look.Ground = {232, 234, 236, 255};
  look.GroundOutside = {247, 247, 248, 255};
  look.GridLine = {150, 156, 164, 255};
  look.Boundary = {72, 78, 88, 255};
  look.Marker = {28, 84, 150, 255};
  look.SunIntensity = 0.78f;
  look.SkyLight = {236, 242, 255, 255};
  look.BounceLight = {190, 186, 180, 255};
  look.AmbientIntensity = 0.46f;
  look.SpecularIntensity = 0.20f;
  look.EdgeDarkening = 0.35f;
  look.ContactDarkening = 0.42f;
  look.HaloStrength = 0.55f;
  look.HaloOpacity = 1.0f;
  return look;
}

SLook MakeDarkLook() {
  SLook look;
  look.Background = {18, 20, 24, 255};
  look.Ground = {52, 56, 63, 255};
  look.GroundOutside = {26, 28, 33, 255};
  look.GridLine = {104, 112, 124, 255};
  look.Boundary = {176, 184, 196, 255};
  look.Marker = {122, 190, 255, 255};
  look.SunIntensity = 0.72f;
  look.SkyLight = {214, 226, 255, 255};
  look.BounceLight = {120, 124, 136, 255};
  look.AmbientIntensity = 0.36f;
  look.SpecularIntensity = 0.28f;
  look.EdgeDarkening = 0.30f;
  look.ContactDarkening = 0.50f;
  look.HaloStrength = 0.75f;
  look.HaloOpacity = 0.15f;
  return look;
}

}  // namespace

SLook SLook::FromName(const std::string& name) {
  if (name == "light") {
    return MakeLightLook();
  }
  if (name == "dark") {
    return MakeDarkLook();
  }
  THROW_ARGOSEXCEPTION("There is no look \"" << name << "\"; choose \"light\" or \"dark\"");
}

}  // namespace argos
