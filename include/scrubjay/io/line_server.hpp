/// \file
/// Lines of text for whoever listens at a TCP port of this machine.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scrubjay {

/// Listens on the loopback address alone, and never waits: a listener that is slow misses lines, whole ones.
class LineServer {
 public:
  /// `port` 0: any that is free. Throws Error (Kind::Failure) if the port isn't to be had.
  explicit LineServer(std::uint16_t port);
  LineServer(const LineServer&) = delete;
  LineServer& operator=(const LineServer&) = delete;
  ~LineServer();

  std::uint16_t port() const { return port_; }
  /// Lets in who has come, and tells everybody this line (without its end).
  void tell(std::string_view line);

 private:
  struct Listener {
    int file = -1;
    std::string unsent;  ///< the rest of a line
  };

  void let_in();
  static bool send(Listener& listener);

  int file_ = -1;
  std::uint16_t port_ = 0;
  std::vector<Listener> listeners_;
};

}  // namespace scrubjay
