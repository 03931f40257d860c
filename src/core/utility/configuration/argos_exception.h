#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_ARGOS_EXCEPTION_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_ARGOS_EXCEPTION_H

#include <cstring>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>

namespace argos {

/**
 * What the simulator throws for every mistake of its user: a wrong experiment file, a missing
 * plug-in, an impossible argument.
 *
 * what() is "[FATAL] " followed by the message; if a nested exception was given, a newline and the
 * nested what() follow. The outermost context therefore comes first, one line per level.
 */
class CARGoSException : public std::exception {
 public:
  /**
   * @param what    what was found and what would be right.
   * @param nested  the exception that led to this one, or null. Its text is copied; it need not
   *                outlive the call.
   */
  CARGoSException(const std::string& what, std::exception* nested = nullptr);
  CARGoSException(const CARGoSException&) = default;
  CARGoSException& operator=(const CARGoSException&) = default;
  ~CARGoSException() noexcept override;

  const char* what() const noexcept override { return m_text.c_str(); }

 private:
  std::string m_text;
};

}  // namespace argos

/**
 * Throws a CARGoSException whose message is a stream expression: THROW_ARGOSEXCEPTION("a" << b).
 * A brace block, so that it can stand after "else" and with or without a semicolon.
 */
#define THROW_ARGOSEXCEPTION(message)                 \
  {                                                   \
    std::ostringstream argosExceptionText_;           \
    argosExceptionText_ << message;                   \
    throw CARGoSException(argosExceptionText_.str()); \
  }

/**
 * The same, for an error that another exception led to.
 * @param nested  a std::exception lvalue, usually the one that was caught.
 */
#define THROW_ARGOSEXCEPTION_NESTED(message, nested)           \
  {                                                            \
    std::ostringstream argosExceptionText_;                    \
    argosExceptionText_ << message;                            \
    throw CARGoSException(argosExceptionText_.str(), &nested); \
  }

/**
 * Throws a CARGoSException if the condition does not hold. For mistakes of the program, not of its
 * user: with NDEBUG it is compiled out, condition and message included, unless
 * ARGOS_CHECK_INVARIANTS is defined, which the CMake option of that name does.
 */
#if !defined(NDEBUG) || defined(ARGOS_CHECK_INVARIANTS)
#define ARGOS_ASSERT(condition, message) \
  {                                      \
    if (!(condition))                    \
      THROW_ARGOSEXCEPTION(message);     \
  }
#else
#define ARGOS_ASSERT(condition, message)
#endif

#endif
