#include <argos3/plugins/simulator/media/simple_radio_medium.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/simulator/media/medium_manual.h>
#include <argos3/plugins/simulator/media/medium_members.h>
#include <argos3/plugins/simulator/media/point_cells.h>

#include <cmath>

namespace argos {

struct CSimpleRadioMedium::SState {
  CMediumMembers<CSimpleRadioEntity> Members;
  std::vector<CSimpleRadioEntity*> Senders;  // senders of this tick, in order
  std::vector<UInt32> Finite;  // numbers of radios at finite positions
  std::vector<Real> X, Y;  // coordinates of these radios, m, world frame
  CPointCells Cells;
  UInt64 NumDelivered = 0;  // number in this tick
};

CSimpleRadioMedium::CSimpleRadioMedium() : m_state(std::make_unique<SState>()) {}

CSimpleRadioMedium::~CSimpleRadioMedium() {
  // removes the radios, which call this object, before its members are destroyed
  CSimpleRadioMedium::Destroy();
}

void CSimpleRadioMedium::Insert(CSimpleRadioEntity& radio) {
  CPositionalMedium::Insert(radio);
  try {
    m_state->Members.Add(radio);
  } catch (...) {
    CPositionalMedium::Erase(radio);
    throw;
  }
}

void CSimpleRadioMedium::Erase(CSimpleRadioEntity& radio) {
  CPositionalMedium::Erase(radio);
  m_state->Members.Remove(radio);
}

void CSimpleRadioMedium::Reset() {
  CPositionalMedium::Reset();
  m_state->NumDelivered = 0;
}

UInt64 CSimpleRadioMedium::GetNumDelivered() const {
  return m_state->NumDelivered;
}

void CSimpleRadioMedium::TakeActs() {
  CMediumMembers<CSimpleRadioEntity>& members = m_state->Members;
  members.Update();
  m_state->Senders.clear();
  m_state->NumDelivered = 0;
  for (size_t number = 0; number < members.GetSize(); ++number) {
    CSimpleRadioEntity& radio = *members.Get(number);
    radio.DropOldMessages();
    if (!radio.GetOutbox().empty()) {
      m_state->Senders.push_back(&radio);
    }
  }
  if (m_state->Senders.empty()) {
    return;
  }
  SortByCell();
  for (CSimpleRadioEntity* sender : m_state->Senders) {
    Deliver(*sender);
    sender->ClearOutbox();
  }
}

void CSimpleRadioMedium::SortByCell() {
  SState& state = *m_state;
  state.Finite.clear();
  state.X.clear();
  state.Y.clear();
  for (size_t number = 0; number < state.Members.GetSize(); ++number) {
    const CVector3& position = state.Members.Get(number)->GetPosition();
    if (std::isfinite(position.GetX()) && std::isfinite(position.GetY()) &&
        std::isfinite(position.GetZ())) {
      state.Finite.push_back(static_cast<UInt32>(number));
      state.X.push_back(position.GetX());
      state.Y.push_back(position.GetY());
    }
  }
  Real reach = 0.0;
  for (const CSimpleRadioEntity* sender : state.Senders) {
    reach += sender->GetRange() / static_cast<Real>(state.Senders.size());
  }
  state.Cells.SetOptions(GetIndexChoice(), GetSpace().GetArenaLimits());
  state.Cells.Sort(state.X.data(), state.Y.data(), state.Finite.size(), reach);
}

void CSimpleRadioMedium::Deliver(CSimpleRadioEntity& sender) {
  const CVector3& place = sender.GetPosition();
  const Real range = sender.GetRange();
  const SPeriodicity& period = GetSpace().GetContext().Arena.Period;
  // a receiver hears the nearest image of the sender
  const Real reachX = period.X.IsOn() ? std::min(range, 0.5 * period.X.Period) : range;
  const Real reachY = period.Y.IsOn() ? std::min(range, 0.5 * period.Y.Period) : range;
  period.ForDisplacements(
      {place.GetX() - reachX, place.GetY() - reachY, place.GetX() + reachX, place.GetY() + reachY},
      [&](Real dx, Real dy) { DeliverTo(sender, CVector3(dx, dy, 0.0)); });
}

// To the receivers that are nearest to an image of the sender.
void CSimpleRadioMedium::DeliverTo(CSimpleRadioEntity& sender, const CVector3& displacement) {
  const CVector3 place = sender.GetPosition() + displacement;
  const Real range = sender.GetRange();
  const SPeriodicity& period = GetSpace().GetContext().Arena.Period;
  m_state->Cells.ForPlacesNear(place.GetX(), place.GetY(), range, [&](size_t cellPlace) {
    const UInt32 number = m_state->Finite[m_state->Cells.GetPoint(cellPlace)];
    CSimpleRadioEntity& receiver = *m_state->Members.Get(number);
    const CVector3 way = receiver.GetPosition() - place;
    if (&receiver == &sender || !(way.SquareLength() < range * range) ||
        !period.X.IsShortest(way.GetX()) || !period.Y.IsShortest(way.GetY())) {
      return;
    }
    receiver.Deliver(place, sender.GetOutbox());
    m_state->NumDelivered += sender.GetOutbox().size();
  });
}

REGISTER_MEDIUM(
    CSimpleRadioMedium, "simple_radio", "the authors of this project", "1.0",
    "Carries messages from radio to radio.",
    R"(Radios send messages of any size, any number in a tick. A message reaches every other radio of the medium within
the sender's range, through obstacles, in the same tick, before any motion. A radio receives
messages in the order in which their senders were added to the arena, and keeps them until its robot's sensor reads
them, for one tick at most.

Radios on a robot:

  <foot-bot id="fb0">
    <body position="0,0,0" />
    <controller config="c1" />
    <simple_radios>
      <simple_radio id="wifi" medium="radios" range="5" position="0,0,0.1" />
    </simple_radios>
  </foot-bot>

  simple_radio@id           text, default radio_0, radio_1, ...: the radio's name for the controller.
  simple_radio@medium       text, required: the id of a simple_radio medium.
  simple_radio@range        m, >= 0, required: range of its messages.
  simple_radio@position     "x,y,z", m, default "0,0,0": in the frame of the anchor.
  simple_radio@orientation  "z,y,x", degrees, default "0,0,0": ignored.
  simple_radio@anchor       text, default "origin": a frame of the body.
)" + RequiredMediumXML(R"(<simple_radio id="radios" />)") +
        OptionalMediumXML(R"(<simple_radio id="radios" index="grid" grid_size="20,20,1" />)") + R"(
ATTRIBUTES

  id         text, required: unique among the media.
  index      "grid" (default) or "hash": spatial index of the radios. It has no effect on results.
  grid_size  "x,y,z", integers >= 1: number of grid cells along each axis. It has no effect on results.
)",
    "Usable")

}  // namespace argos
