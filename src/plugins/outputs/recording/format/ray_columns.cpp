#include <argos3/plugins/simulator/outputs/recording/format/ray_columns.h>

#include <argos3/core/utility/errors/argos_exception.h>

namespace argos {

namespace {

constexpr size_t kMaxRays = size_t(1) << 22;

void Append(const CVector3& vector, EPrecision precision, std::vector<SInt64>& values) {
  values.push_back(ToRecorded(vector.GetX(), precision));
  values.push_back(ToRecorded(vector.GetY(), precision));
  values.push_back(ToRecorded(vector.GetZ(), precision));
}

CVector3 MakeVector(const SInt64* values, EPrecision precision) {
  return CVector3(FromRecorded(values[0], precision), FromRecorded(values[1], precision),
                  FromRecorded(values[2], precision));
}

}  // namespace

void CRayColumns::Restart() {
  m_ends.Restart(0);
  m_points.Restart(0);
}

// if there are equally many, each is probably the same as in the last frame
void CRayColumns::Resize(CPredictedColumn& column, size_t size) {
  if (column.GetSize() != size) {
    column.Restart(size);
  }
}

void CRayColumns::Encode(const std::vector<SRecordedRay>& rays, CByteWriter& out) {
  out.WriteNumber(rays.size());
  CSparseWriter sparse(out);
  UInt32 robot = 0;
  m_endValues.clear();
  m_pointValues.clear();
  for (const SRecordedRay& ray : rays) {
    sparse.Write(UInt64(ray.Robot - robot) << 2 | static_cast<UInt64>(ray.Kind));
    robot = ray.Robot;
    if (ray.Kind == SRecordedRay::EKind::HitPoint) {
      Append(ray.Start, m_precision, m_pointValues);
    } else {
      Append(ray.Start, m_precision, m_endValues);
      Append(ray.End, m_precision, m_endValues);
    }
  }
  sparse.Flush();
  Resize(m_ends, m_endValues.size());
  m_ends.Encode(m_endValues, out);
  Resize(m_points, m_pointValues.size());
  m_points.Encode(m_pointValues, out);
}

void CRayColumns::Decode(std::vector<SRecordedRay>& rays, size_t numEntities, CByteReader& in) {
  rays.clear();
  rays.resize(in.ReadNumberUpTo(kMaxRays, "number of rays"));
  CSparseReader sparse(in);
  UInt64 robot = 0;
  size_t points = 0;
  for (SRecordedRay& ray : rays) {
    const UInt64 code = sparse.Read();
    robot += code >> 2;
    if (robot >= numEntities || (code & 3) > 2) {
      THROW_ARGOSEXCEPTION("it has a ray of a kind, or of an entity, that does not exist");
    }
    ray.Robot = static_cast<UInt32>(robot);
    ray.Kind = static_cast<SRecordedRay::EKind>(code & 3);
    points += ray.Kind == SRecordedRay::EKind::HitPoint ? 1 : 0;
  }
  m_endValues.resize(6 * (rays.size() - points));
  Resize(m_ends, m_endValues.size());
  m_ends.Decode(m_endValues, in);
  m_pointValues.resize(3 * points);
  Resize(m_points, m_pointValues.size());
  m_points.Decode(m_pointValues, in);
  const SInt64* end = m_endValues.data();
  const SInt64* point = m_pointValues.data();
  for (SRecordedRay& ray : rays) {
    if (ray.Kind == SRecordedRay::EKind::HitPoint) {
      ray.Start = ray.End = MakeVector(point, m_precision);
      point += 3;
    } else {
      ray.Start = MakeVector(end, m_precision);
      ray.End = MakeVector(end + 3, m_precision);
      end += 6;
    }
  }
}

}  // namespace argos
