#ifndef ARGOS3_CORE_SIMULATOR_CONTEXT_LOAD_ERRORS_H
#define ARGOS3_CORE_SIMULATOR_CONTEXT_LOAD_ERRORS_H

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>

#include <exception>
#include <functional>
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
 * consequence of others are not reported. After a lack of memory nothing is loaded: what it has
 * interrupted, such as an XML document, may be in no state to be read.
 */
class CLoadErrors {
 public:
  /** Calls @p step, unless memory has run out; records its exception under @p context. @return true
   * if it did not throw. */
  template <typename STEP>
  bool Try(const std::string& context, STEP&& step) {
    if (m_lacksMemory) {
      return false;
    }
    try {
      step();
      return true;
    } catch (const CAlreadyReported&) {
      m_hasConsequences = true;
      return false;
    } catch (const std::exception& error) {
      Add(context, error);
      return false;
    } catch (...) {
      Add(context, CARGoSException(DescribeCurrentException()));
      return false;
    }
  }

  /** @return true if it is another message than those before. */
  bool Add(const std::string& context, const std::exception& error);

  /**
   * Finds further errors after one of @p read: calls it again, as long as a refused attribute can
   * be replaced by another value and the next error is another one.
   * @param read  initialises a part, which is then discarded.
   */
  void FindFurther(const std::function<void()>& read);
  bool IsEmpty() const { return m_messages.empty(); }
  /**
   * @param title  follows the number of messages if there are several.
   * @throws CARGoSException with all messages, numbered, if there are any.
   */
  void ThrowIfAny(const std::string& title = "errors in the experiment") const;
  /** As ThrowIfAny(). @throws CAlreadyReported if there were only consequences of others. */
  void ThrowIfFailed(const std::string& title) const;

 private:
  std::vector<std::string> m_messages;  // unique, in order
  bool m_hasConsequences = false;
  bool m_lacksMemory = false;
};

}  // namespace argos

#endif
