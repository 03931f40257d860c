#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_RAY_COLUMNS_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_RAY_COLUMNS_H

#include <argos3/plugins/simulator/outputs/recording/format/pose_columns.h>
#include <argos3/plugins/simulator/outputs/recording/format/recorded_frame.h>

#include <vector>

namespace argos {

/** The rays of sensors in time. Rays and points are apart, because points come and go. */
class CRayColumns {
 public:
  explicit CRayColumns(EPrecision precision) : m_precision(precision) {}

  void Restart();
  void Encode(const std::vector<SRecordedRay>& rays, CByteWriter& out);
  /** @param numEntities  of the table. @throws CARGoSException */
  void Decode(std::vector<SRecordedRay>& rays, size_t numEntities, CByteReader& in);

 private:
  static void Resize(CPredictedColumn& column, size_t size);

  EPrecision m_precision;
  CPredictedColumn m_ends;  // (rays, start and end)
  CPredictedColumn m_points;  // (points)
  std::vector<SInt64> m_endValues;
  std::vector<SInt64> m_pointValues;
};

}  // namespace argos

#endif
