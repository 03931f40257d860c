#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>

#include <cstdlib>
#include <iomanip>
#include <iostream>

using namespace argos;

// positions of all robots at this moment
static void Print(CSimulator& simulator) {
  CSpace& space = simulator.GetSpace();
  for (const auto& [id, entity] : space.GetEntitiesByType("controller")) {
    CComposableEntity& robot = any_cast<CControllableEntity*>(entity)->GetParent();
    const SAnchor& origin = robot.GetComponent<CEmbodiedEntity>("body").GetOriginAnchor();
    std::cout << "tick " << space.GetSimulationClock() << ": " << robot.GetId() << " is at ("
              << std::fixed << std::setprecision(3) << origin.Position.GetX() << ", "
              << origin.Position.GetY() << ")\n";
  }
}

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: embedding EXPERIMENT\n";
    return EXIT_FAILURE;
  }
  CSimulator simulator;
  const CSimulator::CScope scope(simulator);  // what CSimulator::GetInstance() returns meanwhile
  simulator.SetExperimentFileName(argv[1]);
  simulator.LoadExperiment();

  Print(simulator);
  while (!simulator.IsExperimentFinished()) {
    simulator.UpdateSpace();  // one tick
    if (simulator.GetSpace().GetSimulationClock() % 50 == 0) {
      Print(simulator);
    }
  }

  // the same again, with another seed: simulator.Reset(seed) and so on
  simulator.Reset();
  Print(simulator);
  simulator.Destroy();
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
