#ifndef ARGOS3_CORE_UTILITY_DATATYPES_WHILE_TRUE_H
#define ARGOS3_CORE_UTILITY_DATATYPES_WHILE_TRUE_H

namespace argos {

/** Keeps a flag set for its lifetime. */
class CWhileTrue {
 public:
  explicit CWhileTrue(bool& flag) : m_flag(flag) { m_flag = true; }
  ~CWhileTrue() { m_flag = false; }
  CWhileTrue(const CWhileTrue&) = delete;
  CWhileTrue& operator=(const CWhileTrue&) = delete;

 private:
  bool& m_flag;
};

}  // namespace argos

#endif
