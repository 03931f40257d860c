#include <argos3/campaign/store/database.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <sqlite3.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace argos {

namespace {

constexpr int kBusyTimeout = 10000;  // ms

std::string DescribeFailure(int code, int systemError, const std::string& message) {
  if (code == SQLITE_READONLY_ROLLBACK) {
    return "the program that wrote it was killed while it stored runs: what was stored before is "
           "whole, and can be read after any command that writes, such as resume or merge";
  }
  const std::string reason = systemError != 0 ? std::strerror(systemError) : message;
  switch (code & 0xff) {
    case SQLITE_FULL:
      return "the disk, or the quota, is full: free some space and resume the campaign; what was "
             "stored before is whole";
    case SQLITE_IOERR:
      return code == SQLITE_IOERR_READ || code == SQLITE_IOERR_SHORT_READ
                 ? "reading failed (" + message + "): check the disk"
                 : "writing failed (" + message +
                       "), as it does when the disk is full or a quota or the limit of the size of "
                       "files is reached: free some space and resume the campaign; what was stored "
                       "before is whole";
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_AUTH:
      return "it is not writable (" + message + "): check the rights of the file and of its folder";
    case SQLITE_CANTOPEN:
      return "it cannot be opened (" + reason + "): check that its folder exists, and the rights";
    case SQLITE_NOTADB:
      return "it is not a database: choose another name for the results, or remove the file";
    case SQLITE_CORRUPT:
      return "it is damaged (" + message +
             "): use a copy, or save what can be read with: sqlite3 FILE .recover | sqlite3 NEW";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "another program has locked it for more than " + std::to_string(kBusyTimeout / 1000) +
             " s: close that program, for example an editor of databases";
    case SQLITE_NOMEM:
      return "not enough memory";
    default:
      return message;
  }
}

bool Exists(const std::string& file) {
  return access(file.c_str(), F_OK) == 0;
}

// a URI that leads to a file, whatever characters its name has
std::string MakeImmutableUri(const std::string& file) {
  std::string uri = "file:";
  for (const char c : file) {
    if (c == '%' || c == '?' || c == '#') {
      constexpr char kDigits[] = "0123456789ABCDEF";
      const auto byte = static_cast<unsigned char>(c);
      uri += '%';
      uri += kDigits[byte >> 4];
      uri += kDigits[byte & 15];
    } else {
      uri += c;
    }
  }
  return uri + "?immutable=1";
}

}  // namespace

CDatabase::CDatabase(const std::string& file, EAccess access) : m_file(file) {
  const bool isReadOnly = access == EAccess::ReadOnly;
  const int flags = isReadOnly ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  const auto open = [&](const std::string& name, int more) {
    sqlite3_close(m_handle);
    const int code = sqlite3_open_v2(name.c_str(), &m_handle, flags | more, nullptr);
    sqlite3_extended_result_codes(m_handle, 1);
    sqlite3_busy_timeout(m_handle, kBusyTimeout);
    // the first statement opens the file itself
    return code != SQLITE_OK ? code
                             : sqlite3_exec(m_handle, "SELECT count(*) FROM sqlite_master", nullptr,
                                            nullptr, nullptr);
  };
  int code = open(file, 0);
  // if a folder is not writable, readers cannot create the files of the WAL mode
  if (isReadOnly && (code & 0xff) != SQLITE_OK && (code & 0xff) != SQLITE_NOTADB && Exists(file) &&
      !Exists(file + "-wal") && !Exists(file + "-journal")) {
    code = open(MakeImmutableUri(file), SQLITE_OPEN_URI);
  }
  if (code != SQLITE_OK) {
    try {
      ThrowFailure();
    } catch (...) {
      sqlite3_close(m_handle);
      throw;
    }
  }
}

CDatabase::~CDatabase() {
  for (const auto& [text, cached] : m_cache) {
    sqlite3_finalize(cached.Statement);
  }
  sqlite3_close(m_handle);
}

