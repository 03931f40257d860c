// Readings of the range-and-bearing sensor: geometry, messages, noise, loss.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace argos::range_and_bearing_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

using TPacket = CCI_RangeAndBearingSensor::SPacket;
using TReadings = CCI_RangeAndBearingSensor::TReadings;

SRobotExperiment WithRAB(const std::string& arena, const std::string& attributes = "",
                         const std::string& children = "") {
  SRobotExperiment experiment;
  experiment.Actuators = "<range_and_bearing implementation=\"default\"/>";
  experiment.Sensors = "<range_and_bearing implementation=\"medium\" medium=\"rab\" " + attributes +
                       ">" + children + "</range_and_bearing>";
  experiment.Media = "<range_and_bearing id=\"rab\"/>";
  experiment.Arena = arena;
  return experiment;
}

// a robot with the same range and message size for every type
std::string RobotAt(const std::string& tag, const std::string& id, const CVector3& position,
                    Real yaw = 0.0) {
  return "<" + tag + " id=\"" + id + "\" rab_range=\"4\" rab_data_size=\"3\"><body position=\"" +
         ToText(position) + "\" orientation=\"" + ToText(yaw) +
         ",0,0\"/><controller config=\"c\"/></" + tag + ">";
}

const TReadings& Readings(CRobotWorld& world, const std::string& robot) {
  return world.GetSensor<CCI_RangeAndBearingSensor>(robot, "range_and_bearing").GetReadings();
}

CCI_RangeAndBearingActuator& Actuator(CRobotWorld& world, const std::string& robot) {
  return world.GetActuator<CCI_RangeAndBearingActuator>(robot, "range_and_bearing");
}

}  // namespace

TEST_CASE("range and bearing: ranges are in cm, bearings in the robot's frame",
          "[contract][sensors]") {
  const std::string tag = GENERATE("foot-bot", "e-puck");
  // bearing of the sender in the world, and yaw of the receiver, degrees
  const Real direction = GENERATE(0.0, 40.0, 90.0, 179.0, -120.0);
  const Real yaw = GENERATE(0.0, 30.0, -170.0);
  CAPTURE(tag, direction, yaw);
  const CRadians angle = ToRadians(CDegrees(direction));
  const CVector3 place(0.5, -1.0, 0.0);
  CRobotWorld world(WithRAB(
      RobotAt(tag, "here", place, yaw) +
      RobotAt(tag, "there", place + CVector3(1.5 * Cos(angle), 1.5 * Sin(angle), 0.0), 77.0)));
  world.Step();
  REQUIRE(Readings(world, "here").size() == 1);
  const TPacket& packet = Readings(world, "here")[0];
  // degrees in the file, and coordinates near 1: some roundings of 1e-16
  CHECK_THAT(packet.Range, WithinAbs(150.0, 1e-12));
  const CRadians expected = ToRadians(CDegrees(direction - yaw)).SignedNormalize();
  CHECK_THAT(packet.HorizontalBearing.GetValue(), WithinAbs(expected.GetValue(), 1e-13));
  CHECK_THAT(packet.VerticalBearing.GetValue(), WithinAbs(0.0, 1e-15));
}

TEST_CASE("range and bearing: the elevation is the angle of the sender above the robot's plane",
          "[contract][sensors]") {
  // devices are 0.1 m high on a foot-bot, 0.086 m on an e-puck
  CRobotWorld world(WithRAB(RobotAt("foot-bot", "fb", CVector3(0.0, 0.0, 0.0), 10.0) +
                            RobotAt("e-puck", "ep", CVector3(0.3, 0.4, 0.0), 20.0)));
  world.Step();
  REQUIRE(Readings(world, "fb").size() == 1);
  REQUIRE(Readings(world, "ep").size() == 1);
  const Real rise = 0.1 - 0.086;
  const TPacket& down = Readings(world, "fb")[0];
  const TPacket& up = Readings(world, "ep")[0];
  CHECK_THAT(up.VerticalBearing.GetValue(), WithinAbs(std::atan2(rise, 0.5), 1e-14));
  CHECK_THAT(down.VerticalBearing.GetValue(), WithinAbs(-std::atan2(rise, 0.5), 1e-14));
  CHECK_THAT(up.Range, WithinAbs(100.0 * std::hypot(0.5, rise), 1e-12));
  CHECK_THAT(down.Range, WithinAbs(up.Range, 1e-12));
  const Real toEPuck = std::atan2(0.4, 0.3) - 10.0 * M_PI / 180.0;
  CHECK_THAT(down.HorizontalBearing.GetValue(), WithinAbs(toEPuck, 1e-13));
}

