#ifndef ARGOS3_CAMPAIGN_DESIGN_EXPRESSION_H
#define ARGOS3_CAMPAIGN_DESIGN_EXPRESSION_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

struct lua_State;

namespace argos {

class CLuaState;

/**
 * Evaluates Lua expressions of named values. They know these names and `math` without its random
 * numbers; their time and memory are limited.
 *
 * A value that is a number is one in Lua; other values are strings.
 */
class CExpressions : private CNonCopyable {
 public:
  CExpressions();
  ~CExpressions();

  /** Replaces all names. */
  void SetNames(std::vector<std::pair<std::string, std::string>> namesAndValues);
  void AddName(const std::string& name, const std::string& value);
  /** @param value  may be NaN, with which all comparisons but `~=` are false. */
  void AddNumber(const std::string& name, Real value);

  /**
   * @return the value as text: whole numbers without decimal point, others with 15 digits.
   * @throws CARGoSException with the expression and the reason; also if the value is nil, not
   *   finite, or of another type than number, text or boolean.
   */
  std::string Evaluate(std::string_view expression);
  /** @throws CARGoSException also if the value is not a boolean. */
  bool IsTrue(std::string_view expression);

  /**
   * Replaces each "{expression}" of a text by its value; "{{" stands for '{' and "}}" for '}'.
   * @throws CARGoSException as Evaluate(), or if braces do not match.
   */
  std::string Expand(std::string_view text);

 private:
  struct SValue;

  SValue Compute(std::string_view expression);
  void PushEnvironment(lua_State* state);
  static int HandleUnknownName(lua_State* state);

  std::unique_ptr<CLuaState> m_state;
  std::vector<std::pair<std::string, std::string>> m_names;
  std::vector<std::pair<std::string, Real>> m_numbers;
  std::array<char, 64> m_unknownName = {};  // set by HandleUnknownName()
};

/** @return true if a text contains an expression. */
bool HasExpression(std::string_view text);

/**
 * @return the end of the expression whose '{' is at @p start: the index of its '}'; npos if there
 *   is none. Braces in Lua strings and nested braces do not end it.
 */
size_t FindEndOfExpression(std::string_view text, size_t start);

}  // namespace argos

#endif
