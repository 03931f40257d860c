#include <argos3/program/catalogue/public_headers.h>

#include <argos3/core/utility/plugins/registration.h>
#include <argos3/program/catalogue/header_scanner.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
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

// "class A" of "template <class B> class A : public C"
struct SHead {
  bool IsStruct = false;
  std::string Name;
  std::string Bases;
};

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

STypeText DescribeType(const std::string& name, const std::string& text, const std::string& body) {
  STypeText type{name, text, {}};
  CHeaderScanner members(body);
  bool isPublic = true;
  while (members.Next()) {
    if (!members.GetLabel().empty()) {
      isPublic = members.GetLabel() == "public";
    } else if (isPublic && members.GetCode().find('(') == std::string::npos &&
               members.GetCode().rfind("typedef", 0) != 0 &&
               members.GetCode().rfind("enum", 0) != 0 &&
               members.GetCode().rfind("using", 0) != 0) {
      std::string code = members.GetCode();
      code = code.substr(0, code.find(" ="));
      type.Fields.push_back({code, members.GetComment()});
    }
  }
  return type;
}

STypeText DescribeEnum(const std::string& name, const std::string& text, const std::string& body) {
  STypeText type{name, text, {}};
  static const std::regex kValue(
      "(\\w+)\\s*(?:=[^,/]*)?,?[ ]*(?:/\\*\\*<\\s*((?:[^*]|\\*[^/])*)\\*/)?");
  for (std::sregex_iterator it(body.begin(), body.end(), kValue), end; it != end; ++it) {
    type.Fields.push_back({(*it)[1], PlainComment((*it)[2])});
  }
  return type;
}

std::string ReadFile(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
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
    // in the folder of a build each library has a folder of its own
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
    // as users include it; a build has further folders above "argos3"
    const std::string path = header.string();
    const size_t start = path.rfind("/argos3/");
    AddHeader(onlyInterfaces && start != std::string::npos
                  ? path.substr(start + 1)
                  : header.lexically_relative(folder).string(),
              ReadFile(header));
  }
}

void CPublicHeaders::AddHeader(const std::string& header, const std::string& text) {
  CHeaderScanner declarations(text);
  while (declarations.Next()) {
    if (declarations.GetCode().rfind("namespace", 0) == 0) {
      AddHeader(header, declarations.GetBody());
      continue;
    }
    SHead head;
    if (!declarations.GetBody().empty() && ReadHead(declarations.GetCode(), head)) {
      m_classes.try_emplace(head.Name, SDefinition{header, declarations.GetComment(), head.Bases,
                                                   declarations.GetBody(), head.IsStruct});
    }
  }
}

void CPublicHeaders::AddMembers(const SDefinition& definition, SClassText& description) const {
  CHeaderScanner members(definition.Body);
  bool isPublic = definition.IsStruct;
  const auto self = std::find_if(m_classes.begin(), m_classes.end(),
                                 [&](const auto& known) { return &known.second == &definition; });
  while (members.Next()) {
    if (!members.GetLabel().empty()) {
      isPublic = members.GetLabel() == "public";
      continue;
    }
    const std::string& code = members.GetCode();
    SHead head;
    if (members.GetComment().rfind("robot.", 0) == 0) {
      description.Lua += members.GetComment() + '\n';
    }
    if (!isPublic) {
      continue;
    }
    if (ReadHead(code, head) && !members.GetBody().empty()) {
      description.Types.push_back(DescribeType(head.Name, members.GetComment(), members.GetBody()));
    } else if (code.rfind("enum ", 0) == 0 && !members.GetBody().empty()) {
      const std::string name = code.substr(code.find_last_of(' ') + 1);
      description.Types.push_back(DescribeEnum(name, members.GetComment(), members.GetBody()));
    } else if (IsForControllers(code, self->first)) {
      description.Methods.push_back({Cleaned(code), members.GetComment()});
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
    const std::string& bases = definition->second.Bases;
    for (std::sregex_iterator it(bases.begin(), bases.end(), kWord), end; it != end; ++it) {
      waiting.push_back(it->str());
    }
  }
  return description;
}

}  // namespace argos