TEST_CASE("range and bearing: a tilted robot measures in its own frame", "[contract][sensors]") {
  CRobotWorld world(WithRAB(RobotAt("foot-bot", "here", CVector3()) +
                            RobotAt("foot-bot", "there", CVector3(1.0, 0.0, 0.0))));
  // nose down by 30 degrees about y: the x axis points below the horizon
  auto& here = world.Get<CFootBotEntity>("here");
  here.GetEmbodiedEntity().MoveTo(CVector3(), CQuaternion(ToRadians(CDegrees(30.0)), CVector3::Y),
                                  false, true);
  world.Step();
  REQUIRE(Readings(world, "here").size() == 1);
  const TPacket& packet = Readings(world, "here")[0];
  // its device is now at (0.1 sin 30, 0, 0.1 cos 30), the other device at (1, 0, 0.1)
  const Real ahead = 1.0 - 0.1 * 0.5;
  const Real above = 0.1 - 0.1 * std::sqrt(3.0) / 2.0;
  CHECK_THAT(packet.VerticalBearing.GetValue(),
             WithinAbs(std::atan2(above, ahead) + M_PI / 6.0, 1e-13));
  CHECK_THAT(packet.HorizontalBearing.GetValue(), WithinAbs(0.0, 1e-13));
  CHECK_THAT(packet.Range, WithinAbs(100.0 * std::hypot(ahead, above), 1e-11));
}

TEST_CASE("range and bearing: e-pucks, whose devices are at their tops, occlude each other",
          "[contract][sensors]") {
  CRobotWorld world(WithRAB(RobotAt("e-puck", "a", CVector3(), 33.0) +
                            RobotAt("e-puck", "b", CVector3(0.5, 0.01, 0.0), 77.0) +
                            RobotAt("e-puck", "c", CVector3(1.0, 0.0, 0.0), -13.0)));
  world.Step();
  CHECK(Readings(world, "a").size() == 1);
  CHECK(Readings(world, "b").size() == 2);
  CHECK(Readings(world, "c").size() == 1);
}

TEST_CASE("range and bearing: mirrored worlds give mirrored readings, turned worlds equal ones",
          "[contract][sensors]") {
  CRandomStream random(4, "test", "range and bearing", "places");
  constexpr int kRobots = 25;
  std::vector<CVector3> places;
  std::vector<Real> yaws;
  for (int i = 0; i < kRobots; ++i) {
    // on a jittered lattice of 0.5 m, so that no robots overlap
    places.emplace_back(0.5 * (i % 5) + random.Uniform(-0.1, 0.1) - 1.0,
                        0.5 * (i / 5) + random.Uniform(-0.1, 0.1) - 1.0, 0.0);
    yaws.push_back(random.Uniform(-180.0, 180.0));
  }
  const auto build = [&](Real mirror, Real turn) {
    std::string arena;
    for (int i = 0; i < kRobots; ++i) {
      CVector3 place(places[i].GetX(), mirror * places[i].GetY(), 0.0);
      place.RotateZ(ToRadians(CDegrees(turn)));
      arena += RobotAt(i % 2 == 0 ? "foot-bot" : "e-puck", "r" + std::to_string(i), place,
                       mirror * yaws[i] + turn);
    }
    return WithRAB(arena);
  };
  CRobotWorld plain(build(1.0, 0.0));
  plain.Step();
  const Real mirror = GENERATE(-1.0, 1.0);
  const Real turn = GENERATE(0.0, 123.0);
  CRobotWorld other(build(mirror, turn));
  other.Step();
  size_t numPackets = 0;
  for (int i = 0; i < kRobots; ++i) {
    const TReadings& expected = Readings(plain, "r" + std::to_string(i));
    const TReadings& found = Readings(other, "r" + std::to_string(i));
    CAPTURE(i);
    REQUIRE(found.size() == expected.size());
    numPackets += found.size();
    for (size_t k = 0; k < found.size(); ++k) {
      CHECK_THAT(found[k].Range, WithinAbs(expected[k].Range, 1e-11));
      const CVector2 bearing(1.0, found[k].HorizontalBearing);
      CHECK_THAT(Distance(bearing, CVector2(1.0, mirror * expected[k].HorizontalBearing)),
                 WithinAbs(0.0, 1e-12));
      CHECK_THAT(found[k].VerticalBearing.GetValue(),
                 WithinAbs(expected[k].VerticalBearing.GetValue(), 1e-13));
    }
  }
  // some pairs are occluded, some are not
  CHECK(numPackets > 3 * kRobots);
  CHECK(numPackets < kRobots * (kRobots - 1));
}

