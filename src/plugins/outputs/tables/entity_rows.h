#ifndef ARGOS3_PLUGINS_OUTPUTS_TABLES_ENTITY_ROWS_H
#define ARGOS3_PLUGINS_OUTPUTS_TABLES_ENTITY_ROWS_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/outputs/field.h>
#include <argos3/plugins/simulator/outputs/tables/row_block.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace argos {

class CSpace;

/** @return the items of a list with commas, without the spaces around them, and no empty ones. */
std::vector<std::string> SplitAtCommas(const std::string& text);

/**
 * @param location  of the element, for messages.
 * @param fields    names with commas, such as "pose,readings:proximity".
 * @throws CARGoSException if one is no field, or if there is none.
 */
std::vector<SFieldName> ReadFieldNames(const std::string& location, const std::string& fields);

/**
 * The rows of a table with fields of robots, or of other root entities: follows which entities
 * there are, and copies their fields.
 */
class CEntityRows {
 public:
  /**
   * @param location  of the element, for messages: "file:line: <table>".
   * @param fields    not empty.
   * @param types     of entities, such as "foot-bot"; empty: all robots.
   * @param ids       of the entities among them that have rows; empty: all.
   * @throws CARGoSException if two fields are equal, or if two of them are lists.
   */
  CEntityRows(std::string location, std::vector<SFieldName> fields, std::vector<std::string> types,
              std::vector<std::string> ids = {});

  /**
   * Resolves the fields of the entities there are.
   * @throws CARGoSException with the nearest names if no entity has a field, a type or an id; if
   * two fields have a column of the same name.
   */
  void Resolve(CSpace& space);
  /** Follows entities that were added and removed. @throws CARGoSException as Resolve(). */
  void Update(CSpace& space);
  /** True as soon as there was an entity, which has fixed the columns. */
  bool AreColumnsKnown() const { return m_areColumnsKnown; }
  /** Sets the columns, in a table that has them or, without any entity ever, none. */
  void Describe(STableSchema& schema) const;
  /** The columns in the order of the table, each with the name of its field. */
  std::vector<std::pair<std::string, SColumn>> ListColumns() const;
  /** Those with rows, in the order in which Read() appends them. */
  std::size_t GetNumEntities() const { return m_entities.size(); }
  const CEntity& GetEntity(std::size_t number) const { return *m_entities[number].Entity; }
  /** Appends the rows of now. @return their number. */
  std::size_t Read(SRowBlock& block);
  /** A new file begins: blocks from here on list all robots again. */
  void Restart();

 private:
  /** A field of the table. */
  struct SPart {
    SFieldName Name;
    std::vector<SColumn> Columns;  // columns of all entities, in order of their first appearance
    std::size_t Start = 0;  // place of its numbers in a row
    std::size_t NumNumbers = 0;
    bool WasExtraColumnReported = false;
  };

  /** A field of an entity. */
  struct SCell {
    std::unique_ptr<CFieldReader> Reader;  // null: no values
    std::vector<std::size_t> Places;  // places of its columns in those of the part; empty: same
  };

  struct SEntityRows {
    CEntity* Entity;
    ssize_t Index;  // index of the entity, which tells it from a later one at the same address
    UInt32 Number;  // number of this entity in the file
    std::vector<SCell> Cells;  // are indexed by part
  };

  struct SRoot {
    CEntity* Entity;
    ssize_t Index;
    bool operator==(const SRoot& other) const {
      return Entity == other.Entity && Index == other.Index;
    }
  };

  bool HaveEntitiesChanged(CSpace& space);
  std::vector<CEntity*> ListEntities(CSpace& space) const;
  std::vector<CEntity*> ListEntitiesOfTypes(CSpace& space) const;
  void CheckIds(CSpace& space) const;
  SEntityRows Bind(CEntity& entity);
  SCell BindCell(SPart& part, CEntity& entity);
  void AddColumns(SPart& part, const SBoundField& bound);
  void NoteExtraColumn(SPart& part, const CEntity& entity, const std::string& column) const;
  void CheckFields(const std::vector<CEntity*>& entities, CSpace& space);
  void CheckColumns() const;
  void PlaceColumns();
  void ReadRow(SEntityRows& entity, std::size_t item, SRowBlock& block);

  std::string m_location;
  std::vector<std::string> m_types;
  std::vector<std::string> m_ids;
  std::vector<SPart> m_parts;
  SPart* m_list = nullptr;  // the field that is a list; null: none is
  std::size_t m_listIndex = 0;
  std::size_t m_numNumbers = 0;
  bool m_areColumnsKnown = false;
  std::vector<SEntityRows> m_entities;
  std::vector<SRoot> m_roots;  // roots of the space at the last change
  UInt64 m_robotsVersion = 0;
  bool m_wereEntitiesListed = false;
  std::vector<std::string> m_newIds;  // are not in a block yet
  UInt32 m_nextNumber = 0;
  std::vector<double> m_scratch;
};

}  // namespace argos

#endif
