#ifndef USER_PROJECT_PATH_LOG_H
#define USER_PROJECT_PATH_LOG_H

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/files/output_file.h>

#include <map>
#include <string>

/**
 * Writes the position of each foot-bot after each tick, and the length of its path, as
 * comma-separated values: tick, robot, x (m), y (m), driven (m).
 *
 *   <loop_functions library="build/libpath_log" label="path_log" output="paths.csv" />
 */
class CPathLog : public argos::CLoopFunctions {
 public:
  void Init(argos::TConfigurationNode& node) override;
  void Reset() override;
  void Destroy() override;
  void PostStep() override;
  void PostExperiment() override;

 private:
  struct SPath {
    argos::CVector3 Position;  // in the previous tick, m
    argos::Real Driven = 0.0;  // length of its path so far, m
  };

  void Start();

  std::string m_fileName;
  argos::COutputFile m_file;
  std::map<std::string, SPath> m_paths;  // by the robot's id
};

#endif
