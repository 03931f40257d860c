#include <argos3/core/utility/configuration/argos_configuration.h>

#include <argos3/core/utility/configuration/attribute_text.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <memory>
#include <sstream>

namespace argos_configuration_test {

using namespace argos;
using Catch::Contains;
using Catch::StartsWith;

namespace {

constexpr const char* kXml = R"(<root>
  <!-- a comment -->
  <robot id="r 1" speed="1.5" count="7" on="true" off="false" byte="200" sbyte="-100"
         color="1,2,3,4" v2="1, 2" v3="1,2,3" q="90,0,0" angle="90" rad="1.5" range="-1:2" />
  <group><item n="1"/>text<item n="2"/><other/><item n="3"/></group>
  <empty/>
  <bad real="1.5x" word="abc" unsigned="-1" fraction="10.5" big="5000000000" bool="True" v3="1,2"
       v3more="1,2,3,4" color="1,2,3" range="2:1" byte="256" inf="inf"/>
  <text> 12 </text>
  <word>abc</word>
</root>)";

// a document and short accessors to its parts
struct SWorld {
  SWorld() { Document.Parse(kXml, "test.argos"); }
  TConfigurationNode& operator[](const std::string& tag) {
    return GetNode(Document.GetRoot(), tag);
  }
  template <typename T>
  T Get(const std::string& attribute, const std::string& tag = "robot") {
    T value = T();
    GetNodeAttribute((*this)[tag], attribute, value);
    return value;
  }
  CConfigurationDocument Document;
};

std::string Print(const TConfigurationNode& node) {
  std::ostringstream stream;
  stream << node;
  return stream.str();
}

}  // namespace

// attributes

TEST_CASE("configuration: attributes of every type are read", "[core][configuration]") {
  SWorld world;
  CHECK(world.Get<std::string>("id") == "r 1");
  CHECK(world.Get<Real>("speed") == 1.5);
  CHECK(world.Get<float>("speed") == 1.5f);
  CHECK(world.Get<UInt32>("count") == 7);
  CHECK(world.Get<size_t>("count") == 7);
  CHECK(world.Get<SInt64>("sbyte") == -100);
  CHECK(world.Get<bool>("on"));
  CHECK_FALSE(world.Get<bool>("off"));
  CHECK(world.Get<UInt8>("byte") == 200);
  CHECK(world.Get<SInt8>("sbyte") == -100);
  CHECK(world.Get<CColor>("color") == CColor(1, 2, 3, 4));
  CHECK(world.Get<CVector2>("v2") == CVector2(1, 2));
  CHECK(world.Get<CVector3>("v3") == CVector3(1, 2, 3));
  CHECK(world.Get<CRadians>("rad").GetValue() == 1.5);
  CHECK(world.Get<CDegrees>("angle").GetValue() == 90.0);
  CHECK(world.Get<CRange<Real>>("range").GetMin() == -1.0);
  CHECK(world.Get<CRange<SInt32>>("range").GetMax() == 2);
  const auto quaternion = world.Get<CQuaternion>("q");
  // a quarter turn about Z: cos 45 deg and sin 45 deg, each rounded once
  CHECK_THAT(quaternion.GetW(), Catch::WithinAbs(0.70710678118654752, 1e-15));
  CHECK_THAT(quaternion.GetZ(), Catch::WithinAbs(0.70710678118654752, 1e-15));
}

TEST_CASE("configuration: the error on a missing attribute gives its place and what is there",
          "[core][configuration]") {
  SWorld world;
  CHECK_THROWS_WITH(world.Get<Real>("sped"),
                    "[FATAL] test.argos:3: <robot>: attribute \"sped\" is missing; is \"speed\" a "
                    "misspelling of it?");
  CHECK_THROWS_WITH(world.Get<Real>("movable"),
                    Contains("attribute \"movable\" is missing; it has: "));
  CHECK_THROWS_WITH(world.Get<Real>("x", "empty"),
                    "[FATAL] test.argos:6: <empty>: attribute \"x\" is missing; it has none");
}

