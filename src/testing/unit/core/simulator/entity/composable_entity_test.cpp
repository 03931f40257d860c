#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <memory>

namespace composable_entity_test {

using namespace argos;
using Catch::Contains;

namespace {

/** root: part[a] (position x = 1), part[b] (x = 2), box[inner]: part[a] (x = 3), part[x.y] (x = 4)
 */
class CTree {
 public:
  CTree() : Root(nullptr, "root") {
    Add(Root, "a", 1.0);
    Add(Root, "b", 2.0);
    auto inner = std::make_unique<CInner>(&Root, "inner");
    Inner = inner.get();
    Root.AddComponent(*inner.release());
    Add(*Inner, "a", 3.0);
    Add(*Inner, "x.y", 4.0);
  }

  class CPart : public CPositionalEntity {
   public:
    ENABLE_VTABLE()
    using CPositionalEntity::CPositionalEntity;
    std::string GetTypeDescription() const override { return "part"; }
    void Update() override { ++Updates; }
    int Updates = 0;
  };
  class CInner : public CComposableEntity {
   public:
    ENABLE_VTABLE()
    using CComposableEntity::CComposableEntity;
    std::string GetTypeDescription() const override { return "inner"; }
  };

  static void Add(CComposableEntity& parent, const std::string& id, Real x) {
    parent.AddComponent(*std::make_unique<CPart>(&parent, id, CVector3(x, 0.0, 0.0)).release());
  }
  Real Find(const std::string& path) { return Root.GetComponent<CPart>(path).GetPosition().GetX(); }

  CComposableEntity Root;
  CInner* Inner = nullptr;
};

/* Uses an anchor of a body while it is enabled, as antennas and LEDs do. */
class CAnchorUser : public CPositionalEntity {
 public:
  ENABLE_VTABLE()
  CAnchorUser(CComposableEntity* parent, const std::string& id, CEmbodiedEntity& body)
      : CPositionalEntity(parent, id, CVector3()), m_body(body) {
    m_body.EnableAnchor("tool");
  }
  std::string GetTypeDescription() const override { return "user"; }
  void SetEnabled(bool enabled) override {
    if (enabled != IsEnabled()) {
      enabled ? m_body.EnableAnchor("tool") : m_body.DisableAnchor("tool");
    }
    CPositionalEntity::SetEnabled(enabled);
  }

