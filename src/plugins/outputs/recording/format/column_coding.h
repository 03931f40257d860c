#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_COLUMN_CODING_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_COLUMN_CODING_H

#include <argos3/support/byte_stream.h>

#include <span>
#include <vector>

namespace argos {

/**
 * Values that change in time, such as the x of all robots: coded as differences to the straight
 * line through the two last ones, which are near 0 for what moves steadily and 0 for what rests.
 *
 * Encoder and decoder have one each, with the same calls in the same order. Sums wrap around, so
 * that any 64 bits are coded without loss.
 */
class CPredictedColumn {
 public:
  size_t GetSize() const { return m_last.size(); }
  /** Predicts 0 from now on, for @p size values. */
  void Restart(size_t size);
  /** Adds values at the end, which are predicted as 0 at first. */
  void Append(size_t count);
  /** Removes the values whose flag is set. @param isRemoved (size) */
  void Remove(const std::vector<bool>& isRemoved);

  /** @param values (size) */
  void Encode(std::span<const SInt64> values, CByteWriter& out);
  /** @param values (size) @throws CARGoSException if the bytes are no column. */
  void Decode(std::span<SInt64> values, CByteReader& in);

 private:
  UInt64 Predict(size_t i) const { return 2 * m_last[i] - m_beforeLast[i]; }
  void FinishNew();

  std::vector<UInt64> m_last;
  std::vector<UInt64> m_beforeLast;
  std::vector<UInt8> m_isNew;  // 1: predicted as 0
  bool m_hasNew = false;  // any of them
};

/** Writes numbers of which many are 0: these are counted, not listed. */
class CSparseWriter {
 public:
  explicit CSparseWriter(CByteWriter& out) : m_out(out) {}
  void Write(UInt64 value) {
    if (value == 0) {
      ++m_zeros;
      return;
    }
    Flush();
    m_out.WriteNumber(value);
  }
  /** After the last number. */
  void Flush() {
    if (m_zeros > 0) {
      m_out.WriteByte(0);
      m_out.WriteNumber(m_zeros - 1);
      m_zeros = 0;
    }
  }

 private:
  CByteWriter& m_out;
  UInt64 m_zeros = 0;
};

/** Reads what CSparseWriter wrote. */
class CSparseReader {
 public:
  explicit CSparseReader(CByteReader& in) : m_in(in) {}
  UInt64 Read() {
    if (m_zeros > 0) {
      --m_zeros;
      return 0;
    }
    const UInt64 value = m_in.ReadNumber();
    if (value == 0) {
      m_zeros = m_in.ReadNumber();
    }
    return value;
  }

 private:
  CByteReader& m_in;
  UInt64 m_zeros = 0;  // number of zeros that follow
};

}  // namespace argos

#endif
