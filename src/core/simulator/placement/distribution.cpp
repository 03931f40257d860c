#include <argos3/core/simulator/placement/distribution.h>

#include <argos3/core/simulator/context/library_attribute.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/physics_engine/described_body_model.h>
#include <argos3/core/simulator/placement/ground_order.h>
#include <argos3/core/simulator/placement/planned_bodies.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/configuration/attribute_text.h>
#include <argos3/core/utility/memory/object_slabs.h>
#include <argos3/core/utility/memory/page_preparer.h>
#include <argos3/core/utility/non_copyable.h>
#include <argos3/core/utility/text/classic_locale.h>
#include <argos3/core/utility/threads/thread_pool.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <sstream>

namespace argos {

namespace {

// shortest text that reads back to the very same numbers
std::string ExactText(const CVector3& vector) {
  std::string text;
  std::array<char, 32> buffer{};
  for (UInt32 axis = 0; axis < 3; ++axis) {
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), vector[axis]);
    text += axis > 0 ? "," : "";
    text.append(buffer.data(), result.ptr);
  }
  return text;
}

CQuaternion FromDegrees(const CVector3& zyx) {
  CQuaternion orientation;
  orientation.FromEulerAngles(ToRadians(CDegrees(zyx.GetX())), ToRadians(CDegrees(zyx.GetY())),
                              ToRadians(CDegrees(zyx.GetZ())));
  return orientation;
}

// robots that are created during its lifetime get no controller: only their shape is needed
class CProbing : private CNonCopyable {
 public:
  explicit CProbing(CSpace& space) : m_space(space) {
    m_space.GetContext().Loading.SetProbing(true);
  }
  ~CProbing() { m_space.GetContext().Loading.SetProbing(false); }

 private:
  CSpace& m_space;
};

// Has one thread prepare the memory of many entities while another one creates them: clearing new
// pages is a fifth of the time of the start.
class CMemoryAhead {
 public:
  // @param threads  that the simulation may use
  CMemoryAhead(size_t threads, size_t entities)
      : m_numLeft(threads > 1 && entities >= kManyEntities ? entities : 0),
        m_bytesBefore(CObjectSlabs::GetCurrent().GetNumBytes()) {}

  // it is called after each entity; the first ones show how much memory one needs
  void NoteCreated() {
    if (m_numLeft == 0 || ++m_numSamples < kSamples) {
      return;
    }
    CObjectSlabs& slabs = CObjectSlabs::GetCurrent();
    const size_t ofSamples = slabs.GetNumBytes() - m_bytesBefore;
    const auto block = slabs.ReserveAhead((m_numLeft - kSamples) * ofSamples / kSamples);
    m_preparer.emplace(block.Start, block.Bytes);
    m_numLeft = 0;
  }

 private:
  static constexpr size_t kManyEntities = 20000;
  static constexpr size_t kSamples = 256;

  size_t m_numLeft;  // entities, if memory is to be prepared; else 0
  size_t m_numSamples = 0;
  size_t m_bytesBefore;  // bytes in slabs
  std::optional<CPagePreparer> m_preparer;
};

// more would not fit into the memory of any computer
constexpr UInt64 kMaxEntities = 10000000;
// limit for one entity; without a free place they take some 10 s
constexpr UInt64 kMaxTrials = 10000000;

// the area of the base of an upright solid, m^2; 0 for solids without a flat base
Real ComputeBase(const SShapeDescription& solid) {
  using EKind = SShapeDescription::EKind;
  const bool hasBase =
      solid.Kind == EKind::Box || solid.Kind == EKind::Cylinder || solid.Kind == EKind::Prism;
  const bool isTilted = solid.Orientation.GetX() != 0.0 || solid.Orientation.GetY() != 0.0;
  return hasBase && !isTilted ? solid.ComputeVolume() / solid.Size.GetZ() : 0.0;
}

}  // namespace

CDistribution::CDistribution(CSpace& space, TConfigurationNode& node, CLoadErrors& errors)
    : m_space(space), m_node(node), m_obstacles(&space.GetBodyIndex()) {
  const auto read = [&](auto&& step) { m_isValid = errors.Try("", step) && m_isValid; };
  read([&] { m_positions = CreateVectorGenerator(GetNode(m_node, "position"), m_space.GetRNG()); });
  read([&] {
    m_orientations = CreateVectorGenerator(GetNode(m_node, "orientation"), m_space.GetRNG());
  });
  const auto readCount = [&](const char* attribute, UInt64 most, UInt64& value) {
    read([&] {
      TConfigurationNode& entity = GetNode(m_node, "entity");
      GetNodeAttribute(entity, attribute, value);
      if (value > most) {
        THROW_ARGOSEXCEPTION(entity.GetLocation()
                             << ": <entity>: attribute \"" << attribute
                             << "\" must be an integer from 0 to " << most << ", found " << value);
      }
    });
  };
  readCount("quantity", kMaxEntities, m_quantity);
  readCount("max_trials", kMaxTrials, m_maxTrials);
  read([&] { ReadEntity(); });
}

