// Tables as HDF5 files: a data set for each column.

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/lock_file.h>
#include <argos3/plugins/simulator/outputs/tables/table_format.h>

#include <hdf5.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace argos {

namespace {

constexpr hsize_t kChunk = 2048;  // rows that are stored together
// space that the library needs beside the rows, bytes
constexpr std::uint64_t kMargin = 1 << 20;
constexpr std::size_t kShortestText = 32;  // bytes of an element in a column of texts
constexpr char kSeeds[] = "seeds";  // data set that every file has

// the library of HDF5 is not thread safe in every build
std::mutex& GetLibraryMutex() {
  static std::mutex mutex;
  return mutex;
}

/* An identifier of the library, and the function that releases it. */
class CHandle {
 public:
  using TClose = herr_t (*)(hid_t);

  CHandle() = default;
  CHandle(hid_t id, TClose close) : m_id(id), m_close(close) {
    if (id < 0) {
      THROW_ARGOSEXCEPTION("the HDF5 library reports an error");
    }
  }
  CHandle(CHandle&& other) noexcept { *this = std::move(other); }
  CHandle& operator=(CHandle&& other) noexcept {
    std::swap(m_id, other.m_id);
    std::swap(m_close, other.m_close);
    return *this;
  }
  ~CHandle() {
    if (m_id >= 0) {
      m_close(m_id);
    }
  }

  hid_t Get() const { return m_id; }

