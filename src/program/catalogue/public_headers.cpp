#include <argos3/program/catalogue/public_headers.h>

#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/plugins/registration.h>
#include <argos3/program/catalogue/header_scanner.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

namespace argos {

namespace {

namespace fs = std::filesystem;

// the core's own, whose methods are not listed for each device
bool IsCommonBase(const std::string& name) {
  return name == "CCI_Sensor" || name == "CCI_Actuator";
}

using SHead = CPublicHeaders::SHead;

// "class A" of "template <class B> class A : public C"
bool ReadHead(const std::string& code, SHead& head) {
  static const std::regex kPattern(
      "^(?:template ?<.*> ?)?(class|struct) (\\w+)(?: final)?(?: ?: ?(.*))?$");
  std::smatch match;
  if (!std::regex_match(code, match, kPattern)) {
    return false;
  }
  head = {match[1] == "struct", match[2], match[3]};
  return true;
}

// false for what only the simulator calls
bool IsForControllers(const std::string& code, const std::string& className) {
  static const std::regex kNot(
      ".*\\boverride\\b.*|.*\\boperator\\b.*|.*~.*|.*= delete|.*= default|(typedef|using|friend|"
      "enum|static_assert|template)\\b.*");
  const size_t bracket = code.find('(');
  if (bracket == std::string::npos || std::regex_match(code, kNot)) {
    return false;
  }
  // a constructor has the name of its class
  const std::string name = code.substr(0, bracket);
  return name != className && name != "explicit " + className;
}

std::string Cleaned(const std::string& code) {
  static const std::regex kNoise("^virtual | = 0$|\\bargos::");
  return std::regex_replace(code, kNoise, "");
}

bool IsAccess(const std::string& code) {
  return code == "public" || code == "protected" || code == "private";
}

STypeText DescribeType(const std::string& name, const SHeaderItem& type) {
  static const std::regex kNoField(".*\\(.*|(typedef|enum|using)\\b.*");
  STypeText text{name, type.Comment, {}};
  bool isPublic = true;
  for (const SHeaderItem& member : SplitDeclarations(type.Body)) {
    if (IsAccess(member.Code)) {
      isPublic = member.Code == "public";
    } else if (isPublic && !std::regex_match(member.Code, kNoField)) {
      text.Fields.push_back({member.Code.substr(0, member.Code.find(" =")), member.Comment});
    }
  }
  return text;
}

STypeText DescribeEnum(const std::string& name, const SHeaderItem& type) {
  static const std::regex kValue(
      "(\\w+)\\s*(?:=[^,/]*)?,?[ ]*(?:/\\*\\*<\\s*((?:[^*]|\\*[^/])*)\\*/)?");
  STypeText text{name, type.Comment, {}};
  for (std::sregex_iterator it(type.Body.begin(), type.Body.end(), kValue), end; it != end; ++it) {
    text.Fields.push_back({(*it)[1], PlainComment((*it)[2])});
  }
  return text;
}

}  // namespace

std::string FindInstallation() {
  std::error_code failure;
  const fs::path library =
      fs::canonical(GetLibraryOf(reinterpret_cast<const void*>(&FindInstallation)), failure);
  return library.parent_path().parent_path().parent_path().string();
}

CPublicHeaders::CPublicHeaders() {
  const fs::path include = fs::path(FindInstallation()) / "include";
  std::error_code failure;
  std::set<std::string> folders;
  if (fs::exists(include / "argos3/core", failure)) {
    folders.insert(include.string());
  } else {
    // each library has a folder of its own in the folder of a build
    for (const auto& entry : fs::directory_iterator(include, failure)) {
      folders.insert(entry.path().string());
    }
  }
  for (const std::string& folder : folders) {
    AddFolder(folder, true);
  }
  const char* const more = std::getenv("ARGOS_INCLUDE_PATH");
  std::istringstream list(more == nullptr ? "" : more);
  for (std::string folder; std::getline(list, folder, ':');) {
    AddFolder(folder, false);
  }
}

CPublicHeaders::CPublicHeaders(const THeaders& headers) {
  for (const auto& [header, text] : headers) {
    AddHeader(header, text);
  }
}

void CPublicHeaders::AddFolder(const std::string& folder, bool onlyInterfaces) {
  constexpr auto kOptions = fs::directory_options::follow_directory_symlink |
                            fs::directory_options::skip_permission_denied;
  std::error_code failure;
  std::set<fs::path> headers;
  for (auto it = fs::recursive_directory_iterator(folder, kOptions, failure);
       !failure && it != fs::recursive_directory_iterator(); it.increment(failure)) {
    const fs::path& path = it->path();
    if (path.extension() == ".h" &&
        (!onlyInterfaces || path.string().find("control_interface") != std::string::npos)) {
      headers.insert(path);
    }
  }
  for (const fs::path& header : headers) {
    std::string text;
    std::string problem;
    // users include it so; a build has further folders above "argos3"
    const std::string path = header.string();
    const size_t start = path.rfind("/argos3/");
    if (ReadInputFile(path, text, problem)) {
      AddHeader(onlyInterfaces && start != std::string::npos
                    ? path.substr(start + 1)
                    : header.lexically_relative(folder).string(),
                text);
    }
  }
}

void CPublicHeaders::AddHeader(const std::string& header, const std::string& text) {
  for (const SHeaderItem& item : SplitDeclarations(text)) {
    SHead head;
    if (item.Code.rfind("namespace", 0) == 0) {
      AddHeader(header, item.Body);
    } else if (!item.Body.empty() && ReadHead(item.Code, head)) {
      m_classes.try_emplace(head.Name, SDefinition{header, head, item.Comment, item.Body});
    }
  }
}

void CPublicHeaders::AddMembers(const SDefinition& definition, SClassText& description) {
  bool isPublic = definition.Head.IsStruct;
  for (const SHeaderItem& member : SplitDeclarations(definition.Body)) {
    const std::string& code = member.Code;
    SHead head;
    if (member.Comment.rfind("robot.", 0) == 0) {
      description.Lua += member.Comment + '\n';
    }
    if (IsAccess(code)) {
      isPublic = code == "public";
    } else if (isPublic && !member.Body.empty() && ReadHead(code, head)) {
      description.Types.push_back(DescribeType(head.Name, member));
    } else if (isPublic && !member.Body.empty() && code.rfind("enum ", 0) == 0) {
      description.Types.push_back(DescribeEnum(code.substr(code.find_last_of(' ') + 1), member));
    } else if (isPublic && IsForControllers(code, definition.Head.Name)) {
      description.Methods.push_back({Cleaned(code), member.Comment});
    }
  }
}

SClassText CPublicHeaders::Describe(const std::string& name) const {
  SClassText description;
  const auto found = m_classes.find(name);
  if (found == m_classes.end()) {
    return description;
  }
  description.Header = found->second.Header;
  description.Text = found->second.Text;
  std::set<std::string> visited;
  std::vector<std::string> waiting = {name};
  while (!waiting.empty()) {
    const std::string next = waiting.front();
    waiting.erase(waiting.begin());
    const auto definition = m_classes.find(next);
    if (definition == m_classes.end() || IsCommonBase(next) || !visited.insert(next).second) {
      continue;
    }
    AddMembers(definition->second, description);
    // bases, and arguments of bases that are templates, which may be their bases
    static const std::regex kWord("\\w+");
    const std::string& bases = definition->second.Head.Bases;
    for (std::sregex_iterator it(bases.begin(), bases.end(), kWord), end; it != end; ++it) {
      waiting.push_back(it->str());
    }
  }
  return description;
}

}  // namespace argos
