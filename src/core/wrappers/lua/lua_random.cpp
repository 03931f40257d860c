#include <argos3/core/wrappers/lua/lua_random.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/wrappers/lua/lua_closure.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// all whole numbers up to this one are exact in a float
constexpr SInt64 kMaxWhole = SInt64{1} << 53;

template <auto METHOD>
void AddMethod(lua_State* state, const std::string& path, const char* name, CLuaRandom& random) {
  CLuaClosure::PushMethod<METHOD>(state, path + name, random);
  lua_setfield(state, -2, name);
}

template <typename T>
void CheckOrder(T min, T max) {
  if (!(min <= max)) {
    THROW_ARGOSEXCEPTION("the minimum, " << min << ", is above the maximum, " << max);
  }
}

void CheckFinite(const char* name, Real value) {
  if (!std::isfinite(value)) {
    THROW_ARGOSEXCEPTION(name << " must be a finite number, got " << value);
  }
}

void CheckNotNegative(const char* name, Real value) {
  if (!(value >= 0.0) || !std::isfinite(value)) {
    THROW_ARGOSEXCEPTION(name << " must be a finite number, 0 or more, got " << value);
  }
}

}  // namespace

void CLuaRandom::Register(lua_State* state, const std::string& path) {
  AddMethod<&CLuaRandom::Bernoulli>(state, path, "bernoulli", *this);
  AddMethod<&CLuaRandom::Uniform>(state, path, "uniform", *this);
  AddMethod<&CLuaRandom::UniformInt>(state, path, "uniform_int", *this);
  AddMethod<&CLuaRandom::Exponential>(state, path, "exponential", *this);
  AddMethod<&CLuaRandom::Poisson>(state, path, "poisson", *this);
  AddMethod<&CLuaRandom::Gaussian>(state, path, "gaussian", *this);
}

void CLuaRandom::Seed(UInt32 seed) {
  m_seed = seed;
  if (m_generator != nullptr) {
    m_generator->SetSeed(seed);
    m_generator->Reset();
  }
}

CRandom::CRNG& CLuaRandom::GetGenerator() {
  if (m_generator == nullptr) {
    m_own = std::make_unique<CRandom::CRNG>(m_seed);
    m_generator = m_own.get();
  }
  return *m_generator;
}

bool CLuaRandom::Bernoulli(CLuaArguments& arguments) {
  const Real probability = arguments.HasNext() ? arguments.Next<Real>() : 0.5;
  arguments.Finish();
  if (!(probability >= 0.0 && probability <= 1.0)) {
    THROW_ARGOSEXCEPTION("argument 1, a probability, must be in [0,1], got " << probability);
  }
  return GetGenerator().Bernoulli(probability);
}

Real CLuaRandom::Uniform(CLuaArguments& arguments) {
  Real min = 0.0;
  Real max = 1.0;
  if (arguments.HasNext()) {
    max = arguments.Next<Real>();
    if (arguments.HasNext()) {
      min = max;
      max = arguments.Next<Real>();
    }
  }
  arguments.Finish();
  CheckFinite("the minimum", min);
  CheckFinite("the maximum", max);
  CheckOrder(min, max);
  CheckFinite("the distance from the minimum to the maximum", max - min);
  return min + GetGenerator().Uniform(CRange<Real>(0.0, 1.0)) * (max - min);
}

Real CLuaRandom::UniformInt(CLuaArguments& arguments) {
  SInt64 min = 0;
  SInt64 max = arguments.NextInteger(-kMaxWhole, kMaxWhole);
  if (arguments.HasNext()) {
    min = max;
    max = arguments.NextInteger(-kMaxWhole, kMaxWhole);
  }
  arguments.Finish();
  CheckOrder(min, max);
  // the maximum is excluded, except in an empty range
  const Real draw = GetGenerator().Uniform(CRange<Real>(0.0, 1.0));
  const Real highest = static_cast<Real>(std::max(min, max - 1));
  const Real span = static_cast<Real>(max) - static_cast<Real>(min);
  return std::min(static_cast<Real>(min) + std::floor(draw * span), highest);
}

Real CLuaRandom::Exponential(Real mean) {
  CheckNotNegative("argument 1, the mean,", mean);
  return GetGenerator().Exponential(mean);
}

SLuaInteger CLuaRandom::Poisson(Real mean) {
  return {GetGenerator().Poisson(mean)};
}

Real CLuaRandom::Gaussian(CLuaArguments& arguments) {
  const Real deviation = arguments.Next<Real>();
  const Real mean = arguments.HasNext() ? arguments.Next<Real>() : 0.0;
  arguments.Finish();
  CheckNotNegative("argument 1, the standard deviation,", deviation);
  CheckFinite("argument 2, the mean,", mean);
  return GetGenerator().Gaussian(deviation, mean);
}

}  // namespace argos
