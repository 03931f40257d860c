#include <argos3/core/utility/configuration/argos_configuration.h>

#include <catch2/catch.hpp>

#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <sstream>

namespace configuration_document_test {

using namespace argos;
using Catch::Contains;

namespace {

constexpr const char* kExperiment = R"(<?xml version="1.0" ?>
<argos-configuration>
  <framework>
    <experiment length="10" random_seed="1" />
  </framework>
  <arena size="1,1,1">
    <distribute><entity quantity="1"/></distribute>
    <distribute><entity quantity="2"/></distribute>
    <foot-bot id="fb0"><body position="0,0,0"/></foot-bot>
    <foot-bot id="fb1"><body position="1,0,0"/></foot-bot>
  </arena>
</argos-configuration>
)";

CConfigurationDocument Experiment() {
  CConfigurationDocument document;
  document.Parse(kExperiment, "e.argos");
  return document;
}

// the unread parts as "<tag>" or "<tag>@attribute", separated by blanks
std::string Unread(const CConfigurationDocument& document) {
  std::string unread;
  document.ForEachUnread([&unread](const CConfigurationNode& node, const std::string& attribute) {
    unread += '<' + node.Value() + '>' + (attribute.empty() ? "" : '@' + attribute) + ' ';
  });
  return unread;
}

std::string ErrorOfParsing(const std::string& xml) {
  CConfigurationDocument document;
  try {
    document.Parse(xml, "x.argos");
  } catch (CARGoSException& ex) {
    return ex.what();
  }
  return "accepted";
}

// a temporary file of this process, removed by the destructor
class CTemporaryFile {
 public:
  explicit CTemporaryFile(const std::string& content) {
    m_name = "configuration_document_test." + std::to_string(getpid()) + ".xml";
    std::ofstream(m_name) << content;
  }
  ~CTemporaryFile() { std::remove(m_name.c_str()); }
  const std::string& GetName() const { return m_name; }

 private:
  std::string m_name;
};

}  // namespace

// loading

TEST_CASE("document: a file is loaded and saved", "[core][configuration]") {
  const CTemporaryFile file(kExperiment);
  CConfigurationDocument document;
  document.LoadFile(file.GetName());
  CHECK(document.GetName() == file.GetName());
  CHECK(document.GetRoot().Value() == "argos-configuration");
  CHECK(GetNode(document.GetRoot(), "arena").GetLocation() == file.GetName() + ":6");
  document.SetByPath("arena/@size", "2,2,2");
  document.SaveFile(file.GetName());
  CConfigurationDocument again;
  again.LoadFile(file.GetName());
  CHECK(GetNode(again.GetRoot(), "arena").GetAttribute("size") == "2,2,2");
}

TEST_CASE("document: a file that cannot be read is an error", "[core][configuration]") {
  CConfigurationDocument document = Experiment();
  CHECK_THROWS_WITH(document.LoadFile("/no/such/file.argos"),
                    Contains("\"/no/such/file.argos\": No such file or directory"));
  CHECK_THROWS_WITH(document.LoadFile("/"), Contains("it is a directory"));
  // the document is unchanged
  CHECK(document.GetName() == "e.argos");
  CHECK_THROWS_WITH(document.SaveFile("/no/such/folder/file"), Contains("Cannot write the file"));
}

TEST_CASE("document: an empty document has no root", "[core][configuration]") {
  CConfigurationDocument document;
  CHECK_THROWS_WITH(document.GetRoot(), Contains("a document that was not loaded"));
  CHECK_THROWS_WITH(document.SaveFile("x"), Contains("the document is empty"));
  CHECK_THROWS_WITH(document.SetByPath("@a", "1"), Contains("the document is empty"));
  CHECK(Unread(document).empty());
}