TEST_CASE("range and bearing: a message set in one tick is received in the next",
          "[contract][sensors]") {
  CRobotWorld world(WithRAB(RobotAt("foot-bot", "a", CVector3()) +
                            RobotAt("e-puck", "b", CVector3(1.0, 0.0, 0.0))));
  REQUIRE(Actuator(world, "a").GetSize() == 3);
  world.Step();
  CHECK(Readings(world, "b")[0].Data == CByteArray(3, 0));
  const UInt8 bytes[3] = {1, 200, 255};
  Actuator(world, "a").SetData(CByteArray(bytes, 3));
  CHECK(Readings(world, "b")[0].Data == CByteArray(3, 0));
  world.Step();
  CHECK(Readings(world, "b")[0].Data == CByteArray(bytes, 3));
  // it is sent until it is replaced
  world.Step(3);
  CHECK(Readings(world, "b")[0].Data == CByteArray(bytes, 3));
  Actuator(world, "a").SetData(0, 7);
  world.Step();
  CHECK(Readings(world, "b")[0].Data[0] == 7);
  CHECK(Readings(world, "b")[0].Data[1] == 200);
  Actuator(world, "a").ClearData();
  world.Step();
  CHECK(Readings(world, "b")[0].Data == CByteArray(3, 0));
}

TEST_CASE("range and bearing: lines to the senders are recorded only on request",
          "[contract][sensors]") {
  const bool show = GENERATE(false, true);
  CRobotWorld world(WithRAB(
      RobotAt("foot-bot", "a", CVector3()) + RobotAt("foot-bot", "b", CVector3(1.0, 0.0, 0.0)),
      show ? "show_rays=\"true\"" : ""));
  world.Step();
  const auto& rays = world.GetRobot("a").GetCheckedRays();
  REQUIRE(rays.size() == (show ? 1 : 0));
  if (show) {
    CHECK_FALSE(rays[0].first);
    CHECK(rays[0].second.GetStart() == CVector3(1.0, 0.0, 0.1));
    CHECK(rays[0].second.GetEnd() == CVector3(0.0, 0.0, 0.1));
  }
}

namespace {

constexpr int kDraws = 20000;

// packets that "a" receives from "b", 1 m ahead of it, tick by tick
std::vector<TPacket> DrawPackets(CRobotWorld& world, int num) {
  std::vector<TPacket> packets;
  for (int i = 0; i < num; ++i) {
    world.Step();
    const TReadings& readings = Readings(world, "a");
    packets.insert(packets.end(), readings.begin(), readings.end());
  }
  return packets;
}

std::string Pair() {
  return RobotAt("foot-bot", "a", CVector3()) + RobotAt("foot-bot", "b", CVector3(1.0, 0.0, 0.0));
}

CVector3 PlaceOf(const TPacket& packet) {
  const Real horizontal = packet.Range * Cos(packet.VerticalBearing);
  return CVector3(horizontal * Cos(packet.HorizontalBearing),
                  horizontal * Sin(packet.HorizontalBearing),
                  packet.Range * Sin(packet.VerticalBearing)) /
         100.0;
}

}  // namespace

