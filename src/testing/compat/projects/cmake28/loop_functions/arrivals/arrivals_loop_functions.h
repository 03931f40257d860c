#ifndef ARRIVALS_LOOP_FUNCTIONS_H
#define ARRIVALS_LOOP_FUNCTIONS_H

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/space/space.h>

using namespace argos;

/* Counts the robots beyond a line and writes their number in each tick. */
class CArrivalsLoopFunctions : public CLoopFunctions {
 public:
  virtual void Init(TConfigurationNode& t_tree);
  virtual void Reset();
  virtual void Destroy();
  virtual void PostStep();

 private:
  std::ofstream m_cOutput;
  std::string m_strOutput;
  Real m_fLine;
};

#endif
