// A plug-in of clang-tidy 14, compiled and loaded by scripts/tidy.sh. It is no part of the
// simulator.
//
//   argos-own-code
//     Reports nothing; limits all other checks to code outside of system headers. They would search
//     the standard library and Catch2 once for each unit, which takes longer than all the rest.
//   argos-includes
//     Reports includes of this project's headers that the file does not need, in the unit itself,
//     or in the sources that a unit of a unity build includes, and in the headers of the same
//     names.

#include <clang-tidy/ClangTidyCheck.h>
#include <clang-tidy/ClangTidyModule.h>
#include <clang-tidy/ClangTidyModuleRegistry.h>

#include <clang/AST/ASTContext.h>
#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/ASTMatchers/ASTMatchFinder.h>
#include <clang/ASTMatchers/ASTMatchers.h>
#include <clang/Lex/PPCallbacks.h>
#include <clang/Lex/Preprocessor.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace argos_checks {

using clang::FileEntry;
using clang::SourceLocation;
using clang::SourceManager;

const FileEntry* FileOf(const SourceManager& sources, SourceLocation location) {
  return sources.getFileEntryForID(sources.getFileID(sources.getFileLoc(location)));
}

class COwnCodeCheck : public clang::tidy::ClangTidyCheck {
 public:
  using ClangTidyCheck::ClangTidyCheck;

  void registerMatchers(clang::ast_matchers::MatchFinder* finder) override {
    finder->addMatcher(clang::ast_matchers::translationUnitDecl(), this);
  }

  void check(const clang::ast_matchers::MatchFinder::MatchResult& result) override {
    // the translation unit is visited before its declarations, so this applies to the visit that is
    // under way
    std::vector<clang::Decl*> own;
    for (clang::Decl* declaration : result.Context->getTranslationUnitDecl()->decls()) {
      if (!result.SourceManager->isInSystemHeader(
              result.SourceManager->getFileLoc(declaration->getLocation()))) {
        own.push_back(declaration);
      }
    }
    result.Context->setTraversalScope(own);
  }
};

/** Which files of this project include which, and whose macros each of them uses. */
struct SPreprocessed {
  struct SInclude {
    const FileEntry* File = nullptr;
    SourceLocation Location;
    std::string Name;
  };

  std::map<const FileEntry*, std::vector<SInclude>> Includes;
  std::map<const FileEntry*, std::set<const FileEntry*>> Uses;
};

class CRecorder : public clang::PPCallbacks {
 public:
  CRecorder(const SourceManager& sources, SPreprocessed& record)
      : m_sources(sources), m_record(record) {}

  void InclusionDirective(SourceLocation hash, const clang::Token&, llvm::StringRef name, bool,
                          clang::CharSourceRange, const FileEntry* file, llvm::StringRef,
                          llvm::StringRef, const clang::Module*,
                          clang::SrcMgr::CharacteristicKind kind) override {
    const FileEntry* includer = FileOf(m_sources, hash);
    if (includer != nullptr && file != nullptr && !clang::SrcMgr::isSystem(kind)) {
      m_record.Includes[includer].push_back({file, hash, name.str()});
    }
  }

  void MacroExpands(const clang::Token& token, const clang::MacroDefinition& macro,
                    clang::SourceRange, const clang::MacroArgs*) override {
    Use(token, macro);
  }

  void Defined(const clang::Token& token, const clang::MacroDefinition& macro,
               clang::SourceRange) override {
    Use(token, macro);
  }

  void Ifdef(SourceLocation, const clang::Token& token,
             const clang::MacroDefinition& macro) override {
    Use(token, macro);
  }

  void Ifndef(SourceLocation, const clang::Token& token,
              const clang::MacroDefinition& macro) override {
    Use(token, macro);
  }

 private:
  void Use(const clang::Token& token, const clang::MacroDefinition& macro) {
    if (const clang::MacroInfo* info = macro.getMacroInfo()) {
      m_record.Uses[FileOf(m_sources, token.getLocation())].insert(
          FileOf(m_sources, info->getDefinitionLoc()));
    }
  }

  const SourceManager& m_sources;
  SPreprocessed& m_record;
};

/**
 * Collects, for each of some files, the files with the declarations that it needs. Conservative:
 * the type of every expression counts, named or not.
 */
class CUses : public clang::RecursiveASTVisitor<CUses> {
 public:
  CUses(const SourceManager& sources, SPreprocessed& record,
        const std::set<const FileEntry*>& checked)
      : m_sources(sources), m_record(record), m_checked(checked) {}

  bool shouldVisitTemplateInstantiations() const { return false; }
  bool shouldVisitImplicitCode() const { return true; }