TEST_CASE("range and bearing noise: is a vector of Gaussian length and uniform angles",
          "[contract][sensors]") {
  const Real sigma = 0.05;
  CRobotWorld world(WithRAB(Pair(), "noise_std_dev=\"0.05\""));
  const std::vector<TPacket> packets = DrawPackets(world, kDraws);
  REQUIRE(packets.size() == kDraws);
  CVector3 mean;
  CVector3 squares;
  std::vector<Real> lengths;
  for (const TPacket& packet : packets) {
    const CVector3 error = PlaceOf(packet) - CVector3(1.0, 0.0, 0.0);
    mean += error / kDraws;
    squares += CVector3(error.GetX() * error.GetX(), error.GetY() * error.GetY(),
                        error.GetZ() * error.GetZ()) /
               kDraws;
    lengths.push_back(error.Length());
  }
  // with length L ~ N(0,s), inclination I ~ U[0,PI] and azimuth A ~ U[0,2 PI]:
  // E[z^2] = s^2 E[cos^2 I] = s^2/2, E[x^2] = E[y^2] = s^2 E[sin^2 I] E[cos^2 A] = s^2/4.
  // L^4 has mean 3 s^4, so Var(z^2) = 3 s^4 3/8 - s^4/4 = 0.875 s^4,
  // Var(x^2) = 3 s^4 (3/8)^2 - s^4/16 = 0.359 s^4. Five standard deviations: 1 failure in 10^6
  const Real five = 5.0 / std::sqrt(kDraws);
  CHECK_THAT(mean.GetX(), WithinAbs(0.0, five * sigma * std::sqrt(0.25)));
  CHECK_THAT(mean.GetY(), WithinAbs(0.0, five * sigma * std::sqrt(0.25)));
  CHECK_THAT(mean.GetZ(), WithinAbs(0.0, five * sigma * std::sqrt(0.5)));
  const Real square = sigma * sigma;
  CHECK_THAT(squares.GetX(), WithinAbs(square / 4.0, five * square * std::sqrt(0.359)));
  CHECK_THAT(squares.GetY(), WithinAbs(square / 4.0, five * square * std::sqrt(0.359)));
  CHECK_THAT(squares.GetZ(), WithinAbs(square / 2.0, five * square * std::sqrt(0.875)));
  // Kolmogorov-Smirnov: |L| has the distribution erf(l / (s sqrt 2)); 1.95 / sqrt(n) is exceeded
  // with probability 0.001
  std::sort(lengths.begin(), lengths.end());
  Real greatest = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const Real expected = std::erf(lengths[i] / (sigma * std::sqrt(2.0)));
    greatest = std::max({greatest, std::abs(expected - static_cast<Real>(i) / kDraws),
                         std::abs(expected - static_cast<Real>(i + 1) / kDraws)});
  }
  CHECK(greatest < 1.95 / std::sqrt(kDraws));
}

TEST_CASE("range and bearing noise: <noise> is on the given quantity", "[contract][sensors]") {
  CRobotWorld world(WithRAB(Pair(), "",
                            "<noise on=\"range\" model=\"gaussian\" std_dev=\"2\" bias=\"1\"/>"
                            "<noise on=\"horizontal_bearing\" model=\"uniform\" level=\"0.1\"/>"));
  const std::vector<TPacket> packets = DrawPackets(world, kDraws);
  REQUIRE(packets.size() == kDraws);
  Real rangeSum = 0.0;
  Real rangeSquares = 0.0;
  Real bearingSum = 0.0;
  Real bearingSquares = 0.0;
  for (const TPacket& packet : packets) {
    rangeSum += packet.Range - 101.0;
    rangeSquares += (packet.Range - 101.0) * (packet.Range - 101.0);
    const Real bearing = packet.HorizontalBearing.GetValue();
    REQUIRE(std::abs(bearing) <= 0.1 + 1e-12);
    bearingSum += bearing;
    bearingSquares += bearing * bearing;
    REQUIRE(packet.VerticalBearing == CRadians());
  }
  // tolerance of five standard deviations of each estimate: 1 failure in 10^6
  const Real five = 5.0 / std::sqrt(kDraws);
  CHECK_THAT(rangeSum / kDraws, WithinAbs(0.0, five * 2.0));
  CHECK_THAT(rangeSquares / kDraws, WithinAbs(4.0, five * 4.0 * std::sqrt(2.0)));
  CHECK_THAT(bearingSum / kDraws, WithinAbs(0.0, five * 0.1 / std::sqrt(3.0)));
  CHECK_THAT(bearingSquares / kDraws, WithinAbs(0.01 / 3.0, five * 0.01 * std::sqrt(4.0 / 45.0)));
}

TEST_CASE("range and bearing noise: readings stay in their ranges", "[contract][sensors]") {
  CRobotWorld world(WithRAB(Pair(), "", "<noise model=\"gaussian\" std_dev=\"200\"/>"));
  bool anyTruncated = false;
  for (const TPacket& packet : DrawPackets(world, 300)) {
    CHECK(packet.Range >= 0.0);
    CHECK(Abs(packet.HorizontalBearing) <= CRadians::PI);
    CHECK(Abs(packet.VerticalBearing) <= CRadians::PI_OVER_TWO);
    anyTruncated = anyTruncated || packet.Range == 0.0;
  }
  CHECK(anyTruncated);
}

