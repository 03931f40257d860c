#ifndef TEXT_VIEW_H
#define TEXT_VIEW_H

#include <argos3/core/simulator/visualization/visualization.h>

#include <fstream>
#include <string>

/* Writes the pose of each body after each tick as text: tick, id, x, y and heading in degrees. */
class CTextView : public argos::CVisualization {
 public:
  CTextView() {}
  virtual ~CTextView() {}
  virtual void Init(argos::TConfigurationNode& t_tree);
  virtual void Execute();
  virtual void Reset() {}
  virtual void Destroy();

 private:
  void Write();

  std::ofstream m_cFile;
};

#endif
