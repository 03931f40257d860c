#ifndef ARGOS3_CORE_UTILITY_ERRORS_RUNNING_CODE_H
#define ARGOS3_CORE_UTILITY_ERRORS_RUNNING_CODE_H

#include <argos3/core/utility/errors/signal_safe_text.h>
#include <argos3/core/utility/non_copyable.h>

#include <cstdint>
#include <string>

namespace argos {

/**
 * Which code of users a thread runs now: for error messages, and for the report of a crash.
 *
 * A loop over robots stores only Subject for each of them.
 */
struct SRunningCode {
  /** Appends the name of a subject, as in: robot "ep". Called in signal handlers, too. */
  using TDescribe = void (*)(const void* subject, CSignalSafeText& text);

  const char* Call = nullptr; /**< such as "ControlStep()"; null: no code of users */
  TDescribe Describe = nullptr; /**< null: the subject is a text */
  const void* Subject = nullptr; /**< object whose function is called; null: nothing to be named */
  const std::uint32_t* Tick = nullptr; /**< the simulation's clock; null: outside of ticks */
  bool IsBesideOthers = false; /**< code of a robot: that of others may run at the same time */

  /** That of the calling thread. */
  static SRunningCode& OfThread();

  /** Appends, as in: robot "ep": ControlStep() in tick 3. Nothing if no code of users runs. */
  void AppendTo(CSignalSafeText& text) const;
  std::string ToText() const;
};

/** Sets the calling thread's running code during its lifetime. */
class CRunningCodeScope : private CNonCopyable {
 public:
  explicit CRunningCodeScope(const SRunningCode& code)
      : m_code(SRunningCode::OfThread()), m_previous(m_code) {
    m_code = code;
  }
  ~CRunningCodeScope() { m_code = m_previous; }

  /** To be called before the function of another subject is called. */
  void SetSubject(const void* subject) { m_code.Subject = subject; }

 private:
  SRunningCode& m_code;
  const SRunningCode m_previous;
};

}  // namespace argos

#endif
