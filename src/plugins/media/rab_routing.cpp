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
  for (std::vector<Real>* values : {&X, &Y, &Z, &Range, &Reach}) {
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
  SortByCell(pool);
  CountPairs(pool);
  ReserveScratch(pool);
  ExaminePairs(pool, sight);
  CollectByReceiver(pool);
}

void CRABRouting::SortByCell(CThreadPool& pool) {
  const size_t num = m_devices.GetSize();
  m_finite.clear();
  m_finite.reserve(num);
  m_x.clear();
  m_x.reserve(num);
  m_y.clear();
  m_y.reserve(num);
  m_placeOf.resize(num);
  Real reach = 0.0;
  m_areRangesEqual = true;
  for (size_t device = 0; device < num; ++device) {
    const Real x = m_devices.X[device];
    const Real y = m_devices.Y[device];
    if (std::isfinite(x) && std::isfinite(y) && std::isfinite(m_devices.Z[device])) {
      m_finite.push_back(static_cast<UInt32>(device));
      m_x.push_back(x);
      m_y.push_back(y);
      reach += m_devices.Range[device];
      m_areRangesEqual =
          m_areRangesEqual && m_devices.Range[device] == m_devices.Range[m_finite.front()];
    }
  }
  const size_t numPlaced = m_finite.size();
  m_cells.Sort(m_x.data(), m_y.data(), numPlaced,
               reach / static_cast<Real>(std::max<size_t>(1, numPlaced)));
  m_placed.resize(numPlaced);
  m_placedX.resize(numPlaced);
  m_placedY.resize(numPlaced);
  m_rank.resize(numPlaced);
  pool.ParallelFor(numPlaced, kPlacedPerTask, [this](size_t begin, size_t end, UInt32) {
    for (size_t place = begin; place < end; ++place) {
      const UInt32 device = m_finite[m_cells.GetPoint(place)];
      m_placed[place] = {{m_devices.X[device], m_devices.Y[device], m_devices.Z[device],
                          m_devices.Reach[device], m_devices.Bodies[device]},
                         m_devices.Range[device],
                         device,
                         m_devices.MessageSize[device]};
      m_placedX[place] = m_devices.X[device];
      m_placedY[place] = m_devices.Y[device];
      m_rank[place] = m_areRangesEqual ? static_cast<Real>(device) : -m_devices.Range[device];
      m_placeOf[device] = static_cast<UInt32>(place);
    }
  });
}

// Every pair is examined by the device with the longer range, or with the lower number if ranges
// are equal. If all are, ranks are numbers and decide; else they are ranges, and those of a pair
// may be equal.
template <typename VISIT>
void CRABRouting::ForRangesNear(size_t place, VISIT&& visit) const {
  if (m_period.IsOn()) {
    ForRangesOfImages(place, visit);
    return;
  }
  const Real x = m_placedX[place];
  const Real y = m_placedY[place];
  const Real range = m_placed[place].Range;
  const Real squareRange = range * range;
  const Real rank = m_rank[place] + (m_areRangesEqual ? 0.5 : 0.0);
  // true for every device in range, seen from above, of sufficient rank
  const auto isPair = [=, this](size_t other) {
    const Real dx = m_placedX[other] - x;
    const Real dy = m_placedY[other] - y;
    return (dx * dx + dy * dy < squareRange) & (m_rank[other] >= rank);
  };
  m_cells.ForRangesNear(x, y, range, [&](size_t begin, size_t end) { visit(begin, end, isPair); });
}