TEST_CASE("configuration: errors on malformed values give the text found and the format expected",
          "[core][configuration]") {
  SWorld world;
  const auto bad = [&world](const std::string& attribute, auto value) {
    try {
      GetNodeAttribute(world["bad"], attribute, value);
    } catch (CARGoSException& ex) {
      return std::string(ex.what());
    }
    return std::string("accepted");
  };
  CHECK(bad("real", Real()) ==
        "[FATAL] test.argos:7: <bad>: attribute \"real\": found \"1.5x\", expected a real number "
        "(text follows the number)");
  CHECK(bad("word", Real()) ==
        "[FATAL] test.argos:7: <bad>: attribute \"word\": found \"abc\", expected a real number");
  CHECK_THAT(bad("inf", Real()), Contains("found \"inf\", expected a real number"));
  CHECK_THAT(bad("unsigned", UInt32()),
             Contains("expected an integer from 0 to 4294967295 (the number is out of range)"));
  CHECK_THAT(bad("fraction", SInt32()),
             Contains("expected an integer from -2147483648 to 2147483647"));
  CHECK_THAT(bad("big", UInt32()), Contains("found \"5000000000\""));
  CHECK_THAT(bad("byte", UInt8()), Contains("expected an integer from 0 to 255"));
  CHECK_THAT(bad("unsigned", UInt8()), Contains("expected an integer from 0 to 255"));
  CHECK_THAT(bad("byte", SInt8()), Contains("expected an integer from -128 to 127"));
  CHECK_THAT(bad("bool", bool()), Contains("found \"True\", expected \"true\" or \"false\""));
  CHECK_THAT(bad("v3", CVector3()), Contains("expected three real numbers, \"x,y,z\""));
  CHECK_THAT(bad("v3more", CVector3()), Contains("found \"1,2,3,4\", expected three real numbers"));
  CHECK_THAT(bad("word", CVector2()), Contains("expected two real numbers, \"x,y\""));
  CHECK_THAT(bad("v3", CQuaternion()), Contains("three angles in degrees"));
  CHECK_THAT(bad("color", CColor()), Contains("a colour name or four integers from 0 to 255"));
  CHECK_THAT(bad("range", CRange<Real>()), Contains("a range \"min:max\" with min <= max"));
  CHECK_THAT(bad("word", CRadians()), Contains("an angle in radians, a real number"));
  CHECK_THAT(bad("real", CDegrees()), Contains("an angle in degrees, a real number"));
  CHECK_THAT(bad("real", std::string()), Catch::Equals("accepted"));
}

TEST_CASE("configuration: numbers that are too large are errors, however they are written",
          "[core][configuration]") {
  const auto read = [](const std::string& text) {
    CConfigurationDocument document;
    document.Parse("<box size='" + text + "'/>", "test.argos");
    CVector3 size;
    GetNodeAttribute(document.GetRoot(), "size", size);
    return size;
  };
  for (const char* const text : {"1e13,0,0", "0,-2E12,0", "0,0,1000000000001",
                                 "0.25,12345678901234.5,0", "1.5,1.5,-99999999999999"}) {
    CAPTURE(text);
    CHECK_THROWS_WITH(read(text), Contains("expected real numbers from -1e+12 to 1e+12"));
  }
  for (const char* const text : {"1000000000000,0,0", "1e12,1e-300,0", "0.12345678901234567,0,0",
                                 "3.1234567890123456,-2.1234567890123456,123456789012.5"}) {
    CAPTURE(text);
    CHECK_NOTHROW(read(text));
  }
}