TEST_CASE("range and bearing: packets are lost with the given probability", "[contract][sensors]") {
  struct SCase {
    const char* Attribute;
    Real Probability;
  };
  const SCase c =
      GENERATE(SCase{"packet_drop_prob=\"0.3\"", 0.3}, SCase{"packet_drop_prob=\"0\"", 0.0},
               SCase{"packet_drop_prob=\"1\"", 1.0});
  CRobotWorld world(WithRAB(Pair(), c.Attribute));
  const Real heard = static_cast<Real>(DrawPackets(world, kDraws).size());
  // tolerance of five standard deviations of the binomial distribution: 1 failure in 10^6
  const Real deviation = std::sqrt(kDraws * c.Probability * (1.0 - c.Probability));
  CHECK_THAT(heard, WithinAbs(kDraws * (1.0 - c.Probability), 5.0 * deviation));
}

TEST_CASE("range and bearing noise: differs between robots and repeats after a reset",
          "[contract][sensors]") {
  const std::string attributes = GENERATE("noise_std_dev=\"0.1\"", "packet_drop_prob=\"0.5\"", "");
  const std::string children = attributes.empty() ? "<noise model=\"uniform\" level=\"0.1\"/>" : "";
  CRobotWorld world(WithRAB(Pair(), attributes, children));
  const auto draw = [&world](const std::string& robot) {
    std::vector<Real> ranges;
    for (int i = 0; i < 40; ++i) {
      world.Step();
      const TReadings& readings = Readings(world, robot);
      ranges.push_back(readings.empty() ? -1.0 : readings[0].Range);
    }
    return ranges;
  };
  const std::vector<Real> first = draw("a");
  world.GetSimulator().Reset();
  CHECK(draw("b") != first);
  world.GetSimulator().Reset();
  CHECK(draw("a") == first);
  world.GetSimulator().Reset(2);
  CHECK(draw("a") != first);
}

TEST_CASE("range and bearing: invalid orders and experiments are refused with the reason",
          "[contract][sensors][errors]") {
  SECTION("a message of another size") {
    CRobotWorld world(WithRAB(Pair()));
    CHECK_THROWS_WITH(Actuator(world, "a").SetData(CByteArray(4)), Contains("3 bytes, got 4"));
    CHECK_THROWS_WITH(Actuator(world, "a").SetData(3, 1), Contains("no byte 3"));
  }
  SECTION("invalid attributes") {
    const SInvalidAttributes c =
        GENERATE(SInvalidAttributes{"noise_std_dev=\"-1\"", ">= 0, got -1"},
                 SInvalidAttributes{"packet_drop_prob=\"1.5\"", "[0,1], got 1.5"},
                 SInvalidAttributes{"packet_drop_prob=\"x\"", "packet_drop_prob"},
                 SInvalidAttributes{"show_rays=\"x\"", "show_rays"});
    CHECK_THAT(LoadError(WithRAB(Pair(), c.Attributes)),
               Contains(c.Reason) && Contains("test.argos:"));
  }
  SECTION("noise on an unknown quantity") {
    CHECK_THAT(
        LoadError(WithRAB(Pair(), "", "<noise on=\"bearing\" model=\"uniform\" level=\"1\"/>")),
        Contains("horizontal_bearing"));
  }
  SECTION("a missing medium") {
    SRobotExperiment experiment = WithRAB(Pair());
    experiment.Sensors = "<range_and_bearing implementation=\"medium\"/>";
    CHECK_THAT(LoadError(experiment), Contains("medium"));
  }
  SECTION("an unknown medium") {
    SRobotExperiment experiment = WithRAB(Pair());
    experiment.Media = "<range_and_bearing id=\"rabbit\"/>";
    CHECK_THAT(LoadError(experiment),
               Contains("range and bearing medium") && Contains("\"rab\"") && Contains("rabbit"));
  }
  SECTION("a medium of the wrong type") {
    SRobotExperiment experiment = WithRAB(Pair());
    experiment.Media = "<led id=\"rab\"/>";
    CHECK_THAT(LoadError(experiment), Contains("range and bearing medium"));
  }
  SECTION("a robot without the device") {
    SRobotExperiment experiment = WithRAB(
        "<toy-robot id=\"r\"><body position=\"0,0,0\"/><controller config=\"c\"/></toy-robot>");
    CHECK_THAT(LoadError(experiment), Contains("no component \"rab\"") && Contains("\"r\""));
  }
}

}  // namespace argos::range_and_bearing_test
