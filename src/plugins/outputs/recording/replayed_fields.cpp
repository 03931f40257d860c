#include <argos3/plugins/simulator/outputs/recording/replayed_fields.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace argos {

namespace {

class CReplayedReader : public CFieldReader {
 public:
  CReplayedReader(std::shared_ptr<const SReplayedColumns> columns,
                  std::shared_ptr<const std::size_t> row, std::string field,
                  std::vector<SColumn> bound)
      : m_columns(std::move(columns)),
        m_row(std::move(row)),
        m_field(std::move(field)),
        m_bound(std::move(bound)) {}

  void Read(std::size_t /*index*/, SFieldRow row) override {
    // a file may have other columns in other states
    for (const SRecordedColumn& column : m_columns->Columns) {
      const auto found = std::ranges::find(m_bound, column.Name, &SColumn::Name);
      if (column.Field != m_field || found == m_bound.end() ||
          (found->Kind == EColumnKind::Text) != column.IsText || *m_row >= column.Values.size()) {
        continue;
      }
      const Real value = column.Values[*m_row];
      double& number = row.Numbers[found - m_bound.begin()];
      if (!column.IsText) {
        number = value;
      } else if (value >= 0.0 && value < static_cast<Real>(column.Texts.size())) {
        number = row.Texts.Add(column.Texts[static_cast<std::size_t>(value)]);
      }
    }
  }

 private:
  std::shared_ptr<const SReplayedColumns> m_columns;
  std::shared_ptr<const std::size_t> m_row;
  std::string m_field;
  std::vector<SColumn> m_bound;
};

}  // namespace

SBoundField CReplayedFields::Bind(const std::string& name) const {
  SBoundField bound;
  if (m_columns == nullptr) {
    return bound;
  }
  for (const SRecordedColumn& column : m_columns->Columns) {
    if (column.Field == name) {
      bound.Columns.push_back(
          {column.Name, column.Unit, column.IsText ? EColumnKind::Text : EColumnKind::Number});
    }
  }
  if (!bound.Columns.empty()) {
    bound.Reader = std::make_unique<CReplayedReader>(m_columns, m_row, name, bound.Columns);
  }
  return bound;
}

void CReplayedFields::List(std::vector<std::string>& names) const {
  if (m_columns == nullptr) {
    return;
  }
  for (const SRecordedColumn& column : m_columns->Columns) {
    if (std::find(names.begin(), names.end(), column.Field) == names.end()) {
      names.push_back(column.Field);
    }
  }
}

}  // namespace argos