void CDistribution::ReadEntity() {
  TConfigurationNode& entity = GetNode(m_node, "entity");
  GetNodeAttributeOrDefault(entity, "base_num", m_baseNumber, UInt64(0));
  TConfigurationNodeIterator it;
  it = it.begin(&entity);
  if (it == it.end()) {
    THROW_ARGOSEXCEPTION(entity.GetLocation()
                         << ": <entity> must hold the element to distribute, such as <foot-bot>");
  }
  TConfigurationNode& element = *it;
  if (++it != it.end()) {
    THROW_ARGOSEXCEPTION(it->GetLocation() << ": <" << it->Value()
                                           << ">: <entity> holds one element, and that is already <"
                                           << element.Value() << "> at " << element.GetLocation()
                                           << "; use another <distribute>");
  }
  m_template = &element;
  GetNodeAttribute(*m_template, "id", m_baseId);
}

void CDistribution::Place() {
  // a missing template was reported, too
  if (m_template == nullptr || (m_quantity == 0 && m_isValid)) {
    return;
  }
  CallStep([this] {
    Probe();
    if (m_isValid) {
      PlaceAll();
    } else {
      TryEntity();
    }
  });
}

void CDistribution::TryTemplate() {
  if (m_template != nullptr) {
    CallStep([this] { Probe(); });
  }
}

// restores the template, and adds the element to errors
void CDistribution::CallStep(const std::function<void()>& step) {
  try {
    step();
  } catch (const CAlreadyReported&) {
    m_template->SetAttribute("id", m_baseId);
    throw;
  } catch (std::exception& error) {
    m_template->SetAttribute("id", m_baseId);
    THROW_ARGOSEXCEPTION_NESTED(m_node.GetLocation() << ": <distribute> of <" << m_template->Value()
                                                     << " id=\"" << m_baseId << "\"> failed",
                                error);
  }
  m_template->SetAttribute("id", m_baseId);
}

void CDistribution::PlaceAll() {
  m_positions->RequireCapacity(m_quantity);
  CheckRoom();
  if (m_body != nullptr && m_quantity >= CSpace::kFewRobots) {
    PlaceOnGround();
  } else {
    PlaceOneByOne();
  }
}

// finds errors of its controller; it is not added to the space
void CDistribution::TryEntity() {
  const std::unique_ptr<CEntity> entity = m_space.MakeEntity(m_template->Value());
  entity->Init(*m_template);
  entity->Destroy();
}

// The bases of bodies that stand on one plane must not overlap, nor must their volumes. This finds
// quantities that are too large by far, for which the trials would take minutes.
void CDistribution::CheckRoom() const {
  CVector3 min;
  CVector3 max;
  CVector3 minAngles;
  CVector3 maxAngles;
  if (m_body == nullptr || !m_positions->GetExtent(min, max)) {
    return;
  }
  const bool isUpright = m_orientations->GetExtent(minAngles, maxAngles) &&
                         minAngles.GetY() == 0.0 && maxAngles.GetY() == 0.0 &&
                         minAngles.GetZ() == 0.0 && maxAngles.GetZ() == 0.0;
  const bool isPlane = isUpright && min.GetZ() == max.GetZ();
  Real needed = 0.0;
  for (const SShapeDescription& solid : m_body->Shapes) {
    const Real volume = solid.ComputeVolume();
    needed = std::max(needed, isPlane ? ComputeBase(solid) : volume);
  }
  const Real reach = 2.0 * m_body->ComputeBoundingRadius();
  const CVector3 room = max - min + CVector3(reach, reach, reach);
  const Real available = room.GetX() * room.GetY() * (isPlane ? 1.0 : room.GetZ());
  if (static_cast<Real>(m_quantity) * needed > available) {
    const char* const unit = isPlane ? " m^2" : " m^3";
    THROW_ARGOSEXCEPTION("there is no room for "
                         << m_quantity << " bodies of at least " << needed << unit
                         << ": positions are " << m_positions->Describe()
                         << ", where bodies have at most " << available << unit);
  }
}