TEST_CASE("configuration: a lenient document reads what ARGoS 3 reads, with one warning each",
          "[core][configuration]") {
  CConfigurationDocument document;
  document.Parse(
      "<root unsigned='10.5' negative='-1' byte='12x' v3='-5,,0' v2='1,2,3' range='3:1' real='1.5 "
      "m' "
      "word='abc' bool='yes' few='1,2' color='pinkish'><child v3='1,x,2'/></root>",
      "old.argos");
  document.SetLenient();
  CConfigurationNode& root = document.GetRoot();
  UInt32 number = 0;
  GetNodeAttribute(root, "unsigned", number);
  CHECK(number == 10);
  CHECK_THAT(TakeLogErr(),
             Contains("[WARNING] old.argos:1: <root>: attribute \"unsigned\": found \"10.5\", "
                      "expected an integer from 0 to 4294967295; read as ARGoS 3 reads it"));
  GetNodeAttribute(root, "unsigned", number);
  CHECK(TakeLogErr().empty());
  GetNodeAttribute(root, "negative", number);
  CHECK(number == 4294967295U);
  UInt8 byte = 0;
  GetNodeAttribute(root, "byte", byte);
  CHECK(byte == 12);
  CVector3 v3;
  GetNodeAttribute(root, "v3", v3);
  CHECK(v3 == CVector3(-5, 0, 0));
  CVector2 v2;
  GetNodeAttribute(root, "v2", v2);
  CHECK(v2 == CVector2(1, 2));
  Real real = 0.0;
  GetNodeAttribute(root, "real", real);
  CHECK(real == 1.5);
  CConfigurationNode copy = root;
  const std::unique_ptr<CConfigurationNode> clone = GetNode(root, "child").Clone();
  GetNodeAttribute(*clone, "v3", v3);
  CHECK(v3 == CVector3(1, 0, 2));
  CHECK_THAT(TakeLogErr(), Contains("<child>: attribute \"v3\""));
  // errors there, too
  bool flag = false;
  CHECK_THROWS_AS(GetNodeAttribute(root, "word", real), CARGoSException);
  CHECK_THROWS_AS(GetNodeAttribute(root, "bool", flag), CARGoSException);
  CHECK_THROWS_AS(GetNodeAttribute(root, "few", v3), CARGoSException);
  CColor color;
  CHECK_THROWS_AS(GetNodeAttribute(root, "color", color), CARGoSException);
}

TEST_CASE("configuration: a default replaces missing attributes only", "[core][configuration]") {
  SWorld world;
  Real real = 0;
  GetNodeAttributeOrDefault(world["robot"], "speed", real, 9.0);
  CHECK(real == 1.5);
  GetNodeAttributeOrDefault(world["robot"], "absent", real, 9.0);
  CHECK(real == 9.0);
  // a default of another type, with and without explicit template argument
  GetNodeAttributeOrDefault<Real>(world["robot"], "absent", real, 1);
  CHECK(real == 1.0);
  GetNodeAttributeOrDefault(world["robot"], "absent", real, 2);
  CHECK(real == 2.0);
  std::string text;
  GetNodeAttributeOrDefault(world["robot"], "absent", text, "default");
  CHECK(text == "default");
  bool flag = false;
  GetNodeAttributeOrDefault(world["robot"], "absent", flag, true);
  CHECK(flag);
  UInt8 byte = 0;
  GetNodeAttributeOrDefault(world["robot"], "absent", byte, UInt8(5));
  CHECK(byte == 5);
  SInt8 signedByte = 0;
  GetNodeAttributeOrDefault(world["robot"], "absent", signedByte, SInt8(-5));
  CHECK(signedByte == -5);
  CHECK_THROWS_WITH(GetNodeAttributeOrDefault(world["bad"], "word", real, 1.0),
                    Contains("found \"abc\", expected a real number"));
  CHECK_THROWS_WITH(GetNodeAttributeOrDefault(world["bad"], "bool", flag, true),
                    Contains("found \"True\""));
}

TEST_CASE("configuration: existence of attributes and elements can be tested",
          "[core][configuration]") {
  SWorld world;
  CHECK(NodeAttributeExists(world["robot"], "id"));
  CHECK_FALSE(NodeAttributeExists(world["robot"], "Id"));
  CHECK(NodeExists(world.Document.GetRoot(), "empty"));
  CHECK_FALSE(NodeExists(world.Document.GetRoot(), "item"));
}

