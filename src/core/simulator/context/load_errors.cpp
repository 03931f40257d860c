#include <argos3/core/simulator/context/load_errors.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <new>

namespace argos {

namespace {

constexpr char kFatal[] = "[FATAL] ";

// a chain of exceptions, outermost first, without the prefix of each line
std::string WithoutMarks(std::string text) {
  for (size_t line = 0; line != std::string::npos;) {
    if (text.compare(line, sizeof(kFatal) - 1, kFatal) == 0) {
      text.erase(line, sizeof(kFatal) - 1);
    }
    line = text.find('\n', line);
    if (line != std::string::npos) {
      ++line;
    }
  }
  return text;
}

std::string ReplaceLineBreaks(const std::string& text, const std::string& replacement) {
  std::string result;
  for (const char c : text) {
    if (c == '\n') {
      result += replacement;
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

void CLoadErrors::Add(const std::string& context, const std::exception& error) {
  const bool isLackOfMemory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  std::string message = isLackOfMemory ? "not enough memory" : WithoutMarks(error.what());
  if (!context.empty()) {
    message = context + '\n' + message;
  }
  if (std::find(m_messages.begin(), m_messages.end(), message) == m_messages.end()) {
    m_messages.push_back(message);
  }
}

void CLoadErrors::ThrowIfAny() const {
  if (m_messages.empty()) {
    return;
  }
  // the exception adds the prefix of the first line
  if (m_messages.size() == 1) {
    throw CARGoSException(ReplaceLineBreaks(m_messages.front(), std::string("\n") + kFatal));
  }
  std::string text = std::to_string(m_messages.size()) + " errors in the experiment:";
  for (size_t i = 0; i < m_messages.size(); ++i) {
    const std::string number = std::to_string(i + 1) + ". ";
    text += std::string("\n") + kFatal + number +
            ReplaceLineBreaks(m_messages[i],
                              std::string("\n") + kFatal + std::string(number.size(), ' '));
  }
  throw CARGoSException(text);
}

}  // namespace argos
