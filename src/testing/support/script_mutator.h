#ifndef ARGOS3_TESTING_SUPPORT_SCRIPT_MUTATOR_H
#define ARGOS3_TESTING_SUPPORT_SCRIPT_MUTATOR_H

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace argos {

/** Makes wrong Lua scripts of good ones; the same scripts for the same seed. */
class CScriptMutator {
 public:
  explicit CScriptMutator(std::uint32_t seed) : m_random(seed) {}

  /** Deletes, doubles, swaps and replaces one to four tokens. */
  std::string Mutate(const std::string& script);

 private:
  std::size_t Draw(std::size_t count) { return m_random() % count; }
  void MutateOnce(std::vector<std::string>& tokens);

  // its numbers are the same everywhere
  std::mt19937 m_random;
};

/** The words, numbers, strings, comments, blanks and symbols of a script; joined, they are it. */
std::vector<std::string> ToTokens(const std::string& script);

/**
 * A script whose step() calls each function in a table of Lua with random arguments, in protected
 * calls. An error whose message does not name the function fails with "does not name".
 * @param table  such as "robot".
 * @param calls  in each step.
 */
std::string RandomCallsScript(const std::string& table, std::uint32_t seed, int calls);

}  // namespace argos

#endif
