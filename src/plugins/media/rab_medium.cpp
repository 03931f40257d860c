#include <argos3/plugins/simulator/media/rab_medium.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/media/medium_manual.h>
#include <argos3/plugins/simulator/media/medium_members.h>
#include <argos3/plugins/simulator/media/rab_routing.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace argos {

namespace {

// devices per parallel task
constexpr size_t kMembersPerTask = 256;

}  // namespace

struct CRABMedium::SState {
  CMediumMembers<CRABEquippedEntity> Members;
  SIndexChoice Index;
  CRABRouting Routing;
};

CRABMedium::CRABMedium() : m_state(std::make_unique<SState>()) {}

CRABMedium::~CRABMedium() {
  CRABMedium::Destroy();
}

void CRABMedium::Init(TConfigurationNode& tree) {
  CMedium::Init(tree);
  m_state->Index.Read(tree, true);
  GetNodeAttributeOrDefault(tree, "check_occlusions", m_checkOcclusions, m_checkOcclusions);
  LOG << "[INFO] The range and bearing medium \"" << GetId() << "\" uses the index \""
      << m_state->Index.GetName() << "\"" << std::endl;
}

void CRABMedium::PostSpaceInit() {
  struct SSize {
    const CRABEquippedEntity* First;
    size_t Count;
  };
  std::map<size_t, SSize> sizes;  // are indexed by bytes of a message
  std::vector<CRABEquippedEntity*> devices = m_state->Members.ListAll();
  std::sort(devices.begin(), devices.end(), SEntityComparator());
  for (const CRABEquippedEntity* device : devices) {
    ++sizes.try_emplace(device->GetMsgSize(), SSize{device, 0}).first->second.Count;
  }
  if (sizes.size() < 2) {
    return;
  }
  std::ostringstream list;
  for (const auto& [bytes, size] : sizes) {
    const CEntity& robot = size.First->GetRootEntity();
    list << (bytes == sizes.begin()->first ? "" : ", ") << bytes << " bytes of "
         << robot.GetTypeDescription() << " \"" << robot.GetId() << "\"";
    if (size.Count > 1) {
      list << " and " << size.Count - 1 << " other device" << (size.Count > 2 ? "s" : "");
    }
  }
  LOGERR
      << "[WARNING] medium \"" << GetId()
      << "\": robots whose messages differ in size do not hear each other; there are messages of "
      << list.str() << ". Give them the same \"rab_data_size\"." << std::endl;
}

void CRABMedium::Reset() {
  m_state->Routing.Clear();
  m_sets.clear();
}

void CRABMedium::Destroy() {
  m_state->Members.Clear();
}

void CRABMedium::Insert(CRABEquippedEntity& entity) {
  m_state->Members.Add(entity);
}

void CRABMedium::Erase(CRABEquippedEntity& entity) {
  m_state->Members.Remove(entity);
  // a device that was switched off receives nothing: another one may get its number
  entity.SetNumberInMedium(CMediumMembers<CRABEquippedEntity>::kWaiting);
  // users may hold sets of removed devices
  m_sets.clear();
}

void CRABMedium::Update() {
  m_sets.clear();
  m_state->Members.Update();
  m_state->Routing.SetOptions(m_state->Index, GetSpace().GetArenaLimits());
  m_state->Routing.SetPeriod(GetSpace().GetContext().Arena.Period);
  const CLineOfSight sight(GetSpace());
  TakePositions(sight);
  m_state->Routing.Route(m_cSimulator.GetThreadPool(), m_checkOcclusions ? &sight : nullptr);
}

