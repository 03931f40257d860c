#ifndef ARGOS3_CORE_SIMULATOR_CONTEXT_LOAD_ERRORS_H
#define ARGOS3_CORE_SIMULATOR_CONTEXT_LOAD_ERRORS_H

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>

#include <exception>
#include <string>
#include <vector>

namespace argos {

/** Thrown for a failure that is only a consequence of an already reported error. */
class CAlreadyReported : public CARGoSException {
 public:
  explicit CAlreadyReported(const std::string& what) : CARGoSException(what) {}
};

/**
 * Collects the errors of an experiment, so that one run reports all of them.
 *
 * A failed part is recorded and loading continues with the next; failures that are only a
 * consequence of others are not reported.
 */
class CLoadErrors {
 public:
  /** Calls @p step; records its exception under @p context. @return true if it did not throw. */
  template <typename STEP>
  bool Try(const std::string& context, STEP&& step) {
    try {
      step();
      return true;
    } catch (const CAlreadyReported&) {
      return false;
    } catch (const std::exception& error) {
      Add(context, error);
      return false;
    } catch (...) {
      Add(context, CARGoSException(DescribeCurrentException()));
      return false;
    }
  }

  void Add(const std::string& context, const std::exception& error);
  bool IsEmpty() const { return m_messages.empty(); }
  /** @throws CARGoSException with all messages, numbered, if there are any. */
  void ThrowIfAny() const;

 private:
  std::vector<std::string> m_messages;  // unique, in order
};

}  // namespace argos

#endif
