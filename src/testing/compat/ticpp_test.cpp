/* Code that calls the XML library of ARGoS 3 directly, which argos_configuration.h brings. */

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

#include <catch2/catch.hpp>

#include <unistd.h>

#include <cstdio>

namespace ticpp_test {

using namespace argos;

static const char* MINIMAL = R"(<argos-configuration>
  <framework> <experiment length="5" ticks_per_second="10" random_seed="3" /> </framework>
  <controllers />
  <arena size="4,4,1"> <box id="b" size="1,1,1" movable="false"> <body position="0,0,0" /> </box> </arena>
  <physics_engines> <dynamics2d id="dyn2d" /> </physics_engines>
  <media />
</argos-configuration>)";

/* what an evolutionary designer does: reads a template, changes it, writes it, runs it */
TEST_CASE("compat: a program edits an experiment file with ticpp", "[compat]") {
  const std::string strTemplate = "ticpp_template_" + ToString(::getpid()) + ".argos";
  const std::string strResult = "ticpp_result_" + ToString(::getpid()) + ".argos";
  ticpp::Document tWriter;
  tWriter.Parse(MINIMAL);
  tWriter.SaveFile(strTemplate);

  ticpp::Document tDocument(strTemplate);
  tDocument.LoadFile();
  ticpp::Element* ptRoot = tDocument.FirstChildElement();
  CHECK(ptRoot->Value() == "argos-configuration");
  CHECK(tDocument.FirstChildElement("argos-configuration") == ptRoot);
  CHECK(tDocument.FirstChildElement("other", false) == NULL);
  ticpp::Element* ptExperiment =
      ptRoot->FirstChildElement("framework")->FirstChildElement("experiment");
  ptExperiment->SetAttribute("length", 2);
  TConfigurationNode& tArena = GetNode(*ptRoot, "arena");
  ticpp::Iterator<ticpp::Element> itBox("box");
  int nBoxes = 0;
  for (itBox = itBox.begin(&tArena); itBox != itBox.end(); ++itBox) {
    ticpp::Iterator<ticpp::Attribute> itAttribute;
    for (itAttribute = itAttribute.begin(itBox.Get()); itAttribute != itAttribute.end();
         ++itAttribute)
      CHECK_FALSE(itAttribute->Name().empty());
    ++nBoxes;
  }
  CHECK(nBoxes == 1);
  ticpp::Element tBox("box");
  tBox.SetAttribute("id", "second");
  tBox.SetAttribute("size", "0.1,0.1,0.1");
  tBox.SetAttribute("movable", "false");
  ticpp::Element tBody("body");
  tBody.SetAttribute("position", "1,1,0");
  tBox.InsertEndChild(tBody);
  tArena.LinkEndChild(&tBox);
  tDocument.SaveFile(strResult);

  CSimulator cSimulator;
  cSimulator.Load(tDocument);
  CHECK(cSimulator.GetMaxSimulationClock() == 20);
  cSimulator.Execute();
  CHECK(cSimulator.GetSpace().GetEntity("second").GetTypeDescription() == "box");
  cSimulator.Destroy();
  ticpp::Document tSaved(strResult);
  tSaved.LoadFile();
  int nLength = 0;
  tSaved.FirstChildElement()
      ->FirstChildElement("framework")
      ->FirstChildElement("experiment")
      ->GetAttribute("length", &nLength);
  CHECK(nLength == 2);
  std::remove(strTemplate.c_str());
  std::remove(strResult.c_str());
}

TEST_CASE("compat: a program builds a document with ticpp", "[compat]") {
  ticpp::Document tDocument;
  CHECK(tDocument.FirstChild(false) == NULL);
  ticpp::Element tRoot("root");
  tDocument.LinkEndChild(&tRoot);
  tRoot.SetAttribute("depth", 1.5);
  tRoot.InsertEndChild(ticpp::Element("leaf", "text"));
  ticpp::Node* ptNode = tDocument.FirstChild();
  Real fDepth = 0.0;
  ptNode->ToElement()->GetAttribute("depth", &fDepth);
  CHECK(fDepth == 1.5);
  CHECK(ptNode->FirstChild("leaf")->ToElement()->GetText() == "text");
  CHECK_THROWS_AS(tDocument.InsertEndChild(ticpp::Element("second")), ticpp::Exception);
}

TEST_CASE("compat: errors of nodes are ticpp exceptions with details", "[compat]") {
  ticpp::Document tDocument("no_such_file.argos");
  try {
    tDocument.LoadFile();
    FAIL("no exception");
  } catch (ticpp::Exception& ex) {
    CHECK(ex.m_details.find("no_such_file.argos") != std::string::npos);
    CHECK(std::string(ex.what()).find(ex.m_details) != std::string::npos);
  }
  tDocument.Parse("<a b='x'/>");
  tDocument.Parse("<broken", false);
  CHECK(tDocument.FirstChildElement()->Value() == "a");
  int nValue = 0;
  CHECK_THROWS_AS(tDocument.FirstChildElement()->GetAttribute("b", &nValue), ticpp::Exception);
  CHECK_THROWS_AS(tDocument.FirstChildElement()->FirstChildElement("c"), ticpp::Exception);
}

}  // namespace ticpp_test