// The same in a periodic arena: of each device, the nearest image.
template <typename VISIT>
void CRABRouting::ForRangesOfImages(size_t place, VISIT&& visit) const {
  const Real range = m_placed[place].Range;
  const Real squareRange = range * range;
  const Real rank = m_rank[place] + (m_areRangesEqual ? 0.5 : 0.0);
  const Real halfX = m_period.X.IsOn() ? 0.5 * m_period.X.Period : HUGE_VAL;
  const Real halfY = m_period.Y.IsOn() ? 0.5 * m_period.Y.Period : HUGE_VAL;
  const Real reachX = std::min(range, halfX);
  const Real reachY = std::min(range, halfY);
  const Real homeX = m_placedX[place];
  const Real homeY = m_placedY[place];
  m_period.ForDisplacements(
      {homeX - reachX, homeY - reachY, homeX + reachX, homeY + reachY}, [&](Real dx, Real dy) {
        const Real x = homeX + dx;
        const Real y = homeY + dy;
        const auto isPair = [=, this](size_t other) {
          const Real wayX = m_placedX[other] - x;
          const Real wayY = m_placedY[other] - y;
          return (wayX * wayX + wayY * wayY < squareRange) & (m_rank[other] >= rank) &
                 (wayX >= -halfX) & (wayX < halfX) & (wayY >= -halfY) & (wayY < halfY);
        };
        m_cells.ForRangesNear(x, y, range,
                              [&](size_t begin, size_t end) { visit(begin, end, isPair); });
      });
}

CSightFan::SEnd CRABRouting::MakeNearest(const CSightFan::SEnd& end,
                                         const CSightFan::SEnd& to) const {
  CSightFan::SEnd nearest = end;
  nearest.X += m_period.X.RoundToPeriods(to.X - end.X);
  nearest.Y += m_period.Y.RoundToPeriods(to.Y - end.Y);
  return nearest;
}

void CRABRouting::CountPairs(CThreadPool& pool) {
  m_pairStart.resize(m_placed.size() + 1);
  m_pairStart[0] = 0;
  pool.ParallelFor(m_placed.size(), kPlacedPerTask, [this](size_t begin, size_t end, UInt32) {
    for (size_t place = begin; place < end; ++place) {
      size_t count = 0;
      ForRangesNear(place, [&count](size_t first, size_t last, const auto& isPair) {
        for (size_t other = first; other < last; ++other) {
          count += isPair(other) ? 1 : 0;
        }
      });
      m_pairStart[place + 1] = count;
    }
  });
}

void CRABRouting::ReserveScratch(CThreadPool& pool) {
  size_t most = 0;
  for (size_t place = 0; place < m_placed.size(); ++place) {
    most = std::max(most, m_pairStart[place + 1]);
    m_pairStart[place + 1] += m_pairStart[place];
  }
  ResizeWithSpare(m_hearings, m_pairStart.back());
  m_numHearings.resize(m_placed.size());
  m_scratch.resize(std::max<size_t>(m_scratch.size(), pool.GetNumThreads()));
  for (SScratch& scratch : m_scratch) {
    // FindPairs() writes one beyond the last
    if (scratch.Pairs.size() < most + 1) {
      scratch.Pairs.resize(most + most / 2 + 1);
      scratch.Fan.Reserve(scratch.Pairs.size());
    }
    if (m_period.IsOn() && scratch.Ends.size() < scratch.Pairs.size()) {
      scratch.Ends.resize(scratch.Pairs.size());
    }
  }
}

// to the nearest image
Real CRABRouting::ComputeSquareDistance(const SPlaced& device, const SPlaced& other) const {
  const Real dx = m_period.X.Shorten(other.End.X - device.End.X);
  const Real dy = m_period.Y.Shorten(other.End.Y - device.End.Y);
  const Real dz = other.End.Z - device.End.Z;
  return dx * dx + dy * dy + dz * dz;
}

// lists the places of the devices that one device has to examine; @return their number
size_t CRABRouting::FindPairs(size_t place, std::vector<UInt32>& pairs) const {
  size_t num = 0;
  UInt32* const list = pairs.data();
  ForRangesNear(place, [&num, list](size_t first, size_t last, const auto& isPair) {
    for (size_t other = first; other < last; ++other) {
      // a branch would be mispredicted often
      list[num] = static_cast<UInt32>(other);
      num += isPair(other) ? 1 : 0;
    }
  });
  const SPlaced& device = m_placed[place];
  const Real squareRange = device.Range * device.Range;
  const auto isOut = [&](UInt32 number) {
    const SPlaced& other = m_placed[number];
    return ComputeSquareDistance(device, other) >= squareRange ||
           other.MessageSize != device.MessageSize ||
           (other.Range == device.Range && other.Device <= device.Device);
  };
  return static_cast<size_t>(std::remove_if(list, list + num, isOut) - list);
}

