#ifndef ARGOS3_CORE_UTILITY_DATATYPES_WHILE_TRUE_H
#define ARGOS3_CORE_UTILITY_DATATYPES_WHILE_TRUE_H

#include <argos3/core/utility/non_copyable.h>

namespace argos {

/** Keeps a flag set for its lifetime. */
class CWhileTrue : private CNonCopyable {
 public:
  explicit CWhileTrue(bool& flag) : m_flag(flag) { m_flag = true; }
  ~CWhileTrue() { m_flag = false; }

 private:
  bool& m_flag;
};

}  // namespace argos

#endif
