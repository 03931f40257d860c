// Factories, tags, virtual tables and entity operations in code of users.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/core/utility/plugins/factory.h>
#include <argos3/core/utility/plugins/factory_impl.h>
#include <argos3/core/utility/plugins/vtable.h>

#include <catch2/catch.hpp>

using namespace argos;

/* 4.1, 4.2 factory                     */

class CAnimal {
 public:
  virtual ~CAnimal() {}
  virtual int GetLegs() = 0;
};
class CDog : public CAnimal {
 public:
  virtual int GetLegs() { return 4; }
};
class CBird : public CAnimal {
 public:
  virtual int GetLegs() { return 2; }
};

// at global scope, with and without a semicolon
REGISTER_SYMBOL(CAnimal, CDog, "dog", "author", "1.0", "brief", "long", "status")
REGISTER_SYMBOL(CAnimal, CBird, "bird", "author", "1.0", "a bird", "long", "status");

static CAnimal* MakeDog() {
  return new CDog;
}

TEST_CASE("compat: factory registers and creates classes", "[compat]") {
  CHECK(CFactory<CAnimal>::Exists("dog"));
  CHECK_FALSE(CFactory<CAnimal>::Exists("cat"));
  CAnimal* pcAnimal = CFactory<CAnimal>::New("bird");
  CHECK(pcAnimal->GetLegs() == 2);
  delete pcAnimal;
  CHECK_THROWS_AS(CFactory<CAnimal>::New("cat"), CARGoSException);
  CFactory<CAnimal>::TCreator* ptCreator = &MakeDog;
  CFactory<CAnimal>::Register("wolf", "me", "2.0", "a wolf", "a long wolf", "wild", ptCreator);
  CFactory<CAnimal>::TTypeMap& tMap = CFactory<CAnimal>::GetTypeMap();
  for (CFactory<CAnimal>::TTypeMap::iterator it = tMap.begin(); it != tMap.end(); ++it) {
    CHECK_FALSE(it->first.empty());
  }
  CHECK(tMap["wolf"]->Author == "me");
  CHECK(tMap["wolf"]->Version == "2.0");
  CHECK(tMap["wolf"]->BriefDescription == "a wolf");
  CHECK(tMap["wolf"]->LongDescription == "a long wolf");
  CHECK(tMap["wolf"]->Status == "wild");
  pcAnimal = tMap["wolf"]->Creator();
  CHECK(pcAnimal->GetLegs() == 4);
  delete pcAnimal;
  std::ostringstream cStream;
  CFactory<CAnimal>::Print(cStream);
  CHECK(cStream.str().find("a bird") != std::string::npos);
  CFactory<CAnimal>::Destroy();
  CHECK_FALSE(CFactory<CAnimal>::Exists("dog"));
}

TEST_CASE("compat: dynamic loading loads and unloads libraries", "[compat]") {
  CHECK_THROWS_AS(CDynamicLoading::LoadLibrary("no_such_library"), CARGoSException);
  CHECK_THROWS_AS(CDynamicLoading::UnloadLibrary("no_such_library"), CARGoSException);
  CDynamicLoading::TDLHandle (*pfnLoad)(const std::string&) = &CDynamicLoading::LoadLibrary;
  void (*pfnAll)() = &CDynamicLoading::LoadAllLibraries;
  void (*pfnNone)() = &CDynamicLoading::UnloadAllLibraries;
  CHECK((pfnLoad != NULL && pfnAll != NULL && pfnNone != NULL));
}

/* 4.3 tags and tables                  */

class CShape : public EnableVTableFor<CShape> {
 public:
  ENABLE_VTABLE();
  virtual ~CShape() {}
};
class CRound : public CShape {
 public:
  ENABLE_VTABLE();
};
class CEdgy : public CShape {
 public:
  ENABLE_VTABLE()
};
class CForgotten : public CRound {};

INIT_VTABLE_FOR(CShape)

struct SCornersContext {};
typedef int (*TCorners)();
static int NoCorners() {
  return 0;
}
static int ManyCorners() {
  return 9;
}
static int UnknownCorners() {
  return -1;
}

