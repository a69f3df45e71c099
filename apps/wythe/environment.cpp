// OpenTURNS reads OPENTURNS_NUM_THREADS while it is loaded, before main, and ends the program where that is no
// number. So these variables are taken out of the environment before any library starts: the entries of
// .preinit_array are called then, with the environment as an argument. No function of a library may be called
// there, and no sanitizer is ready. Its settings in files: src/study/draws/sampling.cpp.
namespace wythe::app {
namespace {

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

bool is_of_openturns(const char* entry) {
  constexpr char kName[] = "OPENTURNS_";
  for (int i = 0; kName[i] != '\0'; ++i)
    if (entry[i] != kName[i]) return false;
  return true;
}

void drop_openturns(int /*count*/, char** /*arguments*/, char** environment) {
  char** kept = environment;
  for (char** entry = environment; *entry != nullptr; ++entry)
    if (!is_of_openturns(*entry)) *kept++ = *entry;
  *kept = nullptr;
}

using Early = void (*)(int, char**, char**);
[[gnu::section(".preinit_array"), gnu::used]] const Early kFirst = drop_openturns;

#endif

}  // namespace
}  // namespace wythe::app