 private:
  hid_t m_id = -1;
  TClose m_close = nullptr;
};

void Check(herr_t status) {
  if (status < 0) {
    THROW_ARGOSEXCEPTION("the HDF5 library reports an error");
  }
}

CHandle MakeTextType(std::size_t length) {
  CHandle type(H5Tcopy(H5T_C_S1), H5Tclose);
  Check(H5Tset_size(type.Get(), length));
  Check(H5Tset_strpad(type.Get(), H5T_STR_NULLPAD));
  // Octave reads no texts that are marked as UTF-8
  return type;
}

void WriteTextAttribute(hid_t object, const char* name, const std::string& text) {
  const CHandle type = MakeTextType(std::max<std::size_t>(text.size(), 1));
  const CHandle space(H5Screate(H5S_SCALAR), H5Sclose);
  const CHandle attribute(
      H5Acreate2(object, name, type.Get(), space.Get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  // the library reads as many bytes as the type has, at least one
  Check(H5Awrite(attribute.Get(), type.Get(), text.c_str()));
}

/* A data set of one dimension that grows. */
class CColumn {
 public:
  CColumn(hid_t file, std::string name, const std::string& unit, CHandle type)
      : m_file(file), m_name(std::move(name)), m_unit(unit), m_type(std::move(type)) {
    m_set = Create(m_name);
  }

  /** Bytes that the file grows by if @p count elements are appended, at most. */
  std::uint64_t ComputeGrowth(hsize_t count) const {
    const hsize_t chunks = (m_size + count + kChunk - 1) / kChunk - (m_size + kChunk - 1) / kChunk;
    return chunks * kChunk * GetElementSize();
  }

  hsize_t GetSize() const { return m_size; }

  /** Appends elements without a value (NaN). */
  void AppendNone(hsize_t count) {
    m_size += count;
    Check(H5Dset_extent(m_set.Get(), &m_size));
  }

  void Append(const void* elements, hsize_t count, hid_t memoryType) {
    if (count == 0) {
      return;
    }
    const hsize_t size = m_size + count;
    Check(H5Dset_extent(m_set.Get(), &size));
    const CHandle place(H5Dget_space(m_set.Get()), H5Sclose);
    Check(H5Sselect_hyperslab(place.Get(), H5S_SELECT_SET, &m_size, nullptr, &count, nullptr));
    const CHandle memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
    Check(H5Dwrite(m_set.Get(), memoryType, memory.Get(), place.Get(), H5P_DEFAULT, elements));
    m_size = size;
  }

  /** Appends texts; the elements become longer if one of them needs it. */
  void AppendTexts(const std::vector<std::string_view>& texts) {
    std::size_t longest = 0;
    for (const std::string_view text : texts) {
      longest = std::max(longest, text.size());
    }
    if (longest > GetElementSize()) {
      Widen(std::max(longest, 2 * GetElementSize()));
    }
    const std::size_t length = GetElementSize();
    m_bytes.assign(texts.size() * length, '\0');
    for (std::size_t i = 0; i < texts.size(); ++i) {
      texts[i].copy(m_bytes.data() + i * length, texts[i].size());
    }
    Append(m_bytes.data(), texts.size(), m_type.Get());
  }

  /** Bytes that the file grows by if texts of that length are appended. */
  std::uint64_t ComputeTextGrowth(const std::vector<std::string_view>& texts) const {
    std::size_t longest = GetElementSize();
    for (const std::string_view text : texts) {
      longest = text.size() > longest ? std::max(text.size(), 2 * GetElementSize()) : longest;
    }
    const bool widens = longest > GetElementSize();
    const hsize_t rows = widens ? m_size + texts.size() + kChunk : 0;
    return ComputeGrowth(texts.size()) + rows * longest;
  }

 private:
  std::size_t GetElementSize() const { return H5Tget_size(m_type.Get()); }

  CHandle Create(const std::string& name) const {
    const hsize_t size = 0;
    const hsize_t most = H5S_UNLIMITED;
    const CHandle space(H5Screate_simple(1, &size, &most), H5Sclose);
    const CHandle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    Check(H5Pset_chunk(properties.Get(), 1, &kChunk));
    if (H5Tget_class(m_type.Get()) == H5T_FLOAT) {
      const double none = std::numeric_limits<double>::quiet_NaN();
      Check(H5Pset_fill_value(properties.Get(), H5T_NATIVE_DOUBLE, &none));
    }
    CHandle set(H5Dcreate2(m_file, name.c_str(), m_type.Get(), space.Get(), H5P_DEFAULT,
                           properties.Get(), H5P_DEFAULT),
                H5Dclose);
    if (!m_unit.empty()) {
      WriteTextAttribute(set.Get(), "unit", m_unit);
    }
    return set;
  }

  // copies the rows into a new data set
  void Widen(std::size_t length) {
    const std::string temporary = m_name + "_wider";
    const hsize_t size = m_size;
    const CHandle old = std::move(m_set);
    m_type = MakeTextType(length);
    m_set = Create(temporary);
    m_size = 0;
    std::vector<char> bytes;
    for (hsize_t first = 0; first < size; first += kChunk) {
      const hsize_t count = std::min(kChunk, size - first);
      bytes.assign(count * length, '\0');
      const CHandle place(H5Dget_space(old.Get()), H5Sclose);
      Check(H5Sselect_hyperslab(place.Get(), H5S_SELECT_SET, &first, nullptr, &count, nullptr));
      const CHandle memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
      Check(H5Dread(old.Get(), m_type.Get(), memory.Get(), place.Get(), H5P_DEFAULT, bytes.data()));
      Append(bytes.data(), count, m_type.Get());
    }
    Check(H5Ldelete(m_file, m_name.c_str(), H5P_DEFAULT));
    Check(H5Lmove(m_file, temporary.c_str(), m_file, m_name.c_str(), H5P_DEFAULT, H5P_DEFAULT));
  }

  hid_t m_file;
  std::string m_name;
  std::string m_unit;
  CHandle m_type;
  CHandle m_set;
  hsize_t m_size = 0;  // rows
  std::vector<char> m_bytes;
};

class CHDF5Format : public CTableFormat {
 public:
  ~CHDF5Format() override {
    try {
      Close();
    } catch (...) {
      // a caller that wants to know calls Close() before
      return;
    }
  }

  void Open(const std::string& path, const STableSchema& schema) override {
    m_path = path;
    m_schema = schema;
    Guard([this] { Create(); });
  }

  void AddColumns(const std::vector<SColumn>& columns) override {
    Guard([&] {
      for (const SColumn& column : columns) {
        m_columns.push_back(MakeColumn(column));
        m_columns.back()->AppendNone(m_own[Tick]->GetSize());
      }
      m_schema.AddColumns(columns);
    });
  }

  void Write(const SRowBlock& block) override {
    Guard([&] { WriteRows(block); });
  }

  void Close() override {
    if (m_descriptor < 0) {
      return;
    }
    Guard([this] { CloseFile(); });
  }

 private:
  void CloseFile() {
    const int descriptor = std::exchange(m_descriptor, -1);
    bool isWhole = true;
    if (m_file != nullptr) {
      hsize_t size = 0;
      m_seeds.reset();
      m_columns.clear();
      m_own.clear();
      isWhole = H5Fflush(m_file->Get(), H5F_SCOPE_GLOBAL) >= 0 &&
                H5Fget_filesize(m_file->Get(), &size) >= 0;
      m_file.reset();
      // gives back what was reserved
      isWhole = isWhole && ftruncate(descriptor, static_cast<off_t>(size)) == 0;
    }
    isWhole = close(descriptor) == 0 && isWhole;
    if (!isWhole) {
      THROW_ARGOSEXCEPTION("not all rows are written");
    }
  }

  // columns that every table has
  enum EOwn { Run, Tick, Time, Robot, Robots, Seeds };

  template <typename CALL>
  void Guard(CALL&& call) {
    const std::lock_guard<std::mutex> lock(GetLibraryMutex());
    // its function at the exit of the process would close files before they are complete
    H5dont_atexit();
    // messages of the library would go to the terminal
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    try {
      call();
    } catch (std::exception& error) {
      THROW_ARGOSEXCEPTION("cannot write the file \""
                           << m_path << "\": "
                           << (m_reason.empty() ? "the HDF5 library reports an error" : m_reason));
    }
  }

  void Create() {
    CreateFile();
    const hid_t file = m_file->Get();
    Reserve(0);
    WriteTextAttribute(file, "argos3", m_schema.Version);
    WriteHeader(file);
    const auto add = [this, file](const char* name, const char* unit, hid_t type) {
      m_own.push_back(
          std::make_unique<CColumn>(file, name, unit, CHandle(H5Tcopy(type), H5Tclose)));
    };
    add("run", "", H5T_STD_I32LE);
    add("tick", "", H5T_STD_I32LE);
    add("time", "s", H5T_IEEE_F64LE);
    if (m_schema.HasRobots) {
      add("robot", "", H5T_STD_I32LE);
      m_own.push_back(std::make_unique<CColumn>(file, "robots", "", MakeTextType(kShortestText)));
    }
    m_seeds =
        std::make_unique<CColumn>(file, kSeeds, "", CHandle(H5Tcopy(H5T_STD_I64LE), H5Tclose));
    for (const SColumn& column : m_schema.Columns) {
      m_columns.push_back(MakeColumn(column));
    }
    Check(H5Fflush(file, H5F_SCOPE_GLOBAL));
  }

  // an empty file, which nothing else writes
  void CreateFile() {
    m_descriptor = open(m_path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666);
    struct stat information {};
    if (m_descriptor < 0 || fstat(m_descriptor, &information) != 0) {
      m_reason = std::strerror(errno);
    } else if (!S_ISREG(information.st_mode)) {
      m_reason = "it is no regular file";
    } else if (!TryToLock(m_descriptor)) {
      m_reason = DescribeLockHolder(m_descriptor) + " is writing it";
    }
    if (!m_reason.empty()) {
      THROW_ARGOSEXCEPTION(m_reason);
    }
    const CHandle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    // Octave 7 and h5py read version 1.8 and later
    Check(H5Pset_libver_bounds(access.Get(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V18));
    // the library locks a file only after it has emptied it, and the lock above would stop it
    Check(H5Pset_file_locking(access.Get(), 0, 1));
    m_file = std::make_unique<CHandle>(
        H5Fcreate(m_path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.Get()), H5Fclose);
  }

  std::unique_ptr<CColumn> MakeColumn(const SColumn& column) {
    if (column.Name == kSeeds) {
      m_reason = "the file has a data set \"seeds\" of its own: a column needs another name";
      THROW_ARGOSEXCEPTION(m_reason);
    }
    return std::make_unique<CColumn>(m_file->Get(), column.Name, column.Unit,
                                     column.Kind == EColumnKind::Text
                                         ? MakeTextType(kShortestText)
                                         : CHandle(H5Tcopy(H5T_IEEE_F64LE), H5Tclose));
  }

  // entries with one key are lines of one attribute
  void WriteHeader(hid_t file) {
    std::vector<std::pair<std::string, std::string>> merged;
    for (const auto& [key, value] : m_schema.Header) {
      const auto known =
          std::find_if(merged.begin(), merged.end(),
                       [&key = key](const auto& entry) { return entry.first == key; });
      if (known == merged.end()) {
        merged.emplace_back(key, value);
      } else {
        known->second += '\n' + value;
      }
    }
    constexpr std::size_t kMaxAttributeBytes = 60000;  // the library's limit is 64 KiB
    for (auto& [key, value] : merged) {
      if (value.size() > kMaxAttributeBytes) {
        value.resize(std::min(value.rfind('\n', kMaxAttributeBytes), kMaxAttributeBytes));
      }
      WriteTextAttribute(file, key.c_str(), value);
    }
  }

  // makes sure that the file can grow before the library changes it: so it stays readable if the
  // disk is full
  void Reserve(std::uint64_t growth) {
    hsize_t size = 0;
    Check(H5Fget_filesize(m_file->Get(), &size));
    const int error = posix_fallocate(m_descriptor, 0, static_cast<off_t>(size + growth + kMargin));
    if (error != 0) {
      m_reason = std::strerror(error);
      THROW_ARGOSEXCEPTION(m_reason);
    }
  }

  void WriteRows(const SRowBlock& block) {
    CollectTexts(block);
    const hsize_t rows = block.NumRows;
    std::uint64_t growth = 0;
    for (const auto& column : m_own) {
      growth += column->ComputeGrowth(rows);
    }
    if (m_schema.HasRobots) {
      growth += m_own[Robots]->ComputeTextGrowth(m_robotTexts);
    }
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
      growth += m_texts[i].empty() ? m_columns[i]->ComputeGrowth(rows)
                                   : m_columns[i]->ComputeTextGrowth(m_texts[i]);
    }
    Reserve(growth + m_seeds->ComputeGrowth(block.Ticks.size()));
    WriteOwnColumns(block);
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
      if (m_schema.Columns[i].Kind == EColumnKind::Text) {
        m_columns[i]->AppendTexts(m_texts[i]);
        continue;
      }
      m_numbers.resize(block.NumRows);
      const double* from = block.Numbers.data() + m_schema.Places[i];
      for (double& number : m_numbers) {
        number = *from;
        from += m_schema.NumNumbers;
      }
      m_columns[i]->Append(m_numbers.data(), rows, H5T_NATIVE_DOUBLE);
    }
    Check(H5Fflush(m_file->Get(), H5F_SCOPE_GLOBAL));
  }

  void CollectTexts(const SRowBlock& block) {
    m_robotTexts.assign(block.NewRobots.begin(), block.NewRobots.end());
    m_texts.resize(m_columns.size());
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
      m_texts[i].clear();
      if (m_schema.Columns[i].Kind != EColumnKind::Text) {
        continue;
      }
      for (std::size_t row = 0; row < block.NumRows; ++row) {
        m_texts[i].push_back(
            block.Texts.Get(block.Numbers[row * m_schema.NumNumbers + m_schema.Places[i]]));
      }
    }
  }

  void WriteOwnColumns(const SRowBlock& block) {
    std::vector<std::int32_t> runs;
    std::vector<std::int32_t> ticks;
    std::vector<double> times;
    for (const SRowBlock::STick& tick : block.Ticks) {
      runs.insert(runs.end(), tick.NumRows, static_cast<std::int32_t>(tick.Run));
      ticks.insert(ticks.end(), tick.NumRows, static_cast<std::int32_t>(tick.Tick));
      times.insert(times.end(), tick.NumRows, tick.Time);
      for (; m_numSeeds <= tick.Run; ++m_numSeeds) {
        const std::int64_t seed = tick.Seed;
        m_seeds->Append(&seed, 1, H5T_NATIVE_INT64);
      }
    }
    m_own[Run]->Append(runs.data(), runs.size(), H5T_NATIVE_INT32);
    m_own[Tick]->Append(ticks.data(), ticks.size(), H5T_NATIVE_INT32);
    m_own[Time]->Append(times.data(), times.size(), H5T_NATIVE_DOUBLE);
    if (m_schema.HasRobots) {
      const std::vector<std::int32_t> robots(block.Robots.begin(), block.Robots.end());
      m_own[Robot]->Append(robots.data(), robots.size(), H5T_NATIVE_INT32);
      m_own[Robots]->AppendTexts(m_robotTexts);
    }
  }

  std::string m_path;
  std::string m_reason;  // reason of a failure; empty: not known
  STableSchema m_schema;
  int m_descriptor = -1;  // descriptor of the file, to reserve space
  std::unique_ptr<CHandle> m_file;  // precedes the columns, which are closed first
  std::vector<std::unique_ptr<CColumn>> m_own;  // are indexed by EOwn
  std::unique_ptr<CColumn> m_seeds;  // seeds of the runs
  std::vector<std::unique_ptr<CColumn>> m_columns;
  UInt32 m_numSeeds = 0;
  std::vector<double> m_numbers;
  std::vector<std::string_view> m_robotTexts;
  std::vector<std::vector<std::string_view>> m_texts;  // are indexed by column
};

}  // namespace

REGISTER_TABLE_FORMAT(CHDF5Format, "h5", "HDF5: a data set for each column.")

}  // namespace argos
