# ReadCampaign(): from the campaign file to the combinations.
target_sources(argos3campaign PRIVATE
  design/campaign.cpp
  design/campaign_reader.cpp
  design/combination_filter.cpp
  design/combinations.cpp
  design/element_reading.cpp
  design/expression.cpp
  design/factor_reader.cpp
  design/factor_values.cpp
  design/latin_hypercube.cpp
  design/reductions.cpp
  design/report_reader.cpp
  design/run_reader.cpp
  design/setting_checks.cpp)
