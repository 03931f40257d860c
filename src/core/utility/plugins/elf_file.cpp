#include <argos3/core/utility/plugins/elf_file.h>

#include <argos3/core/utility/non_copyable.h>

#if __has_include(<elf.h>) && __has_include(<link.h>)
#define ARGOS_HAS_ELF
#include <elf.h>
#include <link.h>
#endif

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

namespace argos {

#ifdef ARGOS_HAS_ELF

namespace {

// Bytes of a file, of which few are read. What lies beyond its end is absent, so a damaged file is
// no danger.
class CFileBytes : private CNonCopyable {
 public:
  explicit CFileBytes(const std::string& path)
      : m_file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    const ssize_t size = m_file < 0 ? 0 : pread(m_file, m_head.data(), m_head.size(), 0);
    m_headSize = size > 0 ? size_t(size) : 0;
  }
  ~CFileBytes() {
    if (m_file >= 0) {
      close(m_file);
    }
  }

  // reads up to so many bytes; fewer at the end of the file
  std::string Bytes(size_t offset, size_t size) const {
    if (offset <= m_headSize && size <= m_headSize - offset) {
      return {m_head.data() + offset, size};
    }
    std::string bytes(std::min(size, kMaxRead), '\0');
    const ssize_t count = m_file < 0 ? 0 : pread(m_file, bytes.data(), bytes.size(), off_t(offset));
    bytes.resize(count > 0 ? size_t(count) : 0);
    return bytes;
  }

  // @return false if it is not completely in the file
  template <typename T>
  bool Read(size_t offset, T& object) const {
    const std::string bytes = Bytes(offset, sizeof(T));
    if (bytes.size() < sizeof(T)) {
      return false;
    }
    std::memcpy(&object, bytes.data(), sizeof(T));
    return true;
  }

  // reads up to the next zero
  std::string Text(size_t offset) const {
    const std::string bytes = Bytes(offset, kMaxText);
    return bytes.substr(0, bytes.find('\0'));
  }

 private:
  static constexpr size_t kMaxRead = size_t(1) << 16;
  static constexpr size_t kMaxText = 1024;  // longer than names of files

  int m_file;
  // places of headers and notes
  std::array<char, 4096> m_head{};
  size_t m_headSize = 0;
};

using TSegments = std::vector<ElfW(Phdr)>;

TSegments ReadSegments(const CFileBytes& file) {
  constexpr unsigned char kClass = sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32;
  ElfW(Ehdr) header;
  if (!file.Read(0, header) || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 ||
      header.e_ident[EI_CLASS] != kClass || header.e_phentsize != sizeof(ElfW(Phdr))) {
    return {};
  }
  TSegments segments(header.e_phnum);
  for (size_t i = 0; i < segments.size(); ++i) {
    if (!file.Read(header.e_phoff + i * sizeof(ElfW(Phdr)), segments[i])) {
      return {};
    }
  }
  return segments;
}

std::string Hexadecimal(const std::string& bytes) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const char byte : bytes) {
    text += kDigits[static_cast<unsigned char>(byte) / 16];
    text += kDigits[static_cast<unsigned char>(byte) % 16];
  }
  return text;
}

// the next multiple of four: notes are padded
size_t Padded(size_t size) {
  return (size + 3) / 4 * 4;
}

std::string ReadBuildId(const CFileBytes& file, const ElfW(Phdr) & notes) {
  size_t offset = notes.p_offset;
  ElfW(Nhdr) note;
  while (offset + sizeof(note) <= notes.p_offset + notes.p_filesz && file.Read(offset, note)) {
    const size_t name = offset + sizeof(note);
    const size_t content = name + Padded(note.n_namesz);
    if (note.n_type == NT_GNU_BUILD_ID && file.Bytes(name, 4) == std::string_view("GNU\0", 4)) {
      return Hexadecimal(file.Bytes(content, note.n_descsz));
    }
    offset = content + Padded(note.n_descsz);
  }
  return "";
}

// finds the place in the file of an address of the loaded library
size_t OffsetOf(ElfW(Addr) address, const TSegments& segments) {
  for (const ElfW(Phdr) & segment : segments) {
    if (segment.p_type == PT_LOAD && address >= segment.p_vaddr &&
        address - segment.p_vaddr < segment.p_filesz) {
      return segment.p_offset + (address - segment.p_vaddr);
    }
  }
  return size_t(-1);
}

std::vector<std::string> ReadNeeded(const CFileBytes& file, const ElfW(Phdr) & dynamic,
                                    const TSegments& segments) {
  std::vector<size_t> names;
  size_t texts = size_t(-1);
  const std::string entries = file.Bytes(dynamic.p_offset, dynamic.p_filesz);
  ElfW(Dyn) entry;
  for (size_t i = 0; i + sizeof(entry) <= entries.size(); i += sizeof(entry)) {
    std::memcpy(&entry, entries.data() + i, sizeof(entry));
    if (entry.d_tag == DT_NULL) {
      break;
    }
    if (entry.d_tag == DT_NEEDED) {
      names.push_back(entry.d_un.d_val);
    } else if (entry.d_tag == DT_STRTAB) {
      texts = OffsetOf(entry.d_un.d_ptr, segments);
    }
  }
  std::vector<std::string> needed;
  for (const size_t name : names) {
    if (texts != size_t(-1)) {
      needed.push_back(file.Text(texts + name));
    }
  }
  return needed;
}

}  // namespace

std::string ReadBuildId(const std::string& path) {
  const CFileBytes file(path);
  for (const ElfW(Phdr) & segment : ReadSegments(file)) {
    std::string id = segment.p_type == PT_NOTE ? ReadBuildId(file, segment) : "";
    if (!id.empty()) {
      return id;
    }
  }
  return "";
}

std::vector<std::string> ListNeeded(const std::string& path) {
  const CFileBytes file(path);
  const TSegments segments = ReadSegments(file);
  for (const ElfW(Phdr) & segment : segments) {
    if (segment.p_type == PT_DYNAMIC) {
      return ReadNeeded(file, segment, segments);
    }
  }
  return {};
}

#else

std::string ReadBuildId(const std::string&) {
  return "";
}

std::vector<std::string> ListNeeded(const std::string&) {
  return {};
}

#endif

}  // namespace argos
