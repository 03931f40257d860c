#ifndef ARGOS3_CORE_SIMULATOR_LOAD_ERRORS_H
#define ARGOS3_CORE_SIMULATOR_LOAD_ERRORS_H

#include <argos3/core/utility/configuration/argos_exception.h>

#include <exception>
#include <string>
#include <vector>

namespace argos {

/** Thrown by what can only fail because something else, already reported, did. */
class CAlreadyReported : public CARGoSException {
 public:
  explicit CAlreadyReported(const std::string& what) : CARGoSException(what) {}
};

/**
 * Collects what is wrong with an experiment, so that one run reports all of it.
 *
 * A part that fails is noted and loading goes on with the next; what can only fail because another
 * part did is not reported again.
 */
class CLoadErrors {
 public:
  /** Calls @p step; what it throws is noted under @p context. @return true if it did not throw. */
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
    }
  }

  void Add(const std::string& context, const std::exception& error);
  bool IsEmpty() const { return m_messages.empty(); }
  /** @throws CARGoSException with every message, numbered, if there is any. */
  void ThrowIfAny() const;

 private:
  std::vector<std::string> m_messages;  // each once, in order
};

}  // namespace argos

#endif
