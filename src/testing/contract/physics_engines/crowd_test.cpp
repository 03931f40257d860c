// Many bodies in little space: robots overlap neither walls nor each other.

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/support/overlap.h>
#include <argos3/testing/support/robot_sizes.h>
#include <argos3/testing/support/sanitizers.h>

#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/math/vector2.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>

namespace argos::physics_engines_crowd_test {

using Catch::Matchers::WithinAbs;
using testing::MeasureOverlaps;
using testing::SOverlaps;

namespace {

constexpr Real kFootBotHeight = 0.146899733;  // m

// robots of a crowd, one behind the other and side by side
constexpr int kDeepest = FewerIfSanitized(60);
constexpr int kWidest = FewerIfSanitized(20);

bool IsFinite(const CVector3& v) {
  return std::isfinite(v.GetX()) && std::isfinite(v.GetY()) && std::isfinite(v.GetZ());
}

/** E-pucks in columns between two side walls, all driving the same way or towards each other. */
struct SColumns {
  int Depth = 8;
  int Width = 12;
  Real Yaw = 0.0;  // degrees, of the whole scene
  Real Jitter = 0.0;  // m: each robot starts within this distance of its lattice point, per axis
  bool FaceToFace = false;  // two crowds that face each other instead of a crowd and a wall

  static constexpr Real kAhead = 1.0;  // m: position of the wall at which a single crowd drives

  CVector2 Turn(Real x, Real y) const {
    return CVector2(x, y).Rotate(CRadians(Yaw / 180.0 * ARGOS_PI));
  }
  int CountRobots() const { return Depth * Width * (FaceToFace ? 2 : 1); }