void CRABMedium::TakePositions(const CLineOfSight& sight) {
  const CMediumMembers<CRABEquippedEntity>& members = m_state->Members;
  CRABRouting::SDevices& devices = m_state->Routing.GetDevices();
  devices.Resize(members.GetSize());
  m_cSimulator.GetThreadPool().ParallelFor(
      members.GetSize(), kMembersPerTask, [&](size_t begin, size_t end, UInt32) {
        for (size_t i = begin; i < end; ++i) {
          const CRABEquippedEntity& device = *members.Get(i);
          const CVector3& position = device.GetPosition();
          devices.X[i] = position.GetX();
          devices.Y[i] = position.GetY();
          devices.Z[i] = position.GetZ();
          devices.Range[i] = device.GetRange();
          devices.MessageSize[i] = static_cast<UInt32>(device.GetMsgSize());
          devices.Bodies[i] = CLineOfSight::MakeEnd(device.GetEntityBody());
          devices.Reach[i] =
              CSightFan::ComputeReach(sight, devices.Bodies[i], devices.X[i], devices.Y[i]);
        }
      });
}

CRABMedium::SNumbers CRABMedium::GetSenders(const CRABEquippedEntity& entity) const {
  ARGOS_ASSERT(
      entity.GetNumberInMedium() == CMediumMembers<CRABEquippedEntity>::kWaiting ||
          m_state->Members.Has(entity),
      "the number of \"" << entity.GetId() << "\" in the medium \"" << GetId() << "\" is stale");
  const CRABRouting::SNumbers senders = m_state->Routing.GetSenders(entity.GetNumberInMedium());
  return {senders.First, senders.Last};
}

UInt32 CRABMedium::GetNumDevices() const {
  return static_cast<UInt32>(m_state->Members.GetSize());
}

UInt64 CRABMedium::GetNumDelivered() const {
  return m_state->Routing.GetNumHearings();
}

const CRABEquippedEntity* CRABMedium::GetDevice(UInt32 number) const {
  return m_state->Members.Get(number);
}

const CRABEquippedEntity* const* CRABMedium::GetDevices() const {
  return m_state->Members.GetAll();
}

const CRABMedium::TDevices& CRABMedium::GetRABsCommunicatingWith(CRABEquippedEntity& entity) const {
  if (!m_state->Members.Has(entity)) {
    THROW_ARGOSEXCEPTION("range and bearing \"" << entity.GetContext() << entity.GetId()
                                                << "\" is not in the medium \"" << GetId() << "\"");
  }
  const std::lock_guard<std::mutex> lock(m_setsMutex);
  const auto [found, inserted] = m_sets.try_emplace(&entity);
  if (inserted) {
    for (const UInt32 number : GetSenders(entity)) {
      if (CRABEquippedEntity* const sender = m_state->Members.Get(number)) {
        found->second.insert(sender);
      }
    }
  }
  return found->second;
}

REGISTER_MEDIUM(
    CRABMedium, "range_and_bearing", "the authors of this project", "1.0",
    "Routes the messages of range-and-bearing devices.",
    R"(Robots with a range-and-bearing device send a short message in all directions in every tick; receivers
also measure the distance and direction of the sender. In each tick, after the robots have
moved, robot B receives the message of robot A if their messages have the same size, the distance is smaller than
the range of A, and no body is between them. The robots' own bodies do not occlude; neither does a body that meets
the line between the two devices only inside one of the two robots' bodies. When an experiment is loaded, messages of
different sizes in one medium cause a warning.
)" + RequiredMediumXML(R"(<range_and_bearing id="rab" />)") +
        OptionalMediumXML(
            R"(<range_and_bearing id="rab" check_occlusions="false" index="grid" grid_size="20,20,1" />)") +
        R"(
ATTRIBUTES

  id                text, required: unique among the media.
  check_occlusions  "true" (default) or "false": whether bodies occlude the line between robots.
  index             "grid" (default), "hash" or "dummy": spatial index of the devices. It has
                    no effect on results; "hash" is for few robots far apart, "dummy" tests all
                    pairs.
  grid_size         "x,y,z", integers >= 1: number of grid cells along each axis; by default chosen from
                    the ranges and the number of robots. It has no effect on results.
)",
    "Usable")

}  // namespace argos
