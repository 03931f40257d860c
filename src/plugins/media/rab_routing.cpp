#include <argos3/plugins/simulator/media/rab_routing.h>

#include <argos3/core/utility/threads/thread_pool.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// devices per parallel task, large enough to outweigh the cost of fetching a task
constexpr size_t kPlacedPerTask = 64;

// resizes, with spare capacity so that reallocations are rare
template <typename ELEMENT>
void ResizeWithSpare(std::vector<ELEMENT>& elements, size_t size) {
  if (elements.capacity() < size) {
    elements.reserve(size + size / 2);
  }
  elements.resize(size);
}

}  // namespace

void CRABRouting::SDevices::Resize(size_t size) {
  for (std::vector<Real>* values : {&X, &Y, &Z, &Range}) {
    values->resize(size);
  }
  MessageSize.resize(size);
  Bodies.resize(size);
}

void CRABRouting::Clear() {
  m_devices.Resize(0);
  m_senderStart.clear();
  m_senders.clear();
}

void CRABRouting::Route(CThreadPool& pool, const CLineOfSight* sight) {
  SortByCell();
  CountPairs(pool);
  ExaminePairs(pool, sight);
  CollectByReceiver(pool);
}

void CRABRouting::SortByCell() {
  const size_t num = m_devices.GetSize();
  m_finite.clear();
  m_finite.reserve(num);
  m_x.clear();
  m_x.reserve(num);
  m_y.clear();
  m_y.reserve(num);
  Real reach = 0.0;
  for (size_t device = 0; device < num; ++device) {
    const Real x = m_devices.X[device];
    const Real y = m_devices.Y[device];
    if (std::isfinite(x) && std::isfinite(y) && std::isfinite(m_devices.Z[device])) {
      m_finite.push_back(static_cast<UInt32>(device));
      m_x.push_back(x);
      m_y.push_back(y);
      reach += m_devices.Range[device];
    }
  }
  const size_t numPlaced = m_finite.size();
  m_cells.Sort(m_x.data(), m_y.data(), numPlaced,
               reach / static_cast<Real>(std::max<size_t>(1, numPlaced)));
  m_placed.resize(numPlaced);
  for (size_t place = 0; place < numPlaced; ++place) {
    const UInt32 device = m_finite[m_cells.GetPoint(place)];
    m_placed[place] = {m_devices.X[device],          m_devices.Y[device],      m_devices.Z[device],
                       m_devices.Range[device],      m_devices.Bodies[device], device,
                       m_devices.MessageSize[device]};
  }
}

// visits the pairs that a device has to examine: devices in its range with a shorter range; of two
// with equal ranges the one with the lower number examines
template <typename VISIT>
void CRABRouting::ForPairsOf(const SPlaced& device, VISIT&& visit) const {
  const Real squareRange = device.Range * device.Range;
  m_cells.ForPlacesNear(device.X, device.Y, device.Range, [&](size_t place) {
    const SPlaced& other = m_placed[place];
    const Real dx = other.X - device.X;
    const Real dy = other.Y - device.Y;
    const Real dz = other.Z - device.Z;
    const Real squareDistance = dx * dx + dy * dy + dz * dz;
    if (squareDistance >= squareRange || other.MessageSize != device.MessageSize ||
        other.Range > device.Range ||
        (other.Range == device.Range && other.Device <= device.Device)) {
      return;
    }
    visit(other, squareDistance);
  });
}

void CRABRouting::CountPairs(CThreadPool& pool) {
  m_pairStart.resize(m_placed.size() + 1);
  m_pairStart[0] = 0;
  pool.ParallelFor(m_placed.size(), kPlacedPerTask, [this](size_t begin, size_t end, UInt32) {
    for (size_t place = begin; place < end; ++place) {
      size_t count = 0;
      ForPairsOf(m_placed[place], [&count](const SPlaced&, Real) { ++count; });
      m_pairStart[place + 1] = 2 * count;
    }
  });
  for (size_t place = 0; place < m_placed.size(); ++place) {
    m_pairStart[place + 1] += m_pairStart[place];
  }
  ResizeWithSpare(m_hearings, m_pairStart.back());
  m_numHearings.resize(m_placed.size());
}

void CRABRouting::ExaminePairs(CThreadPool& pool, const CLineOfSight* sight) {
  const auto examine = [&](size_t place) {
    const SPlaced& device = m_placed[place];
    SHearing* const first = m_hearings.data() + m_pairStart[place];
    SHearing* next = first;
    ForPairsOf(device, [&](const SPlaced& other, Real squareDistance) {
      // the direction does not depend on the examining device, so neither do the roundings
      const bool forward = device.Device < other.Device;
      const SPlaced& from = forward ? device : other;
      const SPlaced& to = forward ? other : device;
      if (sight != nullptr &&
          !sight->IsClear(CRay3(CVector3(from.X, from.Y, from.Z), CVector3(to.X, to.Y, to.Z)),
                          from.Body, to.Body)) {
        return;
      }
      *next++ = {other.Device, device.Device};
      if (squareDistance < other.Range * other.Range) {
        *next++ = {device.Device, other.Device};
      }
    });
    m_numHearings[place] = static_cast<UInt32>(next - first);
    ARGOS_ASSERT(m_pairStart[place] + m_numHearings[place] <= m_pairStart[place + 1],
                 "a device has more hearings than pairs: " << m_numHearings[place]);
  };
  pool.ParallelFor(m_placed.size(), kPlacedPerTask, [&](size_t begin, size_t end, UInt32) {
    for (size_t place = begin; place < end; ++place) {
      examine(place);
    }
  });
}

void CRABRouting::CollectByReceiver(CThreadPool& pool) {
  const size_t num = m_devices.GetSize();
  const auto forHearings = [this](auto&& visit) {
    for (size_t place = 0; place < m_placed.size(); ++place) {
      const SHearing* const first = m_hearings.data() + m_pairStart[place];
      std::for_each(first, first + m_numHearings[place], visit);
    }
  };
  m_senderStart.assign(num + 1, 0);
  forHearings([this](const SHearing& hearing) { ++m_senderStart[hearing.Receiver + 1]; });
  m_cursor.resize(num);
  for (size_t device = 0; device < num; ++device) {
    m_senderStart[device + 1] += m_senderStart[device];
    m_cursor[device] = m_senderStart[device];
  }
  ResizeWithSpare(m_senders, m_senderStart.back());
  forHearings([this](const SHearing& hearing) {
    m_senders[m_cursor[hearing.Receiver]++] = hearing.Sender;
  });
  pool.ParallelFor(num, kPlacedPerTask, [this](size_t begin, size_t end, UInt32) {
    for (size_t device = begin; device < end; ++device) {
      std::sort(m_senders.begin() + m_senderStart[device],
                m_senders.begin() + m_senderStart[device + 1]);
    }
  });
}

}  // namespace argos
