#include <argos3/plugins/simulator/visualizations/live/run/script_editor.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/outputs/root_components.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/wrappers/lua/lua_controller.h>
#include <argos3/core/wrappers/lua/lua_script.h>

#include <cctype>
#include <string_view>

namespace argos {

namespace {

constexpr size_t kMaxScriptBytes = size_t(3) << 16;  // in JSON, it fits into a message of a viewer

// the line that a message of Lua names: "file:12: ..."; 0 if there is none
UInt32 FindLine(const std::string& message, const std::string& file) {
  const std::string start = file + ':';
  for (size_t at = message.find(start); at != std::string::npos; at = message.find(start, at + 1)) {
    size_t digit = at + start.size();
    UInt32 line = 0;
    constexpr UInt32 kMaxLine = 100000000;
    for (; digit < message.size() &&
           std::isdigit(static_cast<unsigned char>(message[digit])) != 0 && line < kMaxLine;
         ++digit) {
      line = 10 * line + static_cast<UInt32>(message[digit] - '0');
    }
    if (line > 0) {
      return line;
    }
  }
  return 0;
}

std::string WithoutMarks(std::string message) {
  constexpr std::string_view kMark = "[FATAL] ";
  for (size_t at = message.find(kMark); at != std::string::npos; at = message.find(kMark, at)) {
    message.erase(at, kMark.size());
  }
  return message;
}

TJson DescribeError(const std::string& text, const std::string& file) {
  const std::string message = WithoutMarks(text);
  TJson answer = {{"error", message}};
  if (const UInt32 line = FindLine(message, file); line > 0) {
    answer["line"] = line;
  }
  return answer;
}

void CheckLength(const std::string& text) {
  if (text.size() > kMaxScriptBytes) {
    THROW_ARGOSEXCEPTION("a script of more than 192 KiB cannot be edited here");
  }
}

}  // namespace

CScriptEditor::SRobot CScriptEditor::GetRobot(CEntity& root) const {
  auto* const entity = FindExisting<CControllableEntity>(root);
  auto* const controller = entity != nullptr && entity->HasController()
                               ? dynamic_cast<CLuaController*>(&entity->GetController())
                               : nullptr;
  if (controller == nullptr || controller->GetScript() == nullptr) {
    THROW_ARGOSEXCEPTION('"' << root.GetId() << "\" has no controller in Lua");
  }
  if (controller->IsUnsafe()) {
    THROW_ARGOSEXCEPTION("the script of \"" << root.GetId()
                                            << "\" is unsafe=\"true\": it cannot be edited here");
  }
  return {entity, controller};
}

// @return the robots that run this file, in the order of the space
std::vector<CScriptEditor::SRobot> CScriptEditor::FindRobots(const std::string& file) const {
  std::vector<SRobot> robots;
  for (CEntity* const root : m_simulator.GetSpace().GetRootEntityVector()) {
    auto* const entity = FindExisting<CControllableEntity>(*root);
    if (entity == nullptr || !entity->HasController()) {
      continue;
    }
    auto* const controller = dynamic_cast<CLuaController*>(&entity->GetController());
    if (controller != nullptr && controller->GetScript() != nullptr &&
        controller->GetScript()->Path == file && !controller->IsUnsafe()) {
      robots.push_back({entity, controller});
    }
  }
  return robots;
}

TJson CScriptEditor::Open(CEntity& root) const {
  const std::shared_ptr<const SLuaScript>& script = GetRobot(root).Controller->GetScript();
  const auto change = m_changes.find(script->Path);
  const bool isChanged = change != m_changes.end();
  const std::string text = isChanged ? change->second.Text : script->ReadText();
  CheckLength(text);
  return {{"file", script->Path},
          {"text", text},
          {"robots", FindRobots(script->Path).size()},
          {"changed", isChanged}};
}

// a robot that an error of its script has stopped goes on
void CScriptEditor::Restart(const SRobot& robot, const std::shared_ptr<const SLuaScript>& script) {
  const bool hadFailed = !robot.Controller->IsOK();
  robot.Controller->Restart(script);
  if (hadFailed && !robot.Entity->IsQuarantined()) {
    robot.Entity->SetStopped(false);
  }
}

TJson CScriptEditor::RestartAll(const std::vector<SRobot>& robots,
                                const std::shared_ptr<const SLuaScript>& script) {
  TJson answer = {{"file", script->Path}, {"robots", robots.size()}};
  size_t numFailed = 0;
  for (const SRobot& robot : robots) {
    try {
      Restart(robot, script);
    } catch (...) {
      const std::string message = DescribeCurrentException();
      if (&robot == &robots.front()) {
        return DescribeError(message, script->Path);
      }
      LOGERR << "[ERROR] The script that a viewer has applied does not start, and the former one "
                "goes on: "
             << message << std::endl;
      ++numFailed;
    }
  }
  if (numFailed > 0) {
    answer["failed"] = numFailed;
  }
  return answer;
}

TJson CScriptEditor::Apply(CEntity& root, const std::string& text) {
  CheckLength(text);
  const std::shared_ptr<const SLuaScript> before = GetRobot(root).Controller->GetScript();
  std::shared_ptr<const SLuaScript> script;
  try {
    script = before->MakeVariant(text);
  } catch (const CARGoSException& error) {
    return DescribeError(error.what(), before->Path);
  }
  const std::vector<SRobot> robots = FindRobots(before->Path);
  TJson answer = RestartAll(robots, script);
  if (!answer.contains("error")) {
    const auto [change, isNew] = m_changes.try_emplace(before->Path);
    if (isNew) {
      change->second.Original = before;
    }
    change->second.Current = script;
    change->second.Text = text;
    answer["first"] = robots.front().Entity->GetRootEntity().GetId();
  }
  return answer;
}

void CScriptEditor::ApplyToAdded(CEntity& root) {
  const auto* const entity = FindExisting<CControllableEntity>(root);
  if (m_changes.empty() || entity == nullptr || !entity->HasController()) {
    return;
  }
  for (const auto& [file, change] : m_changes) {
    for (const SRobot& robot : FindRobots(file)) {
      if (robot.Entity == entity) {
        Restart(robot, change.Current);
      }
    }
  }
}

void CScriptEditor::Restore() {
  for (const auto& [file, change] : m_changes) {
    static_cast<void>(RestartAll(FindRobots(file), change.Original));
  }
  m_changes.clear();
}

}  // namespace argos
