#include <argos3/plugins/simulator/outputs/tables/entity_rows.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/outputs/root_components.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/text/lists.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace argos {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// one entity of each type: enough for messages about names
std::vector<CEntity*> ChooseOneOfEachType(const std::vector<CEntity*>& entities) {
  std::set<std::string> types;
  std::vector<CEntity*> chosen;
  std::copy_if(entities.begin(), entities.end(), std::back_inserter(chosen),
               [&types](const CEntity* entity) {
                 return types.insert(entity->GetTypeDescription()).second;
               });
  return chosen;
}

bool HasController(CEntity& entity) {
  const auto* const robot = FindExisting<CControllableEntity>(entity);
  return robot != nullptr && robot->HasController();
}

}  // namespace

std::vector<std::string> SplitAtCommas(const std::string& text) {
  std::vector<std::string> items;
  Tokenize(text, items, ",");
  for (std::string& item : items) {
    const std::size_t first = item.find_first_not_of(" \t\n");
    const std::size_t last = item.find_last_not_of(" \t\n");
    item = first == std::string::npos ? "" : item.substr(first, last - first + 1);
  }
  std::erase(items, "");
  return items;
}

std::vector<SFieldName> ReadFieldNames(const std::string& location, const std::string& fields) {
  std::vector<SFieldName> names;
  for (const std::string& name : SplitAtCommas(fields)) {
    try {
      names.emplace_back(name);
    } catch (std::exception& error) {
      THROW_ARGOSEXCEPTION_NESTED(location << ": \"fields\"", error);
    }
  }
  if (names.empty()) {
    THROW_ARGOSEXCEPTION(location << ": \"fields\" lists no field; argos3 -q fields lists those "
                                     "that there are");
  }
  return names;
}

CEntityRows::CEntityRows(std::string location, std::vector<SFieldName> fields,
                         std::vector<std::string> types, std::vector<std::string> ids)
    : m_location(std::move(location)), m_types(std::move(types)), m_ids(std::move(ids)) {
  std::set<std::string> names;
  for (SFieldName& field : fields) {
    if (!names.insert(field.Name).second) {
      THROW_ARGOSEXCEPTION(m_location << ": the field \"" << field.Name << "\" is listed twice");
    }
    SPart part{std::move(field), {}};
    m_parts.push_back(std::move(part));
  }
  for (std::size_t i = 0; i < m_parts.size(); ++i) {
    if (!m_parts[i].Name.Field->IsList()) {
      continue;
    }
    if (m_list != nullptr) {
      THROW_ARGOSEXCEPTION(m_location << ": the fields \"" << m_list->Name.Name << "\" and \""
                                      << m_parts[i].Name.Name
                                      << "\" have lists of rows of their own: a table contains one "
                                         "such field at most");
    }
    m_list = &m_parts[i];
    m_listIndex = i;
  }
}

std::vector<CEntity*> CEntityRows::ListEntitiesOfTypes(CSpace& space) const {
  std::vector<CEntity*> entities;
  if (m_types.empty()) {
    for (CControllableEntity* robot : space.GetControllableEntities()) {
      entities.push_back(&robot->GetRootEntity());
    }
    return entities;
  }
  for (CEntity* root : space.GetRootEntityVector()) {
    if (std::count(m_types.begin(), m_types.end(), root->GetTypeDescription()) > 0) {
      entities.push_back(root);
    }
  }
  return entities;
}

std::vector<CEntity*> CEntityRows::ListEntities(CSpace& space) const {
  std::vector<CEntity*> entities = ListEntitiesOfTypes(space);
  if (!m_ids.empty()) {
    std::erase_if(entities, [this](const CEntity* entity) {
      return std::find(m_ids.begin(), m_ids.end(), entity->GetId()) == m_ids.end();
    });
  }
  return entities;
}

void CEntityRows::CheckIds(CSpace& space) const {
  std::vector<std::string> known;
  for (const CEntity* entity : ListEntitiesOfTypes(space)) {
    known.push_back(entity->GetId());
  }
  constexpr std::size_t kMaxListed = 20;
  for (const std::string& id : m_ids) {
    if (std::find(known.begin(), known.end(), id) != known.end()) {
      continue;
    }
    const std::string near = DidYouMean(id, known);
    const bool isList = near.starts_with("; known");
    THROW_ARGOSEXCEPTION(m_location << ": \"robots\": there is no "
                                    << (m_types.empty() ? "robot" : "such entity") << " \"" << id
                                    << "\" at the start"
                                    << (isList && known.size() > kMaxListed ? "" : near));
  }
}

void CEntityRows::Resolve(CSpace& space) {
  for (const std::string& type : m_types) {
    if (!space.HasEntityType(type)) {
      THROW_ARGOSEXCEPTION(m_location << ": \"of\": there are no entities <" << type << ">"
                                      << DidYouMean(type, space.GetEntityTypes()));
    }
  }
  if (!m_ids.empty()) {
    CheckIds(space);
  }
  Update(space);
}

