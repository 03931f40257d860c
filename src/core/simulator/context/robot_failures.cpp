#include <argos3/core/simulator/context/robot_failures.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/line_marks.h>
#include <argos3/core/utility/logging/argos_log.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace argos {

namespace {

constexpr char kFatalMark[] = "[FATAL] ";
// prefix in errors of Lua scripts
constexpr char kTraceback[] = "stack traceback:";
// named in the summary; more of them are only counted
constexpr size_t kMaxNames = 10;

bool IsPartOfName(char character) {
  return std::isalnum(static_cast<unsigned char>(character)) != 0 || character == '_';
}

// equal for equal errors of different robots; ids that are numbers are not looked for
std::string WithoutId(std::string text, const std::string& robot) {
  const bool hasLetter = std::any_of(robot.begin(), robot.end(), [](char character) {
    return std::isalpha(static_cast<unsigned char>(character)) != 0;
  });
  const std::string wanted = hasLetter ? robot : '"' + robot + '"';
  for (size_t at = text.find(wanted); at != std::string::npos; at = text.find(wanted, at)) {
    const size_t end = at + wanted.size();
    const bool isWord = (at == 0 || !IsPartOfName(text[at - 1])) &&
                        (end == text.size() || !IsPartOfName(text[end]));
    if (isWord) {
      text.erase(at, wanted.size());
    } else {
      at = end;
    }
  }
  return text;
}

// errors of Lua scripts name the robot themselves
std::string WithContext(const std::string& robot, const std::string& context,
                        const std::string& cause) {
  const bool hasContext = cause.rfind(kFatalMark + ("robot \"" + robot + '"'), 0) == 0;
  return MarkLines(hasContext ? cause : context + '\n' + cause);
}

// the lines of a text, each with one mark, the first without; a traceback is left out
std::string Shorten(const std::string& text) {
  const size_t markLength = sizeof(kFatalMark) - 1;
  std::istringstream lines(text);
  std::string result;
  std::string line;
  while (std::getline(lines, line)) {
    if (line.rfind(kFatalMark, 0) == 0) {
      line.erase(0, markLength);
    }
    if (line == kTraceback) {
      break;
    }
    result += (result.empty() ? "" : '\n' + (kFatalMark + std::string("  "))) + line;
  }
  return result;
}

std::string ListRobots(const std::vector<std::string>& robots) {
  std::string list;
  for (size_t i = 0; i < std::min(robots.size(), kMaxNames); ++i) {
    list += (i > 0 ? ", \"" : "\"") + robots[i] + '"';
  }
  if (robots.size() > kMaxNames) {
    list += " and " + std::to_string(robots.size() - kMaxNames) + " more";
  }
  return list;
}

}  // namespace

void CRobotFailures::Note(const std::string& robot, UInt32 tick, const std::string& context,
                          const std::string& cause) {
  SNote note{CARGoSLog::GetSequence(), robot, tick, WithContext(robot, context, cause),
             WithoutId(cause, robot)};
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_notes.push_back(std::move(note));
}

void CRobotFailures::Report() {
  if (m_notes.empty()) {
    return;
  }
  std::ranges::stable_sort(m_notes, {}, &SNote::Place);
  for (SNote& note : m_notes) {
    const auto [found, isNew] = m_errorByKey.emplace(note.Key, m_errors.size());
    const size_t number = found->second;
    if (isNew) {
      LOGERR << note.Text << std::endl;
      m_errors.push_back({note.Text, note.Key, 0, note.Tick, {}});
    }
    ARGOS_ASSERT(number < m_errors.size(), "there is no error number " << number);
    SError& error = m_errors[number];
    ++error.Count;
    if (m_named.emplace(number, note.Robot).second) {
      error.Robots.push_back(note.Robot);
    }
  }
  m_notes.clear();
}

void CRobotFailures::Clear() {
  m_notes.clear();
  m_errors.clear();
  m_errorByKey.clear();
  m_named.clear();
}

std::string CRobotFailures::Summarize() const {
  std::ostringstream text;
  for (const SError& error : m_errors) {
    text << kFatalMark << (error.Count == 1 ? "once" : std::to_string(error.Count) + " times")
         << ", first in tick " << error.FirstTick << ", of " << ListRobots(error.Robots) << ": "
         << Shorten(error.Text) << '\n';
  }
  return text.str();
}

}  // namespace argos