TEST_CASE("configuration: a written value can be read", "[core][configuration]") {
  TConfigurationNode node("node");
  SetNodeAttribute(node, "real", 0.1);
  SetNodeAttribute(node, "third", 1.0 / 3.0);
  SetNodeAttribute(node, "flag", true);
  SetNodeAttribute(node, "byte", UInt8(65));
  SetNodeAttribute(node, "signed", SInt8(-65));
  SetNodeAttribute(node, "text", std::string("a < b & \"c\""));
  SetNodeAttribute(node, "vector", CVector3(0.1, 1.0 / 3.0, -2));
  CHECK(node.GetAttribute("real") == "0.1");
  CHECK(node.GetAttribute("flag") == "true");
  CHECK(node.GetAttribute("byte") == "65");
  CHECK(node.GetAttribute("signed") == "-65");
  CHECK(node.GetAttribute("text") == "a < b & \"c\"");
  Real third = 0;
  GetNodeAttribute(node, "third", third);
  CHECK(third == 1.0 / 3.0);
  CVector3 vector;
  GetNodeAttribute(node, "vector", vector);
  CHECK(vector.GetX() == 0.1);
  CHECK(vector.GetY() == 1.0 / 3.0);
  SetNodeAttribute(node, "flag", false);
  bool flag = true;
  GetNodeAttribute(node, "flag", flag);
  CHECK_FALSE(flag);
}

TEST_CASE("configuration: the text of an element can be read", "[core][configuration]") {
  SWorld world;
  UInt32 number = 0;
  GetNodeText(world["text"], number);
  CHECK(number == 12);
  std::string word;
  GetNodeText(world["word"], word);
  CHECK(word == "abc");
  CHECK_THROWS_WITH(GetNodeText(world["word"], number),
                    "[FATAL] test.argos:10: <word>: the text: found \"abc\", expected an integer "
                    "from 0 to 4294967295");
  CHECK_THROWS_WITH(GetNodeText(world["empty"], number), Contains("<empty> contains no text"));
  GetNodeTextOrDefault(world["empty"], number, 3U);
  CHECK(number == 3);
  GetNodeTextOrDefault(world["text"], number, 3U);
  CHECK(number == 12);
  world["empty"].SetText(4);
  CHECK(world["empty"].GetText() == "4");
}

// elements

TEST_CASE("configuration: the error on a missing element gives its place and what is there",
          "[core][configuration]") {
  SWorld world;
  CHECK_THROWS_WITH(
      world["rbot"],
      "[FATAL] test.argos:1: <root>: element <rbot> is missing inside it; is \"robot\" a "
      "misspelling of it?");
  CHECK_THROWS_WITH(GetNode(world["group"], "xyz"),
                    Contains("<xyz> is missing inside it; it has: item, other"));
}

TEST_CASE("configuration: the iteration idiom visits children in order", "[core][configuration]") {
  SWorld world;
  TConfigurationNode& group = world["group"];
  std::string tags;
  TConfigurationNodeIterator it;
  for (it = it.begin(&group); it != it.end(); ++it) {
    tags += it->Value() + ' ';
  }
  CHECK(tags == "item item other item ");

  std::string numbers;
  TConfigurationNodeIterator items("item");
  for (items = items.begin(&group); items != items.end(); items++) {
    std::string n;
    GetNodeAttribute(*items, "n", n);
    numbers += n;
  }
  CHECK(numbers == "123");

  items = group.LastChildElement();
  CHECK((--items)->GetAttribute("n") == "2");
  items--;
  CHECK((*items).GetAttribute("n") == "1");
  CHECK(items.Get() == group.FirstChildElement());
  CHECK(--items == items.end());
}

TEST_CASE("configuration: attributes can be iterated", "[core][configuration]") {
  SWorld world;
  std::string names;
  TConfigurationAttributeIterator it;
  for (it = it.begin(&world["bad"]); it != it.end(); ++it) {
    names += it->Name() + '=' + it->Value() + ' ';
  }
  CHECK_THAT(names, StartsWith("real=1.5x word=abc unsigned=-1 "));
  TConfigurationAttributeIterator none;
  CHECK(none.begin(&world["empty"]) == none.end());

  CConfigurationAttribute* attribute = world["bad"].FirstAttribute();
  std::string name;
  attribute->GetName(&name);
  CHECK(name == "real");
  CHECK(attribute->Next()->Name() == "word");
  CConfigurationAttribute* last = attribute;
  while (CConfigurationAttribute* const next = last->Next(false)) {
    last = next;
  }
  CHECK_THROWS_WITH(last->Next(),
                    Contains("test.argos:") && Contains("no attribute follows \"" + last->Name()));
  CHECK_THROWS_WITH(CConfigurationAttribute().Name(), Contains("does not exist was used"));
  Real value = 0;
  CHECK_THROWS_WITH(attribute->GetValue(&value), Contains("attribute \"real\": found \"1.5x\""));
  attribute->SetValue(2.5);
  attribute->GetValue(&value);
  CHECK(value == 2.5);
  CHECK(world["empty"].FirstAttribute(false) == nullptr);
  CHECK_THROWS_WITH(world["empty"].FirstAttribute(), Contains("<empty> has no attributes"));
}

