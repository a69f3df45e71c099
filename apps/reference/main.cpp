// Writes the reference page of model files from the specs' own descriptions (make docs).
#include <fstream>
#include <iostream>

#include "wythe/io.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: wythe_reference PAGE.md\n";
    return 2;
  }
  std::ofstream page(argv[1]);
  page << wythe::reference_page();
  page.close();
  if (!page) {
    std::cerr << argv[1] << ": cannot be written\n";
    return 4;
  }
}
