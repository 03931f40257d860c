# what argos3-plot consists of: figures of the tables that runs write
target_sources(argos3campaign PRIVATE
  plot/metric_figure.cpp
  plot/table_file.cpp
  plot/trajectory_figure.cpp)