TEST_CASE("configuration: parents and siblings can be reached, or an error tells why not",
          "[core][configuration]") {
  SWorld world;
  TConfigurationNode& group = world["group"];
  TConfigurationNode* first = group.FirstChildElement();
  CHECK(first->Parent() == &group);
  CHECK(first->NextSiblingElement()->GetAttribute("n") == "2");
  CHECK(first->NextSiblingElement("other")
            ->NextSiblingElement(std::string("item"))
            ->GetAttribute("n") == "3");
  CHECK(first->PreviousSiblingElement(false) == nullptr);
  CHECK(group.FirstChildElement("nothing", false) == nullptr);
  CHECK(world["empty"].FirstChildElement(false) == nullptr);
  CHECK_THROWS_WITH(world["empty"].FirstChildElement(), Contains("<empty> contains no element"));
  CHECK_THROWS_WITH(world["empty"].LastChildElement(), Contains("<empty> contains no element"));
  CHECK_THROWS_WITH(world["word"].NextSiblingElement(), Contains("no element follows <word>"));
  CHECK_THROWS_WITH(world["word"].NextSiblingElement("x"),
                    Contains("no element <x> follows <word>"));
  CHECK_THROWS_WITH(world["robot"].PreviousSiblingElement(),
                    Contains("no element precedes <robot>"));
  CHECK_THROWS_WITH(world.Document.GetRoot().Parent(), Contains("<root> has no parent element"));
  CHECK(world["empty"].NoChildren());
  CHECK_FALSE(group.NoChildren());
}

TEST_CASE("configuration: an element reports its file and line", "[core][configuration]") {
  SWorld world;
  CHECK(world["group"].GetLine() == 5);
  CHECK(world["group"].GetFileName() == "test.argos");
  CHECK(world["group"].GetLocation() == "test.argos:5");
  TConfigurationNode made("made");
  CHECK(made.GetLine() == 0);
  CHECK(made.GetLocation() == "(made by the program)");
}

TEST_CASE("configuration: inserted children are copies and keep their file and line",
          "[core][configuration]") {
  SWorld world;
  TConfigurationNode parent("parent");
  AddChildNode(parent, world["group"]);
  AddChildNode(parent, world["robot"]);
  CHECK(GetNode(parent, "group").GetLocation() == "test.argos:5");
  CHECK(GetNode(GetNode(parent, "group"), "other").GetLocation() == "test.argos:5");
  // a copy: the original does not change with it
  SetNodeAttribute(GetNode(parent, "robot"), "speed", 3.0);
  CHECK(world.Get<Real>("speed") == 1.5);

  TConfigurationNode child("child", 5);
  CHECK(child.GetText() == "5");
  parent.InsertBeforeChild(GetNode(parent, "group"), child);
  parent.InsertAfterChild(GetNode(parent, "robot"), "last");
  parent.InsertBeforeChild(GetNode(parent, "robot"), "between");
  std::string tags;
  TConfigurationNodeIterator it;
  for (it = it.begin(&parent); it != it.end(); ++it) {
    tags += it->Value() + ' ';
  }
  CHECK(tags == "child group between robot last ");
  CHECK_THROWS_WITH(parent.InsertAfterChild(child, child), Contains("is not a child of <parent>"));
  CHECK_THROWS_WITH(parent.InsertBeforeChild(child, child), Contains("is not a child of <parent>"));
  CHECK_THROWS_WITH(parent.RemoveChild(&child), Contains("<child> is not a child of <parent>"));
}

