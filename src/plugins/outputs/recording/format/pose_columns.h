#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_POSE_COLUMNS_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_POSE_COLUMNS_H

#include <argos3/core/simulator/geometry/body_pose.h>
#include <argos3/plugins/simulator/outputs/recording/format/column_coding.h>

#include <array>
#include <span>
#include <vector>

namespace argos {

/** How exactly a recording keeps poses and rays. */
enum class EPrecision : UInt8 {
  Grid, /**< rounded to kPoseGrid, as views draw them */
  Exact /**< all bits of each number */
};

/** A number as the whole number that is recorded. NaN and infinity on the grid become NaN. */
SInt64 ToRecorded(Real value, EPrecision precision);
/** Its inverse. */
Real FromRecorded(SInt64 value, EPrecision precision);

/** The poses of all entities in time: a column for each of the seven numbers of a pose. */
class CPoseColumns {
 public:
  explicit CPoseColumns(EPrecision precision) : m_precision(precision) {}

  void Restart(size_t size);
  void Append(size_t count);
  /** @param isRemoved  by place. */
  void Remove(const std::vector<bool>& isRemoved);

  /** @param poses  as many as there are. */
  void Encode(std::span<const SBodyPose> poses, CByteWriter& out);
  /** @throws CARGoSException */
  void Decode(std::span<SBodyPose> poses, CByteReader& in);

 private:
  static constexpr size_t kNumbers = 7;  // position, then w, x, y, z of the orientation

  EPrecision m_precision;
  std::array<CPredictedColumn, kNumbers> m_columns;
  std::vector<SInt64> m_values;  // values of one column
  std::vector<Real> m_numbers;  // (poses, kNumbers)
};

}  // namespace argos

#endif