TEST_CASE("document: malformed XML is refused with its line", "[core][configuration]") {
  CHECK_THAT(ErrorOfParsing(""), Contains("x.argos: not well-formed XML: the document is empty"));
  CHECK_THAT(ErrorOfParsing("<a>\n<b>\n</a>"),
             Contains("x.argos:3: not well-formed XML: </a> is found where </b> must come first: "
                      "<b> of line 2 is still open"));
  // neither comments nor attributes nor CDATA count
  CHECK_THAT(ErrorOfParsing("<?xml version='1.0'?>\n<a><!-- <x> -->\n<c y='>'/><d z='/'></d>\n"
                            "<![CDATA[<e>]]></b></a>"),
             Contains("x.argos:4: not well-formed XML: </b> is found where </a> must come first: "
                      "<a> of line 2 is still open"));
  CHECK_THAT(ErrorOfParsing("<a>\n<b></b>"), Contains("not well-formed XML"));
  CHECK_THAT(ErrorOfParsing("<a>\n<b x=1/></a>"),
             Contains("x.argos:2: not well-formed XML: an "
                      "attribute of this element is malformed"));
  CHECK_THAT(ErrorOfParsing("<a b='1' b='2'/>"), Contains("given twice"));
  CHECK_THAT(ErrorOfParsing("<a>\n<!-- \n</a>"),
             Contains("x.argos:2: not well-formed XML: this comment"));
  CHECK_THAT(ErrorOfParsing("<a/>\n<b/>"),
             Contains("x.argos:2: not well-formed XML: <b> is outside "
                      "the root element <a>"));
  CHECK_THAT(ErrorOfParsing("<a/>\ntext"),
             Contains("x.argos:2: not well-formed XML: this text is not"));
  CHECK_THAT(ErrorOfParsing("<!-- only -->"), Contains("the document has no element"));
  CHECK_THAT(ErrorOfParsing("just text"), Contains("not well-formed XML"));
  CHECK_THAT(ErrorOfParsing("<a"), Contains("not well-formed XML"));
  CHECK_THAT(ErrorOfParsing(std::string("<a/>\0", 5)), Contains("zero byte at offset 4"));
}

TEST_CASE("document: references are those of XML", "[core][configuration]") {
  CConfigurationDocument document;
  document.Parse(
      "<a b='&amp;&lt;&gt;&quot;&apos;&#65;&#xe9;'><!-- R&D &x; -->"
      "<c><![CDATA[R&D]]></c></a>");
  CHECK(document.GetRoot().GetAttribute("b") == "&<>\"'A\xC3\xA9");
  CHECK(GetNode(document.GetRoot(), "c").GetText() == "R&D");

  constexpr const char* kRaw =
      "x.argos:2: not well-formed XML: this \"&\" begins no entity and must "
      "be written \"&amp;\"";
  for (const char* const text : {"R&D", "R & D", "&", "a&amp", "&#;", "&;", "&#65", "?a=1&b=2"}) {
    CAPTURE(text);
    CHECK_THAT(ErrorOfParsing("<a>\n<b c='" + std::string(text) + "'/></a>"), Contains(kRaw));
    CHECK_THAT(ErrorOfParsing("<a>\n" + std::string(text) + "</a>"), Contains(kRaw));
  }
  for (const char* const number : {"#0", "#x", "#xD800", "#x110000", "#12a", "#65537000000000"}) {
    CAPTURE(number);
    CHECK_THAT(ErrorOfParsing("<a>\n<b c='&" + std::string(number) + ";'/></a>"),
               Contains("x.argos:2: not well-formed XML: \"&" + std::string(number) +
                        ";\" is the number of no character"));
  }
  CHECK_THAT(ErrorOfParsing("<a>\n<b c='&uuml;'/></a>"),
             Contains("x.argos:2: not well-formed XML: there is no entity \"&uuml;\", only &amp;"));
}

TEST_CASE("document: a DOCTYPE may not declare anything", "[core][configuration]") {
  CHECK(ErrorOfParsing("<!DOCTYPE a SYSTEM \"a[1].dtd\">\n<a/>") == "accepted");
  for (const char* const declarations :
       {"<!ENTITY speed \"5\">", "", "<!ATTLIST b c CDATA \"1\">", "<!-- it's -->"}) {
    CHECK_THAT(ErrorOfParsing("<?xml version='1.0'?>\n<!DOCTYPE a [" + std::string(declarations) +
                              "]>\n<a b='&speed;'/>"),
               Contains("x.argos:2: not well-formed XML: declarations in a DOCTYPE"));
  }
}

