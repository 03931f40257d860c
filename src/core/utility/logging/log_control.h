#ifndef ARGOS3_CORE_UTILITY_LOGGING_LOG_CONTROL_H
#define ARGOS3_CORE_UTILITY_LOGGING_LOG_CONTROL_H

#include <argos3/core/utility/non_copyable.h>

#include <functional>
#include <string>

namespace argos {

/**
 * Importance of a line of a log, by its mark: [FATAL] or [ERROR], [WARNING], [INFO]. Lines without
 * a mark are Info on LOG, and Error on LOGERR.
 */
enum class ELogLevel { Error, Warning, Info, Debug };

/**
 * What becomes of the lines of all logs, LOG and LOGERR among them; for programs that embed the
 * simulator.
 *
 * Takes effect when a log is flushed. The functions may be called at any time, on any thread.
 */
class CLogControl {
 public:
  /**
   * Drops lines that are less important than the level. Info, the default, drops none. With Debug,
   * there are also lines about the libraries that are loaded.
   */
  static void SetLevel(ELogLevel level);
  static ELogLevel GetLevel();

  /**
   * Writes "[INFO] " and the text, a line about the run, at once: to the file of LOG if that is
   * redirected, else to the standard error, in the colour of LOG. On the standard output, the lines
   * that follow the start of a run are those of users' code, and scripts read the last one. Not
   * while robots are updated.
   */
  static void Notify(const std::string& text);

  /** @param line  with its mark, without colours and without the line break. */
  using TLineReceiver = std::function<void(ELogLevel level, const std::string& line)>;

  /**
   * Passes complete lines to a function instead of writing them to the streams; an empty function
   * ends that. The function is called by the thread that flushes, by one thread at a time, in the
   * order of the log. It must not flush a log, nor throw.
   */
  static void SetLineReceiver(TLineReceiver receiver);

  /**
   * Puts "[label] " into each line that this thread logs from now on, after its mark: so that lines
   * of simulations on several threads can be told apart. Threads of a simulation that this thread
   * loads have the label, too. Empty: no label.
   */
  static void SetThreadLabel(const std::string& label);
  static std::string GetThreadLabel();
};

/**
 * Shows each line of all logs to a function too, during its lifetime, without any effect on where
 * the line goes, and before the level drops it. There can be several; the rest as for
 * CLogControl::SetLineReceiver(). It stays where it was made.
 */
class CLogObserver : private CNonCopyable {
 public:
  explicit CLogObserver(CLogControl::TLineReceiver show);
  ~CLogObserver();

  void Show(ELogLevel level, const std::string& line) const { m_show(level, line); }

 private:
  CLogControl::TLineReceiver m_show;
};

}  // namespace argos

#endif
