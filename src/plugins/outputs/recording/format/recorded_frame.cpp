#include <argos3/plugins/simulator/outputs/recording/format/recorded_frame.h>

namespace argos {

void SFrameUpdate::Clear() {
  IsRestart = false;
  NewTypes.clear();
  Removed.clear();
  Added.clear();
  Poses.clear();
  Words.clear();
  Rays.clear();
  Floor.reset();
  Columns.clear();
  Metrics.clear();
  Commands.clear();
  Drawing.clear();
}

size_t SFrameUpdate::ComputeSize() const {
  size_t size = sizeof(*this) + Poses.capacity() * sizeof(SBodyPose) +
                Words.capacity() * sizeof(UInt32) + Rays.capacity() * sizeof(SRecordedRay) +
                Added.capacity() * sizeof(SRecordedEntity) + Drawing.capacity() +
                (Floor != nullptr ? Floor->Pixels.size() : 0);
  for (const SRecordedColumn& column : Columns) {
    size += column.Values.capacity() * sizeof(Real) + column.Texts.capacity() * sizeof(std::string);
  }
  return size;
}

}  // namespace argos
