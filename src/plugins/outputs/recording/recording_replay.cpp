#include <argos3/plugins/simulator/outputs/recording/recording_replay.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/plugins/simulator/outputs/recording/format/drawing_coding.h>
#include <argos3/plugins/simulator/outputs/recording/format/type_coding.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

/* Colours the floor, and draws, as it was recorded. */
class CReplayLoopFunctions : public CLoopFunctions {
 public:
  explicit CReplayLoopFunctions(const CRecordingReplay& replay) : m_replay(replay) {}

  CColor GetFloorColor(const CVector2& positionOnFloor) override {
    const SRecordedFloor* const floor = m_replay.GetFloor();
    if (floor == nullptr || floor->Pixels.empty()) {
      return CColor::WHITE;
    }
    const CVector3& size = GetSpace().GetArenaSize();
    const CVector3 corner = GetSpace().GetArenaCenter() - size * 0.5;
    const size_t column =
        ToPixel((positionOnFloor.GetX() - corner.GetX()) / size.GetX(), floor->Width);
    const size_t row =
        ToPixel((positionOnFloor.GetY() - corner.GetY()) / size.GetY(), floor->Height);
    const char* const pixel = &floor->Pixels[3 * (row * floor->Width + column)];
    return CColor(static_cast<UInt8>(pixel[0]), static_cast<UInt8>(pixel[1]),
                  static_cast<UInt8>(pixel[2]));
  }

  void DrawInWorld(CDrawing& drawing) override { Draw(SDrawnShape::ESpace::World, drawing); }
  void DrawInOverlay(CDrawing& drawing) override { Draw(SDrawnShape::ESpace::Overlay, drawing); }

 private:
  void Draw(SDrawnShape::ESpace space, CDrawing& drawing) const {
    if (!m_replay.GetDrawing().empty()) {
      CByteReader in(m_replay.GetDrawing());
      DrawAgain(in, space, drawing);
    }
  }

  // colours continue beyond the edges; NaN gives the first pixel
  static size_t ToPixel(Real share, UInt32 pixels) {
    const Real pixel = share * pixels;
    return pixel > 0.0 ? static_cast<size_t>(std::min<Real>(pixel, pixels - 1)) : 0;
  }

  const CRecordingReplay& m_replay;
};

UInt32 ToTick(const SReplayTime& time, Real tickLength) {
  constexpr Real kTolerance = 1e-6;  // ticks: of a division that should give a whole number
  const Real tick = time.IsInSeconds ? std::ceil(time.Value / tickLength - kTolerance) : time.Value;
  return static_cast<UInt32>(std::clamp<Real>(tick, 0.0, ~UInt32(0)));
}

}  // namespace

CRecordingReplay::CRecordingReplay() = default;
CRecordingReplay::~CRecordingReplay() = default;

void CRecordingReplay::Open(const SReplayRequest& request) {
  m_reader = std::make_unique<CRecordingReader>(request.File);
  if (!m_reader->GetWarning().empty()) {
    LOGERR << "[WARNING] " << m_reader->GetWarning() << std::endl;
  }
  const SRecordingInfo& info = m_reader->GetInfo();
  m_experimentFile = info.ExperimentFile;
  m_every = std::max<UInt32>(request.Every, 1);
  SelectPart(request);
  LOG << "[INFO] Replaying ticks " << m_firstTick << " to " << m_lastTick << " of \""
      << request.File << "\", recorded " << info.Date << " by argos3 " << info.Version << " from \""
      << info.ExperimentFile << "\" with random seed " << info.Seed << std::endl;
  for (const auto& [path, value] : info.Overrides) {
    LOG << "[INFO] The run was set to " << path << "=" << value << std::endl;
  }
}

void CRecordingReplay::SelectPart(const SReplayRequest& request) {
  const SRecordingInfo& info = m_reader->GetInfo();
  const UInt32 first = m_reader->GetFirstTick();
  const UInt32 last = m_reader->GetLastTick();
  const UInt32 from = request.From ? ToTick(*request.From, info.TickLength) : first;
  const UInt32 to = request.To ? ToTick(*request.To, info.TickLength) : last;
  if (from > last || to < first || from > to) {
    THROW_ARGOSEXCEPTION("the recording \""
                         << request.File << "\" has no state from tick " << from << " to tick "
                         << to << ": it has ticks " << first << " to " << last << ", that is "
                         << first * info.TickLength << " s to " << last * info.TickLength << " s");
  }
  m_lastTick = m_reader->FindLastTickUpTo(to);
  m_firstTick = from;
  if (m_lastTick < from) {
    THROW_ARGOSEXCEPTION("the recording \"" << request.File << "\" has no state from tick " << from
                                            << " to tick " << to << ": it has one every "
                                            << m_reader->GetInfo().Every << " ticks");
  }
}

