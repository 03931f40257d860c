#include "table_reading.h"

#include <argos3/core/utility/errors/argos_exception.h>

#include <hdf5.h>
#include <zlib.h>

#include <cstdlib>
#include <cstring>
#include <limits>
#include <sstream>

namespace argos {

namespace {

std::vector<std::string> Split(const std::string& line) {
  std::vector<std::string> items(1);
  for (const char c : line) {
    if (c == ',') {
      items.emplace_back();
    } else {
      items.back() += c;
    }
  }
  return items;
}

/* A data set, open while this exists. */
class CDataSet {
 public:
  CDataSet(const std::string& path, const std::string& name)
      : m_file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {
    m_set = m_file < 0 ? -1 : H5Dopen2(m_file, name.c_str(), H5P_DEFAULT);
    if (m_set < 0) {
      THROW_ARGOSEXCEPTION("no data set " << name << " in " << path);
    }
    const hid_t space = H5Dget_space(m_set);
    H5Sget_simple_extent_dims(space, &m_size, nullptr);
    H5Sclose(space);
  }
  ~CDataSet() {
    H5Dclose(m_set);
    H5Fclose(m_file);
  }
  CDataSet(const CDataSet&) = delete;
  CDataSet& operator=(const CDataSet&) = delete;

  hid_t Get() const { return m_set; }
  std::size_t GetSize() const { return m_size; }

 private:
  hid_t m_file;
  hid_t m_set;
  hsize_t m_size = 0;
};

}  // namespace

std::vector<double> SReadTable::GetNumbers(const std::string& column) const {
  std::vector<double> numbers;
  for (const std::string& text : Columns.at(column)) {
    numbers.push_back(text.empty() ? std::numeric_limits<double>::quiet_NaN()
                                   : std::strtod(text.c_str(), nullptr));
  }
  return numbers;
}

SReadTable ReadCSV(const std::string& text) {
  SReadTable table;
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line)) {
    if (line.rfind('#', 0) == 0) {
      table.Header.push_back(line);
    } else if (table.Names.empty()) {
      table.Names = Split(line);
      for (const std::string& name : table.Names) {
        table.Columns[name];
      }
    } else {
      const std::vector<std::string> items = Split(line);
      if (items.size() != table.Names.size()) {
        THROW_ARGOSEXCEPTION("a line with " << items.size() << " items: " << line);
      }
      for (std::size_t i = 0; i < items.size(); ++i) {
        table.Columns[table.Names[i]].push_back(items[i]);
      }
    }
  }
  return table;
}

std::string Unzip(const std::string& path) {
  gzFile file = gzopen(path.c_str(), "rb");
  std::string text;
  char part[4096];
  int count = 0;
  while ((count = gzread(file, part, sizeof part)) > 0) {
    text.append(part, static_cast<std::size_t>(count));
  }
  if (gzclose(file) != Z_OK || count < 0) {
    THROW_ARGOSEXCEPTION("damaged: " << path);
  }
  return text;
}

std::vector<double> ReadHDF5Numbers(const std::string& path, const std::string& name) {
  const CDataSet set(path, name);
  std::vector<double> numbers(set.GetSize());
  H5Dread(set.Get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
  return numbers;
}

std::vector<std::string> ReadHDF5Texts(const std::string& path, const std::string& name) {
  const CDataSet set(path, name);
  const hid_t type = H5Dget_type(set.Get());
  const std::size_t length = H5Tget_size(type);
  std::vector<char> bytes(set.GetSize() * length);
  H5Dread(set.Get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data());
  H5Tclose(type);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < set.GetSize(); ++i) {
    const char* const start = bytes.data() + i * length;
    texts.emplace_back(start, strnlen(start, length));
  }
  return texts;
}

}  // namespace argos
