#include <argos3/core/simulator/placement/arena_filling.h>

#include <argos3/core/simulator/placement/distribution.h>
#include <argos3/core/simulator/space/space.h>

namespace argos {

void FillArena(CSpace& space, TConfigurationNode& arena, CLoadErrors& errors) {
  const std::string distribute = "distribute";
  TConfigurationNodeIterator it;
  for (it = it.begin(&arena); it != it.end(); ++it) {
    if (it->Value() != distribute) {
      errors.Try("", [&] { space.CreateEntity(*it); });
    }
  }
  for (it = it.begin(&arena); it != it.end(); ++it) {
    if (it->Value() == distribute) {
      errors.Try("", [&] { CDistribution(space, *it).Place(); });
    }
  }
}

}  // namespace argos
