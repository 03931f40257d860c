#ifndef ARGOS3_SUPPORT_EXIT_STATUS_H
#define ARGOS3_SUPPORT_EXIT_STATUS_H

namespace argos {

/** The exit status of a process that a signal has ended is this plus its number, as of shells. */
constexpr int kSignalStatus = 128;

}  // namespace argos

#endif
