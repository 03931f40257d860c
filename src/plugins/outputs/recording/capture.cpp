#include <argos3/plugins/simulator/outputs/recording/capture.h>

#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/floor_samples.h>
#include <argos3/plugins/simulator/outputs/recording/format/type_coding.h>

namespace argos {

namespace {

// prefetched entities; their data is scattered in memory
constexpr UInt32 kAhead = 8;

}  // namespace

void CCapture::Restart() {
  m_entities.clear();
  m_types.clear();
  m_isRestart = true;
  m_floor.reset();
  m_floorEntity = nullptr;
}

void CCapture::Take(CSpace& space, SFrameUpdate& update) {
  update.Tick = space.GetSimulationClock();
  update.IsRestart = m_isRestart;
  m_isRestart = false;
  TakeEntities(space, update);
  UInt32 number = 0;
  for (const CTrackedEntity& entity : m_entities) {
    if (number + 2 * kAhead < m_entities.size()) {
      m_entities[number + 2 * kAhead].PrepareRead();
      m_entities[number + kAhead].PrepareColors();
    }
    entity.AppendPoses(update.Poses);
    entity.AppendWords(update.Words);
    entity.AppendRays(number++, update.Rays);
  }
  TakeFloor(space, update);
}

bool CCapture::RemoveGone(CSpace& space, SFrameUpdate& update) {
  const std::vector<CEntity*>& roots = space.GetRootEntityVector();
  size_t kept = 0;
  bool hasNewParts = false;
  for (size_t i = 0; i < m_entities.size(); ++i) {
    if (i + kAhead < m_entities.size()) {
      m_entities[i + kAhead].PrepareCheck();
    }
    if (kept < roots.size() && m_entities[i].Is(*roots[kept])) {
      if (kept != i) {
        m_entities[kept] = std::move(m_entities[i]);
      }
      hasNewParts = hasNewParts || m_entities[kept].HasNewParts();
      ++kept;
    } else {
      update.Removed.push_back(static_cast<UInt32>(i));
    }
  }
  m_entities.erase(m_entities.begin() + static_cast<std::ptrdiff_t>(kept), m_entities.end());
  return hasNewParts;
}

void CCapture::TakeEntities(CSpace& space, SFrameUpdate& update) {
  if (RemoveGone(space, update)) {
    Restart();
    m_isRestart = false;
    update.Removed.clear();
    update.IsRestart = true;
  }
  const std::vector<CEntity*>& roots = space.GetRootEntityVector();
  m_entities.reserve(roots.size());
  for (size_t i = m_entities.size(); i < roots.size(); ++i) {
    CTrackedEntity entity(*roots[i]);
    const bool isLikeLast = i > 0 && entity.IsLike(m_entities.back());
    entity.SetType(isLikeLast ? m_entities.back().GetType() : FindType(entity, update));
    update.Added.push_back({roots[i]->GetId(), entity.GetType()});
    m_entities.push_back(std::move(entity));
  }
}

UInt32 CCapture::FindType(const CTrackedEntity& entity, SFrameUpdate& update) {
  SRecordedType type = entity.MakeType();
  std::string bytes;
  CByteWriter out(bytes);
  WriteType(type, out);
  WriteSolids(type, out);
  const auto [found, isNew] = m_types.try_emplace(bytes, static_cast<UInt32>(m_types.size()));
  if (isNew) {
    update.NewTypes.push_back(std::move(type));
  }
  return found->second;
}

void CCapture::TakeFloor(CSpace& space, SFrameUpdate& update) {
  if (!space.HasFloorEntity()) {
    m_floor.reset();
    m_floorEntity = nullptr;
    return;
  }
  CFloorEntity& floor = space.GetFloorEntity();
  if (m_floorEntity != &floor || m_floorVersion != floor.GetVersion()) {
    auto now = ReadFloor(space, floor);
    if (m_floor == nullptr || *m_floor != *now) {
      m_floor = std::move(now);
    }
    m_floorEntity = &floor;
    m_floorVersion = floor.GetVersion();
  }
  update.Floor = m_floor;
}

std::shared_ptr<const SRecordedFloor> CCapture::ReadFloor(CSpace& space,
                                                          CFloorEntity& floor) const {
  const SFloorSamples samples = SampleFloor(floor, space.GetArenaCenter(), space.GetArenaSize());
  auto image = std::make_shared<SRecordedFloor>();
  image->Width = static_cast<UInt32>(samples.Width);
  image->Height = static_cast<UInt32>(samples.Height);
  image->Pixels.reserve(size_t(3) * image->Width * image->Height);
  for (size_t i = 0; i < samples.Pixels.size(); i += 4) {
    for (size_t color = 0; color < 3; ++color) {
      image->Pixels.push_back(static_cast<char>(samples.Pixels[i + color]));
    }
  }
  return image;
}

void TakeMetrics(CSpace& space, SFrameUpdate& update) {
  update.Metrics.clear();
  for (const CMetrics::SMetric& metric : space.GetExtension<CMetrics>().GetAll()) {
    update.Metrics.push_back({metric.Name, metric.Unit, metric.Value});
  }
}

}  // namespace argos
