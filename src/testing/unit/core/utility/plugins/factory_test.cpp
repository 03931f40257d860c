#include <argos3/core/utility/plugins/factory.h>
#include <argos3/core/utility/plugins/factory_impl.h>
#include <argos3/core/utility/plugins/vtable.h>

#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <memory>
#include <sstream>

using Catch::Contains;

// classes registered in every way that the macros must support

namespace argos {

class CTestShape {
 public:
  virtual ~CTestShape() = default;
  virtual std::string GetName() const = 0;
};

class CTestDisc : public CTestShape {
 public:
  std::string GetName() const override { return "disc"; }
};

// inside the namespace, without and with a semicolon
REGISTER_SYMBOL(CTestShape, CTestDisc, "disc", "An Author", "1.0", "A round shape", "Very round.",
                "Usable")
REGISTER_SYMBOL(CTestShape, CTestDisc,
                "di"
                "sk",
                "a", "v", "b", "l", "s");

}  // namespace argos

// at global scope, without "using namespace", a global class and one of the namespace
class CTestSquare : public argos::CTestShape {
 public:
  std::string GetName() const override { return "square"; }
};
REGISTER_SYMBOL(CTestShape, CTestSquare, "square", "a", "v", "b", "l", "s")
REGISTER_SYMBOL(CTestShape, CTestDisc, "global disc", "a", "v", "b", "l", "s");

// a base class of a user
class CTestMine {
 public:
  virtual ~CTestMine() = default;
};
REGISTER_SYMBOL(CTestMine, CTestMine, "mine", "a", "v", "b", "l", "s");

using namespace argos;

typedef CFactory<CTestShape> TShapes;

// factory

TEST_CASE("factory: macros register classes at program start", "[core][factory]") {
  for (const std::string label : {"disc", "disk", "global disc"}) {
    CAPTURE(label);
    REQUIRE(TShapes::Exists(label));
    const std::unique_ptr<CTestShape> shape(TShapes::New(label));
    CHECK(shape->GetName() == "disc");
  }
  const std::unique_ptr<CTestShape> square(TShapes::New("square"));
  CHECK(square->GetName() == "square");
  CHECK(CFactory<CTestMine>::Exists("mine"));
  CHECK_FALSE(CFactory<CTestMine>::Exists("disc"));
  CHECK_NOTHROW(ThrowRegistrationProblems("nothing is wrong"));
}

TEST_CASE("factory: the description of a class is stored with it", "[core][factory]") {
  const TShapes::TTypeMap& types = TShapes::GetTypeMap();
  REQUIRE(types.count("disc") == 1);
  const auto& info = *types.find("disc")->second;
  CHECK(info.Author == "An Author");
  CHECK(info.Version == "1.0");
  CHECK(info.BriefDescription == "A round shape");
  CHECK(info.LongDescription == "Very round.");
  CHECK(info.Status == "Usable");
  CHECK(info.Library == GetLibraryOf(reinterpret_cast<const void*>(info.Creator)));
  CHECK_FALSE(info.Library.empty());
}

TEST_CASE(
    "factory: the error on an unknown label lists the nearest, or all, and where libraries are",
    "[core][factory]") {
  CHECK_THROWS_WITH(TShapes::New("discc"),
                    Contains("there is no CTestShape \"discc\"; did you mean \"disc\"") &&
                        Contains("\n[FATAL] If a library of yours has it: name the library, with "
                                 "library=\"PATH\" in this element") &&
                        Contains("; searched in: /"));
  CHECK_THROWS_WITH(TShapes::New("xyz"), Contains("; known: disc, disk, global disc, square\n"));
}

TEST_CASE("factory: registering at run time replaces the former class silently",
          "[core][factory]") {
  class CLocal {
   public:
    virtual ~CLocal() = default;
    int Value = 0;
  };
  typedef CFactory<CLocal> TLocals;
  CHECK_THROWS_WITH(TLocals::New("x"), Contains("known: none"));
  TLocals::Register("b", "a", "v", "second", "l", "s", [] { return new CLocal; });
  TLocals::Register("a", "a", "v", "old", "l", "s", [] { return new CLocal; });
  TLocals::Register("a", "a", "v", "first", "l", "s", [] {
    auto* object = new CLocal;
    object->Value = 7;
    return object;
  });
  const std::unique_ptr<CLocal> object(TLocals::New("a"));
  CHECK(object->Value == 7);
  std::ostringstream stream;
  TLocals::Print(stream);
  CHECK(stream.str() == "   [ a ]\n      first\n\n   [ b ]\n      second\n\n");
  TLocals::Destroy();
  CHECK_FALSE(TLocals::Exists("a"));
  CHECK(TLocals::GetTypeMap().empty());
}

