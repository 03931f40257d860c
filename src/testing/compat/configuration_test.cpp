// Code of users of the XML helpers.

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>

#include <catch2/catch.hpp>

namespace configuration_test {

using namespace argos;

class CResource : public CBaseConfigurableResource {
 public:
  virtual ~CResource() {}
  virtual void Init(TConfigurationNode& t_tree) {
    GetNodeAttribute(t_tree, "value", m_fValue);
    m_ptNode = &t_tree;
  }
  virtual void Reset() {}
  virtual void Destroy() {}
  Real m_fValue = 0.0;
  TConfigurationNode* m_ptNode = NULL;
};

static const char* XML =
    "<root name='a b' value='2.5' yes='true' no='false' n='200' s='-100' size='12' v2='1,2' v3='1, "
    "2, 3' q='90,0,0'"
    " rad='1.5' deg='45' range='-1:2.5' drange='-10:10' color='red' rgba='1,2,3,4' bad='x'>\n"
    "  <child id='1'>text</child>\n  <child id='2' />\n  <other>3.5</other>\n  <child id='3' "
    "/>\n</root>";

TEST_CASE("compat: attributes of every type can be read", "[compat]") {
  CConfigurationDocument cDocument;
  cDocument.Parse(XML);
  TConfigurationNode& tNode = cDocument.GetRoot();
  std::string strName;
  GetNodeAttribute(tNode, "name", strName);
  CHECK(strName == "a b");
  Real fValue;
  GetNodeAttribute(tNode, "value", fValue);
  CHECK(fValue == 2.5);
  bool bYes, bNo;
  GetNodeAttribute(tNode, "yes", bYes);
  GetNodeAttribute(tNode, "no", bNo);
  CHECK((bYes && !bNo));
  UInt8 unByte;
  GetNodeAttribute(tNode, "n", unByte);
  CHECK(unByte == 200);
  SInt8 nByte;
  GetNodeAttribute(tNode, "s", nByte);
  CHECK(nByte == -100);
  size_t unSize;
  GetNodeAttribute(tNode, "size", unSize);
  CHECK(unSize == 12);
  UInt16 un16;
  UInt32 un32;
  UInt64 un64;
  SInt16 n16;
  SInt32 n32;
  SInt64 n64;
  GetNodeAttribute(tNode, "size", un16);
  GetNodeAttribute(tNode, "size", un32);
  GetNodeAttribute(tNode, "size", un64);
  GetNodeAttribute(tNode, "size", n16);
  GetNodeAttribute(tNode, "size", n32);
  GetNodeAttribute(tNode, "size", n64);
  CHECK(un16 + un32 + un64 + n16 + n32 + n64 == 72);
  CVector2 cV2;
  GetNodeAttribute(tNode, "v2", cV2);
  CHECK(cV2 == CVector2(1.0, 2.0));
  CVector3 cV3;
  GetNodeAttribute(tNode, "v3", cV3);
  CHECK(cV3 == CVector3(1.0, 2.0, 3.0));
  CQuaternion cQ;
  GetNodeAttribute(tNode, "q", cQ);
  CHECK_THAT(CVector3(CVector3::X).Rotate(cQ).GetY(), Catch::WithinAbs(1.0, 1e-15));
  CRadians cRadians;
  GetNodeAttribute(tNode, "rad", cRadians);
  CHECK(cRadians == CRadians(1.5));
  CDegrees cDegrees;
  GetNodeAttribute(tNode, "deg", cDegrees);
  CHECK(cDegrees == CDegrees(45.0));
  CRange<Real> cRange;
  GetNodeAttribute(tNode, "range", cRange);
  CHECK(cRange.GetMax() == 2.5);
  CRange<CDegrees> cDegreeRange(CDegrees(-1.0), CDegrees(1.0));
  GetNodeAttribute(tNode, "drange", cDegreeRange);
  CHECK(cDegreeRange.GetMin() == CDegrees(-10.0));
  CColor cColor;
  GetNodeAttribute(tNode, "color", cColor);
  CHECK(cColor == CColor::RED);
  GetNodeAttribute(tNode, "rgba", cColor);
  CHECK(cColor == CColor(1, 2, 3, 4));
  CHECK_THROWS_AS(GetNodeAttribute(tNode, "missing", fValue), CARGoSException);
  CHECK_THROWS_AS(GetNodeAttribute(tNode, "bad", fValue), CARGoSException);
  CHECK_THROWS_AS(GetNodeAttribute(tNode, "bad", bYes), CARGoSException);
}

TEST_CASE("compat: attributes may have defaults", "[compat]") {
  CConfigurationDocument cDocument;
  cDocument.Parse(XML);
  TConfigurationNode& tNode = cDocument.GetRoot();
  Real fValue = 0.0;
  GetNodeAttributeOrDefault(tNode, "missing", fValue, fValue);
  CHECK(fValue == 0.0);
  GetNodeAttributeOrDefault(tNode, "value", fValue, 7.0);
  CHECK(fValue == 2.5);
  GetNodeAttributeOrDefault<Real>(tNode, "missing", fValue, 7.0f);
  CHECK(fValue == 7.0);
  CDegrees cAlpha = ToDegrees(CRadians::PI);
  GetNodeAttributeOrDefault(tNode, "missing", cAlpha, cAlpha);
  GetNodeAttributeOrDefault(tNode, "deg", cAlpha, CDegrees(1.0));
  CHECK(cAlpha == CDegrees(45.0));
  bool bFlag = false;
  GetNodeAttributeOrDefault(tNode, "missing", bFlag, true);
  CHECK(bFlag);
  UInt8 unByte = 0;
  GetNodeAttributeOrDefault(tNode, "missing", unByte, static_cast<UInt8>(5));
  CHECK(unByte == 5);
  SInt8 nByte = 0;
  GetNodeAttributeOrDefault(tNode, "missing", nByte, static_cast<SInt8>(-5));
  CHECK(nByte == -5);
  std::string strText;
  GetNodeAttributeOrDefault(tNode, "missing", strText, std::string("default"));
  CHECK(strText == "default");
  UInt32 unNumber = 3;
  GetNodeAttributeOrDefault(tNode, "missing", unNumber, unNumber);
  CHECK(unNumber == 3);
  CVector3 cV;
  GetNodeAttributeOrDefault(tNode, "missing", cV, CVector3(1.0, 1.0, 1.0));
  CHECK(cV.GetX() == 1.0);
  CHECK_THROWS_AS(GetNodeAttributeOrDefault(tNode, "bad", fValue, 7.0), CARGoSException);
}

TEST_CASE("compat: elements and their texts can be read", "[compat]") {
  CConfigurationDocument cDocument;
  cDocument.Parse(XML);
  TConfigurationNode& tNode = cDocument.GetRoot();
  CHECK(tNode.Value() == "root");
  CHECK(NodeExists(tNode, "child"));
  CHECK_FALSE(NodeExists(tNode, "nobody"));
  CHECK(NodeAttributeExists(tNode, "value"));
  CHECK_FALSE(NodeAttributeExists(tNode, "missing"));
  CHECK_THROWS_AS(GetNode(tNode, "nobody"), CARGoSException);
  std::string strText;
  GetNodeText(GetNode(tNode, "child"), strText);
  CHECK(strText == "text");
  Real fText;
  GetNodeText(GetNode(tNode, "other"), fText);
  CHECK(fText == 3.5);
  TConfigurationNodeIterator itSecond("child");
  itSecond = itSecond.begin(&tNode);
  ++itSecond;
  GetNodeTextOrDefault(*itSecond, fText, 9.0);
  CHECK(fText == 9.0);
}

TEST_CASE("compat: elements and attributes can be iterated", "[compat]") {
  CConfigurationDocument cDocument;
  cDocument.Parse(XML);
  TConfigurationNode& tNode = cDocument.GetRoot();
  std::string strTags;
  TConfigurationNodeIterator it;
  for (it = it.begin(&tNode); it != it.end(); ++it) {
    strTags += it->Value() + " ";
  }
  CHECK(strTags == "child child other child ");
  UInt32 unSum = 0;
  TConfigurationNodeIterator itChild("child");
  for (itChild = itChild.begin(&tNode); itChild != itChild.end(); ++itChild) {
    UInt32 unId;
    GetNodeAttribute(*itChild, "id", unId);
    unSum = unSum * 10 + unId;
  }
  CHECK(unSum == 123);
  size_t unAttributes = 0;
  TConfigurationAttributeIterator itAttribute;
  for (itAttribute = itAttribute.begin(&tNode); itAttribute != itAttribute.end(); itAttribute++) {
    std::string strName = itAttribute->Name(), strValue = itAttribute->Value();
    CHECK_FALSE(strName.empty());
    ++unAttributes;
  }
  CHECK(unAttributes == 17);
}

TEST_CASE("compat: elements can be written, copied and kept", "[compat]") {
  CConfigurationDocument cDocument;
  cDocument.Parse(XML);
  TConfigurationNode& tNode = cDocument.GetRoot();
  SetNodeAttribute(tNode, "value", 4.0);
  SetNodeAttribute(tNode, "yes", false);
  SetNodeAttribute(tNode, "n", static_cast<UInt8>(7));
  SetNodeAttribute(tNode, "s", static_cast<SInt8>(-7));
  SetNodeAttribute(tNode, "new", CVector3(1.0, 2.0, 3.0));
  SetNodeAttribute(tNode, "text", std::string("abc"));
  std::string strN;
  GetNodeAttribute(tNode, "n", strN);
  CHECK(strN == "7");
  CVector3 cNew;
  GetNodeAttribute(tNode, "new", cNew);
  CHECK(cNew == CVector3(1.0, 2.0, 3.0));
  bool bYes;
  GetNodeAttribute(tNode, "yes", bYes);
  CHECK_FALSE(bYes);
  // a handle that is created first and assigned later; a new element
  TConfigurationNode tHandle;
  tHandle = GetNode(tNode, "other");
  CHECK(tHandle.Value() == "other");
  TConfigurationNode tFresh("fresh");
  SetNodeAttribute(tFresh, "id", std::string("f"));
  AddChildNode(tNode, tFresh);
  std::string strId;
  GetNodeAttribute(GetNode(tNode, "fresh"), "id", strId);
  CHECK(strId == "f");
  CResource cResource;
  cResource.Init(tNode);
  CHECK(cResource.m_fValue == 4.0);
  CHECK(cResource.m_ptNode->Value() == "root");
}

TEST_CASE("compat: nodes can be traversed", "[compat]") {
  CConfigurationDocument cDocument;
  cDocument.Parse(XML);
  TConfigurationNode& tNode = cDocument.GetRoot();
  TConfigurationNode* ptFirst = tNode.FirstChild();
  CHECK(ptFirst->ToElement()->GetAttribute("id") == "1");
  CHECK(tNode.FirstChild("other")->Value() == "other");
  CHECK(tNode.FirstChild(std::string("other"))->NextSibling()->GetAttribute("id") == "3");
  CHECK(tNode.LastChild()->GetAttribute("id") == "3");
  CHECK(tNode.LastChild("other")->Value() == "other");
  CHECK(tNode.LastChild("child")->PreviousSibling()->Value() == "other");
  CHECK(tNode.LastChild("child")->PreviousSibling("child")->GetAttribute("id") == "2");
  CHECK(tNode.LastChild("nobody", false) == NULL);
  CHECK_THROWS_WITH(tNode.LastChild("nobody"), Catch::Contains("<nobody>"));
  CHECK(ptFirst->PreviousSibling(false) == NULL);
  CHECK(ptFirst->PreviousSibling("child", false) == NULL);
  CHECK_THROWS_WITH(ptFirst->PreviousSibling("child"), Catch::Contains("precedes"));
  CHECK(ptFirst->NextSibling("other")->Value() == "other");
  CHECK(ptFirst->NextSibling("nobody", false) == NULL);
  std::string strIds;
  TConfigurationNode* ptChild = NULL;
  while ((ptChild = tNode.IterateChildren("child", ptChild)) != NULL) {
    strIds += ptChild->GetAttribute("id");
  }
  CHECK(strIds == "123");
  UInt32 unChildren = 0;
  for (ptChild = tNode.IterateChildren(NULL); ptChild; ptChild = tNode.IterateChildren(ptChild)) {
    ++unChildren;
  }
  CHECK(unChildren == 4);
  CHECK(tNode.GetAttributeOrDefault("value", "none") == "2.5");
  CHECK(tNode.GetAttributeOrDefault("missing", "none") == "none");
  CHECK(ptFirst->GetTextOrDefault("none") == "text");
  CHECK(ptFirst->NextSibling()->GetTextOrDefault("none") == "none");
  /* a linked element can still be changed by the caller */
  TConfigurationNode* ptNew = new TConfigurationNode("new");
  tNode.LinkEndChild(ptNew);
  ptNew->SetAttribute("id", 4);
  CHECK(tNode.LastChild()->GetAttribute("id") == "4");
  delete ptNew;
  TConfigurationNode tOther("replacement");
  tNode.ReplaceChild(tNode.FirstChild("other"), tOther);
  CHECK(tNode.FirstChild("other", false) == NULL);
  CHECK(tNode.FirstChild("replacement")->NextSibling()->GetAttribute("id") == "3");
}

TEST_CASE("compat: members of an element are accessible", "[compat]") {
  CConfigurationDocument cDocument;
  cDocument.Parse(XML);
  TConfigurationNode& tNode = cDocument.GetRoot();
  CHECK(tNode.GetAttribute("value") == "2.5");
  Real fValue;
  tNode.GetAttribute("value", &fValue);
  CHECK(fValue == 2.5);
  CHECK(tNode.GetAttribute<Real>("value") == 2.5);
  tNode.GetAttributeOrDefault("missing", &fValue, 1.0);
  CHECK(fValue == 1.0);
  tNode.SetAttribute("value", 3.5);
  CHECK(tNode.HasAttribute("value"));
  tNode.RemoveAttribute("value");
  CHECK_FALSE(tNode.HasAttribute("value"));
  TConfigurationNode* ptChild = tNode.FirstChildElement();
  CHECK(ptChild->GetText() == "text");
  CHECK(tNode.FirstChildElement("other")->Value() == "other");
  CHECK(tNode.FirstChildElement(std::string("other"))->Value() == "other");
  CHECK(ptChild->NextSiblingElement()->GetAttribute("id") == "2");
  CHECK(ptChild->NextSiblingElement("other")->Value() == "other");
  CHECK(tNode.FirstChildElement("nobody", false) == NULL);
  CHECK_THROWS(tNode.FirstChildElement("nobody"));
  ptChild->SetText("other text");
  std::string strText;
  ptChild->GetText(&strText);
  CHECK(strText == "other text");
  CHECK(ptChild->FirstAttribute()->Name() == "id");
  CHECK(tNode.NoChildren() == false);
  ptChild->SetValue("renamed");
  CHECK(tNode.FirstChildElement()->Value() == "renamed");
  std::ostringstream cStream;
  cStream << tNode;
  CHECK(cStream.str().find("<renamed") != std::string::npos);
  CHECK(ptChild->Parent()->Value() == "root");
  TConfigurationNode tFirst("first"), tLast("last", 2.5);
  tNode.InsertBeforeChild(*ptChild, tFirst);
  tNode.InsertAfterChild(*ptChild, TConfigurationNode("second"));
  tNode.InsertEndChild(tLast);
  CHECK(tNode.FirstChildElement()->Value() == "first");
  CHECK(ptChild->NextSiblingElement()->Value() == "second");
  CHECK(tNode.FirstChildElement("last")->GetText() == "2.5");
  tNode.RemoveChild(tNode.FirstChildElement("first"));
  CHECK(tNode.FirstChildElement()->Value() == "renamed");
  CHECK(tNode.Clone()->Value() == "root");
  std::string strName, strValue;
  ptChild->FirstAttribute()->GetName(&strName);
  ptChild->FirstAttribute()->GetValue(&strValue);
  CHECK((strName == "id" && strValue == "1"));
  ptChild->FirstAttribute()->SetValue(7);
  CHECK(ptChild->GetAttribute("id") == "7");
  CHECK(ptChild->FirstAttribute()->Next(false) == NULL);
  tNode.Clear();
  CHECK(tNode.NoChildren());
}

}  // namespace configuration_test