TEST_CASE("document: text is converted from the encoding that is declared",
          "[core][configuration]") {
  constexpr const char* kUmlaut = "\xC3\xA4";
  for (const char* const encoding : {"ISO-8859-1", "iso-8859-1", "latin1"}) {
    CConfigurationDocument document;
    document.Parse("<?xml version='1.0' encoding='" + std::string(encoding) + "'?>\n<a b='\xE4'/>");
    CHECK(document.GetRoot().GetAttribute("b") == kUmlaut);
    // what is saved is what it says that it is
    CConfigurationDocument copy;
    copy.Parse(document.ToText());
    CHECK(copy.GetRoot().GetAttribute("b") == kUmlaut);
  }
  for (const char* const declaration :
       {"", "<?xml version='1.0'?>", "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone='yes'?>",
        "<?xml version=\"1.0\" encoding='utf-8'?>", "<?xml version='1.0' encoding='US-ASCII'?>",
        "<?xml version='1.0' encoding='ascii'?>", "\xEF\xBB\xBF<?xml version='1.0'?>"}) {
    CAPTURE(declaration);
    const std::string start(declaration);
    CConfigurationDocument document;
    document.Parse(start + "<a b='" + kUmlaut + "'/>");
    CHECK(document.GetRoot().GetAttribute("b") == kUmlaut);
    CHECK_THAT(ErrorOfParsing(start + "\n<a b='\xE4'/>"),
               Contains("x.argos:2: not well-formed XML: byte 0xE4 is not UTF-8; save the file as "
                        "UTF-8, or name its encoding"));
    // comments are not read
    CHECK(ErrorOfParsing(start + "\n<!-- \xE4 --><a/>") == "accepted");
  }
  CHECK_THAT(ErrorOfParsing("<?xml version='1.0' encoding='UTF-16'?><a/>"),
             Contains("x.argos:1: not well-formed XML: the encoding \"UTF-16\" is not supported"));
  CHECK_THAT(ErrorOfParsing(std::string("\xFF\xFE<\0a\0/\0>\0", 10)),
             Contains("x.argos:1: not well-formed XML: the file is encoded in UTF-16"));
}

// unread elements and attributes

TEST_CASE("document: of a long text that is not used the start is shown", "[core][configuration]") {
  CConfigurationDocument document;
  const std::string start(60, 'x');
  document.Parse("<a><b>" + start + "</b><c>" + start + "y</c></a>", "x.argos");
  GetNode(document.GetRoot(), "b");
  GetNode(document.GetRoot(), "c");
  const std::vector<std::string> lines = document.DescribeUnread();
  REQUIRE(lines.size() == 2);
  CHECK_THAT(lines[0], Contains("the text '" + start + "'"));
  CHECK_THAT(lines[1], Contains("the text '" + start + "...'"));
  // not within a character
  const std::string umlauts = start.substr(1) + "\xC3\xA4\xC3\xB6";
  document.Parse("<a>" + umlauts + "</a>");
  document.GetRoot();
  CHECK_THAT(document.DescribeUnread().at(0), Contains('\'' + start.substr(1) + "...'"));
}

TEST_CASE("document: an element may have many attributes", "[core][configuration]") {
  constexpr int kAttributes = 500;
  const auto name = [](int number) { return "attribute_" + std::to_string(number); };
  std::string xml = "<a ";
  for (int i = 0; i < kAttributes; ++i) {
    xml += name(i) + "=\"1\" ";
  }
  CConfigurationDocument document;
  document.Parse(xml + "/>", "many.argos");
  TConfigurationNode& root = document.GetRoot();
  CHECK(NodeAttributeExists(root, name(kAttributes - 1)));
  CHECK_FALSE(NodeAttributeExists(root, name(kAttributes)));
  CHECK(document.DescribeUnread().size() == 64);
  CHECK(NodeAttributeExists(root, name(5)));
  CHECK(document.DescribeUnread().size() == 63);
  for (const std::string& each : root.GetAttributeNames()) {
    REQUIRE(NodeAttributeExists(root, each));
  }
  int number = 0;
  TConfigurationAttributeIterator attribute;
  for (attribute = attribute.begin(&root); attribute != attribute.end(); ++attribute) {
    ++number;
  }
  CHECK(number == kAttributes);
  // names that are given twice are found
  CHECK_THROWS_WITH(document.Parse(xml + name(0) + "='1'/>", "many.argos"),
                    Contains("given twice"));
  CHECK_THROWS_WITH(document.Parse(xml + name(kAttributes - 1) + "='1'/>", "many.argos"),
                    Contains("given twice"));
}