TEST_CASE("registration: of two classes with one label the first is kept and a problem is reported",
          "[core][factory]") {
  class COther {
   public:
    virtual ~COther() = default;
  };
  class CFirst : public COther {};
  class CSecond : public COther {};
  const auto create = []() -> COther* { return new COther; };
  const SRegisteredClass first{&typeid(CFirst), sizeof(CFirst)};
  RegisterSymbol<COther>(ARGOS_BUILD_ID, "x", "a", "v", "first", "l", "s", create, first);
  RegisterSymbol<COther>(ARGOS_BUILD_ID, "x", "a", "v", "second", "l", "s", create,
                         {&typeid(CSecond), sizeof(CSecond)});
  CHECK(CFactory<COther>::GetTypeMap()["x"]->BriefDescription == "first");
  CHECK_THROWS_WITH(ThrowRegistrationProblems("context:"),
                    Contains("context:\n[FATAL]   label \"x\" of ") &&
                        Contains("is registered twice by") && Contains("CFirst and ") &&
                        Contains("CSecond; load only one"));
  // a problem is reported once
  CHECK_NOTHROW(ThrowRegistrationProblems("context:"));

  // two versions of a class differ in their sizes
  RegisterSymbol<COther>(ARGOS_BUILD_ID, "x", "a", "v", "third", "l", "s", create,
                         {&typeid(CFirst), sizeof(CFirst) + 8});
  CHECK(CFactory<COther>::GetTypeMap()["x"]->BriefDescription == "first");
  CHECK_THROWS_WITH(ThrowRegistrationProblems("context:"),
                    Contains("with two versions of the class ") && Contains("CFirst;"));

  // the same class again
  RegisterSymbol<COther>(ARGOS_BUILD_ID, "x", "a", "v", "fourth", "l", "s", create, first);
  CHECK(CFactory<COther>::GetTypeMap()["x"]->BriefDescription == "fourth");
  CHECK_NOTHROW(ThrowRegistrationProblems("context:"));
  CHECK_THAT(TakeLogErr(),
             Contains("[WARNING] The label \"x\"") && Contains("the last one counts"));
}

TEST_CASE("registration: a class of another build is refused with the difference",
          "[core][factory]") {
  class COther2 {
   public:
    virtual ~COther2() = default;
  };
  const std::string core = GetCoreBuildId();
  CHECK(core == ARGOS_BUILD_ID);
  std::string other = core;
  Replace(other, "real=double", "real=float");
  RegisterSymbol<COther2>(other, "x", "a", "v", "b", "l", "s",
                          []() -> COther2* { return new COther2; },
                          {&typeid(COther2), sizeof(COther2)});
  CHECK_FALSE(CFactory<COther2>::Exists("x"));
  CHECK_THROWS_WITH(ThrowRegistrationProblems("context:"),
                    Contains("was built against another version or with other options: it has "
                             "real=float, the core has real=double; rebuild it"));
}

TEST_CASE("registration: a plug-in compiled against another public header is refused",
          "[core][factory]") {
  class COther3 {
   public:
    virtual ~COther3() = default;
  };
  const std::string core = GetCoreBuildId();
  const std::string::size_type hash = core.find(";media=");
  REQUIRE(hash != std::string::npos);
  const std::string built = core.substr(hash + 7, 12);
  CHECK(built.find_first_not_of("0123456789abcdef") == std::string::npos);
  std::string other = core;
  Replace(other, built, "0123456789ab");
  RegisterSymbol<COther3>(other, "x", "a", "v", "b", "l", "s",
                          []() -> COther3* { return new COther3; },
                          {&typeid(COther3), sizeof(COther3)});
  CHECK_FALSE(CFactory<COther3>::Exists("x"));
  CHECK_THROWS_WITH(
      ThrowRegistrationProblems("context:"),
      Contains("it has media=0123456789ab, the core has media=" + built + "; rebuild"));
}

// tags

namespace {

struct STestRoot : public EnableVTableFor<STestRoot> {
  virtual ~STestRoot() = default;
  virtual int Answer() { return 0; }
  ENABLE_VTABLE();
};
struct STestChild : public STestRoot {
  ENABLE_VTABLE()
  int Answer() override { return 1; }
};
struct STestGrandchild : public STestChild {
  ENABLE_VTABLE();
};
struct STestUntagged : public STestChild {};

struct STestContext {};
typedef int (*TTestFunction)(STestRoot&);
typedef CVTable<STestContext, STestRoot, TTestFunction> TTestTable;

INIT_VTABLE_FOR(STestRoot);

}  // namespace

TEST_CASE("tags: each class has its own, counted from 1, the root first", "[core][vtable]") {
  STestRoot root;
  STestChild child;
  STestGrandchild grandchild;
  STestUntagged untagged;
  STestRoot& asRoot = grandchild;
  CHECK(root.GetTag() == 1);
  CHECK(child.GetTag() != root.GetTag());
  CHECK(asRoot.GetTag() != child.GetTag());
  // a class without its own tag has that of its base
  CHECK(untagged.GetTag() == child.GetTag());
  CHECK(GetTag<STestChild, STestRoot>() == child.GetTag());
  CHECK(root.GetTagHelper(&child) == child.GetTag());
  const std::size_t grandchildTag = STagHolder<STestGrandchild, STestRoot>::Tag;
  CHECK(grandchildTag == asRoot.GetTag());
  CHECK(STagCounter<STestRoot>::Count == 3);
}

TEST_CASE("tables: a missing entry is replaced by the root's", "[core][vtable]") {
  TTestTable table;
  CHECK(table.Size() == 0);
  CHECK(table[1] == nullptr);
  table.Add<STestChild>([](STestRoot& object) { return 10 + object.Answer(); });
  STestChild child;
  STestGrandchild grandchild;
  REQUIRE(table[child.GetTag()] != nullptr);
  CHECK(table[child.GetTag()](child) == 11);
  CHECK(table[grandchild.GetTag()] == nullptr);
  table.Add<STestRoot>([](STestRoot&) { return -1; });
  CHECK(table[grandchild.GetTag()](grandchild) == -1);
  CHECK(table[1000](child) == -1);
  CHECK(table.Size() == child.GetTag() + 1);
}

TEST_CASE("tables: one per context", "[core][vtable]") {
  struct SOtherContext {};
  GetVTable<STestContext, STestRoot, TTestFunction>().Add<STestRoot>([](STestRoot&) { return 5; });
  STestRoot root;
  auto& table = GetVTable<STestContext, STestRoot, TTestFunction>();
  CHECK(table[root.GetTag()](root) == 5);
  auto& other = GetVTable<SOtherContext, STestRoot, TTestFunction>();
  CHECK(other[root.GetTag()] == nullptr);
}
