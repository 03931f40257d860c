// Tests that the noise of the cameras has the documented distributions.

#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_perspective_camera_sensor.h>
#include <argos3/plugins/simulator/entities/led_entity.h>
#include <argos3/testing/support/arena_text.h>
#include <argos3/testing/support/robot_sizes.h>
#include <argos3/testing/support/robot_world.h>
#include <argos3/testing/support/statistics.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace camera_noise_test {

using namespace argos;

namespace {

constexpr int kDraws = 20000;

Real Uniform(Real value, Real min, Real max) {
  return (value - min) / (max - min);
}

// two foot-bots, each with a light 50 cm away, 1 rad to the left of straight ahead
SRobotExperiment WithCameras(const std::string& sensor) {
  SRobotExperiment experiment;
  experiment.Sensors = sensor;
  for (const Real y : {0.0, 3.0}) {
    const std::string id = y == 0.0 ? "a" : "b";
    experiment.Arena +=
        Robot("foot-bot", id, PoseText(CVector3(0.0, y, 0.0))) +
        LightText("l" + id, CVector3(0.5 * std::cos(1.0), y + 0.5 * std::sin(1.0), 0.1));
  }
  return experiment;
}

std::string Omnidirectional(const std::string& attributes, const std::string& noise = "") {
  return "<colored_blob_omnidirectional_camera implementation=\"rot_z_only\" medium=\"leds\" " +
         attributes + ">" + noise + "</colored_blob_omnidirectional_camera>";
}

struct SBlobs {
  std::vector<Real> Distances;  // cm
  std::vector<Real> Angles;  // rad
};

SBlobs Draw(CRobotWorld& world, const std::string& robot, int num) {
  auto& camera = world.GetSensor<CCI_ColoredBlobOmnidirectionalCameraSensor>(
      robot, "colored_blob_omnidirectional_camera");
  camera.Enable();
  SBlobs blobs;
  for (int i = 0; i < num; ++i) {
    world.Step();
    REQUIRE(camera.GetReadings().BlobList.size() == 1);
    blobs.Distances.push_back(camera.GetReadings().BlobList[0]->Distance);
    blobs.Angles.push_back(camera.GetReadings().BlobList[0]->Angle.GetValue());
  }
  return blobs;
}

}  // namespace

TEST_CASE("omnidirectional camera noise: the displacement is Gaussian, its direction uniform",
          "[contract][cameras][noise]") {
  const Real deviation = 0.1;
  CRobotWorld world(WithCameras(Omnidirectional("noise_std_dev=\"0.1\"")));
  const SBlobs blobs = Draw(world, "a", kDraws);
  std::vector<Real> lengths;
  std::vector<Real> directions;
  for (int i = 0; i < kDraws; ++i) {
    const Real x = blobs.Distances[i] * std::cos(blobs.Angles[i]) - 50.0 * std::cos(1.0);
    const Real y = blobs.Distances[i] * std::sin(blobs.Angles[i]) - 50.0 * std::sin(1.0);
    lengths.push_back(std::hypot(x, y) / 50.0);
    directions.push_back(std::atan2(y, x));
  }
  CHECK(KolmogorovSmirnovExcess(lengths, [&](Real length) {
          return 2.0 * NormalDistribution(length, deviation) - 1.0;
        }) < 1.0);
  CHECK(KolmogorovSmirnovExcess(
            directions, [](Real direction) { return Uniform(direction, -M_PI, M_PI); }) < 1.0);
  // the test can fail: a deviation that is off by a tenth does not pass
  CHECK(KolmogorovSmirnovExcess(lengths, [&](Real length) {
          return 2.0 * NormalDistribution(length, 1.1 * deviation) - 1.0;
        }) > 1.0);
}

TEST_CASE("omnidirectional camera noise: <noise> on distance and angle has the stated distribution",
          "[contract][cameras][noise]") {
  CRobotWorld world(WithCameras(
      Omnidirectional("",
                      "<noise on=\"distance\" model=\"gaussian\" std_dev=\"2\" bias=\"3\"/>"
                      "<noise on=\"angle\" model=\"uniform\" level=\"0.2\"/>")));
  const SBlobs blobs = Draw(world, "a", kDraws);
  CHECK(KolmogorovSmirnovExcess(blobs.Distances, [](Real distance) {
          return NormalDistribution(distance - 53.0, 2.0);
        }) < 1.0);
  CHECK(KolmogorovSmirnovExcess(blobs.Angles, [](Real angle) { return Uniform(angle, 0.8, 1.2); }) <
        1.0);
}

TEST_CASE("omnidirectional camera noise: readings stay in their ranges",
          "[contract][cameras][noise]") {
  CRobotWorld world(
      WithCameras(Omnidirectional("",
                                  "<noise on=\"distance\" model=\"gaussian\" std_dev=\"100\"/>"
                                  "<noise on=\"angle\" model=\"uniform\" level=\"9\"/>")));
  const SBlobs blobs = Draw(world, "a", 1000);
  for (int i = 0; i < 1000; ++i) {
    CHECK(blobs.Distances[i] >= 0.0);
    CHECK((blobs.Angles[i] >= -M_PI && blobs.Angles[i] < M_PI));
  }
}

