/* Evolves the wheel speeds with which a foot-bot gets farthest in ten seconds. */

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/simulator.h>

#include <cstdlib>
#include <iostream>

#include "racer_loop_functions.h"

static const Real MAX_SPEED = 20.0;

/* Runs one trial and returns its fitness. */
static Real Evaluate(argos::CSimulator& c_simulator, const Real* pf_genome) {
  CRacerLoopFunctions& cLoopFunctions =
      dynamic_cast<CRacerLoopFunctions&>(c_simulator.GetLoopFunctions());
  cLoopFunctions.ConfigureFromGenome(pf_genome);
  c_simulator.Reset();
  c_simulator.Execute();
  return cLoopFunctions.Performance();
}

int main(int n_argc, char** ppch_argv) {
  argos::CSimulator& cSimulator = argos::CSimulator::GetInstance();
  cSimulator.SetExperimentFileName(ppch_argv[1]);
  cSimulator.LoadExperiment();

  CRandom::CreateCategory("ga", 12345);
  CRandom::CRNG* pcRNG = CRandom::CreateRNG("ga");
  CRange<Real> cSpeeds(-MAX_SPEED, MAX_SPEED);

  Real pfStraight[2] = {MAX_SPEED, MAX_SPEED};
  Real pfTurn[2] = {MAX_SPEED, -MAX_SPEED};
  std::cout << "straight " << Evaluate(cSimulator, pfStraight) << std::endl;
  std::cout << "turn " << Evaluate(cSimulator, pfTurn) << std::endl;

  Real pfBest[2] = {0.0, 0.0};
  Real fBest = Evaluate(cSimulator, pfBest);
  std::cout << "initial " << fBest << std::endl;
  for (UInt32 i = 0; i < 60; ++i) {
    Real pfChild[2];
    for (UInt32 j = 0; j < 2; ++j) {
      pfChild[j] = pfBest[j] + pcRNG->Gaussian(5.0);
      cSpeeds.TruncValue(pfChild[j]);
    }
    Real fChild = Evaluate(cSimulator, pfChild);
    if (fChild >= fBest) {
      fBest = fChild;
      pfBest[0] = pfChild[0];
      pfBest[1] = pfChild[1];
    }
  }
  std::cout << "best " << fBest << std::endl;
  std::cout << "again " << Evaluate(cSimulator, pfBest) - fBest << std::endl;
  std::cout << "trials "
            << dynamic_cast<CRacerLoopFunctions&>(cSimulator.GetLoopFunctions()).GetTrials()
            << std::endl;

  CRandom::RemoveCategory("ga");
  cSimulator.Destroy();
  return EXIT_SUCCESS;
}
