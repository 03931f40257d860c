#include <argos3/plugins/simulator/outputs/recording/format/pose_columns.h>

#include <argos3/core/simulator/geometry/pose_grid.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <bit>
#include <limits>

namespace argos {

namespace {

// no number on the grid has this value
constexpr SInt64 kNoNumber = SInt64(1) << 62;

// adding it moves the whole part of a number below 2^51 to the low bits, rounded to the nearest
constexpr double kRounder = 0x1.8p52;

// negative numbers descend in their bits; turned round, neighbours differ by one everywhere
SInt64 TurnNegative(SInt64 bits) {
  return bits < 0 ? bits ^ std::numeric_limits<SInt64>::max() : bits;
}

}  // namespace

SInt64 ToRecorded(Real value, EPrecision precision) {
  if (precision == EPrecision::Exact) {
    return TurnNegative(std::bit_cast<SInt64>(value));
  }
  const Real units = value / kPoseGrid;
  if (!(std::abs(units) < kMaxOnPoseGrid)) {
    return kNoNumber;
  }
  return std::bit_cast<SInt64>(units + kRounder) - std::bit_cast<SInt64>(kRounder);
}

Real FromRecorded(SInt64 value, EPrecision precision) {
  if (precision == EPrecision::Exact) {
    return std::bit_cast<Real>(TurnNegative(value));
  }
  return value == kNoNumber ? std::numeric_limits<Real>::quiet_NaN()
                            : static_cast<Real>(value) * kPoseGrid;
}

void CPoseColumns::Restart(size_t size) {
  for (CPredictedColumn& column : m_columns) {
    column.Restart(size);
  }
}

void CPoseColumns::Append(size_t count) {
  for (CPredictedColumn& column : m_columns) {
    column.Append(count);
  }
}

void CPoseColumns::Remove(const std::vector<bool>& isRemoved) {
  for (CPredictedColumn& column : m_columns) {
    column.Remove(isRemoved);
  }
}

void CPoseColumns::Encode(std::span<const SBodyPose> poses, CByteWriter& out) {
  m_values.resize(poses.size());
  const auto encode = [&](size_t number, auto&& get) {
    for (size_t i = 0; i < poses.size(); ++i) {
      m_values[i] = ToRecorded(get(poses[i]), m_precision);
    }
    ARGOS_ASSERT(number < kNumbers, "a pose has no number " << number);
    m_columns[number].Encode(m_values, out);
  };
  encode(0, [](const SBodyPose& pose) { return pose.Position.GetX(); });
  encode(1, [](const SBodyPose& pose) { return pose.Position.GetY(); });
  encode(2, [](const SBodyPose& pose) { return pose.Position.GetZ(); });
  encode(3, [](const SBodyPose& pose) { return pose.Orientation.GetW(); });
  encode(4, [](const SBodyPose& pose) { return pose.Orientation.GetX(); });
  encode(5, [](const SBodyPose& pose) { return pose.Orientation.GetY(); });
  encode(6, [](const SBodyPose& pose) { return pose.Orientation.GetZ(); });
}

void CPoseColumns::Decode(std::span<SBodyPose> poses, CByteReader& in) {
  m_values.resize(poses.size());
  m_numbers.resize(poses.size() * kNumbers);
  for (size_t number = 0; number < kNumbers; ++number) {
    m_columns[number].Decode(m_values, in);
    for (size_t i = 0; i < poses.size(); ++i) {
      m_numbers[i * kNumbers + number] = FromRecorded(m_values[i], m_precision);
    }
  }
  for (size_t i = 0; i < poses.size(); ++i) {
    const Real* const pose = &m_numbers[i * kNumbers];
    poses[i].Position = CVector3(pose[0], pose[1], pose[2]);
    poses[i].Orientation = CQuaternion(pose[3], pose[4], pose[5], pose[6]);
  }
}

}  // namespace argos
