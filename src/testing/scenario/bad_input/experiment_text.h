#ifndef ARGOS3_TESTING_SCENARIO_BAD_INPUT_EXPERIMENT_TEXT_H
#define ARGOS3_TESTING_SCENARIO_BAD_INPUT_EXPERIMENT_TEXT_H

#include <string>

namespace argos {

/**
 * A small valid experiment: one e-puck, one box, one engine. A test makes one part invalid.
 *
 * Each part begins on the line given by the constants, so that tests can check line numbers.
 */
struct SExperimentText {
  static constexpr int kFrameworkLine = 2;
  static constexpr int kControllersLine = 3;
  static constexpr int kEnginesLine = 4;
  static constexpr int kMediaLine = 5;
  static constexpr int kArenaLine = 6;
  static constexpr int kRestLine = 7;

  std::string Framework =
      "<framework><experiment ticks_per_second=\"10\" length=\"1\" random_seed=\"1\"/></framework>";
  std::string Controllers = "<controllers>" + Controller("test_idle") + "</controllers>";
  std::string Engines = "<physics_engines><dynamics2d id=\"dyn2d\"/></physics_engines>";
  std::string Media = "<media/>";
  std::string ArenaAttributes = "size=\"4,4,1\"";
  std::string Box =
      "<box id=\"b\" size=\"0.2,0.2,0.2\" movable=\"false\"><body position=\"1,0,0\"/></box>";
  std::string Robot = RobotAt("ep", "0,0,0");
  std::string Rest;

  /** A controller with id "c", from the library of test controllers. */
  static std::string Controller(const std::string& label, const std::string& params = "<params/>",
                                const std::string& sensors = "<sensors/>");
  static std::string RobotAt(const std::string& id, const std::string& position);

  std::string ToXml() const;
};

/** The libraries of test controllers and of another version; absolute paths. */
std::string BadControllersLibrary();
std::string OtherVersionLibrary();

/** Loads the experiment as "test.argos". @return the text of the exception; empty if it loads. */
std::string LoadError(const SExperimentText& experiment);
/** Loads any XML. @return as LoadError(). */
std::string LoadErrorOfXml(const std::string& xml);
/** Loads and runs to the end. @return as LoadError(). */
std::string RunError(const SExperimentText& experiment);
/** Loads an experiment that must be valid. @return the output to LOGERR. */
std::string LoadWarnings(const SExperimentText& experiment);
/** Likewise of any XML. */
std::string LoadWarningsOfXml(const std::string& xml);

/** @return "test.argos:<line>:". */
std::string At(int line);

}  // namespace argos

#endif
