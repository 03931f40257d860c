#ifndef ARGOS3_PLUGINS_OUTPUTS_QUANTITIES_FIELD_H
#define ARGOS3_PLUGINS_OUTPUTS_QUANTITIES_FIELD_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/plugins/factory.h>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace argos {

class CEntity;

/** What a column contains. */
enum class EColumnKind {
  Number, /**< NaN where there is no value */
  Text /**< empty where there is no value */
};

/** A column of a table. */
struct SColumn {
  std::string Name; /**< letters, digits and '_', beginning with a letter */
  std::string Unit; /**< such as "m"; "" for numbers without a unit, and texts */
  EColumnKind Kind = EColumnKind::Number;
};

/** @return the text with '_' in place of what a name of a column must not contain. */
std::string ToColumnName(const std::string& text);

/** The texts of rows: a text is stored once, and its number takes its place in the row. */
class CRowTexts {
 public:
  /** @return the number of the text, to be stored in a row. NaN stands for an empty text. */
  double Add(std::string_view text);
  /** Adds bytes, as two hexadecimal digits each. */
  double AddHexadecimal(const unsigned char* bytes, std::size_t count);
  /** @param number  of Add(), or NaN. */
  std::string_view Get(double number) const;
  /** Forgets the texts; keeps the memory. */
  void Clear();

 private:
  std::string m_texts;
  std::vector<std::size_t> m_ends;  // end of each text in m_texts
};

/** What CFieldReader::Read() fills. */
struct SFieldRow {
  double* Numbers; /**< one for each number of the field, NaN before the call */
  CRowTexts& Texts; /**< serves columns of texts: Numbers[i] = Texts.Add(text) */
  const SColumn* Columns; /**< belong to the table, for the columns of the field */
};

/**
 * Reads a field of one entity; created when the entity is added to a table. It may be destroyed
 * after the entity, which its destructor must not use.
 *
 * Called on the main thread, between ticks. Must not change the simulation.
 */
class CFieldReader {
 public:
  virtual ~CFieldReader() = default;

  /** Number of rows that the entity has now; not 1 only for lists. */
  virtual std::size_t CountRows() { return 1; }
  /** Copies the numbers of row @p index < CountRows(). Not to allocate memory in a settled run. */
  virtual void Read(std::size_t index, SFieldRow row) = 0;
};

/** A field of one entity. */
struct SBoundField {
  std::unique_ptr<CFieldReader> Reader; /**< null: the entity does not have this field */
  std::vector<SColumn> Columns; /**< empty: not known yet; then those of other entities hold */
};

/**
 * A named quantity of robots and other root entities, such as poses or readings, that tables of
 * results contain.
 *
 * Its name in an experiment file is its label, or its label, ':' and an argument:
 * "readings:proximity".
 */
class CField {
 public:
  virtual ~CField() = default;

  /**
   * Resolves the field for an entity, so that reading it needs no look-up.
   * @param root      root entity. Components may be created at their first look-up: only those are
   *   to be looked up that exist, or that do not change the state of the simulation.
   * @param argument  what follows the ':' in the name; empty without one.
   */
  virtual SBoundField Bind(CEntity& root, const std::string& argument) const = 0;

  /** Adds the names that an entity has for this field, for messages. @param label  of the field. */
  virtual void ListNames(CEntity& root, const std::string& label,
                         std::vector<std::string>& names) const;

  /** True if the field has a name only together with an argument. */
  virtual bool NeedsArgument() const { return false; }
  /** True if an entity has any number of rows at a time: a list, such as that of messages. */
  virtual bool IsList() const { return false; }
  /** True if robots without a controller, as in a replay, have no values for this field. */
  virtual bool NeedsController() const { return false; }

  /**
   * Number of numbers that Read() copies; 0 (the default): as many as there are columns. Fields
   * with more numbers than columns compute the columns in Derive().
   */
  virtual std::size_t GetNumRaw() const { return 0; }
  /**
   * Turns the numbers that Read() has copied into columns, in place: what takes time does so here,
   * off the main thread. @param numbers  GetNumRaw(); the first ones become the columns.
   */
  virtual void Derive(double* numbers) const;
};

/** A root entity that has values of fields itself: in a replay, those that were recorded. */
class CFieldSource {
 public:
  virtual ~CFieldSource() = default;

  /** @param name  as in an experiment file. The reader is null if there are no such values. */
  virtual SBoundField BindField(const std::string& name) const = 0;
  /** Adds the names of the fields that it has. */
  virtual void ListFields(std::vector<std::string>& names) const = 0;
};

/** The name of a field in an experiment file, and the field. */
struct SFieldName {
  /**
   * @throws CARGoSException with the nearest names if there is no such field, or if an argument is
   *   missing or too many. The text does not contain file and line.
   */
  explicit SFieldName(const std::string& name);

  /** As CField::Bind(); values of a CFieldSource come first, unless they are to be derived. */
  SBoundField Bind(CEntity& root) const;

  std::string Name;
  std::string Label; /**< precedes ':' */
  std::string Argument; /**< follows ':' */
  std::unique_ptr<CField> Field;
};

/** @return all names of fields that one of the entities has, each once. */
std::vector<std::string> ListFieldNames(const std::vector<CEntity*>& roots);

}  // namespace argos

/** Registers a field under the label that files use; see REGISTER_SYMBOL. */
#define REGISTER_FIELD(CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, LONG_DESCRIPTION,    \
                       STATUS)                                                                    \
  REGISTER_SYMBOL(CField, CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, LONG_DESCRIPTION, \
                  STATUS)

#endif