  std::string ToXml() const {
    const Real half = 0.04 * Width + 0.02;
    std::string arena;
    const auto addWall = [&](const std::string& id, Real length, Real width, Real x, Real y) {
      const CVector2 at = Turn(x, y);
      std::ostringstream size;
      size << length << "," << width << ",0.5";
      arena += WallXml(id, size.str(), at.GetX(), at.GetY(), Yaw);
    };
    const Real sideLength = 0.2 * Depth + 3.0;
    addWall("left", sideLength, 0.1, 0.0, half + 0.05);
    addWall("right", sideLength, 0.1, 0.0, -half - 0.05);
    if (!FaceToFace) {
      addWall("front", 0.1, 2.0 * half + 1.0, kAhead + 0.05, 0.0);
    }
    CRandomStream random(1, "test", "columns", "places");
    for (int i = 0; i < CountRobots(); ++i) {
      const int column = i / Width % Depth;
      const bool facesBack = i >= Depth * Width;
      Real x = FaceToFace ? -0.05 - 0.1 * column : 0.8 - 0.1 * column;
      x = (facesBack ? -x : x) + random.Uniform(-Jitter, Jitter);
      const Real y = 0.08 * (i % Width) - 0.04 * (Width - 1) + random.Uniform(-Jitter, Jitter);
      const CVector2 at = Turn(x, y);
      arena += DriverXml("e-puck", "r" + std::to_string(i), at.GetX(), at.GetY(),
                         Yaw + (facesBack ? 180.0 : 0.0), 10, 10);
    }
    return arena;
  }
};

}  // namespace

TEST_CASE("crowd: discs that drive to one place overlap by at most 2 % of the radius",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  const int rings = std::min(8, engine.DeepestCrowd);
  CAPTURE(engine, rings);
  std::string arena;
  int count = 0;
  for (int ring = 1; ring <= rings; ++ring) {
    for (int k = 0; k < 6 * ring; ++k) {
      const Real angle = 2.0 * ARGOS_PI * k / (6 * ring);
      const Real distance = 0.12 * ring;
      // every robot faces the centre and keeps driving
      arena += DriverXml("e-puck", "r" + std::to_string(count++), distance * std::cos(angle),
                         distance * std::sin(angle), angle * 180.0 / ARGOS_PI + 180.0, 10, 10);
    }
  }
  REQUIRE(count == 3 * rings * (rings + 1));
  CDriveWorld world(engine.ToXml(), arena);
  world.Step(50);
  SOverlaps overlaps;
  for (int tick = 0; tick < 150; ++tick) {
    world.Step();
    MeasureOverlaps(world.GetSpace(), overlaps);
  }
  // The crowd is dense: its discs cover 70 % of the circle around their centres. In a square
  // lattice they would cover 79 %.
  Real farthest = 0.0;
  for (int i = 0; i < count; ++i) {
    const std::string id = "r" + std::to_string(i);
    farthest = std::max(farthest, world.Position(id).Length());
    // no robot is on top of another one
    CHECK(world.Tilt(id) < 0.1);
  }
  CHECK(count * kEPuckRadius * kEPuckRadius >= 0.7 * farthest * farthest);
  CHECK(SOverlaps::Quantile(overlaps.WithRobots, 0.99) <= 0.02);
}

TEST_CASE("crowd: robots that press against a wall overlap neither it nor each other",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  SColumns columns;
  columns.Depth = std::min(columns.Depth, engine.DeepestCrowd);
  columns.Width = std::min({columns.Width, 2 * engine.DeepestCrowd, kWidest});
  columns.Yaw = GENERATE(0.0, 37.0);
  CAPTURE(columns.Yaw);
  CDriveWorld world(engine.ToXml(), columns.ToXml());
  SOverlaps overlaps;
  for (int tick = 0; tick < 150; ++tick) {
    world.Step();
    MeasureOverlaps(world.GetSpace(), overlaps);
  }
  // the specified limit of engines: 2 % of the radius
  CHECK(SOverlaps::Quantile(overlaps.WithRobots, 0.99) <= 0.02);
  CHECK(SOverlaps::Quantile(overlaps.WithWalls, 1.0) <= 0.02);
  // they do press: the front row touches the wall
  const CVector2 ahead = columns.Turn(1.0, 0.0);
  Real foremost = 0.0;
  for (int i = 0; i < columns.CountRobots(); ++i) {
    const CVector3 position = world.Position("r" + std::to_string(i));
    foremost = std::max(foremost, position.GetX() * ahead.GetX() + position.GetY() * ahead.GetY());
  }
  CHECK_THAT(foremost, WithinAbs(SColumns::kAhead - kEPuckRadius, 0.02 * kEPuckRadius));
}

TEST_CASE("crowd: at the greatest depth, against a wall or another crowd, robots never overlap",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  SColumns columns;
  columns.Depth = std::min(engine.DeepestCrowd, kDeepest);
  columns.Width = std::min({8, engine.DeepestCrowd, kWidest});
  std::tie(columns.Yaw, columns.FaceToFace) = GENERATE(
      std::make_tuple(0.0, false), std::make_tuple(37.0, false), std::make_tuple(0.0, true));
  if (columns.FaceToFace && columns.Depth < 10) {
    // in engines where depth matters, two crowds are equivalent to one of twice the depth
    columns.Depth /= 2;
  }
  // columns exactly in line, and columns that buckle
  columns.Jitter = GENERATE(0.0, 0.002);
  CAPTURE(columns.Yaw, columns.FaceToFace, columns.Jitter);
  CDriveWorld world(engine.ToXml(), columns.ToXml());
  // while the crowd forms and afterwards: the last robot drives 3 cm for each robot ahead of it
  const int ticks = 130 + 3 * columns.Depth;
  for (int tick = 0; tick < ticks; ++tick) {
    world.Step();
    SOverlaps overlaps;
    MeasureOverlaps(world.GetSpace(), overlaps);
    CAPTURE(tick);
    // The limit is 2 % of the radius at the 99th percentile. Here every robot is within it, plus
    // the depth by which engines detect contacts late at 20 cm/s.
    const Real most = 0.02 + 0.2 * engine.Lateness / kEPuckRadius;
    REQUIRE(SOverlaps::Quantile(overlaps.WithRobots, 1.0) <= most);
    REQUIRE(SOverlaps::Quantile(overlaps.WithWalls, 1.0) <= most);
  }
  if (columns.FaceToFace && columns.Depth < 10) {
    return;  // shallow crowds pass through each other
  }
  // The crowd has formed: columns in line have the length of all diameters, others use gaps as
  // well. Two crowds face to face buckle sooner or later; robots at their sides then push others
  // back.
  const CVector2 ahead = columns.Turn(1.0, 0.0);
  Real rearmost = SColumns::kAhead;
  for (int i = 0; i < columns.Depth * columns.Width; ++i) {
    const CVector3 position = world.Position("r" + std::to_string(i));
    rearmost = std::min(rearmost, position.GetX() * ahead.GetX() + position.GetY() * ahead.GetY());
  }
  const Real front = columns.FaceToFace ? 0.0 : SColumns::kAhead;
  CHECK(front - rearmost <= (columns.FaceToFace ? 1.1 : 1.02) * columns.Depth * 2.0 * kEPuckRadius);
}

TEST_CASE("crowd: overlapping robots are separated, and no coordinate becomes NaN",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  // 5 cm deep, or at the same position
  const Real distance = GENERATE(2.0 * kFootBotRadius - 0.05, 0.0);
  CAPTURE(distance);
  CDriveWorld world(engine.ToXml(), DriverXml("foot-bot", "a", 0, 0, 0, 0, 0) +
                                        DriverXml("foot-bot", "b", 5, 0, 0, 0, 0));
  world.Body("b").MoveTo(CVector3(distance, 0, 0), CQuaternion(), false, true);
  world.Step(20);
  const CVector3 a = world.Position("a");
  const CVector3 b = world.Position("b");
  REQUIRE(IsFinite(a));
  REQUIRE(IsFinite(b));
  // side by side or, in engines with a third dimension, one on top of the other, which is nearer
  const bool areBeside =
      std::hypot(a.GetX() - b.GetX(), a.GetY() - b.GetY()) >= 2.0 * kFootBotRadius * 0.98;
  const bool areStacked =
      engine.HasSlopes && std::abs(a.GetZ() - b.GetZ()) >= kFootBotHeight * 0.98;
  CHECK((areBeside || areStacked));
  // two robots of equal mass are displaced equally
  CHECK_THAT(0.5 * (a.GetX() + b.GetX()), WithinAbs(0.5 * distance, 1e-3));
}

TEST_CASE("crowd: a robot wedged in a narrow gap stays finite and near", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  // walls that converge, and a crowd that pushes into the gap
  constexpr Real kSlant = 12.0 / 180.0 * ARGOS_PI;
  std::string arena = WallXml("upper", "2,0.1,0.5", 1.0, 0.25, -12.0) +
                      WallXml("lower", "2,0.1,0.5", 1.0, -0.25, 12.0);
  for (int i = 0; i < 30; ++i) {
    arena += DriverXml("e-puck", "r" + std::to_string(i), -0.1 - 0.08 * (i / 3),
                       -0.08 + 0.08 * (i % 3), 0, 15, 15);
  }
  CDriveWorld world(engine.ToXml(), arena);
  SOverlaps overlaps;
  for (int tick = 0; tick < 200; ++tick) {
    world.Step();
    MeasureOverlaps(world.GetSpace(), overlaps);
  }
  CHECK(SOverlaps::Quantile(overlaps.WithWalls, 1.0) <= 0.02 + engine.Slack / kEPuckRadius);
  // a disc fits until its centre is half a wall and its radius from both walls' axes
  const Real depth = 0.02 * kEPuckRadius;
  const Real deepest =
      1.0 + (0.25 - (0.05 + kEPuckRadius - depth) / std::cos(kSlant)) / std::tan(kSlant);
  Real foremost = -1.0;
  for (int i = 0; i < 30; ++i) {
    const CVector3 position = world.Position("r" + std::to_string(i));
    REQUIRE(IsFinite(position));
    REQUIRE(std::abs(position.GetY()) < 1.0);
    foremost = std::max(foremost, position.GetX());
  }
  CHECK(foremost <= deepest);
  CHECK(foremost >= 1.0);
}

TEST_CASE("crowd: a robot among objects in a pen keeps itself and the objects inside",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  // light and heavy objects of every shape, and foot-bots that push them
  std::string arena = WallXml("n", "2.2,0.1,0.5", 0, 1.05) + WallXml("s", "2.2,0.1,0.5", 0, -1.05) +
                      WallXml("e", "0.1,2.2,0.5", 1.05, 0) + WallXml("w", "0.1,2.2,0.5", -1.05, 0);
  std::ostringstream objects;
  for (int i = 0; i < 12; ++i) {
    const Real x = -0.75 + 0.5 * (i % 4);
    const Real y = -0.6 + 0.6 * (i / 4);
    if (i % 2 == 0) {
      objects << "<box id='o" << i << "' size='0.2,0.12,0.2' movable='true' mass='"
              << (i % 4 == 0 ? 0.1 : 3.0) << "'><body position='" << x << "," << y
              << ",0' orientation='" << 15 * i << ",0,0'/></box>";
    } else {
      objects << "<cylinder id='o" << i << "' radius='0.08' height='0.2' movable='true' mass='"
              << (i % 4 == 1 ? 0.1 : 3.0) << "'><body position='" << x << "," << y
              << ",0'/></cylinder>";
    }
  }
  arena += objects.str();
  for (int i = 0; i < 4; ++i) {
    arena += DriverXml("foot-bot", "r" + std::to_string(i), -0.75 + 0.5 * i, 0.28, 90.0 * i, 10,
                       8.0 + i);
  }
  CDriveWorld world(engine.ToXml(), arena);
  SOverlaps overlaps;
  for (int tick = 0; tick < 600; ++tick) {
    world.Step();
    MeasureOverlaps(world.GetSpace(), overlaps);
    for (int i = 0; i < 12; ++i) {
      const CVector3 position = world.Position("o" + std::to_string(i));
      REQUIRE(IsFinite(position));
      // half of the narrowest side keeps every centre this far from the walls
      REQUIRE(std::max(std::abs(position.GetX()), std::abs(position.GetY())) < 1.0 - 0.06 * 0.98);
    }
  }
  CHECK(SOverlaps::Quantile(overlaps.WithRobots, 0.99) <= 0.02);
  // a robot that pushes an object against others leans on it: in 4 of 32 runs of dynamics3d with
  // other places, it did so by up to 6 % for some ticks
  CHECK(SOverlaps::Quantile(overlaps.WithRobots, 1.0) <= (engine.HasSlopes ? 0.08 : 0.02));
}

TEST_CASE("speed: a robot does not pass through a thin wall at any speed", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  const Real speed = GENERATE(50.0, 500.0, 5000.0);  // cm/s
  const std::string iterations = GENERATE(as<std::string>(), "", "iterations='1'");
  CAPTURE(speed, iterations);
  // unless something held it down
  const bool overturns = engine.HasSlopes && speed > 1000.0;
  CDriveWorld world(
      engine.ToXml("e", iterations),
      // so long that a robot with spinning wheels does not slide around its end
      WallXml("wall", "0.01,16,0.5", 3.0, 0) + DriverXml("foot-bot", "r", 0, 0.3, 0, speed, speed));
  for (int tick = 0; tick < 100; ++tick) {
    world.Step();
    REQUIRE(world.Position("r").GetX() < 2.995);
    if (overturns) {
      continue;
    }
    // the bounding box includes the tilt
    const Real front = world.Body("r").GetBoundingBox().MaxCorner.GetX();
    REQUIRE(front <= 2.995 + 0.02 * kFootBotRadius + engine.Slack);
  }
  if (!overturns) {
    CHECK_THAT(world.Position("r").GetX() + kFootBotRadius,
               WithinAbs(2.995, 0.02 * kFootBotRadius));
  }
}

}  // namespace argos::physics_engines_crowd_test
