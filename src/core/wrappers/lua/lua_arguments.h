#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_ARGUMENTS_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_ARGUMENTS_H

#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

struct lua_State;

namespace argos {

/**
 * Reads and checks the arguments of a call from Lua, one after the other.
 *
 * Types are those of Lua, without conversions: the string "10" is not a number, and 1 is not a
 * boolean. A wrong argument throws a CARGoSException, which the functions of a CLuaTable turn into
 * a Lua error with the name of the function and the line of the script. So use this class only
 * there.
 */
class CLuaArguments {
 public:
  explicit CLuaArguments(lua_State* state);

  /**
   * From now on functions that take whole numbers truncate others, as in ARGoS 3: the first with a
   * warning.
   * @param owner  of the script, for the warning: `robot "r0"`.
   */
  static void AcceptFractions(lua_State* state, const std::string& owner);

  lua_State* GetState() const { return m_state; }
  /** Number of arguments, read or not. */
  int GetCount() const { return m_count; }
  bool HasNext() const { return m_next <= m_count; }
  bool IsNextTable() const;
  bool IsNextString() const;
  bool IsNextNumber() const;
  /** True if the next argument is nil or missing. */
  bool IsNextNil() const;
  void Skip() { ++m_next; }

  /**
   * Reads the next argument.
   * @tparam T  Real, CRadians (a number, rad), bool, an integer type (a whole number in its range),
   * std::string, CVector2, CVector3, CQuaternion, or CColor: a name or "r,g,b,a", else three
   * arguments from 0 to 255.
   * @throws CARGoSException "argument 2 must be a number, got nil".
   */
  template <typename T>
  T Next() {
    if constexpr (std::is_same_v<T, bool>) {
      return NextBoolean();
    } else if constexpr (std::is_floating_point_v<T>) {
      return static_cast<T>(NextNumber());
    } else if constexpr (std::is_integral_v<T>) {
      return static_cast<T>(NextInteger(GetLowest<T>(), GetHighest<T>()));
    } else if constexpr (std::is_same_v<T, CRadians>) {
      return CRadians(NextNumber());
    } else if constexpr (std::is_same_v<T, std::string>) {
      return NextString();
    } else if constexpr (std::is_same_v<T, CColor>) {
      return NextColor();
    } else if constexpr (std::is_same_v<T, CVector2>) {
      return NextObject<CVector2>("a vector2");
    } else if constexpr (std::is_same_v<T, CVector3>) {
      return NextObject<CVector3>("a vector3");
    } else {
      static_assert(std::is_same_v<T, CQuaternion>, "no argument of a Lua function has this type");
      return NextObject<CQuaternion>("a quaternion");
    }
  }

  /** Reads a string without copying it: valid during the call. */
  std::string_view NextText();

  /** Reads a whole number in [min,max]. */
  SInt64 NextInteger(SInt64 min, SInt64 max);

  /** Reads a number from 1 to @p count, as Lua counts. @return the number counted from 0. */
  std::size_t NextIndex(std::size_t count);

  /** Reads a table of exactly @p count whole numbers from 0 to 255. */
  std::vector<UInt8> NextBytes(std::size_t count);

  /** @throws CARGoSException if not all arguments have been read. */
  void Finish() const;

  /** @throws CARGoSException "argument <number of the next> must be <expected>, got <found>". */
  [[noreturn]] void ThrowNextMustBe(const std::string& expected) const;

 private:
  /** @return false if the value at @p index is not a whole number, and was not truncated to one. */
  bool ToWhole(int index, SInt64& value) const;
  template <typename T>
  static constexpr SInt64 GetLowest() {
    return static_cast<SInt64>(std::numeric_limits<T>::min());
  }
  template <typename T>
  static constexpr SInt64 GetHighest() {
    return sizeof(T) < sizeof(SInt64) || std::is_signed_v<T>
               ? static_cast<SInt64>(std::numeric_limits<T>::max())
               : std::numeric_limits<SInt64>::max();
  }

  Real NextNumber();
  bool NextBoolean();
  std::string NextString();
  CColor NextColor();
  template <typename T>
  T NextObject(const char* expected);

  lua_State* m_state;
  int m_count;
  int m_next = 1;
};

}  // namespace argos

#endif