TEST_CASE("document: everything is unread at first", "[core][configuration]") {
  CConfigurationDocument document = Experiment();
  CHECK(Unread(document) == "<argos-configuration> ");
  document.GetRoot();
  CHECK(Unread(document) == "<framework> <arena> ");
}

TEST_CASE("document: every kind of access marks the attribute or element as read",
          "[core][configuration]") {
  CConfigurationDocument document = Experiment();
  TConfigurationNode& framework = GetNode(document.GetRoot(), "framework");
  CHECK(NodeExists(framework, "experiment"));
  CHECK(Unread(document) == "<experiment>@length <experiment>@random_seed <arena> ");
  TConfigurationNode& experiment = GetNode(framework, "experiment");
  SECTION("read of a value") {
    UInt32 seed = 0;
    GetNodeAttribute(experiment, "random_seed", seed);
    CHECK(Unread(document) == "<experiment>@length <arena> ");
  }
  SECTION("test of existence") {
    CHECK(NodeAttributeExists(experiment, "length"));
    CHECK(Unread(document) == "<experiment>@random_seed <arena> ");
  }
  SECTION("read with a default") {
    Real length = 0;
    GetNodeAttributeOrDefault(experiment, "length", length, 0.0);
    CHECK(Unread(document) == "<experiment>@random_seed <arena> ");
  }
  SECTION("read through a copy of the handle") {
    const TConfigurationNode copy = experiment;
    CHECK(copy.GetAttribute("length") == "10");
    CHECK(Unread(document) == "<experiment>@random_seed <arena> ");
  }
  SECTION("iteration over attributes") {
    TConfigurationAttributeIterator it;
    for (it = it.begin(&experiment); it != it.end(); ++it) {
    }
    CHECK(Unread(document) == "<arena> ");
  }
  SECTION("removal of attributes") {
    CHECK(experiment.GetAttribute("random_seed") == "1");
    experiment.RemoveAttribute("length");
    CHECK(Unread(document) == "<arena> ");
  }
  SECTION("iteration over elements") {
    MarkSubtreeRead(framework);
    TConfigurationNodeIterator it("foot-bot");
    for (it = it.begin(&GetNode(document.GetRoot(), "arena")); it != it.end(); ++it) {
      MarkSubtreeRead(*it);
    }
    CHECK(Unread(document) == "<arena>@size <distribute> <distribute> ");
  }
  SECTION("marking of a whole subtree") {
    MarkSubtreeRead(document.GetRoot());
    CHECK(Unread(document).empty());
  }
}

TEST_CASE("document: an attribute set by path still counts as unread", "[core][configuration]") {
  CConfigurationDocument document = Experiment();
  MarkSubtreeRead(document.GetRoot());
  document.Parse("<a><b/></a>");
  GetNode(document.GetRoot(), "b");
  document.SetByPath("b/@typo", "1");
  CHECK(Unread(document) == "<b>@typo ");
}

// paths

TEST_CASE("document: paths reach attributes", "[core][configuration]") {
  CConfigurationDocument document = Experiment();
  const auto value = [&document](const std::string& tag, const std::string& attribute) {
    return GetNode(GetNode(document.GetRoot(), "framework"), tag).GetAttribute(attribute);
  };
  CHECK(document.SetByPath("/argos-configuration/framework/experiment/@length", "1") ==
        "e.argos:4: <experiment> length=\"1\" (was \"10\")");
  CHECK(value("experiment", "length") == "1");
  document.SetByPath("framework/experiment/@length", "2");
  CHECK(value("experiment", "length") == "2");
  document.SetByPath("/framework/experiment/@length", "3");
  CHECK(value("experiment", "length") == "3");
  document.SetByPath("//experiment/@length", "4");
  CHECK(value("experiment", "length") == "4");
  document.SetByPath("*/experiment/@length", "5");
  CHECK(value("experiment", "length") == "5");
  CHECK(document.SetByPath("framework/experiment/@new", "6") ==
        "e.argos:4: <experiment> new=\"6\" (was not there)");
  CHECK(value("experiment", "new") == "6");
  document.SetByPath("@version", "7");
  CHECK(document.GetRoot().GetAttribute("version") == "7");
  document.SetByPath("//argos-configuration/@version", "8");
  CHECK(document.GetRoot().GetAttribute("version") == "8");
}

