#ifndef ARGOS3_TESTING_SUPPORT_TERMINAL_H
#define ARGOS3_TESTING_SUPPORT_TERMINAL_H

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace argos {

/** A pseudo-terminal; what is written on it can be read. */
class CTerminal {
 public:
  /** @param columns  its width; 0: unknown, as of a serial line. */
  explicit CTerminal(unsigned short columns)
      : m_reader(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    if (m_reader < 0 || grantpt(m_reader) != 0 || unlockpt(m_reader) != 0) {
      return;
    }
    m_screen = open(ptsname(m_reader), O_RDWR | O_NOCTTY | O_CLOEXEC);
    winsize size{};
    size.ws_col = columns;
    ioctl(m_reader, TIOCSWINSZ, &size);
    fcntl(m_reader, F_SETFL, O_NONBLOCK);
  }
  ~CTerminal() {
    close(m_reader);
    close(m_screen);
  }
  CTerminal(const CTerminal&) = delete;
  CTerminal& operator=(const CTerminal&) = delete;

  /** @return file that is a terminal; -1 if the system has none. */
  int GetFile() const { return m_screen; }

  /** @return what was written since the last call; "\n" is "\r\n". */
  std::string Read() {
    std::string text;
    char buffer[1024];
    for (ssize_t size = 0; (size = read(m_reader, buffer, sizeof(buffer))) > 0;) {
      text.append(buffer, static_cast<size_t>(size));
    }
    return text;
  }

 private:
  int m_reader = -1;
  int m_screen = -1;
};

}  // namespace argos

#endif
