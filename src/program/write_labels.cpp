// argos3_write_labels LIBRARY: writes the index of the labels that a library registers beside it
// (label_index.h). The build runs it for each library of plug-ins.

#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/core/utility/plugins/label_index.h>
#include <argos3/core/utility/plugins/registered_labels.h>

#include <unistd.h>

#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: " << argv[0] << " LIBRARY\n";
    return 2;
  }
  try {
    const std::string library = std::filesystem::absolute(argv[1]).string();
    argos::CDynamicLoading::LoadLibrary(library);
    argos::WriteLabelIndex(library,
                           argos::ListLabelsOf(std::filesystem::path(library).filename().string()));
  } catch (const std::exception& error) {
    std::cerr << "The labels of \"" << argv[1] << "\" cannot be listed: " << error.what() << '\n';
    return 1;
  }
  // the libraries are not destroyed: it takes time, and sanitizers would check them in each build
  _exit(0);
}
