# one run: in this process, and in processes with limits
target_sources(argos3campaign PRIVATE
  execution/collected_columns.cpp
  execution/experiment_paths.cpp
  execution/metric_collection.cpp
  execution/output_tail.cpp
  execution/run_execution.cpp
  execution/run_messages.cpp
  execution/run_process.cpp
  execution/message_stream.cpp
  execution/worker.cpp
  execution/worker_process.cpp)