  bool TraverseDecl(clang::Decl* declaration) {
    if (declaration == nullptr) {
      return true;
    }
    const FileEntry* outer = m_file;
    if (declaration->getLocation().isValid()) {
      m_file = FileOf(m_sources, declaration->getLocation());
    }
    if (m_checked.count(m_file) != 0 || llvm::isa<clang::DeclContext>(declaration)) {
      RecursiveASTVisitor::TraverseDecl(declaration);
    }
    m_file = outer;
    return true;
  }

  bool VisitNamedDecl(clang::NamedDecl* declaration) {
    // what is defined here and declared in a header belongs to that header
    NeedAllOf(declaration);
    return true;
  }

  bool VisitValueDecl(clang::ValueDecl* declaration) {
    Need(declaration->getType());
    return true;
  }

  bool VisitCXXMethodDecl(clang::CXXMethodDecl* method) {
    for (const clang::CXXMethodDecl* overridden : method->overridden_methods()) {
      NeedAllOf(overridden);
    }
    return true;
  }

  bool VisitTypeLoc(clang::TypeLoc type) {
    Need(type.getType());
    return true;
  }

  bool VisitExpr(clang::Expr* expression) {
    Need(expression->getType());
    return true;
  }

  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) {
    NeedAllOf(reference->getDecl());
    NeedAllOf(reference->getFoundDecl());
    return true;
  }

  bool VisitMemberExpr(clang::MemberExpr* member) {
    NeedAllOf(member->getMemberDecl());
    return true;
  }

  bool VisitOverloadExpr(clang::OverloadExpr* overloads) {
    for (const clang::NamedDecl* candidate : overloads->decls()) {
      NeedAllOf(candidate);
    }
    return true;
  }

  bool VisitCXXConstructExpr(clang::CXXConstructExpr* construction) {
    NeedAllOf(construction->getConstructor());
    return true;
  }

  bool VisitUsingDecl(clang::UsingDecl* declaration) {
    for (const clang::UsingShadowDecl* shadow : declaration->shadows()) {
      NeedAllOf(shadow->getTargetDecl());
    }
    return true;
  }

  bool TraverseTemplateName(clang::TemplateName name) {
    if (const clang::TemplateDecl* declaration = name.getAsTemplateDecl()) {
      NeedAllOf(declaration);
    }
    return RecursiveASTVisitor::TraverseTemplateName(name);
  }

 private:
  void NeedAllOf(const clang::Decl* declaration) {
    // a namespace is declared wherever it is opened
    if (declaration == nullptr || llvm::isa<clang::NamespaceDecl>(declaration) ||
        m_checked.count(m_file) == 0) {
      return;
    }
    for (const clang::Decl* each : declaration->redecls()) {
      m_record.Uses[m_file].insert(FileOf(m_sources, each->getLocation()));
    }
    if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(declaration)) {
      if (const clang::FunctionDecl* pattern = function->getTemplateInstantiationPattern()) {
        m_record.Uses[m_file].insert(FileOf(m_sources, pattern->getLocation()));
      }
    }
  }

  void Need(clang::QualType type) {
    if (type.isNull() || m_checked.count(m_file) == 0 ||
        !m_seen.insert({m_file, type.getAsOpaquePtr()}).second) {
      return;
    }
    if (const auto* alias = type->getAs<clang::TypedefType>()) {
      NeedAllOf(alias->getDecl());
    }
    if (const clang::TagDecl* tag = type->getAsTagDecl()) {
      NeedAllOf(tag);
      if (const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(tag)) {
        NeedAllOf(made->getSpecializedTemplate());
        for (const clang::TemplateArgument& argument : made->getTemplateArgs().asArray()) {
          if (argument.getKind() == clang::TemplateArgument::Type) {
            Need(argument.getAsType());
          }
        }
      }
    }
    if (!type->getPointeeType().isNull()) {
      Need(type->getPointeeType());
    } else if (const clang::ArrayType* array = type->getAsArrayTypeUnsafe()) {
      Need(array->getElementType());
    } else if (const auto* function = type->getAs<clang::FunctionProtoType>()) {
      Need(function->getReturnType());
      for (const clang::QualType parameter : function->param_types()) {
        Need(parameter);
      }
    }
  }

  const SourceManager& m_sources;
  SPreprocessed& m_record;
  const std::set<const FileEntry*>& m_checked;
  const FileEntry* m_file = nullptr;
  std::set<std::pair<const FileEntry*, void*>> m_seen;
};

class CIncludesCheck : public clang::tidy::ClangTidyCheck {
 public:
  using ClangTidyCheck::ClangTidyCheck;

