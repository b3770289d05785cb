// For programs with AddressSanitizer: Fast DDS 2.9 deletes an object of its own as one of its base, whose destructor
// isn't virtual (RTPSReader's), and nothing that we do could help it.
extern "C" const char* __asan_default_options();  // NOLINT(readability-identifier-naming): as the sanitizer has it
extern "C" const char* __asan_default_options() {
  return "new_delete_type_mismatch=0";
}
