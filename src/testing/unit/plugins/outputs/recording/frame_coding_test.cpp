#include <argos3/core/simulator/geometry/pose_grid.h>
#include <argos3/plugins/simulator/outputs/recording/format/frame_coding.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace frame_coding_test {

using namespace argos;

namespace {

SRecordedType MakeRobotType(UInt32 leds) {
  SRecordedType type;
  type.Kind = SRecordedType::EKind::Body;
  type.Tag = "foot-bot";
  type.IsRobot = type.IsMovable = type.HasAppearance = true;
  type.NumLEDs = leds;
  type.Box.MaxCorner = CVector3(0.085, 0.085, 0.146);
  SVisualPart part;
  part.Kind = SVisualPart::EKind::Cylinder;
  part.Anchor = "turret";
  part.Color = CColor(1, 2, 3, 4);
  part.Material = EMaterial::Metal;
  type.Appearance.Parts.push_back(part);
  type.Anchors = {"turret"};
  return type;
}

SBodyPose MakePose(Real x, Real y, Real angle) {
  return {CVector3(x, y, 0.0), CQuaternion(std::cos(angle / 2), 0.0, 0.0, std::sin(angle / 2))};
}

bool HasSameBits(Real a, Real b) {
  return std::bit_cast<UInt64>(a) == std::bit_cast<UInt64>(b);
}

// one robot with an anchor and two LEDs at each of several places
SFrameUpdate MakeUpdate(UInt32 tick, const std::vector<Real>& places) {
  SFrameUpdate update;
  update.Tick = tick;
  for (const Real place : places) {
    update.Poses.push_back(MakePose(place, 2.0 * place, place));
    update.Poses.push_back(MakePose(place, 2.0 * place, -place));
    update.Words.insert(update.Words.end(), {0, 0xff0000ffu, tick});
  }
  return update;
}

SFrameUpdate MakeFirst(UInt32 tick, const std::vector<Real>& places) {
  SFrameUpdate update = MakeUpdate(tick, places);
  update.IsRestart = true;
  update.NewTypes.push_back(MakeRobotType(2));
  for (size_t i = 0; i < places.size(); ++i) {
    update.Added.push_back({"fb" + std::to_string(i), 0});
  }
  return update;
}

}  // namespace

TEST_CASE("pose grid: rounds to the nearest multiple of 2^-20, and a multiple to itself",
          "[core][recording]") {
  const Real grid = 1.0 / 1048576.0;
  const Real value = GENERATE(0.0, 1.0, -2.5, 123.456, -1e-7, 4e6);
  CAPTURE(value);
  const Real snapped = SnapToPoseGrid(value);
  CHECK(std::abs(snapped - value) <= grid / 2);
  CHECK(snapped / grid == std::round(snapped / grid));
  CHECK(HasSameBits(SnapToPoseGrid(snapped), snapped));
  // what is recorded is what is drawn
  CHECK(HasSameBits(FromRecorded(ToRecorded(value, EPrecision::Grid), EPrecision::Grid), snapped));
}

TEST_CASE("pose grid: what is no number is recorded as such", "[core][recording]") {
  const Real value = GENERATE(std::numeric_limits<Real>::quiet_NaN(),
                              std::numeric_limits<Real>::infinity(), -1e300);
  CHECK(std::isnan(FromRecorded(ToRecorded(value, EPrecision::Grid), EPrecision::Grid)));
}

TEST_CASE("exact precision: all bits of a number are kept", "[core][recording]") {
  const Real value =
      GENERATE(0.0, -0.0, 1.0, -1.0 / 3.0, 1e-310, 1e308, std::numeric_limits<Real>::infinity());
  CHECK(HasSameBits(FromRecorded(ToRecorded(value, EPrecision::Exact), EPrecision::Exact), value));
}

