#ifndef ARGOS3_CORE_UTILITY_PROCESSES_CPU_TIME_H
#define ARGOS3_CORE_UTILITY_PROCESSES_CPU_TIME_H

namespace argos {

/** User and system time of all threads of the process, s; as getrusage() has it, but in ns. */
double GetProcessCPUTime();

}  // namespace argos

#endif
