// What readers of elements ask for.

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/configuration/request_recorder.h>
#include <argos3/core/utility/math/vector3.h>

#include <catch2/catch.hpp>

namespace request_recorder_test {

using namespace argos;

namespace {

const SRequestedAttribute& Attribute(const SRequestedElement& element, const std::string& name) {
  REQUIRE(element.Attributes.count(name) == 1);
  return element.Attributes.at(name);
}

}  // namespace

TEST_CASE("requests: names and types are recorded, values do not change", "[core][configuration]") {
  CConfigurationDocument document;
  document.Parse("<root a='2.5' n='7' b='true' v='1,2,3' s='text'><child x='-3'/></root>");
  Real real = 0.0;
  UInt32 whole = 0;
  UInt8 small = 0;
  SInt32 negative = 0;
  bool flag = false;
  CVector3 vector;
  std::string text;
  const CRequestRecorder recorder;
  TConfigurationNode& root = document.GetRoot();
  GetNodeAttribute(root, "a", real);
  GetNodeAttribute(root, "n", whole);
  GetNodeAttribute(root, "n", small);
  GetNodeAttribute(root, "b", flag);
  GetNodeAttribute(root, "v", vector);
  GetNodeAttribute(root, "s", text);
  GetNodeAttributeOrDefault(root, "absent", real, real);
  GetNodeAttribute(GetNode(root, "child"), "x", negative);
  CHECK_FALSE(NodeExists(root, "other"));
  CHECK_THROWS(GetNodeAttribute(root, "needed", text));

  CHECK(real == 2.5);
  CHECK(whole == 7);
  CHECK(small == 7);
  CHECK(flag);
  CHECK(vector == CVector3(1.0, 2.0, 3.0));
  CHECK(text == "text");
  CHECK(negative == -3);

  const SRequestedElement* const found = recorder.GetRequests().Find({"root"});
  REQUIRE(found != nullptr);
  CHECK(Attribute(*found, "a").Expected == "a real number");
  CHECK(Attribute(*found, "n").Expected == "an integer from 0 to 255");
  CHECK(Attribute(*found, "b").Sample == "false");
  CHECK(Attribute(*found, "v").Sample == "1,1,1");
  CHECK(Attribute(*found, "s").Sample.empty());
  CHECK(Attribute(*found, "absent").Sample == "1");
  CHECK_FALSE(Attribute(*found, "absent").IsMissed);
  CHECK(Attribute(*found, "needed").IsMissed);
  REQUIRE(found->Find({"child"}) != nullptr);
  CHECK(Attribute(*found->Find({"child"}), "x").Expected.rfind("an integer from -", 0) == 0);
  REQUIRE(found->Find({"other"}) != nullptr);
  CHECK_FALSE(found->Find({"other"})->IsVisited);
}

TEST_CASE("requests: what is read as two types has none", "[core][configuration]") {
  CConfigurationDocument document;
  document.Parse("<root both='1,2,3' same='1,2,3'/>");
  const CRequestRecorder recorder;
  TConfigurationNode& root = document.GetRoot();
  CVector3 vector;
  std::string text;
  GetNodeAttribute(root, "both", vector);
  GetNodeAttribute(root, "both", text);
  GetNodeAttribute(root, "same", vector);
  GetNodeAttribute(root, "same", vector);
  // whether it is there at all says nothing about its type
  CHECK(NodeAttributeExists(root, "same"));
  const SRequestedElement* const found = recorder.GetRequests().Find({"root"});
  REQUIRE(found != nullptr);
  CHECK(Attribute(*found, "both").Sample.empty());
  CHECK(Attribute(*found, "same").Sample == "1,1,1");
}

TEST_CASE("requests: those of a copy belong to the original", "[core][configuration]") {
  CConfigurationDocument document;
  document.Parse("<root><device implementation='default'><part/></device></root>");
  const CRequestRecorder recorder;
  {
    const std::unique_ptr<TConfigurationNode> copy = GetNode(document.GetRoot(), "device").Clone();
    CHECK_FALSE(NodeAttributeExists(GetNode(*copy, "part"), "size"));
  }
  const SRequestedElement* const device =
      recorder.GetRequests().Find({"root"})->Find({"device", "default"});
  REQUIRE(device != nullptr);
  REQUIRE(device->Find({"part"}) != nullptr);
  CHECK(device->Find({"part"})->Attributes.count("size") == 1);
}

TEST_CASE("requests: iterating over attributes means any", "[core][configuration]") {
  CConfigurationDocument document;
  document.Parse("<root><params speed='3'/></root>");
  const CRequestRecorder recorder;
  TConfigurationAttributeIterator it;
  for (it = it.begin(&GetNode(document.GetRoot(), "params")); it != it.end(); ++it) {
    CHECK(it->Name() == "speed");
  }
  CHECK(recorder.GetRequests().Find({"root"})->Find({"params"})->IsOpen);
}

TEST_CASE("requests: without a recorder nothing is loose", "[core][configuration]") {
  { const CRequestRecorder recorder; }
  CConfigurationDocument document;
  document.Parse("<root a='2.5 x'/>");
  Real real = 0.0;
  CHECK_THROWS(GetNodeAttribute(document.GetRoot(), "a", real));
}

}  // namespace request_recorder_test