TEST_CASE("predicted column: any numbers are decoded as they were", "[core][recording]") {
  std::mt19937_64 random(1);
  std::string bytes;
  CByteWriter out(bytes);
  CPredictedColumn encoder;
  std::vector<std::vector<SInt64>> frames;
  encoder.Restart(5);
  for (int frame = 0; frame < 20; ++frame) {
    std::vector<SInt64> values(5);
    for (SInt64& value : values) {
      // of all sizes, also those at the limits of the type
      value = static_cast<SInt64>(random() >> (random() % 64));
      value = random() % 2 == 0 ? value : -value;
    }
    values[0] =
        frame % 2 == 0 ? std::numeric_limits<SInt64>::min() : std::numeric_limits<SInt64>::max();
    frames.push_back(values);
    encoder.Encode(values, out);
  }
  CPredictedColumn decoder;
  decoder.Restart(5);
  CByteReader in(bytes);
  for (const std::vector<SInt64>& expected : frames) {
    std::vector<SInt64> values(5);
    decoder.Decode(values, in);
    CHECK(values == expected);
  }
  CHECK(in.IsAtEnd());
}

TEST_CASE("predicted column: steady motion and rest take three bytes for all",
          "[core][recording]") {
  std::vector<SInt64> values(1000);
  CPredictedColumn column;
  column.Restart(values.size());
  std::string bytes;
  for (SInt64 tick = 0; tick < 4; ++tick) {
    for (size_t i = 0; i < values.size(); ++i) {
      values[i] = static_cast<SInt64>(i) * tick;
    }
    bytes.clear();
    CByteWriter out(bytes);
    column.Encode(values, out);
  }
  // a zero, and in two bytes of 7 bits that 999 others follow
  CHECK(bytes.size() == 3);
}

TEST_CASE("frames: poses, colours and ticks are decoded as they were", "[core][recording]") {
  const EPrecision precision = GENERATE(EPrecision::Grid, EPrecision::Exact);
  CFrameEncoder encoder(precision);
  std::string bytes;
  std::vector<SFrameUpdate> expected;
  for (UInt32 tick = 3; tick < 40; tick += 3) {
    const std::vector<Real> places = {0.1 * tick, -0.01 * tick * tick};
    SFrameUpdate update = tick == 3 ? MakeFirst(tick, places) : MakeUpdate(tick, places);
    expected.push_back(update);
    encoder.Encode(update, tick == 3 || tick == 21, bytes);
  }
  CFrameDecoder decoder(precision);
  CByteReader in(bytes);
  for (const SFrameUpdate& update : expected) {
    const SRecordedFrame& frame = decoder.Decode(in, update.Tick == 3 || update.Tick == 21);
    CHECK(frame.Tick == update.Tick);
    CHECK(frame.Words == update.Words);
    REQUIRE(frame.Poses.size() == update.Poses.size());
    for (size_t i = 0; i < frame.Poses.size(); ++i) {
      const SBodyPose pose =
          precision == EPrecision::Grid ? SnapToPoseGrid(update.Poses[i]) : update.Poses[i];
      CHECK(HasSameBits(frame.Poses[i].Position.GetX(), pose.Position.GetX()));
      CHECK(HasSameBits(frame.Poses[i].Position.GetY(), pose.Position.GetY()));
      CHECK(HasSameBits(frame.Poses[i].Orientation.GetW(), pose.Orientation.GetW()));
      CHECK(HasSameBits(frame.Poses[i].Orientation.GetZ(), pose.Orientation.GetZ()));
    }
    REQUIRE(frame.Types.size() == 1);
    CHECK(frame.Types[0].Tag == "foot-bot");
    CHECK(frame.Types[0].Anchors == std::vector<std::string>{"turret"});
    CHECK(frame.Types[0].Appearance.Parts[0].Color == CColor(1, 2, 3, 4));
    CHECK(frame.Types[0].Appearance.Parts[0].Material == EMaterial::Metal);
    CHECK(frame.Types[0].Box.MaxCorner == CVector3(0.085, 0.085, 0.146));
  }
  CHECK(in.IsAtEnd());
}

