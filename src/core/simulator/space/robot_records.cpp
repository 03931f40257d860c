#include <argos3/core/simulator/space/robot_records.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <utility>

namespace argos {

CRobotRecords::SThread*& CRobotRecords::CurrentThread() {
  thread_local SThread* thread = nullptr;
  return thread;
}

CRobotRecords::CScope::CScope(CRobotRecords& records, UInt32 thread)
    : m_thread(records.m_threads[thread]), m_previous(std::exchange(CurrentThread(), &m_thread)) {}

CRobotRecords::CScope::~CScope() {
  CurrentThread() = m_previous;
}

void CRobotRecords::Begin(size_t robots, UInt32 threads) {
  ARGOS_ASSERT(threads > 0, "a loop over robots needs a thread");
  m_numRobots = robots;
  if (m_threads.size() != threads) {
    m_threads.clear();
    m_threads.resize(threads);
    for (SThread& thread : m_threads) {
      thread.Owner = this;
      thread.Records.reserve(m_capacity);
    }
  }
  Clear();
}

// a robot may run a simulation of its own: the thread is then one of another loop
CRobotRecords::SThread* CRobotRecords::FindThread() const {
  SThread* const thread = CurrentThread();
  return thread != nullptr && thread->Owner == this ? thread : nullptr;
}

bool CRobotRecords::TryAdd(UInt32 metric, Real value) {
  SThread* const thread = FindThread();
  if (thread == nullptr) {
    return false;
  }
  thread->Records.push_back({thread->Robot, metric, value, true});
  return true;
}

bool CRobotRecords::TryAdd(std::string_view name, std::string_view unit, Real value) {
  SThread* const thread = FindThread();
  if (thread == nullptr) {
    return false;
  }
  std::vector<SNewMetric>& metrics = thread->NewMetrics;
  auto metric = std::find_if(metrics.begin(), metrics.end(), [&](const SNewMetric& known) {
    return known.Name == name && known.Unit == unit;
  });
  if (metric == metrics.end()) {
    metrics.push_back({std::string(name), std::string(unit)});
    metric = metrics.end() - 1;
  }
  thread->Records.push_back(
      {thread->Robot, static_cast<UInt32>(metric - metrics.begin()), value, false});
  return true;
}

bool CRobotRecords::IsEmpty() const {
  return std::ranges::all_of(m_threads, std::ranges::empty, &SThread::Records);
}

void CRobotRecords::Sort() {
  size_t numRecords = 0;
  for (const SThread& thread : m_threads) {
    numRecords += thread.Records.size();
  }
  m_order.Start(numRecords, m_numRobots);
  size_t item = 0;
  for (const SThread& thread : m_threads) {
    for (const SRecord& record : thread.Records) {
      ARGOS_ASSERT(record.Robot < m_numRobots, "robot number " << record.Robot << " of "
                                                               << m_numRobots
                                                               << " has recorded a metric");
      m_order.SetKey(item++, record.Robot);
    }
  }
  m_order.Finish();
  m_sorted.resize(numRecords);
  item = 0;
  for (const SThread& thread : m_threads) {
    for (const SRecord& record : thread.Records) {
      m_sorted[m_order.GetPlace(item++)] = {&record, &thread};
    }
  }
}

// leaves spare room: robots may not record in every tick
void CRobotRecords::ReserveForAll(size_t records) {
  if (records <= m_capacity) {
    return;
  }
  m_capacity = records + records / 2;
  for (SThread& thread : m_threads) {
    thread.Records.reserve(m_capacity);
  }
  m_order.Reserve(m_capacity, m_numRobots);
  m_sorted.reserve(m_capacity);
}

void CRobotRecords::Clear() {
  ReserveForAll(m_sorted.size());
  m_sorted.clear();
  for (SThread& thread : m_threads) {
    thread.Records.clear();
    thread.NewMetrics.clear();
  }
}

}  // namespace argos
