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
  /** Bytes that are kept. */
  static constexpr size_t kSize = 16 << 10;
  /** Those of them that are kept for the end of the text if its middle was dropped. */
  static constexpr size_t kSizeBeyond = 4 << 10;

  /** @param limit  in bytes; 0 means unlimited. */
  explicit COutputTail(UInt64 limit) : m_limit(limit) {}

  void Add(std::string_view text);
  /** All that was added, also what was dropped. */
  UInt64 GetNumBytes() const { return m_numBytes; }
  std::string GetText() const;
  void Clear();

 private:
  UInt64 m_limit;
  UInt64 m_numBytes = 0;
  std::string m_within;  // has at most twice the bytes that are kept
  std::string m_beyond;
};

}  // namespace argos

#endif