TEST_CASE("frames: what is known of a type is decoded as it was", "[core][recording]") {
  const UInt32 flags = GENERATE(range(0U, 16U));
  CAPTURE(flags);
  SFrameUpdate update = MakeFirst(1, {0.0});
  SRecordedType& type = update.NewTypes.front();
  type.IsRobot = (flags & 1U) != 0;
  type.IsMovable = (flags & 2U) != 0;
  type.Flies = (flags & 4U) != 0;
  type.HasAppearance = (flags & 8U) != 0;
  CFrameEncoder encoder(EPrecision::Exact);
  std::string bytes;
  encoder.Encode(update, true, bytes);
  CFrameDecoder decoder(EPrecision::Exact);
  CByteReader in(bytes);
  const SRecordedType& decoded = decoder.Decode(in, true).Types.front();
  CHECK(decoded.IsRobot == type.IsRobot);
  CHECK(decoded.IsMovable == type.IsMovable);
  CHECK(decoded.Flies == type.Flies);
  CHECK(decoded.HasAppearance == type.HasAppearance);
}

TEST_CASE("frames: entities come and go", "[core][recording]") {
  CFrameEncoder encoder(EPrecision::Exact);
  std::string bytes;
  SFrameUpdate first = MakeFirst(0, {1.0, 2.0, 3.0});
  encoder.Encode(first, true, bytes);
  // the second and the first leave, another type of entities comes
  SFrameUpdate second = MakeUpdate(1, {3.5});
  second.Removed = {0, 1};
  SRecordedType box;
  box.Kind = SRecordedType::EKind::Body;
  box.Tag = "box";
  second.NewTypes.push_back(box);
  second.Added.push_back({"box", 1});
  second.Poses.push_back(MakePose(9.0, 9.0, 0.0));
  second.Words.push_back(7);
  encoder.Encode(second, false, bytes);

  CFrameDecoder decoder(EPrecision::Exact);
  CByteReader in(bytes);
  const UInt64 version = decoder.Decode(in, true).EntitiesVersion;
  const SRecordedFrame& frame = decoder.Decode(in, false);
  CHECK(frame.EntitiesVersion != version);
  REQUIRE(frame.Entities.size() == 2);
  CHECK(frame.Entities[0].Id == "fb2");
  CHECK(frame.Entities[1].Id == "box");
  REQUIRE(frame.Poses.size() == 3);
  CHECK(frame.Poses[0].Position == CVector3(3.5, 7.0, 0.0));
  CHECK(frame.Poses[2].Position == CVector3(9.0, 9.0, 0.0));
  CHECK(frame.Words == std::vector<UInt32>{0, 0xff0000ffu, 1, 7});
}

TEST_CASE("frames: a restart without a complete frame forgets the entities before it",
          "[core][recording]") {
  CFrameEncoder encoder(EPrecision::Exact);
  std::string bytes;
  std::vector<SFrameUpdate> expected = {MakeFirst(0, {1.0, 2.0, 3.0}), MakeFirst(1, {4.0, 5.0}),
                                        MakeUpdate(2, {4.5, 5.5, 6.0}),
                                        MakeUpdate(3, {5.0, 6.0, 7.0}), MakeUpdate(4, {7.5, 9.0})};
  expected[2].Added.push_back({"added", 0});
  expected[4].Removed = {0};
  for (SFrameUpdate& update : expected) {
    SFrameUpdate given = update;
    encoder.Encode(given, update.Tick == 0, bytes);
  }
  CFrameDecoder decoder(EPrecision::Exact);
  CByteReader in(bytes);
  for (const SFrameUpdate& update : expected) {
    CAPTURE(update.Tick);
    const SRecordedFrame& frame = decoder.Decode(in, update.Tick == 0);
    CHECK(frame.Words == update.Words);
    REQUIRE(frame.Poses.size() == update.Poses.size());
    for (size_t i = 0; i < frame.Poses.size(); ++i) {
      CHECK(frame.Poses[i].Position == update.Poses[i].Position);
    }
  }
}

