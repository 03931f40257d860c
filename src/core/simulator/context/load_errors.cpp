#include <argos3/core/simulator/context/load_errors.h>

#include <argos3/core/utility/configuration/attribute_repairs.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <new>

namespace argos {

namespace {

// more lines hide those printed first
constexpr size_t kMaxMessages = 50;

// the text to which exceptions that wrap a std::bad_alloc turn it
constexpr char kLackOfMemory[] = "not enough memory";

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

bool CLoadErrors::Add(const std::string& context, const std::exception& error) {
  const bool isBadAlloc = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  std::string message = isBadAlloc ? kLackOfMemory : WithoutMarks(error.what());
  m_lacksMemory = m_lacksMemory || message.find(kLackOfMemory) != std::string::npos;
  if (!context.empty()) {
    message = context + '\n' + message;
  }
  if (std::find(m_messages.begin(), m_messages.end(), message) != m_messages.end()) {
    return false;
  }
  m_messages.push_back(message);
  return true;
}

void CLoadErrors::FindFurther(const std::function<void()>& read) {
  // attributes of an element
  constexpr int kMaxAttempts = 20;
  CAttributeRepairs repairs;
  for (int attempt = 0; attempt < kMaxAttempts && !m_lacksMemory; ++attempt) {
    try {
      read();
      return;
    } catch (const CAlreadyReported&) {
      return;
    } catch (const std::exception& error) {
      // the first attempt repeats the error that is known
      const bool isNew = Add("", error);
      if ((attempt > 0 && !isNew) || !repairs.RepairLast()) {
        return;
      }
    }
  }
}

void CLoadErrors::ThrowIfAny(const std::string& title) const {
  if (m_messages.empty()) {
    return;
  }
  // the exception adds the prefix of the first line
  if (m_messages.size() == 1) {
    throw CARGoSException(ReplaceLineBreaks(m_messages.front(), std::string("\n") + kFatal));
  }
  std::string text = std::to_string(m_messages.size()) + ' ' + title + ':';
  const size_t printed = std::min(m_messages.size(), kMaxMessages);
  for (size_t i = 0; i < printed; ++i) {
    const std::string number = std::to_string(i + 1) + ". ";
    text += std::string("\n") + kFatal + number +
            ReplaceLineBreaks(m_messages[i],
                              std::string("\n") + kFatal + std::string(number.size(), ' '));
  }
  if (printed < m_messages.size()) {
    text += std::string("\n") + kFatal + "... and " + std::to_string(m_messages.size() - printed) +
            " errors more";
  }
  throw CARGoSException(text);
}

void CLoadErrors::ThrowIfFailed(const std::string& title) const {
  ThrowIfAny(title);
  if (m_hasConsequences) {
    throw CAlreadyReported(title);
  }
}

}  // namespace argos
