#ifndef USER_PROJECT_PATH_LOG_H
#define USER_PROJECT_PATH_LOG_H

#include <argos3/core/simulator/loop_functions.h>

#include <fstream>
#include <map>
#include <string>

/**
 * Writes where each foot-bot is after each tick, and how far it has driven, as comma-separated
 * values: tick, robot, x (m), y (m), driven (m).
 *
 *   <loop_functions library="build/libpath_log" label="path_log" output="paths.csv" />
 */
class CPathLog : public argos::CLoopFunctions {
 public:
  void Init(argos::TConfigurationNode& node) override;
  void Reset() override;
  void PostStep() override;
  void PostExperiment() override;

 private:
  struct SPath {
    argos::CVector3 Position;  // where the robot was last, m
    argos::Real Driven = 0.0;  // length of its path so far, m
  };

  void Start();

  std::string m_fileName;
  std::ofstream m_file;
  std::map<std::string, SPath> m_paths;  // by the robot's id
};

#endif
