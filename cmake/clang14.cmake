# clang before 16 refuses a constructor within Argument that needs the whole of Message (include/wythe/parts/message.h). For that
# compiler the same header with the constructor behind both, found before the original; goes away with the next
# change of that header.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 16)
  file(READ ${CMAKE_SOURCE_DIR}/include/wythe/parts/message.h header)
  set(body "\n      : Argument(std::move(called), static_cast<double>(number)) {}")
  string(REPLACE "integral auto number)${body}" "integral auto number);" moved "${header}")
  string(REPLACE "[[nodiscard]] bool operator==(const Message& a, const Message& b);"
    "Argument::Argument(std::string called, std::integral auto number)${body}\n[[nodiscard]] bool operator==(const Message& a, const Message& b);"
    moved "${moved}")
  file(WRITE ${CMAKE_BINARY_DIR}/generated/clang14/wythe/parts/message.h "${moved}")
  target_compile_options(wythe PUBLIC "SHELL:-iquote ${CMAKE_BINARY_DIR}/generated/clang14")
endif()
