#ifndef ARGOS3_PROGRAM_CATALOGUE_PUBLIC_HEADERS_H
#define ARGOS3_PROGRAM_CATALOGUE_PUBLIC_HEADERS_H

#include <map>
#include <string>
#include <vector>

namespace argos {

/** A declaration in a header, and its comment. */
struct SDeclaration {
  std::string Code; /**< has one line and no body: "Real Range = 0.0" */
  std::string Text; /**< comment, units included; paragraphs end with a newline */
};

/** A type inside a class: what a controller reads. */
struct STypeText {
  std::string Name; /**< "SPacket" */
  std::string Text;
  std::vector<SDeclaration> Fields;
};

/** What a header says of a class, and of the bases of that class below CCI_Sensor. */
struct SClassText {
  std::string Header; /**< path for #include: "argos3/.../ci_leds_actuator.h"; "" if not found */
  std::string Text;
  std::string Lua; /**< comments about what the class adds to the table "robot" */
  std::vector<SDeclaration> Methods; /**< public ones that controllers call */
  std::vector<STypeText> Types;
};

/**
 * The installed headers of control interfaces, which are read when a question is asked: their
 * comments are the only description of the methods.
 */
class CPublicHeaders {
 public:
  /** Texts by the name of the header. */
  using THeaders = std::map<std::string, std::string>;

  /**
   * Searches the folders named control_interface of the running installation, or of its build, and
   * all folders below those in the environment variable ARGOS_INCLUDE_PATH (separated by colons).
   */
  CPublicHeaders();
  explicit CPublicHeaders(const THeaders& headers);

  /** Without methods if no header defines the class. @param name  "CCI_LEDsActuator" */
  SClassText Describe(const std::string& name) const;

  /** The beginning of a definition. */
  struct SHead {
    bool IsStruct = false;
    std::string Name;
    std::string Bases;
  };

 private:
  struct SDefinition {
    std::string Header;
    SHead Head;
    std::string Text;
    std::string Body;
  };

  void AddFolder(const std::string& folder, bool onlyInterfaces);
  void AddHeader(const std::string& header, const std::string& text);
  static void AddMembers(const SDefinition& definition, SClassText& description);

  std::map<std::string, SDefinition> m_classes;  // indexed by name
};

/** The installation of the running core library: the folder above lib/argos3. */
std::string FindInstallation();

}  // namespace argos

#endif