TEST_CASE("document: predicates select among siblings", "[core][configuration]") {
  CConfigurationDocument document = Experiment();
  CHECK_THAT(document.SetByPath("arena/distribute[2]/entity/@quantity", "9"),
             Contains("e.argos:8: <entity> quantity=\"9\" (was \"2\")"));
  CHECK_THAT(document.SetByPath("//foot-bot[@id='fb1']/body/@position", "5,5,5"),
             Contains("(was \"1,0,0\")"));
  CHECK_THAT(document.SetByPath("arena/foot-bot[@id=\"fb0\"]/@id", "x"), Contains("(was \"fb0\")"));
  CHECK_THAT(document.SetByPath("arena/*[3]/@id", "y"), Contains("(was \"x\")"));
}

TEST_CASE("document: a double slash changes all matches", "[core][configuration]") {
  CConfigurationDocument document = Experiment();
  CHECK(document.SetByPath("//entity/@quantity", "7") ==
        "e.argos:7: <entity> quantity=\"7\" (was \"1\")\n"
        "e.argos:8: <entity> quantity=\"7\" (was \"2\")");
  CHECK_THAT(document.SetByPath("//*//body/@position", "0"), Contains("e.argos:10"));
}

TEST_CASE("document: the error on a path without a match names the step and the nearest name",
          "[core][configuration]") {
  CConfigurationDocument document = Experiment();
  CHECK_THROWS_WITH(
      document.SetByPath("framework/experimet/@length", "1"),
      "[FATAL] \"framework/experimet/@length\": nothing matches the step \"experimet\" "
      "inside <framework> (line 3); did you mean \"experiment\"?");
  CHECK_THROWS_WITH(document.SetByPath("//footbot/@id", "1"),
                    Contains("did you mean \"foot-bot\"?"));
  CHECK_THROWS_WITH(document.SetByPath("arena/distribute[3]/@x", "1"),
                    Contains("elements <distribute> there: 2"));
  CHECK_THROWS_WITH(document.SetByPath("zzz/@x", "1"), Contains("known: framework, arena"));
}

TEST_CASE("document: a path that matches several elements is an error with their lines",
          "[core][configuration]") {
  CConfigurationDocument document = Experiment();
  CHECK_THROWS_WITH(document.SetByPath("arena/distribute/entity/@quantity", "1"),
                    Contains("matches 2 elements, in lines 7, 8"));
  // nothing was changed
  CHECK(GetNode(GetNode(GetNode(document.GetRoot(), "arena"), "distribute"), "entity")
            .GetAttribute("quantity") == "1");
}

TEST_CASE("document: malformed paths are errors", "[core][configuration]") {
  CConfigurationDocument document = Experiment();
  for (const char* path : {"", "/", "framework", "framework/experiment", "a//@b", "@a/b", "a[/@b",
                           "a[0]/@b", "a[x]/@b", "a[@id]/@b", "a[@id='x]/@b", "a[@id=x]/@b",
                           "a[@ident]/@b", "a[@ident=]/@b", "a[@id=']/@b", "[1]/@b", "a///@b"}) {
    CAPTURE(path);
    CHECK_THROWS_WITH(document.SetByPath(path, "1"), Contains("is not a path to an attribute"));
  }
  CHECK_THROWS_WITH(document.SetByPath("a b/@c", "1"), Contains("cannot be the name"));
  CHECK_THROWS_WITH(document.SetByPath("framework/@a b", "1"), Contains("cannot be the name"));
}

}  // namespace configuration_document_test
