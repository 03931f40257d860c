#ifndef ARGOS3_CAMPAIGN_EXECUTION_OUTPUT_TAIL_H
#define ARGOS3_CAMPAIGN_EXECUTION_OUTPUT_TAIL_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>
#include <string_view>

namespace argos {

/**
 * The end of what a run prints, in bounded memory.
 *
 * What exceeds the limit is dropped, but for its very end: the report of a crash comes last. The
 * text is then the end of what was within the limit, a line that says how much was dropped, and
 * the last bytes.
 */
class COutputTail {
 public:
  static constexpr size_t kSize = 16 << 10; /**< bytes that are kept */
  static constexpr size_t kSizeBeyond = 4 << 10; /**< of them for the end, if much was dropped */

  /** @param limit  bytes; 0: none. */
  explicit COutputTail(UInt64 limit) : m_limit(limit) {}

  void Add(std::string_view text);
  /** All that was added, also what was dropped. */
  UInt64 GetNumBytes() const { return m_numBytes; }
  std::string GetText() const;
  void Clear();

 private:
  UInt64 m_limit;
  UInt64 m_numBytes = 0;
  std::string m_within;  // at most twice what is kept
  std::string m_beyond;
};

}  // namespace argos

#endif
