#include <argos3/program/catalogue/libraries_of.h>

#include <argos3/core/simulator/context/library_attribute.h>
#include <argos3/core/utility/configuration/configuration_document.h>

namespace argos {

namespace {

void LoadIn(TConfigurationNode& element) {
  LoadLibraryOf(element);
  TConfigurationNodeIterator it;
  for (it = it.begin(&element); it != it.end(); ++it) {
    LoadIn(*it);
  }
}

}  // namespace

void LoadLibrariesOf(const std::string& experimentFile) {
  CConfigurationDocument document;
  document.LoadFile(experimentFile);
  LoadIn(document.GetRoot());
}

}  // namespace argos
