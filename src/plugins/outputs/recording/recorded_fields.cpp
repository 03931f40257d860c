#include <argos3/plugins/simulator/outputs/recording/recorded_fields.h>

#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <cmath>
#include <limits>
#include <unordered_map>

namespace argos {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::vector<SFieldName> ReadFields(const std::string& location, const std::string& fields) {
  std::vector<SFieldName> names = ReadFieldNames(location, fields);
  for (const SFieldName& name : names) {
    if (name.Field->IsList()) {
      THROW_ARGOSEXCEPTION(location << ": \"fields\": \"" << name.Name
                                    << "\" is a list of rows, which a recording cannot have; "
                                       "<table> writes it");
    }
    if (name.Field->GetNumRaw() > 0) {
      THROW_ARGOSEXCEPTION(location << ": \"fields\": \"" << name.Name
                                    << "\" needs no recording: tables of a replay compute it from "
                                       "the poses");
    }
  }
  return names;
}

/* The texts of a column, each once. */
class CTextNumbers {
 public:
  explicit CTextNumbers(std::vector<std::string>& texts) : m_texts(texts) {}

  Real Get(std::string_view text) {
    const auto [found, isNew] =
        m_numbers.try_emplace(std::string(text), static_cast<Real>(m_texts.size()));
    if (isNew) {
      m_texts.emplace_back(text);
    }
    return found->second;
  }

 private:
  std::vector<std::string>& m_texts;
  std::unordered_map<std::string, Real> m_numbers;
};

}  // namespace

CRecordedFields::CRecordedFields(const std::string& location, const std::string& fields,
                                 CSpace& space)
    : m_rows(location, ReadFields(location, fields), {}) {
  m_rows.Resolve(space);
}

void CRecordedFields::FindNumbers(CSpace& space) {
  std::unordered_map<const CEntity*, UInt32> numbers;
  UInt32 number = 0;
  for (const CEntity* root : space.GetRootEntityVector()) {
    numbers[root] = number++;
  }
  m_numEntities = number;
  m_numbers.resize(m_rows.GetNumEntities());
  for (std::size_t i = 0; i < m_numbers.size(); ++i) {
    m_numbers[i] = numbers.at(&m_rows.GetEntity(i));
  }
}

void CRecordedFields::Take(CSpace& space, SFrameUpdate& update) {
  m_rows.Update(space);
  if (update.IsRestart || !update.Added.empty() || !update.Removed.empty() ||
      m_numbers.size() != m_rows.GetNumEntities()) {
    FindNumbers(space);
  }
  m_block.Clear();
  m_rows.Read(m_block);
  std::size_t index = 0;
  for (const auto& [field, column] : m_rows.ListColumns()) {
    AddColumn(index++, field, column, update);
  }
}

void CRecordedFields::AddColumn(std::size_t index, const std::string& field, const SColumn& column,
                                SFrameUpdate& update) const {
  const bool isText = column.Kind == EColumnKind::Text;
  SRecordedColumn& recorded =
      update.Columns.emplace_back(SRecordedColumn{field, column.Name, column.Unit, isText, {}, {}});
  recorded.Values.assign(m_numEntities, kNone);
  CTextNumbers texts(recorded.Texts);
  const std::size_t numNumbers = m_numbers.empty() ? 0 : m_block.Numbers.size() / m_numbers.size();
  for (std::size_t row = 0; row < m_numbers.size(); ++row) {
    ARGOS_ASSERT(index < numNumbers, "a row has no number " << index);
    const double value = m_block.Numbers[row * numNumbers + index];
    ARGOS_ASSERT(m_numbers[row] < recorded.Values.size(),
                 "there is no entity number " << m_numbers[row]);
    Real& place = recorded.Values[m_numbers[row]];
    place = isText && !std::isnan(value) ? texts.Get(m_block.Texts.Get(value)) : value;
  }
}

}  // namespace argos
