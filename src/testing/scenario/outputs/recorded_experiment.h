#ifndef ARGOS3_TESTING_SCENARIO_OUTPUTS_RECORDED_EXPERIMENT_H
#define ARGOS3_TESTING_SCENARIO_OUTPUTS_RECORDED_EXPERIMENT_H

#include "../command_line/program_run.h"

#include <string>
#include <vector>

namespace argos {

/**
 * An experiment with every kind of output: frames in out/, data.csv, profile.txt, and the logs.
 *
 * Two foot-bots run for 20 ticks, with a frame of 32x32 pixels every ten ticks. An element that
 * nothing reads causes a warning on the error log.
 */
std::string RecordedExperiment();

/** Arguments to run it with log.txt, err.txt and a digest. */
std::vector<std::string> RecordedArguments();

/**
 * Checks that what a run, complete or not, has left can be read: whole pictures, tables of whole
 * lines, no partial files.
 */
void CheckOutputsAreReadable(const CTestFolder& folder);

/** Checks that nothing is missing. */
void CheckOutputsAreComplete(const CTestFolder& folder);

}  // namespace argos

#endif
