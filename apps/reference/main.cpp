// Writes the parts of docs/reference and of web/src/headers that come from the program's own descriptions (make docs).
#include <exception>
#include <iostream>

#include "wythe/io.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: wythe_reference docs/reference web/src/headers\n";
    return 2;
  }
  try {
    wythe::write_reference(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 4;
  }
}