void CRABRouting::ExaminePairsOf(size_t place, SScratch& scratch, const CLineOfSight* sight) {
  const size_t num = FindPairs(place, scratch.Pairs);
  const SPlaced& device = m_placed[place];
  if (sight != nullptr) {
    scratch.Fan.Start(device.End);
    for (size_t pair = 0; pair < num; ++pair) {
      const SPlaced& other = m_placed[scratch.Pairs[pair]];
      const CSightFan::SEnd* end = &other.End;
      if (m_period.IsOn()) {
        scratch.Ends[pair] = MakeNearest(other.End, device.End);
        end = &scratch.Ends[pair];
      }
      // the direction does not depend on the examining device, so neither do the roundings
      scratch.Fan.Add(*end, device.Device < other.Device);
    }
    scratch.Fan.Trace(*sight);
  }
  THearing* const first = m_hearings.data() + m_pairStart[place];
  THearing* next = first;
  for (size_t pair = 0; pair < num; ++pair) {
    if (sight != nullptr && !scratch.Fan.IsClear(pair)) {
      continue;
    }
    const SPlaced& other = m_placed[scratch.Pairs[pair]];
    const bool isMutual = ComputeSquareDistance(device, other) < other.Range * other.Range;
    *next++ = other.Device | (isMutual ? kMutual : 0);
  }
  m_numHearings[place] = static_cast<UInt32>(next - first);
  ARGOS_ASSERT(m_pairStart[place] + m_numHearings[place] <= m_pairStart[place + 1],
               "a device has more hearings than pairs: " << m_numHearings[place]);
}

void CRABRouting::ExaminePairs(CThreadPool& pool, const CLineOfSight* sight) {
  pool.ParallelFor(m_placed.size(), kPlacedPerTask, [&](size_t begin, size_t end, UInt32 thread) {
    for (size_t place = begin; place < end; ++place) {
      ExaminePairsOf(place, m_scratch[thread], sight);
    }
  });
}

// calls visit(examining device, hearing), by the number of the device
template <typename VISIT>
void CRABRouting::ForHearings(VISIT&& visit) const {
  for (const UInt32 device : m_finite) {
    const UInt32 place = m_placeOf[device];
    const THearing* const first = m_hearings.data() + m_pairStart[place];
    std::for_each(first, first + m_numHearings[place],
                  [&](THearing hearing) { visit(device, hearing); });
  }
}

void CRABRouting::CollectByReceiver(CThreadPool& pool) {
  const size_t num = m_devices.GetSize();
  m_senderStart.assign(num + 1, 0);
  ForHearings([this](UInt32 device, THearing hearing) {
    ++m_senderStart[(hearing & ~kMutual) + 1];
    m_senderStart[device + 1] += (hearing & kMutual) != 0 ? 1 : 0;
  });
  m_cursor.resize(num);
  for (size_t device = 0; device < num; ++device) {
    m_senderStart[device + 1] += m_senderStart[device];
    m_cursor[device] = m_senderStart[device];
  }
  ResizeWithSpare(m_senders, m_senderStart.back());
  const auto append = [this](UInt32 receiver, UInt32 sender) {
    m_senders[m_cursor[receiver]++] = sender;
  };
  ForHearings([&](UInt32 device, THearing hearing) { append(hearing & ~kMutual, device); });
  if (m_areRangesEqual) {
    // All pairs are mutual, and the senders with lower numbers, which have examined theirs, are
    // listed in order. Each device is now appended to the lists of these, in order, too.
    for (const UInt32 device : m_finite) {
      for (UInt32 i = m_senderStart[device], end = m_cursor[device]; i < end; ++i) {
        append(m_senders[i], device);
      }
    }
    return;
  }
  ForHearings([&](UInt32 device, THearing hearing) {
    if ((hearing & kMutual) != 0) {
      append(device, hearing & ~kMutual);
    }
  });
  pool.ParallelFor(num, kPlacedPerTask, [this](size_t begin, size_t end, UInt32) {
    for (size_t device = begin; device < end; ++device) {
      std::sort(m_senders.begin() + m_senderStart[device],
                m_senders.begin() + m_senderStart[device + 1]);
    }
  });
}

}  // namespace argos