// creates one entity of the type, without a controller, to get its body description
void CDistribution::Probe() {
  const CProbing probing(m_space);
  LoadLibraryOf(*m_template);
  const std::unique_ptr<CEntity> probe = m_space.MakeEntity(m_template->Value());
  // an entity without a body has its pose in attributes of its own element
  m_poseNode = m_template;
  if (dynamic_cast<CPositionalEntity*>(probe.get()) == nullptr) {
    if (!NodeExists(*m_template, "body")) {
      TConfigurationNode body("body");
      AddChildNode(*m_template, body);
    }
    m_poseNode = &GetNode(*m_template, "body");
  }
  WriteIntoTemplate(m_baseId, CVector3(), CVector3());
  probe->Init(*m_template);
  if (CEmbodiedEntity* body = FindEmbodiedEntity(*probe)) {
    m_hasBody = true;
    m_body = body->GetSharedBodyDescription();
  } else if (m_poseNode != m_template) {
    THROW_ARGOSEXCEPTION("<" << m_template->Value()
                             << "> has neither a body nor a position: it cannot be distributed");
  }
  probe->Destroy();
}

std::string CDistribution::MakeId(UInt64 number) const {
  return m_baseId + std::to_string(m_baseNumber + number);
}

// tries places that are free of the space's bodies until one is taken
// @param take  bool(position, orientation, angles in degrees)
template <typename TAKE>
void CDistribution::FindPlace(UInt64 number, TAKE&& take) {
  const bool canRetry = m_positions->CanRetry() || m_orientations->CanRetry();
  const UInt64 trials = canRetry ? m_maxTrials + 1 : 1;
  for (UInt64 trial = 0; trial < trials; ++trial) {
    const CVector3 position = m_positions->Next(trial > 0);
    const CVector3 angles = m_orientations->Next(trial > 0);
    const CQuaternion orientation = FromDegrees(angles);
    if (IsFree(position, orientation) && take(position, orientation, angles)) {
      return;
    }
  }
  GiveUp(MakeId(number), trials);
}

void CDistribution::PlaceOneByOne() {
  for (UInt64 number = 0; number < m_quantity; ++number) {
    const std::string id = MakeId(number);
    FindPlace(number, [&](const CVector3& position, const CQuaternion&, const CVector3& angles) {
      WriteIntoTemplate(id, position, angles);
      return TryToCreate(id);
    });
  }
}

void CDistribution::PlaceOnGround() {
  const SPlaces places = ChoosePlaces();
  const std::vector<UInt32> order =
      OrderOnGround(places.Positions, 2.0 * m_body->ComputeBoundingRadius());
  std::vector<ssize_t> indices(order.size());  // indexed by number
  m_space.ReserveRoots(order.size());
  CMemoryAhead memory(m_space.GetContext().Pool->GetNumThreads(), order.size());
  for (const UInt32 number : order) {
    WriteIntoTemplate(MakeId(number), places.Positions[number], places.Angles[number]);
    indices[number] = m_space.CreateEntity(*m_template).GetIndex();
    memory.NoteCreated();
  }
  m_space.OrderRoots(indices);
}

// places of bodies that overlap neither those of the space nor each other
CDistribution::SPlaces CDistribution::ChoosePlaces() {
  SPlaces places;
  places.Positions.reserve(m_quantity);
  places.Angles.reserve(m_quantity);
  std::vector<SBodyPose> poses;  // the index refers to them
  poses.reserve(m_quantity);
  CBodyIndex index;
  const SArena& arena = m_space.GetContext().Arena;
  index.SetArea(arena.Limits, arena.Period);
  CEmbodiedEntity body(nullptr);  // stands for all of them
  for (UInt64 number = 0; number < m_quantity; ++number) {
    FindPlace(number, [&](const CVector3& position, const CQuaternion& orientation,
                          const CVector3& angles) {
      m_lastObstacle = index.FindOverlap(*m_body, position, orientation, CBodyIndex::kNoBody);
      m_isLastPlanned = true;
      if (m_lastObstacle != CBodyIndex::kNoBody) {
        return false;
      }
      places.Positions.push_back(position);
      places.Angles.push_back(angles);
      poses.push_back({arena.Period.Wrap(position), orientation});
      index.Add(body, poses.back(), *m_body, true);
      return true;
    });
  }
  return places;
}

