// Each fault with its whole text and line.

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/configuration/configuration_path.h>
#include <argos3/core/utility/configuration/xml_text.h>

#include <catch2/catch.hpp>

#include <tinyxml2.h>

#include <string>

namespace xml_text_test {

using namespace argos;

namespace {

// "<line>: <text>", or "right"
std::string Describe(const SXmlFault& fault) {
  return fault.Text.empty() ? "right" : std::to_string(fault.Line) + ": " + fault.Text;
}

std::string Mismatch(const std::string& xml) {
  return Describe(FindMismatch(xml));
}

std::string Fault(const std::string& xml) {
  return Describe(FindXmlFault(xml));
}

// what a path finds, as the attributes "id" of the elements, or the text of the error
std::string Find(const std::string& path) {
  constexpr const char* kXml =
      "<root id='r'><a id='1'><b id='2' x=''/><b id='3'/></a>\n"
      "<a id='4'><b id='5' x='7'><b id='6'/></b></a>\n<c id='7'/><root id='8'/></root>";
  tinyxml2::XMLDocument document;
  REQUIRE(document.Parse(kXml) == tinyxml2::XML_SUCCESS);
  try {
    const CConfigurationPath parsed(path);
    std::string ids = parsed.GetAttribute() + ':';
    for (const tinyxml2::XMLElement* element : parsed.Find(*document.RootElement())) {
      ids += ' ' + std::string(element->Attribute("id"));
    }
    return ids;
  } catch (const CARGoSException& error) {
    return std::string(error.what()).substr(std::string("[FATAL] ").size());
  }
}

}  // namespace

TEST_CASE("XML: numbers of characters are those of production 2", "[core][configuration]") {
  for (const char* number : {"9", "10", "13", "32", "x20", "xD7FF", "xE000", "xFFFD", "x10000",
                             "x10FFFF", "55295", "1114111"}) {
    CAPTURE(number);
    CHECK(Fault("<a>&#" + std::string(number) + ";</a>") == "right");
  }
  for (const char* number :
       {"0", "8", "11", "12", "14", "31", "x1F", "xD800", "xDFFF", "xFFFE", "xFFFF", "x110000",
        "55296", "1114112", "99999999999999999999999", "12a", "xg", "x"}) {
    CAPTURE(number);
    CHECK(Fault("<a>\n&#" + std::string(number) + ";</a>") ==
          "2: \"&#" + std::string(number) + ";\" is the number of no character that XML allows");
  }
}

TEST_CASE("XML: what begins no reference is a fault", "[core][configuration]") {
  const std::string fault = "1: this \"&\" begins no entity and must be written \"&amp;\"";
  for (const char* text : {"&", "& ", "&;", "&#;", "&#", "&amp", "&amp ", "&a&b;", "&lt=;"}) {
    CAPTURE(text);
    CHECK(Fault(text) == fault);
  }
  CHECK(Fault("&amp;&lt;&gt;&quot;&apos;") == "right");
  CHECK(Fault("<a>&nbsp;</a>") ==
        "1: there is no entity \"&nbsp;\", only &amp; &lt; &gt; &quot; and &apos;; write its "
        "text, or \"&amp;nbsp;\" if that is the text");
  for (const char* name : {"&a.b-c:d_1;", "&\xC3\xA4;"}) {
    CHECK(Fault(name).rfind("1: there is no entity", 0) == 0);
  }
}

TEST_CASE("XML: comments, CDATA and instructions may contain anything", "[core][configuration]") {
  CHECK(Fault("<!-- & \xFF --><![CDATA[ & ]]><?x & ?><!y & ><a/>") == "right");
  CHECK(Fault("<!-- -->&") != "right");
  CHECK(Fault("<![CDATA[]]>&") != "right");
  CHECK(Fault("<?x?>&") != "right");
  CHECK(Fault("<!-- &") == "right");
  CHECK(Fault(std::string("<a>\n\n\0</a>", 10)) ==
        "3: zero byte at offset 5; is it a text file, in UTF-8?");
  CHECK(Fault("<a>\n\xE9</a>").rfind("2: byte 0xE9 is not UTF-8; save the file as UTF-8", 0) == 0);
  CHECK(Fault("<a>\xC3\xA9\xE2\x82\xAC\xF0\x9F\xA4\x96</a>") == "right");
}

TEST_CASE("XML: a DOCTYPE without declarations is accepted", "[core][configuration]") {
  CHECK(Fault("<!DOCTYPE a><a/>") == "right");
  CHECK(Fault("<!DOCTYPE a SYSTEM \"[\"><a>[</a>") == "right");
  CHECK(Fault("<!DOCTYPE a SYSTEM '[\"'><a>[</a>") == "right");
  CHECK(Fault("\n<!DOCTYPE a [ ]><a/>").rfind("2: declarations in a DOCTYPE", 0) == 0);
  CHECK(Fault("<!DOCTYPE a SYSTEM 'x' [ ]><a/>").rfind("1: declarations in a DOCTYPE", 0) == 0);
}

TEST_CASE("XML: tags that do not match are named with their lines", "[core][configuration]") {
  CHECK(Mismatch("<a><b/><c></c>\n<d x='>/'\ny=\"'>\"/></a>") == "right");
  CHECK(Mismatch("<a>\n<b>\n</a>") ==
        "3: </a> is found where </b> must come first: <b> of line 2 is still open");
  CHECK(Mismatch("<a/>\n</a>") == "2: </a> closes an element that is not open");
  CHECK(Mismatch("<a>\n<b\n>\n</b>\n") == "1: <a> is still open at the end of the file");
  CHECK(Mismatch("\n<a") == "2: <a> is still open at the end of the file");
  CHECK(Mismatch("<a><!-- <b> --><![CDATA[<c>]]><?d <e> ?><!f></a>") == "right");
  CHECK(Mismatch("<a>\n<!-- \n\n --><b>\n</a>") ==
        "5: </a> is found where </b> must come first: <b> of line 4 is still open");
  CHECK(Mismatch("<a\tx=''>\n</a\n>") == "right");
}

TEST_CASE("XML: the encoding in the declaration decides how bytes are read",
          "[core][configuration]") {
  const auto convert = [](std::string xml) {
    const SXmlFault fault = ConvertToUtf8(xml);
    return fault.Text.empty() ? xml : Describe(fault);
  };
  CHECK(convert("<?xml encoding='ISO-8859-1'?><a>x\x7F\x80\xBF\xC0\xFF</a>") ==
        "<?xml encoding='UTF-8'?><a>x\x7F\xC2\x80\xC2\xBF\xC3\x80\xC3\xBF</a>");
  CHECK(convert("<?xml version=\"1.0\"\nencoding = \"Latin-1\" ?>\xE9") ==
        "<?xml version=\"1.0\"\nencoding = \"UTF-8\" ?>\xC3\xA9");
  for (const char* same :
       {"<?xml encoding='utf8'?>\xE9", "<?xml encoding='US-ASCII'?>", "<?xml version='1.0'?>",
        "<?xml encoding=''?>", "<?xml encoding='x", "<?xml encoding", "encoding='utf-7'"}) {
    CAPTURE(same);
    CHECK(convert(same) == same);
  }
  CHECK(convert("<?xml\n encoding='utf-7'?>") ==
        "2: the encoding \"utf-7\" is not supported: save the file as UTF-8, or as ISO-8859-1, and "
        "name that in this line");
  CHECK(convert("\xFF\xFE<") == "1: the file is encoded in UTF-16; save it as UTF-8");
  CHECK(convert("\xFE\xFF<") == "1: the file is encoded in UTF-16; save it as UTF-8");
}

TEST_CASE("paths: steps, places and conditions select elements", "[core][configuration]") {
  CHECK(Find("a/b[@id='3']/@x") == "x: 3");
  CHECK(Find("/root/c/@x") == "x: 7");
  CHECK(Find("root/c/@x") == "x: 7");
  CHECK(Find("c/@x") == "x: 7");
  CHECK(Find("a[2]/b/@x") == "x: 5");
  CHECK(Find("a[2]/b[1]/b/@x") == "x: 6");
  CHECK(Find("a/b[@x='']/@x") == "x: 2");
  CHECK(Find("a/b[@x=\"7\"]/@x") == "x: 5");
  CHECK(Find("//b/@x") == "x: 2 3 5 6");
  CHECK(Find("//b[2]/@x") == "x: 3");
  CHECK(Find("//a//b/@x") == "x: 2 3 5 6");
  CHECK(Find("//b//b/@x") == "x: 6");
  CHECK(Find("//root/@x") == "x: r 8");
  CHECK(Find("//*[@id='8']/@x") == "x: 8");
  CHECK(Find("*[3]/@x") == "x: 7");
  CHECK(Find("/*/c/@x") == "x: 7");
  CHECK(Find("//b[@id='5'][1]/@x") == "x: 5");
  CHECK(Find("@x") == "x: r");
}

TEST_CASE("paths: errors say what was found", "[core][configuration]") {
  CHECK(Find("a/b/@x") ==
        "\"a/b/@x\" matches 3 elements, in lines 1, 1, 2: select one, as in "
        "\"b[1]\" or with [@id='...'], or begin with \"//\" for all");
  CHECK(Find("a[3]/@x") ==
        "\"a[3]/@x\": nothing matches the step \"a[3]\" inside <root> (line 1); elements <a> "
        "there: 2");
  CHECK(Find("//b[@id='9']/@x") ==
        "\"//b[@id='9']/@x\": nothing matches the step \"b[@id='9']\" inside <root> (line 1); "
        "elements <b> there: 4");
  CHECK(Find("a[2]/d/@x") ==
        "\"a[2]/d/@x\": nothing matches the step \"d\" inside <a> (line 2); known: b");
  const auto malformed = [](const std::string& path) {
    const std::string text = Find(path);
    const std::string start = '"' + path + "\" is not a path to an attribute: ";
    REQUIRE(text.rfind(start, 0) == 0);
    return text.substr(start.size(), text.find("; expected a form") - start.size());
  };
  const std::string isEmpty = "a step between two slashes or after the last one is empty";
  CHECK(malformed("a///@x") == isEmpty);
  CHECK(malformed("a/@x/") == isEmpty);
  CHECK(malformed("a/") == isEmpty);
  CHECK(malformed("@x/a") == "\"@x\" is not at the end");
  CHECK(malformed("a//@x") == "\"//\" precedes the attribute");
  CHECK(malformed("a/b") == "it does not end with \"@\" and the name of an attribute");
  CHECK(malformed("") == "it does not end with \"@\" and the name of an attribute");
  CHECK(malformed("[1]/@x") == "the step \"[1]\" names no element");
  CHECK(malformed("a[1/@x") == "the brackets of the step \"a[1/@x\" do not match");
  CHECK(malformed("a[1]b/@x") == "the brackets of the step \"a[1]b\" do not match");
  for (const char* condition :
       {"0", "", "-1", "1.5", "@a", "@a=", "@a='", "@a='b", "@a='b\"", "a='b'", "@='b", "b"}) {
    CHECK(malformed("a[" + std::string(condition) + "]/@x") ==
          "[" + std::string(condition) +
              "] is neither a number from 1 up nor a condition [@name='value']");
  }
}

}  // namespace xml_text_test