UInt32 CRecordingReplay::ReadSeed(const std::string& file) const {
  return CRecordingReader(file).GetInfo().Seed;
}

std::vector<SRecordedPose> CRecordingReplay::ReadPoses(const std::string& file,
                                                       const std::optional<SReplayTime>& at) const {
  CRecordingReader reader(file);
  const Real tickLength = reader.GetInfo().TickLength;
  const UInt32 tick = at ? ToTick(*at, tickLength) : reader.GetLastTick();
  if (tick < reader.GetFirstTick() || tick > reader.GetLastTick()) {
    THROW_ARGOSEXCEPTION("the recording \"" << file << "\" has no state at tick " << tick
                                            << ": it has ticks " << reader.GetFirstTick() << " to "
                                            << reader.GetLastTick() << ", that is "
                                            << reader.GetFirstTick() * tickLength << " s to "
                                            << reader.GetLastTick() * tickLength << " s");
  }
  const UInt32 state = reader.FindLastTickUpTo(tick);
  reader.Seek(state);
  const SRecordedFrame* frame = reader.ReadNext();
  // blocks begin earlier
  while (frame != nullptr && frame->Tick < state) {
    frame = reader.ReadNext();
  }
  std::vector<SRecordedPose> poses;
  if (frame == nullptr) {
    return poses;
  }
  size_t place = 0;
  for (const SRecordedEntity& entity : frame->Entities) {
    const size_t numPoses = frame->Types[entity.Type].GetNumPoses();
    if (numPoses > 0) {
      poses.push_back({entity.Id, frame->Poses[place]});
    }
    place += numPoses;
  }
  return poses;
}

const std::string& CRecordingReplay::GetExperiment() const {
  return m_reader->GetInfo().Experiment;
}

UInt32 CRecordingReplay::GetSeed() const {
  return m_reader->GetInfo().Seed;
}

Real CRecordingReplay::GetTickLength() const {
  return m_reader->GetInfo().TickLength;
}

bool CRecordingReplay::IsExact() const {
  return m_reader->GetInfo().Precision == EPrecision::Exact;
}

std::unique_ptr<CLoopFunctions> CRecordingReplay::MakeLoopFunctions() {
  return std::make_unique<CReplayLoopFunctions>(*this);
}

void CRecordingReplay::Begin(CSpace& space) {
  Seek(space, m_firstTick);
}

void CRecordingReplay::Seek(CSpace& space, UInt32 tick) {
  m_nextTick = std::clamp(tick, m_firstTick, m_lastTick);
  m_reader->Seek(m_nextTick);
  m_hasEnded = false;
  Advance(space);
}

void CRecordingReplay::Advance(CSpace& space) {
  if (m_hasEnded) {
    return;
  }
  const SRecordedFrame* const frame = ReadFrame();
  if (frame == nullptr) {
    m_hasEnded = true;
    return;
  }
  Show(*frame, space);
  m_hasEnded = frame->Tick >= m_lastTick;
  m_nextTick = m_every > ~UInt32(0) - frame->Tick ? ~UInt32(0) : frame->Tick + m_every;
}

// the tick of the part's last state, whatever the step is
const SRecordedFrame* CRecordingReplay::ReadFrame() {
  const SRecordedFrame* frame = m_reader->ReadNext();
  while (frame != nullptr && frame->Tick < m_nextTick && frame->Tick < m_lastTick) {
    frame = m_reader->ReadNext();
  }
  return frame;
}

