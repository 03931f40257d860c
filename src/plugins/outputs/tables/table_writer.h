#ifndef ARGOS3_PLUGINS_OUTPUTS_TABLES_TABLE_WRITER_H
#define ARGOS3_PLUGINS_OUTPUTS_TABLES_TABLE_WRITER_H

#include <argos3/core/utility/non_copyable.h>
#include <argos3/plugins/simulator/outputs/tables/row_block.h>
#include <argos3/plugins/simulator/outputs/tables/table_format.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace argos {

/**
 * Formats and writes the rows of one file on a thread of its own.
 *
 * If rows come faster than they can be written, the caller waits: at most kMaxWaiting blocks are
 * stored.
 */
class CTableWriter : private CNonCopyable {
 public:
  /** @param format  of the file; not null. */
  CTableWriter(std::string path, std::unique_ptr<CTableFormat> format);
  /** Closes the file; a failure is lost: call Close() before. */
  ~CTableWriter();

  const std::string& GetPath() const { return m_path; }
  bool IsOpen() const { return m_thread.joinable(); }
  /** @return true until Open() is called: a file that failed to open is not tried again. */
  bool CanOpen() const { return !m_wasOpened; }
  /** Creates the file and starts the thread. @throws CARGoSException if that fails. */
  void Open(const STableSchema& schema);
  /** Adds columns of numbers after the others: rows until now have no values there. */
  void AddColumns(const std::vector<SColumn>& columns);
  /** The block that takes the next rows. */
  SRowBlock& GetBlock() { return *m_current; }
  /**
   * To be called when the rows of a tick are complete: hands the block over if it is full or old.
   * @throws CARGoSException if earlier rows could not be written.
   */
  void EndTick();
  /** Returns when all rows are in the file. @throws CARGoSException if that failed. */
  void Finish();
  /** The same, and closes the file and ends the thread. */
  void Close();

 private:
  using TBlock = std::unique_ptr<SRowBlock>;

  static constexpr std::size_t kMaxWaiting = 4;  // blocks
  static constexpr std::size_t kFullRows = 8192;
  static constexpr std::chrono::seconds kOldest{1};  // longest time that rows wait for others

  void Work();
  void WriteBlock(SRowBlock& block);
  void Push();
  void ThrowFailure();

  std::string m_path;
  std::unique_ptr<CTableFormat> m_format;
  STableSchema m_schema;
  TBlock m_current;
  std::chrono::steady_clock::time_point m_lastPush;
  bool m_wasOpened = false;
  bool m_wasFailureThrown = false;

  std::mutex m_mutex;  // guards all below
  std::condition_variable m_changed;
  std::vector<TBlock> m_waiting;  // the next one first
  std::vector<TBlock> m_free;
  bool m_isWriting = false;
  bool m_isEnding = false;
  std::exception_ptr m_failure;
  std::thread m_thread;
};

}  // namespace argos

#endif