TEST_CASE("configuration: using a removed element is an error", "[core][configuration]") {
  SWorld world;
  TConfigurationNode& group = world["group"];
  TConfigurationNode& item = GetNode(group, "item");
  group.RemoveChild(&item);
  CHECK(group.FirstChildElement()->GetAttribute("n") == "2");
  CHECK_THROWS_WITH(item.Value(), Contains("used after it was removed"));
  TConfigurationNode& other = GetNode(group, "other");
  group.Clear();
  CHECK(group.NoChildren());
  CHECK_THROWS_WITH(other.HasAttribute("x"),
                    Contains("test.argos:5: a configuration node was used"));
}

TEST_CASE("configuration: attributes and tags can be changed", "[core][configuration]") {
  TConfigurationNode node("node");
  node.SetAttribute("a", 1);
  node.SetAttribute("b", 2);
  node.SetAttribute("c", "x");
  node.RemoveAttribute("b");
  node.RemoveAttribute("absent");
  CHECK(node.GetAttributeNames() == std::vector<std::string>{"a", "c"});
  CHECK(node.GetAttribute("b").empty());
  CHECK(node.GetAttribute<int>("a") == 1);
  int value = 0;
  CHECK_FALSE(node.GetAttribute("b", &value, false));
  node.GetAttributeOrDefault("b", &value, 8);
  CHECK(value == 8);
  node.SetValue("renamed");
  CHECK(node.Value() == "renamed");
  std::string tag;
  node.GetValue(&tag);
  CHECK(tag == "renamed");
  CHECK_THROWS_WITH(node.SetValue("1 2"), Contains("\"1 2\" cannot be the name of an XML element"));
  CHECK_THROWS_WITH(node.SetAttribute("<", 1), Contains("cannot be the name"));
  CHECK_THROWS_WITH(TConfigurationNode(""), Contains("cannot be the name"));
}

TEST_CASE("configuration: a text that is written as it is can be read", "[core][configuration]") {
  SWorld world;
  SetAttributeText(world["empty"], "new", "1,2,3");
  SetAttributeText(world["robot"], "speed", "2.5");
  CHECK(world.Get<CVector3>("new", "empty") == CVector3(1.0, 2.0, 3.0));
  CHECK(world.Get<Real>("speed") == 2.5);
  CHECK_THROWS_WITH(SetAttributeText(world["empty"], "a b", "1"), Contains("cannot be the name"));
}

TEST_CASE("configuration: nodes print as XML and are read from it", "[core][configuration]") {
  TConfigurationNode node("a");
  node.SetAttribute("x", 1);
  node.InsertEndChild("b");
  CHECK(Print(node) == "<a x=\"1\">\n    <b/>\n</a>\n");
  std::istringstream stream("<c><d y='2'/></c>");
  stream >> node;
  CHECK(node.Value() == "c");
  CHECK(GetNode(node, "d").GetAttribute("y") == "2");
  std::istringstream broken("<c>");
  CHECK_THROWS_WITH(broken >> node, Contains("(stream)"));
}

TEST_CASE("configuration: handles share their element and outlive the document",
          "[core][configuration]") {
  TConfigurationNode handle;
  CHECK(handle.IsEmpty());
  CHECK_THROWS_WITH(handle.Value(), Contains("An empty configuration node was used"));
  {
    SWorld world;
    handle = world["group"];
    TConfigurationNode copy(handle);
    copy.SetAttribute("new", 1);
    CHECK(world["group"].HasAttribute("new"));
  }
  CHECK(handle.Value() == "group");
  CHECK(GetNode(handle, "other").Parent()->HasAttribute("new"));
  const std::unique_ptr<TConfigurationNode> clone = handle.Clone();
  clone->SetAttribute("new", 2);
  CHECK(handle.GetAttribute<int>("new") == 1);
}

TEST_CASE("configuration: references are stable, and assigning to one changes no document",
          "[core][configuration]") {
  SWorld world;
  TConfigurationNode* robot = &world["robot"];
  CHECK(&world["robot"] == robot);
  TConfigurationNode& reference = world["robot"];
  reference = world["group"];
  CHECK(reference.Value() == "group");
  CHECK(world["robot"].Value() == "robot");
  CHECK(world["group"].Value() == "group");
  SWorld elsewhere;
  reference = elsewhere["word"];
  CHECK(reference.GetText() == "abc");
}

}  // namespace argos_configuration_test
