#include <argos3/plugins/simulator/outputs/recording/format/column_coding.h>

#include <argos3/core/utility/errors/argos_exception.h>

namespace argos {

void CPredictedColumn::Restart(size_t size) {
  m_last.assign(size, 0);
  m_beforeLast.assign(size, 0);
  m_isNew.assign(size, 1);
  m_hasNew = size > 0;
}

void CPredictedColumn::Append(size_t count) {
  const size_t size = GetSize() + count;
  m_last.resize(size, 0);
  m_beforeLast.resize(size, 0);
  m_isNew.resize(size, 1);
  m_hasNew = m_hasNew || count > 0;
}

void CPredictedColumn::Remove(const std::vector<bool>& isRemoved) {
  ARGOS_ASSERT(isRemoved.size() == GetSize(), "flags of another number of values");
  size_t kept = 0;
  for (size_t i = 0; i < GetSize(); ++i) {
    if (!isRemoved[i]) {
      m_last[kept] = m_last[i];
      m_beforeLast[kept] = m_beforeLast[i];
      m_isNew[kept] = m_isNew[i];
      ++kept;
    }
  }
  m_last.resize(kept);
  m_beforeLast.resize(kept);
  m_isNew.resize(kept);
}

// new values are predicted to rest after their first one
void CPredictedColumn::FinishNew() {
  for (size_t i = 0; m_hasNew && i < m_last.size(); ++i) {
    if (m_isNew[i] != 0) {
      m_beforeLast[i] = m_last[i];
      m_isNew[i] = 0;
    }
  }
  m_hasNew = false;
}

void CPredictedColumn::Encode(std::span<const SInt64> values, CByteWriter& out) {
  ARGOS_ASSERT(values.size() == GetSize(), "a column of another number of values");
  CSparseWriter sparse(out);
  for (size_t i = 0; i < values.size(); ++i) {
    const auto value = static_cast<UInt64>(values[i]);
    sparse.Write(CByteWriter::FoldSign(static_cast<SInt64>(value - Predict(i))));
    m_beforeLast[i] = m_last[i];
    m_last[i] = value;
  }
  sparse.Flush();
  FinishNew();
}

void CPredictedColumn::Decode(std::span<SInt64> values, CByteReader& in) {
  ARGOS_ASSERT(values.size() == GetSize(), "a column of another number of values");
  CSparseReader sparse(in);
  for (size_t i = 0; i < values.size(); ++i) {
    const UInt64 value = Predict(i) + static_cast<UInt64>(CByteReader::UnfoldSign(sparse.Read()));
    m_beforeLast[i] = m_last[i];
    m_last[i] = value;
    values[i] = static_cast<SInt64>(value);
  }
  FinishNew();
}

}  // namespace argos
