// Compares every sensor of every robot with Gaussian noise with the same sensor without noise: the
// readings differ by the requested distribution, except where they are clamped to their range.

#include <argos3/testing/contract/sensors/symmetry_probe.h>

#include <catch2/catch.hpp>

#include <regex>

namespace sensor_noise_test {

using namespace argos;

namespace {

// so many draws that a standard deviation a fifth too large is detected
constexpr size_t kDraws = 6000;
// in sigmas: readings closer to the limits of their range are not used,
// because noise might clamp them
constexpr Real kMargin = 7.0;

// adds noise to each self-closing element, which is a device or a detector of a camera
std::string WithGaussian(const std::string& devices, Real sigma) {
  static const std::regex element("<([a-z_]+)([^<>]*)/>");
  return std::regex_replace(devices, element,
                            "<$1$2><noise model='gaussian' std_dev='" + ToText(sigma) + "'/></$1>");
}

void Append(std::vector<Real>& errors, const SNoisyReadings& noise,
            const TSymmetryReadings& readings, const TSymmetryReadings& exact) {
  REQUIRE(readings.size() == exact.size());
  for (size_t i = 0; i < exact.size(); ++i) {
    const bool isConcerned =
        std::count(noise.Columns.begin(), noise.Columns.end(), i % noise.Stride) > 0;
    const Real margin = kMargin * noise.Sigma;
    if (isConcerned && exact[i] > noise.Min + margin && exact[i] < noise.Max - margin) {
      errors.push_back(readings[i] - exact[i]);
    }
  }
}

}  // namespace

TEST_CASE("sensor noise: every sensor of every robot has the requested distribution",
          "[contract][sensors][noise]") {
  SSymmetryMap map;
  map.IsInOrderOfCreation = true;
  for (SSymmetryProbe& probe : MakeSymmetryProbes()) {
    const Real sigma = probe.Noise.Sigma;
    if (sigma == 0.0) {
      continue;
    }
    CAPTURE(probe.Name);
    CRobotWorld exact(MakeSymmetryExperiment(probe, map));
    probe.Sensors = WithGaussian(probe.Sensors, sigma);
    CRobotWorld noisy(MakeSymmetryExperiment(probe, map));
    for (CRobotWorld* world : {&exact, &noisy}) {
      if (probe.Prepare) {
        probe.Prepare(*world, map);
      }
    }
    std::vector<Real> errors;
    for (size_t tick = 0; tick < kDraws && errors.size() < kDraws; ++tick) {
      exact.Step();
      noisy.Step();
      const TSymmetryReadings truth = probe.Read(exact, map);
      Append(errors, probe.Noise, probe.Read(noisy, map), truth);
    }
    REQUIRE(errors.size() >= kDraws);
    CHECK(KolmogorovSmirnovExcess(
              errors, [sigma](Real error) { return NormalDistribution(error, sigma); }) <= 1.0);
  }
}

}  // namespace sensor_noise_test
