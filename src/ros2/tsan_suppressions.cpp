// For programs with ThreadSanitizer, about Fast DDS 2.9, of which it sees the locks alone.
extern "C" const char* __tsan_default_suppressions();  // NOLINT(readability-identifier-naming): as the sanitizer has it
extern "C" const char* __tsan_default_suppressions() {
  return
      // It locks mutexes with a deadline, by pthread_mutex_clocklock, which the sanitizer of Clang 14 doesn't know:
      // they look as if nobody had locked them who unlocks them.
      "mutex:libfastrtps.so\n"
      // It takes locks of its own in either order: where endpoints of others and of ours are matched, and where a
      // secure endpoint goes. Not all of libfastrtps, whose threads call us: our locks and its own are watched.
      "deadlock:eprosima::fastrtps::rtps::PDP::lookupWriterProxyData\n"
      "deadlock:eprosima::fastrtps::rtps::security::SecurityManager\n"
      "deadlock:eprosima::fastrtps::rtps::StatefulReader::~StatefulReader\n";
}
