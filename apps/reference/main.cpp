// Writes the reference page of model files from the specs' own descriptions (make docs).
#include <exception>
#include <iostream>

#include "wythe/io.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: wythe_reference PAGE.md\n";
    return 2;
  }
  try {
    wythe::write_text(argv[1], wythe::reference_page());
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 4;
  }
}