// the description of the entities; Probe() does not know one that a user's model has given them
std::shared_ptr<const SBodyDescription> CDistribution::FindDescription() const {
  if (m_body != nullptr || !m_hasBody) {
    return m_body;
  }
  for (UInt64 number = 0; number < m_quantity; ++number) {
    CEntity* const entity = m_space.TryGetEntity(MakeId(number));
    CEmbodiedEntity* const body = entity != nullptr ? FindEmbodiedEntity(*entity) : nullptr;
    if (body != nullptr && body->GetBodyDescription() != nullptr) {
      return body->GetSharedBodyDescription();
    }
  }
  THROW_ARGOSEXCEPTION("only the engine knows the shape of a <"
                       << m_template->Value()
                       << ">: its places cannot be drawn again; load the experiment again instead");
}

void CDistribution::ChooseAgain(CPlannedBodies& bodies) {
  CallStep([&] {
    m_chosen.clear();
    m_positions = CreateVectorGenerator(GetNode(m_node, "position"), m_space.GetRNG());
    m_orientations = CreateVectorGenerator(GetNode(m_node, "orientation"), m_space.GetRNG());
    m_body = FindDescription();
    m_obstacles = &bodies.GetIndex();
    for (UInt64 number = 0; number < m_quantity; ++number) {
      CEntity* const entity = m_space.TryGetEntity(MakeId(number));
      FindPlace(number,
                [&](const CVector3& position, const CQuaternion& orientation, const CVector3&) {
                  m_chosen.push_back({number, {position, orientation}});
                  return true;
                });
      if (m_body != nullptr) {
        bodies.Add(entity != nullptr ? FindEmbodiedEntity(*entity) : nullptr, m_body,
                   m_chosen.back().Pose);
      }
    }
  });
}

void CDistribution::TakeChosen() {
  for (const SChosen& chosen : m_chosen) {
    CEntity* const entity = m_space.TryGetEntity(MakeId(chosen.Number));
    if (entity == nullptr) {
      continue;
    }
    if (auto* const point = dynamic_cast<CPositionalEntity*>(entity)) {
      point->SetInitPosition(chosen.Pose.Position);
      point->SetInitOrientation(chosen.Pose.Orientation);
    } else if (CEmbodiedEntity* const body = FindEmbodiedEntity(*entity)) {
      body->SetInitPose(chosen.Pose.Position, chosen.Pose.Orientation);
    }
  }
  m_chosen.clear();
}

bool CDistribution::IsFree(const CVector3& position, const CQuaternion& orientation) {
  m_lastPosition = position;
  if (m_body == nullptr) {
    return true;
  }
  m_lastObstacle = m_obstacles->FindOverlap(*m_body, position, orientation, CBodyIndex::kNoBody);
  m_isLastPlanned = false;
  return m_lastObstacle == CBodyIndex::kNoBody;
}

bool CDistribution::TryToCreate(const std::string& id) {
  CEntity& entity = m_space.CreateEntity(*m_template);
  // a body without a description is tested by its engine after it was added
  if (!m_hasBody || m_body != nullptr || !FindEmbodiedEntity(entity)->IsCollidingWithSomething()) {
    return true;
  }
  m_lastObstacle = CBodyIndex::kNoBody;
  CallEntityOperation<CSpaceOperationRemoveEntity, CSpace, void>(m_space, m_space.GetEntity(id));
  return false;
}

void CDistribution::WriteIntoTemplate(const std::string& id, const CVector3& position,
                                      const CVector3& anglesInDegrees) {
  SetAttributeText(*m_template, "id", id);
  SetAttributeText(*m_poseNode, "position", ExactText(position));
  SetAttributeText(*m_poseNode, "orientation", ExactText(anglesInDegrees));
}

std::string CDistribution::DescribeObstacle() const {
  if (m_lastObstacle == CBodyIndex::kNoBody) {
    return "something in its engine";
  }
  return m_isLastPlanned ? MakeId(m_lastObstacle)
                         : m_obstacles->GetBody(m_lastObstacle).GetRootEntity().GetId();
}

void CDistribution::GiveUp(const std::string& id, UInt64 trials) const {
  CTextOutput message;
  message << "no free place for \"" << id << "\" after " << trials
          << (trials == 1 ? " trial" : " trials") << "; positions are " << m_positions->Describe()
          << "; the last one, (" << m_lastPosition << "), is taken by \"" << DescribeObstacle()
          << "\"; make the area larger, the quantity smaller, or \"max_trials\" larger";
  THROW_ARGOSEXCEPTION(message.str());
}

}  // namespace argos
