#ifndef ARGOS3_CAMPAIGN_STORE_DATABASE_H
#define ARGOS3_CAMPAIGN_STORE_DATABASE_H

// private: SQLite with exceptions

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>

#include <map>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace argos {

/** An SQLite database. Failures are CARGoSExceptions that say what the user can do. */
class CDatabase : private CNonCopyable {
 public:
  enum class EAccess { ReadOnly, Write };

  /** Opens a file; EAccess::Write creates it. */
  CDatabase(const std::string& file, EAccess access);
  ~CDatabase();

  /** Executes statements without parameters, and ignores their rows. */
  void Execute(const std::string& statements);
  /** @return the number that a statement without parameters gives; 0 if it gives none. */
  SInt64 QueryNumber(const std::string& statement);
  SInt64 GetLastRowId() const;
  const std::string& GetFile() const { return m_file; }
  /** Throws the exception for the last failure. */
  [[noreturn]] void ThrowFailure() const;

 private:
  friend class CQuery;

  struct SCached {
    sqlite3_stmt* Statement = nullptr;
    bool IsUsed = false;
  };

  sqlite3_stmt* Prepare(const std::string& statement) const;

  std::string m_file;
  sqlite3* m_handle = nullptr;
  std::map<std::string, SCached> m_cache;  // indexed by text
};

/** The execution of one statement, which is prepared once for each database. */
class CQuery : private CNonCopyable {
 public:
  CQuery(CDatabase& database, const std::string& statement);
  ~CQuery();

  /** Binds the next parameter; NaN becomes NULL. */
  CQuery& Bind(SInt64 value);
  CQuery& Bind(UInt64 value) { return Bind(static_cast<SInt64>(value)); }
  CQuery& Bind(UInt32 value) { return Bind(SInt64{value}); }
  CQuery& Bind(int value) { return Bind(SInt64{value}); }
  CQuery& Bind(Real value);
  CQuery& Bind(const std::string& value);

  /** @return true if there is a row, which the functions below read. */
  bool Step();
  /** For statements without rows; afterwards parameters can be bound again. */
  void Execute();

  SInt64 GetInteger(int column) const;
  UInt32 GetUInt32(int column) const { return static_cast<UInt32>(GetInteger(column)); }
  Real GetReal(int column) const; /**< NaN for NULL */
  std::string GetText(int column) const;
  bool IsNull(int column) const;

 private:
  CDatabase& m_database;
  CDatabase::SCached* m_cached;
  sqlite3_stmt* m_statement;
  int m_parameter = 0;
};

/** A transaction that writes; undone unless Commit() is called. */
class CTransaction : private CNonCopyable {
 public:
  explicit CTransaction(CDatabase& database);
  ~CTransaction();
  void Commit();

 private:
  CDatabase& m_database;
  bool m_isOpen = true;
};

}  // namespace argos

#endif
