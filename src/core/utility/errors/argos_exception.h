#ifndef ARGOS3_CORE_UTILITY_ERRORS_ARGOS_EXCEPTION_H
#define ARGOS3_CORE_UTILITY_ERRORS_ARGOS_EXCEPTION_H

#include <argos3/core/config.h>  // checks the language level

#include <cstring>
#include <exception>
#include <iostream>
#include <locale>
#include <sstream>
#include <string>

namespace argos {

/**
 * The exception for every mistake of a user: a wrong experiment file, a missing plug-in, an invalid
 * argument.
 *
 * what() is "[FATAL] " followed by the message; a nested exception adds a newline and its own
 * what(). The outermost context therefore comes first, one line per level.
 */
class CARGoSException : public std::exception {
 public:
  /**
   * @param what    the value found and the values allowed.
   * @param nested  the exception that caused this one, or null. Its text is copied.
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
 * A brace block, so that it works after "else" and with or without a semicolon.
 */
#define THROW_ARGOSEXCEPTION(message)                  \
  {                                                    \
    std::ostringstream argosExceptionText_;            \
    argosExceptionText_.imbue(std::locale::classic()); \
    argosExceptionText_ << message;                    \
    throw CARGoSException(argosExceptionText_.str());  \
  }

/**
 * Throws a CARGoSException that was caused by another error.
 * @param nested  a std::exception lvalue, usually the caught one.
 */
#define THROW_ARGOSEXCEPTION_NESTED(message, nested)           \
  {                                                            \
    std::ostringstream argosExceptionText_;                    \
    argosExceptionText_.imbue(std::locale::classic());         \
    argosExceptionText_ << message;                            \
    throw CARGoSException(argosExceptionText_.str(), &nested); \
  }

/**
 * Throws a CARGoSException if the condition does not hold. For errors of the program, not of its
 * user: NDEBUG compiles out both condition and message, unless ARGOS_CHECK_INVARIANTS is defined,
 * as it is by the CMake option of that name.
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
