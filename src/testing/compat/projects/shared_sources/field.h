#ifndef FIELD_H
#define FIELD_H

#include <argos3/core/simulator/loop_functions.h>

class CGatherer;

/** Counts what the robots report, and prints the count as the last line of a run. */
class CField : public argos::CLoopFunctions {
 public:
  void Init(argos::TConfigurationNode& tree) override;
  void PostExperiment() override;
  void Report() { ++m_unReports; }

  static int NumFields;

 private:
  int m_unReports = 0;
};

#endif
