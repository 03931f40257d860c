#include <argos3/core/simulator/placement/arena_filling.h>

#include <argos3/core/simulator/placement/distribution.h>
#include <argos3/core/simulator/space/space.h>

namespace argos {

void FillArena(CSpace& space, TConfigurationNode& arena, CLoadErrors& errors) {
  const std::string distribute = "distribute";
  TConfigurationNodeIterator it;
  for (it = it.begin(&arena); it != it.end(); ++it) {
    if (it->Value() != distribute) {
      if (!errors.Try("", [&] { space.CreateEntity(*it); })) {
        errors.FindFurther([&] { space.TryEntity(*it); });
      }
    }
  }
  for (it = it.begin(&arena); it != it.end(); ++it) {
    if (it->Value() == distribute) {
      CDistribution distribution(space, *it, errors);
      if (!errors.Try("", [&] { distribution.Place(); })) {
        errors.FindFurther([&] { distribution.TryTemplate(); });
      }
    }
  }
}

}  // namespace argos