void CDatabase::Execute(const std::string& statements) {
  if (sqlite3_exec(m_handle, statements.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    ThrowFailure();
  }
}

SInt64 CDatabase::QueryNumber(const std::string& statement) {
  CQuery query(*this, statement);
  return query.Step() ? query.GetInteger(0) : 0;
}

SInt64 CDatabase::GetLastRowId() const {
  return sqlite3_last_insert_rowid(m_handle);
}

void CDatabase::ThrowFailure() const {
  const int code = m_handle == nullptr ? SQLITE_NOMEM : sqlite3_extended_errcode(m_handle);
  const int primary = code & 0xff;
  const int systemError = primary == SQLITE_CANTOPEN ? sqlite3_system_errno(m_handle) : 0;
  const char* message = m_handle == nullptr ? "" : sqlite3_errmsg(m_handle);
  THROW_ARGOSEXCEPTION("the results file \""
                       << m_file << "\": " << DescribeFailure(code, systemError, message));
}

sqlite3_stmt* CDatabase::Prepare(const std::string& statement) const {
  sqlite3_stmt* prepared = nullptr;
  if (sqlite3_prepare_v2(m_handle, statement.c_str(), static_cast<int>(statement.size()), &prepared,
                         nullptr) != SQLITE_OK) {
    ThrowFailure();
  }
  return prepared;
}

// queries

CQuery::CQuery(CDatabase& database, const std::string& statement)
    : m_database(database), m_cached(&database.m_cache[statement]) {
  if (m_cached->IsUsed) {
    // a query inside another one with the same text
    m_cached = nullptr;
    m_statement = database.Prepare(statement);
    return;
  }
  if (m_cached->Statement == nullptr) {
    m_cached->Statement = database.Prepare(statement);
  }
  m_cached->IsUsed = true;
  m_statement = m_cached->Statement;
}

CQuery::~CQuery() {
  if (m_cached == nullptr) {
    sqlite3_finalize(m_statement);
    return;
  }
  sqlite3_reset(m_statement);
  sqlite3_clear_bindings(m_statement);
  m_cached->IsUsed = false;
}

CQuery& CQuery::Bind(SInt64 value) {
  if (sqlite3_bind_int64(m_statement, ++m_parameter, value) != SQLITE_OK) {
    m_database.ThrowFailure();
  }
  return *this;
}

CQuery& CQuery::Bind(Real value) {
  // SQLite stores NaN as NULL
  if (sqlite3_bind_double(m_statement, ++m_parameter, value) != SQLITE_OK) {
    m_database.ThrowFailure();
  }
  return *this;
}

CQuery& CQuery::Bind(const std::string& value) {
  if (sqlite3_bind_text64(m_statement, ++m_parameter, value.data(), value.size(), SQLITE_TRANSIENT,
                          SQLITE_UTF8) != SQLITE_OK) {
    m_database.ThrowFailure();
  }
  return *this;
}

bool CQuery::Step() {
  const int code = sqlite3_step(m_statement);
  if (code != SQLITE_ROW && code != SQLITE_DONE) {
    m_database.ThrowFailure();
  }
  return code == SQLITE_ROW;
}

void CQuery::Execute() {
  while (Step()) {
  }
  sqlite3_reset(m_statement);
  m_parameter = 0;
}

SInt64 CQuery::GetInteger(int column) const {
  return sqlite3_column_int64(m_statement, column);
}

Real CQuery::GetReal(int column) const {
  return IsNull(column) ? std::numeric_limits<Real>::quiet_NaN()
                        : sqlite3_column_double(m_statement, column);
}

std::string CQuery::GetText(int column) const {
  const unsigned char* text = sqlite3_column_text(m_statement, column);
  const int size = sqlite3_column_bytes(m_statement, column);
  return text == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(text), size);
}

bool CQuery::IsNull(int column) const {
  return sqlite3_column_type(m_statement, column) == SQLITE_NULL;
}

// transactions

CTransaction::CTransaction(CDatabase& database) : m_database(database) {
  m_database.Execute("BEGIN IMMEDIATE");
}

CTransaction::~CTransaction() {
  if (m_isOpen) {
    try {
      m_database.Execute("ROLLBACK");
    } catch (const CARGoSException&) {
      // SQLite has undone it itself, because of the failure that is being reported
      return;
    }
  }
}

void CTransaction::Commit() {
  m_database.Execute("COMMIT");
  m_isOpen = false;
}

}  // namespace argos