bool CEntityRows::HaveEntitiesChanged(CSpace& space) {
  if (m_types.empty()) {
    const UInt64 version = space.GetVersionOfControllableEntities();
    const bool isSame = std::exchange(m_wereEntitiesListed, true) && version == m_robotsVersion;
    m_robotsVersion = version;
    return !isSame;
  }
  const CEntity::TVector& roots = space.GetRootEntityVector();
  const bool isSame = std::exchange(m_wereEntitiesListed, true) &&
                      std::equal(roots.begin(), roots.end(), m_roots.begin(), m_roots.end(),
                                 [](const CEntity* root, const SRoot& known) {
                                   return root == known.Entity && root->GetIndex() == known.Index;
                                 });
  if (!isSame) {
    m_roots.clear();
    for (CEntity* root : roots) {
      m_roots.push_back({root, root->GetIndex()});
    }
  }
  return !isSame;
}

void CEntityRows::Update(CSpace& space) {
  if (!HaveEntitiesChanged(space)) {
    return;
  }
  const std::vector<CEntity*> entities = ListEntities(space);
  std::map<std::pair<CEntity*, ssize_t>, std::size_t> known;
  for (std::size_t i = 0; i < m_entities.size(); ++i) {
    known[{m_entities[i].Entity, m_entities[i].Index}] = i;
  }
  std::vector<SEntityRows> now;
  now.reserve(entities.size());
  for (CEntity* entity : entities) {
    const auto found = known.find({entity, entity->GetIndex()});
    now.push_back(found != known.end() ? std::move(m_entities[found->second]) : Bind(*entity));
  }
  m_entities = std::move(now);
  if (!m_areColumnsKnown && !m_entities.empty()) {
    CheckFields(entities, space);
    CheckColumns();
    PlaceColumns();
    m_areColumnsKnown = true;
  }
}

CEntityRows::SEntityRows CEntityRows::Bind(CEntity& entity) {
  SEntityRows bound{&entity, entity.GetIndex(), m_nextNumber++, {}};
  m_newIds.push_back(entity.GetId());
  for (SPart& part : m_parts) {
    bound.Cells.push_back(BindCell(part, entity));
  }
  return bound;
}

CEntityRows::SCell CEntityRows::BindCell(SPart& part, CEntity& entity) {
  SBoundField bound = part.Name.Bind(entity);
  SCell cell;
  if (bound.Reader == nullptr) {
    return cell;
  }
  cell.Reader = std::move(bound.Reader);
  if (!m_areColumnsKnown) {
    AddColumns(part, bound);
  }
  bool isSame = true;
  for (std::size_t i = 0; i < bound.Columns.size(); ++i) {
    const auto found = std::ranges::find(part.Columns, bound.Columns[i].Name, &SColumn::Name);
    if (found == part.Columns.end()) {
      NoteExtraColumn(part, entity, bound.Columns[i].Name);
    }
    cell.Places.push_back(static_cast<std::size_t>(found - part.Columns.begin()));
    isSame = isSame && cell.Places.back() == i && i < part.Columns.size();
  }
  if (isSame) {
    cell.Places.clear();
  }
  return cell;
}

void CEntityRows::AddColumns(SPart& part, const SBoundField& bound) {
  for (const SColumn& column : bound.Columns) {
    if (std::ranges::find(part.Columns, column.Name, &SColumn::Name) == part.Columns.end()) {
      part.Columns.push_back(column);
    }
  }
}

void CEntityRows::NoteExtraColumn(SPart& part, const CEntity& entity,
                                  const std::string& column) const {
  if (!std::exchange(part.WasExtraColumnReported, true)) {
    LOGERR << "[WARNING] " << m_location << ": \"" << entity.GetId()
           << "\", which was added in the run, has the column \"" << column << "\" of the field \""
           << part.Name.Name
           << "\", which the table had begun without: it is left out. A table of its own (of=\""
           << entity.GetTypeDescription() << "\") has all columns" << std::endl;
  }
}

void CEntityRows::CheckFields(const std::vector<CEntity*>& entities, CSpace& /*space*/) {
  const bool haveControllers =
      std::ranges::any_of(entities, [](CEntity* entity) { return HasController(*entity); });
  std::string empty;
  for (std::size_t i = 0; i < m_parts.size(); ++i) {
    SPart& part = m_parts[i];
    if (!part.Columns.empty()) {
      continue;
    }
    if (part.Name.Field->NeedsController() && !haveControllers) {
      part.Columns = {{ToColumnName(part.Name.Name), ""}};
      AppendQuoted(empty, part.Name.Name);
      continue;
    }
    const bool isUnset =
        std::any_of(m_entities.begin(), m_entities.end(),
                    [i](const SEntityRows& rows) { return rows.Cells[i].Reader != nullptr; });
    THROW_ARGOSEXCEPTION(
        m_location << ": no " << (m_types.empty() ? "robot" : "such entity") << " has the field \""
                   << part.Name.Name << '"' << (isUnset ? " with a value at the start" : "")
                   << DidYouMean(part.Name.Name, ListFieldNames(ChooseOneOfEachType(entities))));
  }
  if (!empty.empty()) {
    LOGERR << "[WARNING] " << m_location
           << ": the robots have no controllers here, so these fields have no values: " << empty
           << std::endl;
  }
}

