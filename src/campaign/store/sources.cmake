# CResultStore and what is exported from it.
target_sources(argos3campaign PRIVATE
  store/csv_export.cpp
  store/database.cpp
  store/experiment_files.cpp
  store/failed_runs.cpp
  store/json_export.cpp
  store/registration.cpp
  store/result_queries.cpp
  store/result_schema.cpp
  store/result_store.cpp
  store/store_lock.cpp
  store/store_merge.cpp)