TEST_CASE("frames: rays, floor, columns and drawings are decoded as they were",
          "[core][recording]") {
  auto floor = std::make_shared<SRecordedFloor>(SRecordedFloor{2, 2, std::string(12, 'a')});
  auto painted = std::make_shared<SRecordedFloor>(*floor);
  painted->Pixels[7] = 'b';
  CFrameEncoder encoder(EPrecision::Grid);
  std::string bytes;
  SFrameUpdate first = MakeFirst(0, {1.0});
  first.Floor = floor;
  encoder.Encode(first, true, bytes);
  SFrameUpdate second = MakeUpdate(1, {1.0});
  second.Floor = painted;
  using EKind = SRecordedRay::EKind;
  second.Rays = {{0, EKind::Obstructed, CVector3(1, 2, 3), CVector3(4, 5, 6)},
                 {0, EKind::HitPoint, CVector3(7, 8, 9), CVector3(7, 8, 9)}};
  second.Columns = {{"battery", "battery_charge", "J", false, {0.75}, {}},
                    {"lua:state", "lua_state", "", true, {1.0}, {"walk", "rest"}}};
  second.Metrics = {{"food", "", 3.0}, {"spread", "m", 0.5}};
  second.Commands = {{1, "{\"do\":\"move\"}"}, {1, ""}};
  second.Drawing = "shapes";
  encoder.Encode(second, false, bytes);

  CFrameDecoder decoder(EPrecision::Grid);
  CByteReader in(bytes);
  decoder.SetFloor(floor);
  CHECK(decoder.Decode(in, true).Rays.empty());
  const SRecordedFrame& frame = decoder.Decode(in, false);
  REQUIRE(frame.Floor != nullptr);
  CHECK(*frame.Floor == *painted);
  REQUIRE(frame.Rays.size() == 2);
  CHECK(frame.Rays[0].Kind == EKind::Obstructed);
  CHECK(frame.Rays[0].End == CVector3(4, 5, 6));
  CHECK(frame.Rays[1].Kind == EKind::HitPoint);
  CHECK(frame.Rays[1].Start == CVector3(7, 8, 9));
  REQUIRE(frame.Columns.size() == 2);
  CHECK(frame.Columns[0].Field == "battery");
  CHECK(frame.Columns[0].Name == "battery_charge");
  CHECK(frame.Columns[0].Unit == "J");
  CHECK_FALSE(frame.Columns[0].IsText);
  CHECK(frame.Columns[0].Values == std::vector<Real>{0.75});
  CHECK(frame.Columns[1].Field == "lua:state");
  CHECK(frame.Columns[1].IsText);
  CHECK(frame.Columns[1].Values == std::vector<Real>{1.0});
  CHECK(frame.Columns[1].Texts == std::vector<std::string>{"walk", "rest"});
  CHECK(frame.Metrics == second.Metrics);
  CHECK(frame.Commands == second.Commands);
  CHECK(frame.Drawing == "shapes");
}

TEST_CASE("frames: cut and changed bytes give exceptions or frames, nothing else",
          "[core][recording]") {
  CFrameEncoder encoder(EPrecision::Grid);
  std::string bytes;
  SFrameUpdate first = MakeFirst(0, {1.0, 2.0});
  encoder.Encode(first, true, bytes);
  for (size_t size = 0; size < bytes.size(); ++size) {
    CFrameDecoder decoder(EPrecision::Grid);
    CByteReader in(std::string_view(bytes).substr(0, size));
    CHECK_THROWS_AS(decoder.Decode(in, true), CARGoSException);
  }
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i) {
    std::string changed = bytes;
    changed[random() % changed.size()] = static_cast<char>(random());
    CFrameDecoder decoder(EPrecision::Grid);
    CByteReader in(changed);
    try {
      decoder.Decode(in, true);
    } catch (const CARGoSException&) {
      continue;
    }
  }
}

}  // namespace frame_coding_test
