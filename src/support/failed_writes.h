#ifndef ARGOS3_SUPPORT_FAILED_WRITES_H
#define ARGOS3_SUPPORT_FAILED_WRITES_H

namespace argos {

/**
 * From now on, writing to a closed pipe, or beyond the limit of a file's size, is an error of the
 * write instead of the end of the process. Programs that this one starts do not inherit that.
 * To be called once, at the start of a program.
 */
void SurviveFailedWrites();

}  // namespace argos

#endif
