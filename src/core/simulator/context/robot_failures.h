#ifndef ARGOS3_CORE_SIMULATOR_CONTEXT_ROBOT_FAILURES_H
#define ARGOS3_CORE_SIMULATOR_CONTEXT_ROBOT_FAILURES_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>

#include <mutex>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace argos {

/**
 * The errors of robots that did not end the run (see EOnError), since the experiment was loaded.
 *
 * Equal errors of several robots, and of one robot after a reset, are one error with a count.
 */
class CRobotFailures : private CNonCopyable {
 public:
  struct SError {
    std::string Text; /**< text of the first of them */
    std::string Key; /**< the text without the robot's id, equal for equal errors */
    size_t Count = 0;
    UInt32 FirstTick = 0;
    std::vector<std::string> Robots; /**< ids, each once, in the order of their errors */
  };

  CRobotFailures() = default;

  /**
   * Notes an error. Any thread.
   * @param context  what threw, as in: robot "ep": ControlStep() threw in tick 3.
   * @param cause    the text of the exception.
   */
  void Note(const std::string& robot, UInt32 tick, const std::string& context,
            const std::string& cause);
  /**
   * Logs each error that has not been logged yet, in the order of the robots. Main thread, at the
   * end of each phase.
   */
  void Report();
  void Clear();

  bool IsEmpty() const { return m_errors.empty(); }
  /** In the order of their first occurrence. */
  const std::vector<SError>& GetErrors() const { return m_errors; }
  /** Lines with the count, the robots and the first tick of each error. */
  std::string Summarize() const;

 private:
  struct SNote {
    UInt64 Place;  // place of the robot in the order of the phase
    std::string Robot;
    UInt32 Tick;
    std::string Text;
    std::string Key;
  };

  std::mutex m_mutex;  // guards the notes
  std::vector<SNote> m_notes;  // notes since the last report
  std::vector<SError> m_errors;
  std::unordered_map<std::string, size_t> m_errorByKey;  // never iterated
  std::set<std::pair<size_t, std::string>> m_named;  // errors and the robots that they name
};

}  // namespace argos

#endif
