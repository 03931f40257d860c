#include <argos3/core/utility/errors/running_code.h>

namespace argos {

namespace {

thread_local SRunningCode runningCode;

}  // namespace

SRunningCode& SRunningCode::OfThread() {
  return runningCode;
}

void SRunningCode::AppendTo(CSignalSafeText& text) const {
  if (Call == nullptr) {
    return;
  }
  if (Subject != nullptr) {
    if (Describe != nullptr) {
      Describe(Subject, text);
    } else {
      text.Append(static_cast<const char*>(Subject));
    }
    text.Append(": ");
  }
  text.Append(Call);
  if (Tick != nullptr) {
    text.Append(" in tick ").AppendNumber(*Tick);
  }
}

std::string SRunningCode::ToText() const {
  CSignalSafeText text;
  AppendTo(text);
  return std::string(text.GetText(), text.GetLength());
}

}  // namespace argos