void CEntityRows::CheckColumns() const {
  std::map<std::string, std::string> fields = {
      {"run", "table"}, {"tick", "table"}, {"time", "table"}, {"robot", "table"}};
  for (const SPart& part : m_parts) {
    for (const SColumn& column : part.Columns) {
      const auto [other, isNew] = fields.emplace(column.Name, part.Name.Name);
      if (!isNew) {
        THROW_ARGOSEXCEPTION(m_location << ": \"" << other->second << "\" and \"" << part.Name.Name
                                        << "\" have a column of the same name, \"" << column.Name
                                        << "\": two tables are needed");
      }
    }
  }
}

void CEntityRows::PlaceColumns() {
  std::size_t most = 0;
  m_numNumbers = 0;
  for (SPart& part : m_parts) {
    part.Start = m_numNumbers;
    part.NumNumbers = std::max(part.Columns.size(), part.Name.Field->GetNumRaw());
    m_numNumbers += part.NumNumbers;
    most = std::max(most, part.NumNumbers);
  }
  // the columns of an entity may be others than those of the table
  for (const SEntityRows& rows : m_entities) {
    for (const SCell& cell : rows.Cells) {
      most = std::max(most, cell.Places.size());
    }
  }
  m_scratch.resize(most);
}

void CEntityRows::Describe(STableSchema& schema) const {
  schema.HasRobots = true;
  schema.NumNumbers = m_numNumbers;
  for (const SPart& part : m_parts) {
    for (std::size_t i = 0; i < part.Columns.size(); ++i) {
      schema.Columns.push_back(part.Columns[i]);
      schema.Places.push_back(part.Start + i);
    }
    if (part.Name.Field->GetNumRaw() > 0 && m_areColumnsKnown) {
      schema.Derivations.push_back({part.Name.Field.get(), part.Start});
    }
  }
}

std::vector<std::pair<std::string, SColumn>> CEntityRows::ListColumns() const {
  std::vector<std::pair<std::string, SColumn>> columns;
  for (const SPart& part : m_parts) {
    for (const SColumn& column : part.Columns) {
      columns.emplace_back(part.Name.Name, column);
    }
  }
  return columns;
}

std::size_t CEntityRows::Read(SRowBlock& block) {
  for (std::string& id : m_newIds) {
    block.NewRobots.push_back(std::move(id));
  }
  m_newIds.clear();
  const std::size_t before = block.NumRows;
  for (SEntityRows& entity : m_entities) {
    if (m_list == nullptr) {
      ReadRow(entity, 0, block);
      continue;
    }
    ARGOS_ASSERT(m_listIndex < entity.Cells.size(),
                 "the entity has no cell number " << m_listIndex);
    CFieldReader* const list = entity.Cells[m_listIndex].Reader.get();
    const std::size_t numItems = list != nullptr ? list->CountRows() : 0;
    for (std::size_t item = 0; item < numItems; ++item) {
      ReadRow(entity, item, block);
    }
  }
  return block.NumRows - before;
}

void CEntityRows::ReadRow(SEntityRows& entity, std::size_t item, SRowBlock& block) {
  const std::size_t start = block.Numbers.size();
  block.Numbers.resize(start + m_numNumbers, kNone);
  block.Robots.push_back(entity.Number);
  ++block.NumRows;
  double* const row = block.Numbers.data() + start;
  for (std::size_t i = 0; i < m_parts.size(); ++i) {
    ARGOS_ASSERT(
        i < entity.Cells.size() && m_parts[i].Start + m_parts[i].Columns.size() <= m_numNumbers,
        "part number " << i << " has no place in the row");
    const SPart& part = m_parts[i];
    const SCell& cell = entity.Cells[i];
    if (cell.Reader == nullptr) {
      continue;
    }
    const std::size_t index = part.Name.Field->IsList() ? item : 0;
    double* const numbers = row + part.Start;
    if (cell.Places.empty()) {
      cell.Reader->Read(index, {numbers, block.Texts, part.Columns.data()});
      continue;
    }
    m_scratch.assign(std::max(m_scratch.size(), cell.Places.size()), kNone);
    cell.Reader->Read(index, {m_scratch.data(), block.Texts, part.Columns.data()});
    for (std::size_t column = 0; column < cell.Places.size(); ++column) {
      if (cell.Places[column] < part.Columns.size()) {
        numbers[cell.Places[column]] = m_scratch[column];
      }
    }
  }
}

void CEntityRows::Restart() {
  m_newIds.clear();
  m_nextNumber = 0;
  for (SEntityRows& entity : m_entities) {
    entity.Number = m_nextNumber++;
    m_newIds.push_back(entity.Entity->GetId());
  }
}

}  // namespace argos
