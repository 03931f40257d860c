#include <argos3/plugins/simulator/media/rfid_medium.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/simulator/media/medium_manual.h>
#include <argos3/plugins/simulator/media/medium_members.h>
#include <argos3/plugins/simulator/media/point_cells.h>

#include <algorithm>
#include <cmath>

namespace argos {

struct CRFIDMedium::SState {
  CMediumMembers<CRFIDTagEntity> Tags;
  CMediumUsers Users;  // all are CUsers
  std::vector<SFound> Found;  // scratch

  SIndexChoice Index;
  CPointCells Cells;
  std::vector<CVector3> Places;  // places of the tags at the last sorting, by number, m
  UInt32 Numbering = 0;  // numbering of the tags at the last sorting
  std::vector<UInt32> Finite;  // numbers of tags at finite positions
  std::vector<Real> X, Y;  // coordinates of these tags, m
  Real Reach = 0.0;  // m, used to choose the cells
};

CRFIDMedium::CUser::CUser(CRFIDMedium& medium, const CControllableEntity& robot, Real reach)
    : CMediumUser(medium.m_state->Users, robot), m_reach(reach) {}

CRFIDMedium::CRFIDMedium() : m_state(std::make_unique<SState>()) {}

CRFIDMedium::~CRFIDMedium() {
  CRFIDMedium::Destroy();
}

void CRFIDMedium::Init(TConfigurationNode& tree) {
  CMedium::Init(tree);
  m_state->Index.Read(tree);
}

void CRFIDMedium::Reset() {
  for (CMediumUser* user : m_state->Users.Get()) {
    user->HasOrder = false;
    static_cast<CUser*>(user)->WrittenTag.clear();
  }
}

void CRFIDMedium::Destroy() {
  m_state->Tags.Clear();
  m_state->Users.RemoveAll();
}

void CRFIDMedium::Insert(CRFIDTagEntity& tag) {
  m_state->Tags.Add(tag);
}

void CRFIDMedium::Erase(CRFIDTagEntity& tag) {
  m_state->Tags.Remove(tag);
}

void CRFIDMedium::Update() {
  // the cells are used by devices only
  if (!m_state->Users.Get().empty()) {
    Refresh();
  }
}

// sorts the tags again if any was added, removed or moved, which is rare
void CRFIDMedium::Refresh() {
  SState& state = *m_state;
  Real reach = 0.0;
  for (const CMediumUser* user : state.Users.Get()) {
    reach = std::max(reach, static_cast<const CUser*>(user)->GetReach());
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
  state.Numbering = state.Tags.GetNumbering();
  state.Cells.SetOptions(state.Index, GetSpace().GetArenaLimits());
  state.Cells.Sort(state.X.data(), state.Y.data(), state.Finite.size(), reach);
}

void CRFIDMedium::FindTags(std::vector<SFound>& found, const CVector3& place, Real reach,
                           const CEntity& ownRoot) const {
  const SState& state = *m_state;
  found.clear();
  ARGOS_ASSERT(state.Numbering == state.Tags.GetNumbering(),
               "the tags of \"" << GetId() << "\" were renumbered after they had been sorted");
  // of each tag, the nearest image
  const SPeriodicity& period = m_cSpace.GetContext().Arena.Period;
  const auto find = [&](const CVector3& here) {
    state.Cells.ForPlacesNear(here.GetX(), here.GetY(), reach, [&](size_t cellPlace) {
      const UInt32 number = state.Finite[state.Cells.GetPoint(cellPlace)];
      const CVector3 way = state.Places[number] - here;
      const Real squareDistance = way.SquareLength();
      if (squareDistance > reach * reach || !period.X.IsShortest(way.GetX()) ||
          !period.Y.IsShortest(way.GetY())) {
        return;
      }
      // null if the tag was removed since the last Update()
      CRFIDTagEntity* const tag = state.Tags.Get(number);
      if (tag != nullptr && &tag->GetRootEntity() != &ownRoot) {
        found.push_back({tag, squareDistance});
      }
    });
  };
  period.ForDisplacements(
      {place.GetX() - reach, place.GetY() - reach, place.GetX() + reach, place.GetY() + reach},
      [&](Real dx, Real dy) { find(place + CVector3(dx, dy, 0.0)); });
  std::sort(found.begin(), found.end(), [](const SFound& a, const SFound& b) {
    return a.Tag->GetNumberInMedium() < b.Tag->GetNumberInMedium();
  });
}

void CRFIDMedium::TakeActs() {
  for (CMediumUser* user : m_state->Users.Get()) {
    static_cast<CUser*>(user)->WrittenTag.clear();
  }
  const std::vector<CMediumUser*>& writers = m_state->Users.TakeOrders();
  if (writers.empty()) {
    return;
  }
  Refresh();
  for (CMediumUser* writer : writers) {
    Write(static_cast<CUser&>(*writer));
  }
}

void CRFIDMedium::Write(CUser& user) {
  std::vector<SFound>& found = m_state->Found;
  FindTags(found, user.Place, user.GetReach(), user.GetRobot().GetRootEntity());
  // among several at equal distance, the one that was created first counts
  const auto nearest = std::min_element(
      found.begin(), found.end(),
      [](const SFound& a, const SFound& b) { return a.SquareDistance < b.SquareDistance; });
  if (nearest != found.end() && nearest->Tag->TryWrite(user.Offset, user.Bytes)) {
    user.WrittenTag = nearest->Tag->GetTagId();
  }
}

REGISTER_MEDIUM(
    CRFIDMedium, "rfid", "the authors of this project", "1.0",
    "Index of the RFID tags that robots read and write.",
    R"(RFID tags are in the arena or mounted on bodies; see the entity "rfid_tag". Robots read them with the
sensor "rfid" and write them with the actuator "rfid", through obstacles, except for their own tags. Robots
that write in the same tick do so in the order in which they were added to the arena: if two write to the same bytes
of a tag, the robot that was added last overwrites the others.
)" + RequiredMediumXML(R"(<rfid id="rfid" />)") +
        OptionalMediumXML(R"(<rfid id="rfid" index="hash" grid_size="20,20,1" />)") + R"(
ATTRIBUTES

  id         text, required: unique among the media.
  index      "grid" (default) or "hash": spatial index of the tags. It has no effect on results.
  grid_size  "x,y,z", integers >= 1: number of grid cells along each axis; by default chosen from the
             reach of the robots' devices. It has no effect on results.
)",
    "Usable")

}  // namespace argos
