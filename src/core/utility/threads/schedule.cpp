#include <argos3/core/utility/threads/schedule.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>

namespace argos {

void CBalanceQuantitySchedule::Start(size_t items, size_t grain, UInt32 threads) {
  const size_t grains = (items + grain - 1) / grain;
  m_items = items;
  m_share = (grains + threads - 1) / threads * grain;
  if (m_taken.size() < threads) {
    m_taken.resize(threads);
  }
  for (STaken& taken : m_taken) {
    taken.Value = false;
  }
}

bool CBalanceQuantitySchedule::Next(UInt32 thread, size_t& begin, size_t& end) {
  if (m_taken[thread].Value) {
    return false;
  }
  m_taken[thread].Value = true;
  begin = std::min(m_items, thread * m_share);
  end = std::min(m_items, begin + m_share);
  return begin < end;
}

void CBalanceLengthSchedule::Start(size_t items, size_t grain, UInt32) {
  m_items = items;
  m_chunk = grain;
  m_next.store(0, std::memory_order_relaxed);
}

bool CBalanceLengthSchedule::Next(UInt32, size_t& begin, size_t& end) {
  begin = m_next.fetch_add(m_chunk, std::memory_order_relaxed);
  end = std::min(m_items, begin + m_chunk);
  return begin < m_items;
}

std::unique_ptr<CSchedule> CreateSchedule(const std::string& method) {
  if (method == "balance_quantity") {
    return std::make_unique<CBalanceQuantitySchedule>();
  }
  if (method == "balance_length") {
    return std::make_unique<CBalanceLengthSchedule>();
  }
  if (CFactory<CSchedule>::Exists(method)) {
    return std::unique_ptr<CSchedule>(CFactory<CSchedule>::New(method));
  }
  std::vector<std::string> known = CFactory<CSchedule>::GetLabels();
  known.insert(known.end(), {"balance_quantity", "balance_length"});
  THROW_ARGOSEXCEPTION("unknown thread balancing method \"" << method << "\""
                                                            << DidYouMean(method, known));
}

}  // namespace argos