 private:
  CEmbodiedEntity& m_body;
};

}  // namespace

TEST_CASE("component path: type, type[id], nested, and ids with dots", "[core][entity]") {
  CTree tree;
  CHECK(tree.Find("part[a]") == 1.0);
  CHECK(tree.Find("part[b]") == 2.0);
  CHECK(tree.Find("part") == 1.0);
  CHECK(tree.Find("inner.part[a]") == 3.0);
  CHECK(tree.Find("inner[inner].part") == 3.0);
  CHECK(tree.Find("inner[inner].part[x.y]") == 4.0);
  CHECK(&tree.Root.GetComponent("inner") == tree.Inner);
}

TEST_CASE("component path: errors name the entity, the path and the components that exist",
          "[core][entity]") {
  CTree tree;
  CHECK_FALSE(tree.Root.HasComponent("part[c]"));
  CHECK_FALSE(tree.Root.HasComponent("prat"));
  CHECK_FALSE(tree.Root.HasComponent("inner.part[b]"));
  CHECK_FALSE(tree.Root.HasComponent("part[a].part"));
  CHECK_FALSE(tree.Root.HasComponent(""));
  CHECK_THROWS_WITH(tree.Root.GetComponent("prat"),
                    Contains("root") && Contains("prat") && Contains("part"));
  CHECK_THROWS_WITH(tree.Root.GetComponent("part[a"), Contains("part[a") && Contains("]"));
  CHECK_THROWS_WITH(tree.Root.GetComponent<CEmbodiedEntity>("part[a]"),
                    Contains("part[a]") && Contains("root"));
}

TEST_CASE("components: the vector keeps the order of addition, the map is keyed by type",
          "[core][entity]") {
  CTree tree;
  REQUIRE(tree.Root.GetComponentVector().size() == 3);
  CHECK(tree.Root.GetComponentVector()[0]->GetId() == "a");
  CHECK(tree.Root.GetComponentVector()[2]->GetId() == "inner");
  CHECK(tree.Root.GetComponentMap().count("part") == 2);
  CHECK(tree.Root.GetComponentMap().count("inner") == 1);
  const auto found = tree.Root.FindComponent("part[b]");
  REQUIRE(found != tree.Root.GetComponentMap().end());
  CHECK(found->first == "part");
  CHECK(found->second->GetId() == "b");
  CHECK(tree.Root.FindComponent("part[c]") == tree.Root.GetComponentMap().end());
}

TEST_CASE("components: a removed component belongs to the caller", "[core][entity]") {
  CTree tree;
  const std::unique_ptr<CEntity> removed(&tree.Root.RemoveComponent("inner.part[a]"));
  CHECK(removed->GetId() == "a");
  CHECK_FALSE(tree.Root.HasComponent("inner.part[a]"));
  CHECK(tree.Inner->GetComponentMap().count("part") == 1);
  CHECK_THROWS_AS(tree.Root.RemoveComponent("inner.part[a]"), CARGoSException);
}

TEST_CASE("entity: context, parent and root", "[core][entity]") {
  CTree tree;
  CEntity& part = tree.Root.GetComponent("inner.part[a]");
  CHECK(part.GetContext() == "root.inner.");
  CHECK(tree.Root.GetContext().empty());
  CHECK(part.HasParent());
  CHECK_FALSE(tree.Root.HasParent());
  CHECK(&part.GetParent() == tree.Inner);
  CHECK(&part.GetRootEntity() == &tree.Root);
  CHECK(&static_cast<const CEntity&>(part).GetRootEntity() == &tree.Root);
  CHECK_THROWS_WITH(tree.Root.GetParent(), Contains("root"));
  CHECK(tree.Root.GetIndex() == -1);
  CHECK(tree.Root.GetTypeDescription() == "composite");
}

TEST_CASE("components: enabling and updating reach every component", "[core][entity]") {
  CTree tree;
  auto& part = tree.Root.GetComponent<CTree::CPart>("part[a]");
  auto& nested = tree.Root.GetComponent<CTree::CPart>("inner.part[a]");
  tree.Root.Update();
  CHECK(part.Updates == 1);
  CHECK(nested.Updates == 1);
  part.Disable();
  tree.Root.Update();
  CHECK(part.Updates == 1);
  CHECK(nested.Updates == 2);
  tree.Root.Disable();
  CHECK_FALSE(nested.IsEnabled());
  tree.Root.Update();
  CHECK(nested.Updates == 2);
  tree.Root.Enable();
  CHECK(part.IsEnabled());
  tree.Root.Update();
  CHECK(part.Updates == 2);
  CHECK(nested.Updates == 3);
}

TEST_CASE("components: a reset reaches every component", "[core][entity]") {
  CTree tree;
  auto& nested = tree.Root.GetComponent<CTree::CPart>("inner.part[a]");
  nested.MoveTo(CVector3(9.0, 9.0, 9.0), CQuaternion());
  tree.Root.Reset();
  CHECK(nested.GetPosition() == CVector3(3.0, 0.0, 0.0));
}

TEST_CASE("components: the uses of an anchor are those of the start after a reset",
          "[core][entity]") {
  const bool isBodyFirst = GENERATE(true, false);
  CAPTURE(isBodyFirst);
  CComposableEntity root(nullptr, "root");
  auto body = std::make_unique<CEmbodiedEntity>(&root, "body", CVector3());
  const SAnchor& tool = body->AddAnchor("tool");
  auto owned = std::make_unique<CAnchorUser>(&root, "user", *body);
  CAnchorUser& user = *owned;
  if (isBodyFirst) {
    root.AddComponent(*body.release());
    root.AddComponent(*owned.release());
  } else {
    root.AddComponent(*owned.release());
    root.AddComponent(*body.release());
  }
  // what is in the arena has an index, and a start to which it returns
  user.SetIndex(1);
  root.MarkStart();
  user.Disable();
  CHECK(tool.InUseCount == 0);
  root.ReturnToStart();
  CHECK(user.IsEnabled());
  CHECK(tool.InUseCount == 1);
}

TEST_CASE("components: those without an id are numbered by type", "[core][entity]") {
  CConfigurationDocument document;
  document.Parse("<part />");
  CComposableEntity root(nullptr, "root");
  for (const std::string expected : {"part_0", "part_1", "part_2"}) {
    auto part = std::make_unique<CTree::CPart>(&root);
    part->Init(document.GetRoot());
    CHECK(part->GetId() == expected);
    root.AddComponent(*part.release());
  }
  document.Parse("<part id='own' />");
  CTree::CPart part(&root);
  part.Init(document.GetRoot());
  CHECK(part.GetId() == "own");
}

TEST_CASE("entity: a root entity without an id is an error with its line", "[core][entity]") {
  CConfigurationDocument document;
  document.Parse("<a>\n<toy-lamp position='0,0,0' />\n</a>", "file.argos");
  CToyLampEntity lamp;
  CHECK_THROWS_WITH(lamp.Init(GetNode(document.GetRoot(), "toy-lamp")),
                    Contains("file.argos:2") && Contains("id"));
}

TEST_CASE("entity comparator: orders by index", "[core][entity]") {
  CToyLampEntity a("a");
  CToyLampEntity b("b");
  a.SetIndex(1);
  b.SetIndex(2);
  const SEntityComparator before;
  CHECK(before(a, b));
  CHECK_FALSE(before(b, a));
  CHECK(before(&a, &b));
  CHECK_FALSE(before(&a, &a));
}

TEST_CASE("digest of an entity: changes with each component", "[core][entity][digest]") {
  CTree tree;
  const auto digestOf = [&] {
    CDigest digest;
    tree.Root.UpdateDigest(digest);
    return digest.GetValue();
  };
  const UInt64 before = digestOf();
  auto& nested = tree.Root.GetComponent<CTree::CPart>("inner.part[a]");
  nested.MoveTo(CVector3(3.0, 0.0, 4e-324), CQuaternion());
  CHECK(digestOf() != before);
  nested.MoveTo(CVector3(3.0, 0.0, 0.0), CQuaternion());
  CHECK(digestOf() == before);
  nested.Disable();
  CHECK(digestOf() != before);
}

}  // namespace composable_entity_test
