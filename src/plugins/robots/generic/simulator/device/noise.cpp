#include <argos3/plugins/robots/generic/simulator/noise.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/plugins/plugin_kind.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>

namespace argos {

namespace {

enum class EModel : UInt8 { Uniform, Gaussian, Rayleigh };

// one <noise>
struct STerm {
  EModel Model = EModel::Uniform;
  bool Relative = false;
  Real Spread = 0.0;  // greatest deviation, standard deviation, or sigma
  Real Bias = 0.0;
};

const std::vector<std::string> kModels = {"uniform", "gaussian", "rayleigh"};
constexpr const char* kSpreads[] = {"level", "std_dev",
                                    "sigma"};  // names of the attribute of each model

const CElementText kNoiseText(
    "noise", "the authors of this project", "Noise of a sensor or an actuator.",
    R"(A child of devices with numbers. Several of them add up. The random numbers of a robot's device depend on the seed, the
robot's id and the device only.

OPTIONAL XML

  <controllers>
    <my_controller id="c1">
      <actuators />
      <sensors>
        <proximity implementation="default">
          <noise model="gaussian" std_dev="0.02" bias="0.01" relative="false" />
        </proximity>
      </sensors>
      <params />
    </my_controller>
  </controllers>

ATTRIBUTES

  model     "uniform", "gaussian" or "rayleigh", required: the distribution of what is added.
  level     >= 0, required for "uniform": numbers are drawn evenly from [-level,level].
  std_dev   >= 0, required for "gaussian": standard deviation; the mean is 0.
  sigma     >= 0, required for "rayleigh": its parameter; numbers are positive.
  bias      real number, default 0: is added to each number.
  relative  "true" or "false", default "false": if "true", what is added is multiplied by the value.
  on        text: the quantity of the device that gets the noise, if it has several; the manual of the device lists
            them. Default: all.

All values are in the units of the quantity.
)");

STerm ReadTerm(TConfigurationNode& node) {
  STerm term;
  std::string model;
  GetNodeAttribute(node, "model", model);
  const auto found = std::find(kModels.begin(), kModels.end(), model);
  if (found == kModels.end()) {
    THROW_ARGOSEXCEPTION(OwnerOf(node) << ": attribute \"model\" must be \"uniform\", "
                                       << "\"gaussian\" or \"rayleigh\", got \"" << model << "\""
                                       << DidYouMean(model, kModels));
  }
  term.Model = static_cast<EModel>(found - kModels.begin());
  const char* const spread = kSpreads[found - kModels.begin()];
  GetNodeAttribute(node, spread, term.Spread);
  RequireNotNegative(term.Spread, OwnerOf(node), std::string("attribute \"") + spread + "\"");
  GetNodeAttributeOrDefault(node, "bias", term.Bias, 0.0);
  GetNodeAttributeOrDefault(node, "relative", term.Relative, false);
  return term;
}

bool IsNoise(const CRange<Real>& range) {
  return range.GetMin() != 0.0 || range.GetMax() != 0.0;
}

STerm UniformTerm(const CRange<Real>& range) {
  STerm term;
  term.Spread = 0.5 * range.GetSpan();
  term.Bias = range.GetMin() + term.Spread;
  return term;
}

Real Draw(const STerm& term, CRandomStream& stream) {
  switch (term.Model) {
    case EModel::Uniform:
      return stream.Uniform(-term.Spread, term.Spread);
    case EModel::Gaussian:
      return stream.Gaussian(term.Spread);
    case EModel::Rayleigh:
      return stream.Rayleigh(term.Spread);
  }
  return 0.0;
}

}  // namespace

struct CDeviceNoise::SState {
  const CControllableEntity& Robot;
  std::string Purpose;  // purpose of the stream
  std::vector<std::vector<STerm>> Terms;  // index: quantity
  CRandomStream Stream;

  SState(const CControllableEntity& robot, const std::string& purpose, size_t numQuantities)
      : Robot(robot), Purpose(purpose), Terms(numQuantities), Stream(MakeStream()) {}

  // uses the current seed
  CRandomStream MakeStream() const {
    return CRandomStream(Robot.GetSimulator().GetRandomSeed(), "argos",
                         Robot.GetRootEntity().GetId(), Purpose);
  }
};

CDeviceNoise::CDeviceNoise() = default;
CDeviceNoise::~CDeviceNoise() = default;
CDeviceNoise::CDeviceNoise(CDeviceNoise&&) noexcept = default;
CDeviceNoise& CDeviceNoise::operator=(CDeviceNoise&&) noexcept = default;

void CDeviceNoise::Init(TConfigurationNode& device, const CControllableEntity& robot,
                        const std::vector<std::string>& quantities,
                        const std::vector<CRange<Real>>& ranges, const std::string& part) {
  m_state.reset();
  const bool hasRange = std::any_of(ranges.begin(), ranges.end(), IsNoise);
  if (!hasRange && !NodeExists(device, "noise")) {
    return;
  }
  // an actuator and a sensor may have the same name: the name of the section distinguishes them
  const TConfigurationNode* const section = device.Parent(false);
  const std::string purpose = (section != nullptr ? section->Value() + " " : std::string()) +
                              device.Value() + " noise" + part;
  m_state = std::make_unique<SState>(robot, purpose, quantities.size());
  for (size_t i = 0; i < ranges.size(); ++i) {
    if (IsNoise(ranges[i])) {
      m_state->Terms[i].push_back(UniformTerm(ranges[i]));
    }
  }
  TConfigurationNodeIterator noise("noise");
  for (noise = noise.begin(&device); noise != noise.end(); ++noise) {
    const STerm term = ReadTerm(*noise);
    std::string on;
    GetNodeAttributeOrDefault(*noise, "on", on, on);
    const auto found = std::find(quantities.begin(), quantities.end(), on);
    if (!on.empty() && found == quantities.end()) {
      THROW_ARGOSEXCEPTION(OwnerOf(*noise) << ": <" << device.Value() << "> has no \"" << on << "\""
                                           << DidYouMean(on, quantities));
    }
    for (size_t i = 0; i < quantities.size(); ++i) {
      if (on.empty() || on == quantities[i]) {
        m_state->Terms[i].push_back(term);
      }
    }
  }
}

void CDeviceNoise::Reset() {
  if (m_state != nullptr) {
    m_state->Stream = m_state->MakeStream();
  }
}

bool CDeviceNoise::IsOn(size_t number) const {
  return m_state != nullptr && !m_state->Terms[number].empty();
}

Real CDeviceNoise::ApplyState(size_t number, Real value) {
  Real noisy = value;
  for (const STerm& term : m_state->Terms[number]) {
    const Real change = term.Bias + Draw(term, m_state->Stream);
    noisy += term.Relative ? value * change : change;
  }
  return noisy;
}

CRange<Real> ReadNoiseLevel(TConfigurationNode& device) {
  Real level = 0.0;
  GetNodeAttributeOrDefault(device, "noise_level", level, level);
  if (!IsIn(kNotNegative, level)) {
    RequireNotNegative(level, OwnerOf(device), "attribute \"noise_level\"");
  }
  return CRange<Real>(-level, level);
}

CRange<Real> ReadNoiseRange(TConfigurationNode& device, const std::string& attribute) {
  CRange<Real> range(0.0, 0.0);
  GetNodeAttributeOrDefault(device, attribute, range, range);
  return range;
}

}  // namespace argos
