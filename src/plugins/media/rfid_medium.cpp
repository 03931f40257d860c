#include <argos3/plugins/simulator/media/rfid_medium.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/simulator/media/medium_members.h>
#include <argos3/plugins/simulator/media/point_cells.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace argos {

struct CRFIDMedium::SState {
  CMediumMembers<CRFIDTagEntity> Tags;
  std::vector<CUser*> Users;  // not owned; in order of registration
  std::vector<std::pair<ssize_t, UInt32>> Writers;  // of this tick: robot, number in Users
  std::vector<SFound> Found;  // scratch

  SIndexChoice Index;
  CPointCells Cells;
  std::vector<CVector3> Places;  // of the tags when they were sorted, m, world frame, by number
  std::vector<UInt32> Finite;  // numbers of tags that are somewhere
  std::vector<Real> X, Y;  // of these, m
  Real Reach = 0.0;  // m, for which cells were chosen
};

CRFIDMedium::CUser::CUser(CRFIDMedium& medium, const CControllableEntity& robot, Real reach)
    : m_medium(&medium), m_robot(robot), m_reach(reach) {
  m_medium->m_state->Users.push_back(this);
}

CRFIDMedium::CUser::~CUser() {
  if (m_medium != nullptr) {
    std::vector<CUser*>& users = m_medium->m_state->Users;
    users.erase(std::find(users.begin(), users.end(), this));
  }
}

ssize_t CRFIDMedium::CUser::GetIndex() const {
  return m_robot.GetIndex();
}

CRFIDMedium::CRFIDMedium() : m_state(std::make_unique<SState>()) {}

CRFIDMedium::~CRFIDMedium() {
  CRFIDMedium::Destroy();
}

void CRFIDMedium::Init(TConfigurationNode& tree) {
  CMedium::Init(tree);
  m_state->Index.Read(tree);
}

void CRFIDMedium::Reset() {
  for (CUser* user : m_state->Users) {
    user->HasOrder = false;
    user->WrittenTag.clear();
  }
}

void CRFIDMedium::Destroy() {
  for (CRFIDTagEntity* tag : m_state->Tags.ListAll()) {
    tag->ClearMedium();
  }
  for (CUser* user : m_state->Users) {
    user->m_medium = nullptr;
  }
  m_state->Users.clear();
}

void CRFIDMedium::AddEntity(CRFIDTagEntity& tag) {
  m_state->Tags.Add(tag);
}

void CRFIDMedium::RemoveEntity(CRFIDTagEntity& tag) {
  m_state->Tags.Remove(tag);
}

void CRFIDMedium::Update() {
  // without devices nobody asks
  if (!m_state->Users.empty()) {
    Refresh();
  }
}

// sorts the tags anew if any has come, gone or moved: most of them lie where they are
void CRFIDMedium::Refresh() {
  SState& state = *m_state;
  Real reach = 0.0;
  for (const CUser* user : state.Users) {
    reach = std::max(reach, user->m_reach);
  }
  bool changed = state.Tags.Update() || reach != state.Reach;
  state.Places.resize(state.Tags.GetSize());
  for (size_t number = 0; number < state.Places.size(); ++number) {
    const CVector3& place = state.Tags.Get(number)->GetPosition();
    changed = changed || place != state.Places[number];
    state.Places[number] = place;
  }
  if (!changed) {
    return;
  }
  state.Finite.clear();
  state.X.clear();
  state.Y.clear();
  for (size_t number = 0; number < state.Places.size(); ++number) {
    const CVector3& place = state.Places[number];
    if (std::isfinite(place.GetX()) && std::isfinite(place.GetY()) && std::isfinite(place.GetZ())) {
      state.Finite.push_back(static_cast<UInt32>(number));
      state.X.push_back(place.GetX());
      state.Y.push_back(place.GetY());
    }
  }
  state.Reach = reach;
  state.Cells.SetOptions(state.Index, GetSpace().GetArenaLimits());
  state.Cells.Sort(state.X.data(), state.Y.data(), state.Finite.size(), reach);
}

void CRFIDMedium::FindTags(std::vector<SFound>& found, const CVector3& place, Real reach,
                           const CEntity& ownRoot) const {
  const SState& state = *m_state;
  found.clear();
  state.Cells.ForPlacesNear(place.GetX(), place.GetY(), reach, [&](size_t cellPlace) {
    const UInt32 number = state.Finite[state.Cells.GetPoint(cellPlace)];
    const Real squareDistance = SquareDistance(state.Places[number], place);
    if (squareDistance > reach * reach) {
      return;
    }
    // null: it has gone since
    CRFIDTagEntity* const tag = state.Tags.Get(number);
    if (tag != nullptr && &tag->GetRootEntity() != &ownRoot) {
      found.push_back({tag, squareDistance});
    }
  });
  std::sort(found.begin(), found.end(), [](const SFound& a, const SFound& b) {
    return a.Tag->GetNumberInMedium() < b.Tag->GetNumberInMedium();
  });
}

void CRFIDMedium::TakeActs() {
  SState& state = *m_state;
  state.Writers.clear();
  for (size_t number = 0; number < state.Users.size(); ++number) {
    CUser& user = *state.Users[number];
    user.WrittenTag.clear();
    // a robot that is not in the space is not near anything
    if (user.HasOrder && user.GetIndex() >= 0) {
      state.Writers.emplace_back(user.GetIndex(), static_cast<UInt32>(number));
    }
    user.HasOrder = false;
  }
  if (state.Writers.empty()) {
    return;
  }
  Refresh();
  std::sort(state.Writers.begin(), state.Writers.end());
  for (const auto& writer : state.Writers) {
    Write(*state.Users[writer.second]);
  }
}

void CRFIDMedium::Write(CUser& user) {
  std::vector<SFound>& found = m_state->Found;
  FindTags(found, user.Place, user.m_reach, user.m_robot.GetRootEntity());
  // of tags equally near, the one that was created first
  const auto nearest = std::min_element(
      found.begin(), found.end(),
      [](const SFound& a, const SFound& b) { return a.SquareDistance < b.SquareDistance; });
  if (nearest != found.end() && nearest->Tag->TryWrite(user.Offset, user.Bytes)) {
    user.WrittenTag = nearest->Tag->GetTagId();
  }
}

REGISTER_MEDIUM(
    CRFIDMedium, "rfid", "the authors of this project", "1.0",
    "Knows where RFID tags are, for robots that read and write them.",
    R"(RFID tags lie in the arena, or are carried by bodies; see the entity "rfid_tag". Robots read them with the
sensor "rfid" and write them with the actuator "rfid", through whatever is between, but not their own tags. Robots
that write in the same tick do so in the order in which they were put into the arena: if two write to the same bytes
of a tag, those of the robot that was created last stay.

REQUIRED XML

  <media>
    <rfid id="rfid" />
  </media>

OPTIONAL XML

  <media>
    <rfid id="rfid" index="hash" grid_size="20,20,1" />
  </media>

ATTRIBUTES

  id         text, required: unique among the media.
  index      "grid" (default) or "hash": how tags near a robot are found. It has no effect on results.
  grid_size  "x,y,z", integers >= 1: into how many cells the arena is divided; by default cells suit the
             reach of the robots' devices. It has no effect on results.
)",
    "Usable")

}  // namespace argos
