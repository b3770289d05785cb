/// \file
/// A domain that no other test is in.
#pragma once

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <stdexcept>
#include <string>

namespace scrubjay::ros {

/// Reserved among all processes that do the same, until it is destroyed.
class FreshDomain {
 public:
  FreshDomain() {
    // Those that are near one another in time have different numbers to begin with.
    const int first = static_cast<int>(::getpid()) % kDomains;
    for (int i = 0; i < kDomains; ++i) {
      if (reserve(1 + (first + i) % kDomains)) return;
    }
    throw std::runtime_error("all domains are taken");
  }
  FreshDomain(const FreshDomain&) = delete;
  FreshDomain& operator=(const FreshDomain&) = delete;
  ~FreshDomain() { ::close(file_); }

  int number() const { return number_; }

 private:
  static constexpr int kDomains = 100;

  /// By a socket's name, which the system gives to one process and takes back when that ends.
  bool reserve(int number) {
    file_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    const std::string name = "scrubjay-test-domain-" + std::to_string(number);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path + 1, name.data(), name.size());  // behind a NUL: no file
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
    if (::bind(file_, reinterpret_cast<const sockaddr*>(&address), size) == 0) {
      number_ = number;
      return true;
    }
    ::close(file_);
    return false;
  }

  int file_ = -1;
  int number_ = 0;
};

}  // namespace scrubjay::ros