void CRecordingReplay::Show(const SRecordedFrame& frame, CSpace& space) {
  if (m_entities.empty() || frame.EntitiesVersion != m_entitiesVersion) {
    UpdateTypes(frame);
    UpdateEntities(frame, space);
    m_entitiesVersion = frame.EntitiesVersion;
  }
  space.SetSimulationClock(frame.Tick);
  const bool hasFloorChanged = m_floor != frame.Floor;
  m_floor = frame.Floor;
  std::span<const SBodyPose> poses(frame.Poses);
  std::span<const UInt32> words(frame.Words);
  for (const CReplayedEntity& entity : m_entities) {
    const SRecordedType& type = *entity.GetType();
    entity.SetState({poses.first(type.GetNumPoses()), words.first(type.GetNumWords())});
    poses = poses.subspan(type.GetNumPoses());
    words = words.subspan(type.GetNumWords());
    if (hasFloorChanged && entity.GetFloor() != nullptr) {
      entity.GetFloor()->SetChanged();
    }
  }
  ShowRays(frame);
  ShowFieldsAndDrawing(frame, space);
}

// those that are as before stay the same objects
void CRecordingReplay::UpdateTypes(const SRecordedFrame& frame) {
  m_types.resize(frame.Types.size());
  m_typeBytes.resize(frame.Types.size());
  for (size_t i = 0; i < frame.Types.size(); ++i) {
    std::string bytes;
    CByteWriter out(bytes);
    WriteType(frame.Types[i], out);
    WriteSolids(frame.Types[i], out);
    if (m_types[i] == nullptr || bytes != m_typeBytes[i]) {
      m_types[i] = std::make_shared<const SRecordedType>(frame.Types[i]);
      m_typeBytes[i] = std::move(bytes);
    }
  }
}

bool CRecordingReplay::IsSame(const CReplayedEntity& entity,
                              const SRecordedEntity& recorded) const {
  ARGOS_ASSERT(recorded.Type < m_types.size(), "there is no type number " << recorded.Type);
  return entity.GetType() == m_types[recorded.Type] && entity.GetId() == recorded.Id;
}

// new ones are at the end of both lists, so what differs before was removed
void CRecordingReplay::UpdateEntities(const SRecordedFrame& frame, CSpace& space) {
  std::vector<CReplayedEntity> kept;
  kept.reserve(frame.Entities.size());
  for (const CReplayedEntity& entity : m_entities) {
    if (kept.size() < frame.Entities.size() && IsSame(entity, frame.Entities[kept.size()])) {
      kept.push_back(entity);
    } else {
      space.Remove(entity.GetEntity());
    }
  }
  m_entities = std::move(kept);
  for (size_t i = m_entities.size(); i < frame.Entities.size(); ++i) {
    const SRecordedEntity& entity = frame.Entities[i];
    ARGOS_ASSERT(entity.Type < m_types.size(), "there is no type number " << entity.Type);
    m_entities.emplace_back(space, entity, m_types[entity.Type]);
  }
  for (size_t i = 0; i < m_entities.size(); ++i) {
    if (CReplayedFields* const fields = m_entities[i].GetFields()) {
      fields->Set(m_columns);
      fields->SetRow(i);
    }
  }
}

void CRecordingReplay::ShowRays(const SRecordedFrame& frame) const {
  for (const SRecordedRay& ray : frame.Rays) {
    ARGOS_ASSERT(ray.Robot < m_entities.size(),
                 "a ray of entity number " << ray.Robot << " of " << m_entities.size());
    CControllableEntity* const robot = m_entities[ray.Robot].GetRobot();
    if (robot == nullptr) {
      continue;
    }
    if (ray.Kind == SRecordedRay::EKind::HitPoint) {
      robot->GetIntersectionPoints().push_back(ray.Start);
    } else {
      robot->AddCheckedRay(ray.Kind == SRecordedRay::EKind::Obstructed, CRay3(ray.Start, ray.End));
    }
  }
}

void CRecordingReplay::ShowFieldsAndDrawing(const SRecordedFrame& frame, CSpace& space) {
  m_columns->Columns = frame.Columns;
  m_drawing = frame.Drawing;
  for (const SRecordedMetric& metric : frame.Metrics) {
    // older runs could record such metrics
    if (!CMetrics::IsReserved(metric.Name)) {
      space.GetExtension<CMetrics>().Set(metric.Name, metric.Value, metric.Unit);
    }
  }
}

REGISTER_REPLAY(CRecordingReplay, "recording", "the authors of this project", "1.0",
                "Replays recordings.", "See <recording>, and doc/recording.md.", "Usable")

}  // namespace argos