TEST_CASE("compat: tags and virtual tables dispatch by class", "[compat]") {
  CRound cRound;
  CEdgy cEdgy;
  CForgotten cForgotten;
  CShape& cShape = cRound;
  CHECK(cShape.GetTag() == (::argos::GetTag<CRound, CShape>()));
  CHECK(cEdgy.GetTag() != cRound.GetTag());
  // without ENABLE_VTABLE() a class has the tag of its base
  CHECK(cForgotten.GetTag() == cRound.GetTag());
  CHECK(STagCounter<CShape>::Count >= 3);
  CHECK((STagHolder<CRound, CShape>::Tag) == cRound.GetTag());
  CVTable<SCornersContext, CShape, TCorners>& cTable =
      GetVTable<SCornersContext, CShape, TCorners>();
  cTable.Add<CShape>(&UnknownCorners);
  cTable.Add<CRound>(&NoCorners);
  CHECK(cTable[cRound.GetTag()]() == 0);
  CHECK(cTable[cEdgy.GetTag()]() == -1);
  CHECK(cTable[12345]() == -1);
  cTable.Add<CEdgy>(&ManyCorners);
  CHECK((GetVTable<SCornersContext, CShape, TCorners>()[cEdgy.GetTag()]() == 9));
  CHECK(cTable.Size() >= 3);
}

/* 4.4 entity operations                */

class CPainter {
 public:
  std::string Painted;
};

namespace argos {

class CPaintedEntity : public CPositionalEntity {
 public:
  ENABLE_VTABLE();
  CPaintedEntity(const std::string& str_id) : CPositionalEntity(NULL, str_id) {}
  virtual std::string GetTypeDescription() const { return "painted"; }
};
class CDerivedEntity : public CPaintedEntity {
 public:
  ENABLE_VTABLE();
  CDerivedEntity(const std::string& str_id) : CPaintedEntity(str_id) {}
};
class CPaintedGroupEntity : public CComposableEntity {
 public:
  ENABLE_VTABLE();
  CPaintedGroupEntity(const std::string& str_id) : CComposableEntity(NULL, str_id) {}
  virtual std::string GetTypeDescription() const { return "painted_group"; }
};

class COperationPaint : public CEntityOperation<COperationPaint, CPainter, SOperationOutcome> {
 public:
  virtual ~COperationPaint() {}
};
class COperationPaintPaintedEntity : public COperationPaint {
 public:
  SOperationOutcome ApplyTo(CPainter& c_painter, CPaintedEntity& c_entity) {
    c_painter.Painted += c_entity.GetId();
    return SOperationOutcome(true);
  }
};
REGISTER_ENTITY_OPERATION(COperationPaint, CPainter, COperationPaintPaintedEntity,
                          SOperationOutcome, CPaintedEntity)

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CPaintedEntity)

SPACE_OPERATION_ADD_ENTITY(CDerivedEntity)
SPACE_OPERATION_REMOVE_ENTITY(CDerivedEntity)
REGISTER_SPACE_OPERATION(CSpaceOperationAddEntity, CSpaceOperationAddCDerivedEntity, CDerivedEntity)
REGISTER_SPACE_OPERATION(CSpaceOperationRemoveEntity, CSpaceOperationRemoveCDerivedEntity,
                         CDerivedEntity);

REGISTER_STANDARD_SPACE_OPERATION_ADD_COMPOSABLE(CPaintedGroupEntity)
REGISTER_STANDARD_SPACE_OPERATION_REMOVE_COMPOSABLE(CPaintedGroupEntity)

}  // namespace argos

TEST_CASE("compat: entity operations dispatch by entity class", "[compat]") {
  CPainter cPainter;
  CPaintedEntity cPainted("p");
  CDerivedEntity cDerived("d");
  CHECK(
      CallEntityOperation<COperationPaint, CPainter, SOperationOutcome>(cPainter, cPainted).Value);
  CHECK(cPainter.Painted == "p");
  // no fallback to the base class
  SOperationOutcome cOutcome =
      CallEntityOperation<COperationPaint, CPainter, SOperationOutcome>(cPainter, cDerived);
  CHECK_FALSE(cOutcome());
  CHECK(cPainter.Painted == "p");
  SOperationOutcome cImplicit = true;
  CHECK(cImplicit());
  CHECK_FALSE(SOperationOutcome().Value);
}
