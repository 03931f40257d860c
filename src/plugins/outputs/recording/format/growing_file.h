#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_GROWING_FILE_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_GROWING_FILE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>

#include <string>
#include <string_view>

namespace argos {

/**
 * A binary file that grows by whole pieces. It appears under its name when it has its first one.
 * What is thrown gives only the reason, without the file's name.
 */
class CGrowingFile : private CNonCopyable {
 public:
  CGrowingFile() = default;
  ~CGrowingFile() { Abandon(); }

  /**
   * Creates the file with its first piece, or replaces an older one of the same format; writes
   * devices and FIFOs directly. While it is open, others of this class cannot replace it.
   * @param magic  how files of the format begin: others are not replaced unless they are empty.
   * @throws CARGoSException
   */
  void Create(const std::string& path, std::string_view magic, std::string_view start);
  /** Checks whether a file could be created, and changes nothing. @throws CARGoSException */
  static void Check(const std::string& path, std::string_view magic);
  /** @throws CARGoSException after which the file ends with the last whole piece. */
  void Append(std::string_view piece);
  /** @throws CARGoSException if the system reports that not all was written. */
  void Close();
  /** Closes it; failures are ignored. */
  void Abandon();

  /** Bytes that were written. */
  UInt64 GetSize() const { return m_size; }

 private:
  static void CheckReplaceable(const std::string& path, std::string_view magic, bool mayBeLocked);
  void CreateRegular(const std::string& path, std::string_view magic, std::string_view start);

  int m_file = -1;
  UInt64 m_size = 0;
  bool m_isRegular = false;
};

}  // namespace argos

#endif