namespace {

// a foot-bot with a light 1 m ahead of its camera, 10 cm to the left and 5 cm up: it
// appears at pixel (250.72, 205.36)
SRobotExperiment WithPerspectiveCamera(const std::string& attributes, const std::string& noise) {
  SRobotExperiment experiment;
  experiment.Sensors =
      "<colored_blob_perspective_camera implementation=\"default\" medium=\"leds\" " + attributes +
      ">" + noise + "</colored_blob_perspective_camera>";
  experiment.Arena = Robot("foot-bot", "r", PoseText(CVector3())) +
                     LightText("l", CVector3(1.0 + kFootBotRadius, 0.1, 0.224249733));
  return experiment;
}

// how often each pixel was drawn; the first and the last bin include values below and above
struct SHistogram {
  explicit SHistogram(SInt32 first) : First(first), Counts(12) {}
  void Add(SInt32 pixel) { ++Counts[std::clamp(pixel - First, 0, 11)]; }
  // against a distribution function of the coordinate before truncation to an integer
  Real ComputeExcess(const std::function<Real(Real)>& distribution) const {
    std::vector<Real> probabilities;
    for (SInt32 i = 0; i < 12; ++i) {
      const Real below = i == 0 ? 0.0 : distribution(First + i);
      probabilities.push_back((i == 11 ? 1.0 : distribution(First + i + 1)) - below);
    }
    return ChiSquareExcess(Counts, probabilities);
  }

  SInt32 First;
  std::vector<size_t> Counts;
};

}  // namespace

TEST_CASE("perspective camera noise: pixels are shifted with the stated distribution",
          "[contract][cameras][noise]") {
  const bool asAttribute = GENERATE(true, false);
  CRobotWorld world(
      WithPerspectiveCamera(asAttribute ? "noise_std_dev=\"2\"" : "",
                            asAttribute ? "" : "<noise model=\"gaussian\" std_dev=\"2\"/>"));
  auto& camera = world.GetSensor<CCI_ColoredBlobPerspectiveCameraSensor>(
      "r", "colored_blob_perspective_camera");
  camera.Enable();
  SHistogram xs(245);
  SHistogram ys(200);
  Real product = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    world.Step();
    REQUIRE(camera.GetReadings().BlobList.size() == 1);
    const auto& blob = *camera.GetReadings().BlobList[0];
    xs.Add(blob.X);
    ys.Add(blob.Y);
    product += (blob.X + 0.5 - 250.718) * (blob.Y + 0.5 - 205.359);
  }
  const Real height = 2.0 * std::tan(M_PI / 6.0) / (5.0 / 3.0);  // of the image at 1 m, m
  const auto around = [](Real middle, Real deviation) {
    return [middle, deviation](Real x) { return NormalDistribution(x - middle, deviation); };
  };
  const Real x = 320.0 - 0.1 * 480.0 / height;
  const Real y = 240.0 - 0.05 * 480.0 / height;
  CHECK(xs.ComputeExcess(around(x, 2.0)) < 1.0);
  CHECK(ys.ComputeExcess(around(y, 2.0)) < 1.0);
  CHECK(xs.ComputeExcess(around(x, 2.2)) > 1.0);
  CHECK(ys.ComputeExcess(around(y + 0.2, 2.0)) > 1.0);
  // the two coordinates are independent: the mean of the product has a
  // standard deviation of 4 / sqrt(n)
  CHECK(std::abs(product / kDraws) < 5.0 * 4.1 / std::sqrt(kDraws));
}

TEST_CASE("perspective camera noise: a blob that leaves the image is lost, none enters it",
          "[contract][cameras][noise]") {
  // about half of the pictures lose a blob at the left edge; a blob outside never appears
  CRobotWorld world(WithPerspectiveCamera("", "<noise model=\"gaussian\" std_dev=\"20\"/>"));
  const Real width = 2.0 * std::tan(M_PI / 6.0) * 0.8;  // of the image at 1 m, m
  auto& light = world.Get<CLEDEntity>("l");
  auto& camera = world.GetSensor<CCI_ColoredBlobPerspectiveCameraSensor>(
      "r", "colored_blob_perspective_camera");
  camera.Enable();
  const auto count = [&](Real y) {
    light.SetPosition(CVector3(1.0 + kFootBotRadius, y, 0.174249733));
    int seen = 0;
    for (int i = 0; i < 2000; ++i) {
      world.Step();
      seen += static_cast<int>(camera.GetReadings().BlobList.size());
    }
    return seen;
  };
  // the pixel is kept if the noise is above -1 pixel, 1/20 of its deviation: P = 0.51994
  const int inside = count(0.5 * width - 1e-6);
  CHECK(std::abs(inside - 2000 * 0.51994) < 5.0 * std::sqrt(2000 * 0.25));
  CHECK(count(0.5 * width * (1.0 + 4.0 / 640.0)) == 0);
}

TEST_CASE("camera noise: differs between robots and repeats after a reset with the same seed",
          "[contract][cameras][noise]") {
  const std::string noise =
      GENERATE(Omnidirectional("noise_std_dev=\"0.1\""),
               Omnidirectional("", "<noise on=\"distance\" model=\"gaussian\" std_dev=\"1\"/>"));
  CRobotWorld world(WithCameras(noise));
  const std::vector<Real> a = Draw(world, "a", 10).Distances;
  world.GetSimulator().Reset();
  CHECK(Draw(world, "b", 10).Distances != a);
  world.GetSimulator().Reset();
  CHECK(Draw(world, "a", 10).Distances == a);
  world.GetSimulator().Reset(2);
  CHECK(Draw(world, "a", 10).Distances != a);
}

}  // namespace camera_noise_test
