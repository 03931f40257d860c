// Evolves the two wheel speeds with which a robot is nearest to a target after ten seconds.
#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <thread>
#include <vector>

using namespace argos;

using TGenome = std::array<Real, 2>;  // speeds of the left and the right wheel, cm/s

/** Drives at the speeds of the genome. Registered by this program: the file names no library. */
class CGenomeController : public CCI_Controller {
 public:
  void Init(TConfigurationNode&) override {
    m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  }
  void ControlStep() override { m_wheels->SetLinearVelocity(m_genome[0], m_genome[1]); }
  void SetGenome(const TGenome& genome) { m_genome = genome; }

 private:
  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  TGenome m_genome = {};
};

REGISTER_CONTROLLER(CGenomeController, "genome")

/** A simulation that is loaded once and run again for each genome. For one thread at a time. */
class CTrial {
 public:
  explicit CTrial(const std::string& experiment) {
    const CSimulator::CScope scope(m_simulator);
    m_simulator.SetExperimentFileName(experiment);
    m_simulator.LoadExperiment();
  }

  /** @return distance from the target at the end, m: less is better. */
  Real Evaluate(const TGenome& genome) {
    const CSimulator::CScope scope(m_simulator);
    auto& robot = dynamic_cast<CComposableEntity&>(m_simulator.GetSpace().GetEntity("robot"));
    auto& controllable = robot.GetComponent<CControllableEntity>("controller");
    dynamic_cast<CGenomeController&>(controllable.GetController()).SetGenome(genome);
    m_simulator.Reset();
    while (!m_simulator.IsExperimentFinished()) {
      m_simulator.UpdateSpace();
    }
    const auto& body = robot.GetComponent<CEmbodiedEntity>("body");
    return Distance(body.GetOriginAnchor().Position, CVector3(0.5, 0.5, 0.0));
  }

 private:
  CSimulator m_simulator;
};

// evaluates genomes on as many threads as there are simulations
static std::vector<Real> EvaluateAll(std::vector<std::unique_ptr<CTrial>>& trials,
                                     const std::vector<TGenome>& genomes) {
  std::vector<Real> distances(genomes.size());
  std::vector<std::thread> threads;
  for (size_t i = 0; i < trials.size(); ++i) {
    threads.emplace_back([&, i] {
      for (size_t j = i; j < genomes.size(); j += trials.size()) {
        distances[j] = trials[i]->Evaluate(genomes[j]);
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  return distances;
}

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::cerr << "usage: evolution EXPERIMENT THREADS\n";
    return EXIT_FAILURE;
  }
  std::vector<std::unique_ptr<CTrial>> trials;
  for (int i = 0; i < std::atoi(argv[2]); ++i) {
    trials.push_back(std::make_unique<CTrial>(argv[1]));
  }

  // random numbers are drawn in this thread only, so results do not depend on the threads
  CRandom::CreateCategory("evolution", 1);
  CRandom::CRNG* const random = CRandom::CreateRNG("evolution");
  TGenome best = {5.0, 5.0};
  Real bestDistance = trials.front()->Evaluate(best);
  Real deviation = 2.0;  // of a mutation, cm/s
  for (int generation = 0; generation < 30; ++generation) {
    std::vector<TGenome> children(8, best);
    for (TGenome& child : children) {
      for (Real& speed : child) {
        speed = std::clamp(speed + random->Gaussian(deviation), 0.0, 20.0);
      }
    }
    const std::vector<Real> distances = EvaluateAll(trials, children);
    const auto nearest = std::min_element(distances.begin(), distances.end());
    if (*nearest < bestDistance) {
      bestDistance = *nearest;
      best = children[nearest - distances.begin()];
      deviation *= 1.2;
    } else {
      deviation *= 0.8;
    }
    std::cout << "generation " << generation << ": " << bestDistance << " m\n";
  }
  std::cout << "best: " << bestDistance << " m, speeds " << best[0] << ' ' << best[1] << '\n';
  CRandom::RemoveCategory("evolution");
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
