#include <argos3/plugins/simulator/outputs/recording/format/entity_table.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/plugins/simulator/outputs/recording/format/type_coding.h>

#include <iterator>

namespace argos {

namespace {

// more than any simulation has: a damaged file must not use up the memory
constexpr size_t kMaxPoses = size_t(1) << 23;
constexpr size_t kMaxWords = size_t(1) << 26;

void WriteChangedTable(bool isRestart, const std::vector<SRecordedType>& types,
                       const std::vector<UInt32>& removed,
                       const std::vector<SRecordedEntity>& added, CByteWriter& out) {
  out.WriteByte(isRestart ? 1 : 0);
  out.WriteNumber(types.size());
  for (const SRecordedType& type : types) {
    WriteType(type, out);
  }
  out.WriteNumber(removed.size());
  UInt32 next = 0;
  for (const UInt32 number : removed) {
    out.WriteNumber(number - next);
    next = number + 1;
  }
  out.WriteNumber(added.size());
  for (const SRecordedEntity& entity : added) {
    out.WriteText(entity.Id);
    out.WriteNumber(entity.Type);
  }
  // older readers ignore the rest
  for (const SRecordedType& type : types) {
    WriteSolids(type, out);
  }
}

}  // namespace

void CEntityTable::WriteChanges(const SFrameUpdate& update, CByteWriter& out) {
  WriteChangedTable(update.IsRestart, update.NewTypes, update.Removed, update.Added, out);
}

void CEntityTable::WriteAll(CByteWriter& out) const {
  WriteChangedTable(true, m_types, {}, m_entities, out);
}

SFrameUpdate CEntityTable::ReadChanges(CByteReader& in) {
  SFrameUpdate update;
  update.IsRestart = in.ReadByte() != 0;
  for (size_t types = in.ReadCount("number of types"); types > 0; --types) {
    update.NewTypes.push_back(ReadType(in));
  }
  UInt64 next = 0;
  for (size_t removed = in.ReadCount("number of removed entities"); removed > 0; --removed) {
    next += in.ReadNumberUpTo(~UInt32(0), "number of a removed entity");
    if (next >= ~UInt32(0)) {
      THROW_ARGOSEXCEPTION("it removes an entity that it does not have");
    }
    update.Removed.push_back(static_cast<UInt32>(next++));
  }
  for (size_t added = in.ReadCount("number of added entities"); added > 0; --added) {
    SRecordedEntity entity;
    entity.Id = in.ReadText();
    entity.Type = static_cast<UInt32>(in.ReadNumberUpTo(~UInt32(0), "type of an entity"));
    update.Added.push_back(std::move(entity));
  }
  if (!in.IsAtEnd()) {
    for (SRecordedType& type : update.NewTypes) {
      ReadSolids(type, in);
    }
  }
  return update;
}

CEntityTable::SChange CEntityTable::Apply(SFrameUpdate& update) {
  SChange change;
  change.IsRestart = update.IsRestart;
  change.IsEmpty = !update.IsRestart && update.Removed.empty() && update.Added.empty();
  if (update.IsRestart) {
    *this = CEntityTable();
  }
  std::move(update.NewTypes.begin(), update.NewTypes.end(), std::back_inserter(m_types));
  if (!update.Removed.empty()) {
    Remove(update.Removed, change);
  }
  Add(std::move(update.Added), change);
  return change;
}

void CEntityTable::Remove(const std::vector<UInt32>& removed, SChange& change) {
  if (removed.back() >= m_entities.size()) {
    THROW_ARGOSEXCEPTION("it removes entity number " << removed.back() << " of "
                                                     << m_entities.size());
  }
  ARGOS_ASSERT(std::is_sorted(removed.begin(), removed.end()),
               "numbers of removed entities ascend");
  size_t next = 0;
  size_t kept = 0;
  for (size_t i = 0; i < m_entities.size(); ++i) {
    const SRecordedType& type = m_types[m_entities[i].Type];
    const bool isRemoved = next < removed.size() && removed[next] == i;
    change.RemovedPoses.insert(change.RemovedPoses.end(), type.GetNumPoses(), isRemoved);
    change.RemovedWords.insert(change.RemovedWords.end(), type.GetNumWords(), isRemoved);
    if (isRemoved) {
      ++next;
      m_numPoses -= type.GetNumPoses();
      m_numWords -= type.GetNumWords();
    } else if (kept++ != i) {
      m_entities[kept - 1] = std::move(m_entities[i]);
    }
  }
  m_entities.resize(kept);
}

void CEntityTable::Add(std::vector<SRecordedEntity>&& added, SChange& change) {
  for (SRecordedEntity& entity : added) {
    if (entity.Type >= m_types.size()) {
      THROW_ARGOSEXCEPTION("the type of its entity \"" << entity.Id << "\" has the number "
                                                       << entity.Type << ", but it has only "
                                                       << m_types.size() << " types");
    }
    const SRecordedType& type = m_types[entity.Type];
    change.NumAddedPoses += type.GetNumPoses();
    change.NumAddedWords += type.GetNumWords();
    m_numPoses += type.GetNumPoses();
    m_numWords += type.GetNumWords();
    if (m_numPoses > kMaxPoses || m_numWords > kMaxWords) {
      THROW_ARGOSEXCEPTION("it has more entities than can be replayed");
    }
    m_entities.push_back(std::move(entity));
  }
}

}  // namespace argos
