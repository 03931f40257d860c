#include <argos3/plugins/simulator/outputs/tables/table_writer.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/threads/signal_stack.h>

#include <utility>

namespace argos {

CTableWriter::CTableWriter(std::string path, std::unique_ptr<CTableFormat> format)
    : m_path(std::move(path)),
      m_format(std::move(format)),
      m_current(std::make_unique<SRowBlock>()) {
  // one is written, one takes rows
  m_waiting.reserve(kMaxWaiting);
  m_free.reserve(kMaxWaiting + 2);
}

CTableWriter::~CTableWriter() {
  try {
    Close();
  } catch (...) {
    // the owner that wants to know has called Close()
    return;
  }
}

void CTableWriter::Open(const STableSchema& schema) {
  m_wasOpened = true;
  m_schema = schema;
  m_format->Open(m_path, m_schema);
  m_lastPush = std::chrono::steady_clock::now();
  m_thread = std::thread([this] {
    CSignalStack::Use();
    Work();
  });
}

void CTableWriter::AddColumns(const std::vector<SColumn>& columns) {
  if (m_current->NumRows > 0) {
    Push();
  }
  m_current->NewColumns.insert(m_current->NewColumns.end(), columns.begin(), columns.end());
}

void CTableWriter::EndTick() {
  if (m_current->NumRows >= kFullRows ||
      (m_current->NumRows > 0 && std::chrono::steady_clock::now() - m_lastPush >= kOldest)) {
    Push();
  }
  const std::lock_guard<std::mutex> lock(m_mutex);
  ThrowFailure();
}

void CTableWriter::Push() {
  m_lastPush = std::chrono::steady_clock::now();
  std::unique_lock<std::mutex> lock(m_mutex);
  m_changed.wait(lock, [this] { return m_waiting.size() < kMaxWaiting; });
  m_waiting.push_back(std::move(m_current));
  if (m_free.empty()) {
    m_current = std::make_unique<SRowBlock>();
  } else {
    ARGOS_ASSERT(m_free.back() != nullptr && m_free.back()->NumRows == 0, "a free block has rows");
    m_current = std::move(m_free.back());
    m_free.pop_back();
  }
  lock.unlock();
  m_changed.notify_all();
}

void CTableWriter::Finish() {
  if (!IsOpen()) {
    return;
  }
  if (m_current->NumRows > 0) {
    Push();
  }
  std::unique_lock<std::mutex> lock(m_mutex);
  m_changed.wait(lock, [this] { return m_waiting.empty() && !m_isWriting; });
  ThrowFailure();
}

void CTableWriter::Close() {
  if (!IsOpen()) {
    return;
  }
  if (m_current->NumRows > 0) {
    Push();
  }
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_isEnding = true;
  }
  m_changed.notify_all();
  m_thread.join();
  try {
    m_format->Close();
  } catch (...) {
    if (m_failure == nullptr) {
      m_failure = std::current_exception();
    }
  }
  ThrowFailure();
}

// once: the run ends by it
void CTableWriter::ThrowFailure() {
  if (m_failure != nullptr && !std::exchange(m_wasFailureThrown, true)) {
    std::rethrow_exception(m_failure);
  }
}

void CTableWriter::Work() {
  std::unique_lock<std::mutex> lock(m_mutex);
  while (true) {
    m_changed.wait(lock, [this] { return m_isEnding || !m_waiting.empty(); });
    if (m_waiting.empty()) {
      return;
    }
    TBlock block = std::move(m_waiting.front());
    m_waiting.erase(m_waiting.begin());
    m_isWriting = true;
    const bool hasFailed = m_failure != nullptr;
    lock.unlock();
    m_changed.notify_all();
    std::exception_ptr failure;
    try {
      if (!hasFailed) {
        WriteBlock(*block);
      }
    } catch (...) {
      failure = std::current_exception();
    }
    block->Clear();
    lock.lock();
    m_failure = m_failure != nullptr ? m_failure : failure;
    m_free.push_back(std::move(block));
    m_isWriting = false;
    m_changed.notify_all();
  }
}

void CTableWriter::WriteBlock(SRowBlock& block) {
  if (!block.NewColumns.empty()) {
    m_schema.AddColumns(block.NewColumns);
    m_format->AddColumns(block.NewColumns);
  }
  for (const STableSchema::SDerivation& derivation : m_schema.Derivations) {
    ARGOS_ASSERT(
        block.Numbers.size() >= block.NumRows * m_schema.NumNumbers &&
            derivation.Start < m_schema.NumNumbers,
        "a block of " << block.NumRows << " rows has " << block.Numbers.size() << " numbers");
    double* numbers = block.Numbers.data() + derivation.Start;
    for (std::size_t row = 0; row < block.NumRows; ++row, numbers += m_schema.NumNumbers) {
      derivation.Field->Derive(numbers);
    }
  }
  m_format->Write(block);
}

}  // namespace argos
