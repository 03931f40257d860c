#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_RANDOM_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_RANDOM_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/core/wrappers/lua/lua_arguments.h>
#include <argos3/core/wrappers/lua/lua_value.h>

#include <memory>
#include <string>

struct lua_State;

namespace argos {

/** The functions of robot.random: each is a method of this class. */
class CLuaRandom {
 public:
  /** The generator, a large Mersenne Twister, is created when a script first draws a number. */
  explicit CLuaRandom(UInt32 seed) : m_seed(seed) {}
  /** Draws from a generator that the caller owns. */
  explicit CLuaRandom(CRandom::CRNG& generator) : m_generator(&generator) {}

  /**
   * Adds the functions to the table on top of the stack.
   * @param path  prefix of their names in messages.
   */
  void Register(lua_State* state, const std::string& path = "robot.random.");

  /** Restarts at the beginning of the stream of a seed. */
  void Seed(UInt32 seed);

  bool Bernoulli(CLuaArguments& arguments);
  Real Uniform(CLuaArguments& arguments);
  Real UniformInt(CLuaArguments& arguments);
  Real Exponential(Real mean);
  SLuaInteger Poisson(Real mean);
  Real Gaussian(CLuaArguments& arguments);

 private:
  CRandom::CRNG& GetGenerator();

  UInt32 m_seed = 0;
  CRandom::CRNG* m_generator = nullptr;
  std::unique_ptr<CRandom::CRNG> m_own;
};

}  // namespace argos

#endif
