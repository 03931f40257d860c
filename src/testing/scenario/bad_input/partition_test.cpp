// Regions of engines that do not fit together, reported when an experiment is loaded.

#include "experiment_text.h"

#include <catch2/catch.hpp>

#include <sstream>
#include <vector>

namespace bad_input_partition_test {

using namespace argos;
using Catch::Contains;

namespace {

// a rectangle; each face may have its own attributes
struct SRegion {
  std::string Id;
  std::string Left, Low, Right, High;
  std::string SouthFace, EastFace, NorthFace, WestFace;
  std::string Heights;
  std::string Type = "dynamics2d";

  std::string ToXml() const {
    const auto vertex = [](const std::string& x, const std::string& y, const std::string& face) {
      return "<vertex point=\"" + x + "," + y + "\" " + face + "/>";
    };
    return "<" + Type + " id=\"" + Id + "\"><boundaries>" + Heights + "<sides>" +
           vertex(Left, Low, SouthFace) + vertex(Right, Low, EastFace) +
           vertex(Right, High, NorthFace) + vertex(Left, High, WestFace) +
           "</sides></boundaries></" + Type + ">";
  }
};

SRegion Region(const std::string& id, const std::string& left, const std::string& right) {
  SRegion region;
  region.Id = id;
  region.Left = left;
  region.Right = right;
  region.Low = "-2";
  region.High = "2";
  return region;
}

std::string ErrorOf(const std::string& engines) {
  SExperimentText experiment;
  experiment.Engines = "<physics_engines>" + engines + "</physics_engines>";
  return LoadError(experiment);
}

std::string ErrorOf(const std::vector<SRegion>& regions) {
  std::string engines;
  for (const SRegion& region : regions) {
    engines += region.ToXml();
  }
  return ErrorOf(engines);
}

}  // namespace

TEST_CASE("bad partition: regions that fit are accepted", "[bad_input][partition]") {
  CHECK(ErrorOf({Region("west", "-2", "0.5"), Region("east", "0.5", "2")}) == "");
  // coordinates rounded to a nanometre
  CHECK(ErrorOf({Region("west", "-2", "0.500000001"), Region("east", "0.5", "2")}) == "");
  // engines of two types, and one without a region for the rest of the arena
  SRegion air = Region("air", "-2", "2");
  air.Type = "pointmass3d";
  CHECK(ErrorOf(Region("ground", "-2", "2").ToXml() + air.ToXml()) == "");
  CHECK(ErrorOf(Region("west", "-2", "0.5").ToXml() + "<dynamics2d id=\"rest\"/>") == "");
  // two planes
  CHECK(ErrorOf("<dynamics2d id=\"low\"/><dynamics2d id=\"high\" elevation=\"1\"/>") == "");
}

TEST_CASE("bad partition: regions that overlap", "[bad_input][partition]") {
  const std::string error = ErrorOf({Region("west", "-2", "0.5"), Region("east", "0.25", "2")});
  // the overlap is a strip of 0.25 m x 4 m
  CHECK_THAT(error, Contains(At(SExperimentText::kEnginesLine) + " <dynamics2d id=\"west\">") &&
                        Contains("<dynamics2d id=\"east\"> share 1 m^2 with the corners") &&
                        Contains("(0.25,-2)") && Contains("(0.5,-2)") && Contains("(0.5,2)") &&
                        Contains("(0.25,2)") && Contains("at z = 0 m"));
  // one region inside another
  SRegion inner = Region("inner", "-1", "1");
  inner.Low = "-1";
  inner.High = "1";
  CHECK_THAT(ErrorOf({Region("outer", "-2", "2"), inner}), Contains("share 4 m^2"));
  // overlapping heights
  const auto slab = [](const std::string& id, const std::string& low, const std::string& high) {
    SRegion region = Region(id, "-2", "2");
    region.Type = "pointmass3d";
    region.Heights = "<top height=\"" + high + "\"/><bottom height=\"" + low + "\"/>";
    return region;
  };
  CHECK(ErrorOf({slab("low", "0", "1"), slab("high", "1", "2")}) == "");
  CHECK_THAT(ErrorOf({slab("low", "0", "1"), slab("high", "0.5", "2")}),
             Contains("share 16 m^2") && Contains("from z = 0.5 to 1 m"));
}

TEST_CASE("bad partition: regions without sides or without a top or bottom overlap, too",
          "[bad_input][partition]") {
  const auto air = [](const std::string& id, const std::string& faces) {
    return "<pointmass3d id=\"" + id + "\"><boundaries>" + faces + "</boundaries></pointmass3d>";
  };
  const std::string low = "<bottom height=\"0.5\"/>";
  const std::string high = "<top height=\"2\"/>";
  const std::string sides =
      "<sides><vertex point=\"0,0\"/><vertex point=\"1,0\"/><vertex point=\"1,3\"/></sides>";
  const auto [first, second, shared] = GENERATE_COPY(table<std::string, std::string, std::string>(
      {{low, low, "share everything from z = 0.5 m up;"},
       {high, high, "share everything up to z = 2 m;"},
       {low, high, "share everything from z = 0.5 to 2 m;"},
       {high, "<top height=\"3\"/>" + sides,
        "share 1.5 m^2 with the corners (0,0), (1,0), (1,3), "
        "up to z = 2 m;"},
       {sides, low, "share 1.5 m^2 with the corners (0,0), (1,0), (1,3), from z = 0.5 m up;"},
       {sides, sides, "(0,0), (1,0), (1,3), at all heights;"}}));
  CAPTURE(first, second);
  CHECK_THAT(ErrorOf(air("a", first) + air("b", second)), Contains(shared));
  CHECK(ErrorOf(air("a", "<top height=\"0.5\"/>") + air("b", low)) == "");
}

TEST_CASE("bad partition: all overlaps are reported together", "[bad_input][partition]") {
  const std::string error =
      ErrorOf({Region("a", "-2", "0.5"), Region("b", "0.25", "1"), Region("c", "0.75", "2")});
  CHECK_THAT(error, Contains("2 errors in the experiment") && Contains("(0.25,-2)") &&
                        Contains("(0.75,-2)"));
}

TEST_CASE("bad partition: a robot outside every region", "[bad_input][partition]") {
  SExperimentText experiment;
  experiment.Engines = "<physics_engines>" + Region("west", "-2", "0").ToXml() +
                       Region("east", "0", "1.5").ToXml() + "</physics_engines>";
  experiment.Robot = SExperimentText::RobotAt("lost", "1.75,1,0");
  CHECK_THAT(LoadError(experiment), Contains(At(SExperimentText::kArenaLine)) &&
                                        Contains("\"lost\"") && Contains("(1.75,1,0)") &&
                                        Contains("of \"west\", \"east\"") &&
                                        Contains("the nearest is that of \"east\", 0.25 m away") &&
                                        Contains("(0,-2), (1.5,-2), (1.5,2), (0,2)"));
  // all such robots are reported
  experiment.Robot += SExperimentText::RobotAt("gone", "-5,5,0");
  CHECK_THAT(LoadError(experiment), Contains("\"lost\"") && Contains("\"gone\"") &&
                                        Contains("that of \"west\", 4.24264 m away"));
}

TEST_CASE("bad partition: a gate to an engine that does not exist", "[bad_input][partition]") {
  SRegion west = Region("west", "-2", "0.5");
  west.EastFace = "gate=\"eest\"";
  CHECK_THAT(
      ErrorOf({west, Region("east", "0.5", "2")}),
      Contains("its side from \"0.5,-2\" to \"0.5,2\" is a gate to \"eest\", which is not an "
               "engine; did you mean \"east\"?"));
  west.EastFace = "gate=\"west\"";
  CHECK_THAT(ErrorOf({west, Region("east", "0.5", "2")}), Contains("a gate to its own engine"));
  west.EastFace = "gate=\"east\" wall=\"true\"";
  CHECK_THAT(ErrorOf({west, Region("east", "0.5", "2")}), Contains("a wall or a gate, not both"));
}

TEST_CASE("bad partition: a gate that does not lead into the named region",
          "[bad_input][partition]") {
  SRegion west = Region("west", "-2", "0.5");
  west.EastFace = "gate=\"east\"";
  CHECK(ErrorOf({west, Region("east", "0.5", "2")}) == "");
  CHECK_THAT(ErrorOf({west, Region("east", "0.75", "2"), Region("between", "0.5", "0.75")}),
             Contains("its side from \"0.5,-2\" to \"0.5,2\" is a gate that does not lead into") &&
                 Contains("<dynamics2d id=\"east\">, which is 0.25 m from it, with the corners "
                          "(0.75,-2), (2,-2), (2,2), (0.75,2)"));
  // a gate on the wrong side
  west.EastFace = "";
  west.WestFace = "gate=\"east\"";
  CHECK_THAT(ErrorOf({west, Region("east", "0.5", "2")}), Contains("which is 2.5 m from it"));
  // a gate in the top face
  SRegion low = Region("low", "-2", "2");
  low.Heights = "<top height=\"1\" gate=\"high\"/>";
  SRegion high = Region("high", "-2", "2");
  high.Heights = "<bottom height=\"1.5\"/>";
  low.Type = high.Type = "pointmass3d";
  CHECK_THAT(ErrorOf({low, high}),
             Contains("its top is a gate") && Contains("which is from z = 1.5 m up"));
  low.Heights = "<top height=\"1.5\" gate=\"high\"/>";
  CHECK(ErrorOf({low, high}) == "");
  // one in a bottom face, below which the other region ends
  high.Heights = "<bottom height=\"1.5\" gate=\"low\"/>";
  low.Heights = "<top height=\"1\"/>";
  CHECK_THAT(ErrorOf({low, high}),
             Contains("its bottom is a gate") && Contains("which is up to z = 1 m"));
  // at the height of the other region, which is beside it
  low.Heights = "<top height=\"1.5\" gate=\"high\"/>";
  high = Region("high", "2", "4");
  high.Type = "pointmass3d";
  high.Heights = "<bottom height=\"1.5\"/>";
  CHECK_THAT(ErrorOf({low, high}),
             Contains("which is beside it, with the corners (2,-2), (4,-2), (4,2), (2,2)"));
  // one in a side, to a region above
  low.Heights = "<top height=\"1\"/>";
  low.EastFace = "gate=\"high\"";
  CHECK_THAT(ErrorOf({low, high}),
             Contains("is a gate that does not lead") && Contains("which is from z = 1.5 m up"));
  // to a short region, whose corners are nearer than the ends of the gate
  high = Region("high", "2.5", "4");
  high.Type = "pointmass3d";
  high.Low = "-1";
  high.High = "1";
  low.Heights = "";
  CHECK_THAT(ErrorOf({low, high}), Contains("which is 0.5 m from it"));
}

TEST_CASE("bad partition: invalid polygons", "[bad_input][partition]") {
  const auto sides = [](const std::string& points) {
    std::string xml = "<dynamics2d id=\"d\"><boundaries><sides>";
    std::istringstream stream(points);
    std::string point;
    while (stream >> point) {
      xml += "<vertex point=\"" + point + "\"/>";
    }
    return ErrorOf(xml + "</sides></boundaries></dynamics2d>");
  };
  CHECK_THAT(sides("0,0 1,0"), Contains("2 different <vertex> given"));
  CHECK_THAT(sides("0,0 1,1 2,2"), Contains("all vertices lie on one line"));
  CHECK_THAT(sides("0,0 0,1 1,1 1,0"),
             Contains("clockwise") && Contains("(1,0), (1,1), (0,1), (0,0)"));
  CHECK_THAT(sides("0,0 2,2 2,0 0,2"), Contains("crosses itself") && Contains("\"1,1\""));
  CHECK_THAT(sides("0,0 2,0 0.5,0.5 0,2"), Contains("not convex") && Contains("\"0.5,0.5\""));
  CHECK_THAT(ErrorOf("<pointmass3d id=\"p\"><boundaries><top height=\"1\"/><bottom height=\"1\"/>"
                     "</boundaries></pointmass3d>"),
             Contains("the bottom, at 1 m, is not below the top, at 1 m"));
}

TEST_CASE("bad partition: walls of an engine that does not support them",
          "[bad_input][partition]") {
  SRegion region = Region("toy", "-2", "2");
  region.Type = "toy_engine";
  region.EastFace = "wall=\"true\"";
  CHECK_THAT(ErrorOf({region}), Contains("<toy_engine id=\"toy\">: an engine of this type cannot "
                                         "stop bodies"));
}

TEST_CASE("bad partition: an invalid automatic partition", "[bad_input][partition]") {
  CHECK_THAT(ErrorOf("<auto_partition engine=\"dynamic2d\" count=\"4\"/>"),
             Contains(At(SExperimentText::kEnginesLine)) &&
                 Contains("no physics engine of type <dynamic2d>; did you mean \"dynamics2d\""));
  CHECK_THAT(ErrorOf("<auto_partition engine=\"dynamics2d\"/>"), Contains("\"count\" is missing"));
  CHECK_THAT(ErrorOf("<auto_partition engine=\"auto_partition\" count=\"4\"/>"),
             Contains("no physics engine of type <auto_partition>"));
  CHECK_THAT(ErrorOf("<auto_partition engine=\"dynamics2d\" count=\"0\"/>"),
             Contains("from 1 to 4096, found 0"));
  CHECK_THAT(ErrorOf("<auto_partition engine=\"dynamics2d\" count=\"4097\"/>"),
             Contains("from 1 to 4096, found 4097"));
  CHECK_THAT(ErrorOf("<auto_partition engine=\"dynamics2d\" count=\"4\"><boundaries><sides/>"
                     "</boundaries></auto_partition>"),
             Contains("get their <sides> from the size of the arena"));
  CHECK(ErrorOf("<auto_partition engine=\"dynamics2d\" count=\"4\"><boundaries>"
                "<top height=\"3\"/></boundaries></auto_partition>") == "");
  // of an arena without a size, whose error is the only one
  SExperimentText empty;
  empty.Engines =
      "<physics_engines><auto_partition engine=\"dynamics2d\" count=\"4\"/></physics_engines>";
  empty.ArenaAttributes = "size=\"4,-4,1\"";
  CHECK_THAT(LoadError(empty), Contains("\"size\" must be positive along both axes") &&
                                   !Contains("errors in the experiment"));
  // another engine that overlaps the partition
  CHECK_THAT(ErrorOf("<auto_partition engine=\"dynamics2d\" count=\"2\"/>" +
                     Region("extra", "-1", "1").ToXml()),
             Contains("<dynamics2d id=\"dynamics2d_0_0\">") && Contains("share 4 m^2"));
  // errors in attributes of the engines are reported once, for the first engine
  const std::string error =
      ErrorOf("<auto_partition engine=\"dynamics2d\" count=\"2\" elevation=\"up\"/>");
  CHECK_THAT(error, Contains("\"elevation\"") && Contains("\"up\""));
  // an unused attribute is reported once
  SExperimentText experiment;
  experiment.Engines =
      "<physics_engines><auto_partition engine=\"dynamics2d\" count=\"4\" iteration=\"3\"/>"
      "</physics_engines>";
  const std::string warnings = LoadWarnings(experiment);
  const size_t first = warnings.find("\"iteration\" is not used");
  REQUIRE(first != std::string::npos);
  CHECK(warnings.find("\"iteration\" is not used", first + 1) == std::string::npos);
}

}  // namespace bad_input_partition_test
