# which runs come next, and the loop that executes them
target_sources(argos3campaign PRIVATE
  scheduling/campaign_manager.cpp
  scheduling/campaign_progress.cpp
  scheduling/metric_watch.cpp
  scheduling/run_plan.cpp
  scheduling/stop_signals.cpp)