  void registerPPCallbacks(const SourceManager& sources, clang::Preprocessor* preprocessor,
                           clang::Preprocessor*) override {
    preprocessor->addPPCallbacks(std::make_unique<CRecorder>(sources, m_record));
  }

  void registerMatchers(clang::ast_matchers::MatchFinder* finder) override {
    finder->addMatcher(clang::ast_matchers::translationUnitDecl(), this);
  }

  void check(const clang::ast_matchers::MatchFinder::MatchResult& result) override {
    const SourceManager& sources = *result.SourceManager;
    const std::set<const FileEntry*> checked = Checked(sources);
    CUses uses(sources, m_record, checked);
    for (clang::Decl* declaration : result.Context->getTranslationUnitDecl()->decls()) {
      if (!sources.isInSystemHeader(sources.getFileLoc(declaration->getLocation()))) {
        uses.TraverseDecl(declaration);
      }
    }
    for (const FileEntry* file : checked) {
      ReportUnused(file);
    }
  }

 private:
  // the unit, unless it is generated, and the header of the same name; of a unity build, all
  // sources of the unit with theirs
  std::set<const FileEntry*> Checked(const SourceManager& sources) const {
    std::set<const FileEntry*> checked;
    const FileEntry* unit = sources.getFileEntryForID(sources.getMainFileID());
    if (!unit->getName().contains("/Unity/")) {
      AddWithHeader(unit, checked);
      return checked;
    }
    const auto includes = m_record.Includes.find(unit);
    if (includes != m_record.Includes.end()) {
      for (const SPreprocessed::SInclude& each : includes->second) {
        AddWithHeader(each.File, checked);
      }
    }
    return checked;
  }

  void AddWithHeader(const FileEntry* source, std::set<const FileEntry*>& checked) const {
    const llvm::StringRef path = source->getName();
    checked.insert(source);
    const llvm::StringRef name = path.substr(path.rfind('/') + 1);
    const auto includes = m_record.Includes.find(source);
    if (includes != m_record.Includes.end()) {
      for (const SPreprocessed::SInclude& each : includes->second) {
        llvm::StringRef header = each.Name;
        header = header.substr(header.rfind('/') + 1);
        header.consume_back(".h");
        if (name == (header + ".cpp").str()) {
          checked.insert(each.File);
        }
      }
    }
  }

  void ReportUnused(const FileEntry* file) {
    const std::set<const FileEntry*>& uses = m_record.Uses[file];
    std::vector<SPreprocessed::SInclude> kept = m_record.Includes[file];
    for (const SPreprocessed::SInclude& each : m_record.Includes[file]) {
      // a unit includes its own header, whether it uses it or not
      if (IsOwnHeader(*file, each.Name) || uses.count(each.File) != 0) {
        continue;
      }
      // what the other includes include, without this one
      std::set<const FileEntry*> others;
      for (const SPreprocessed::SInclude& other : kept) {
        if (other.File != each.File) {
          AddClosure(other.File, others);
        }
      }
      std::set<const FileEntry*> with = others;
      AddClosure(each.File, with);
      const bool isNeeded = std::any_of(with.begin(), with.end(), [&](const FileEntry* brought) {
        return others.count(brought) == 0 && uses.count(brought) != 0;
      });
      if (!isNeeded) {
        diag(each.Location, "nothing of \"%0\" is used here") << each.Name;
        kept.erase(std::find_if(
            kept.begin(), kept.end(),
            [&](const SPreprocessed::SInclude& other) { return other.File == each.File; }));
      }
    }
  }

  static bool IsOwnHeader(const FileEntry& file, llvm::StringRef header) {
    const llvm::StringRef path = file.getName();
    llvm::StringRef name = path.substr(path.rfind('/') + 1);
    name = name.take_until([](char each) { return each == '.'; });
    header = header.substr(header.rfind('/') + 1);
    header.consume_back(".h");
    return name == header || name == (header + "_test").str();
  }

  void AddClosure(const FileEntry* header, std::set<const FileEntry*>& closure) {
    if (closure.insert(header).second) {
      for (const SPreprocessed::SInclude& each : m_record.Includes[header]) {
        AddClosure(each.File, closure);
      }
    }
  }

  SPreprocessed m_record;
};

class CModule : public clang::tidy::ClangTidyModule {
 public:
  void addCheckFactories(clang::tidy::ClangTidyCheckFactories& factories) override {
    factories.registerCheck<COwnCodeCheck>("argos-own-code");
    factories.registerCheck<CIncludesCheck>("argos-includes");
  }
};

const clang::tidy::ClangTidyModuleRegistry::Add<CModule> kModule(
    "argos-module", "checks of this project, and the limits of others");

}  // namespace argos_checks
