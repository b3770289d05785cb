#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <scrubjay/error.hpp>
#include <scrubjay/io/line_server.hpp>

namespace scrubjay {
namespace {

constexpr std::size_t kMostListeners = 64;

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

}  // namespace

LineServer::LineServer(std::uint16_t port) {
  const auto fail = [&] {
    const int reason = errno;
    if (file_ >= 0) ::close(file_);
    throw Error(fmt::format("cannot listen at port {} of this machine: {}", port, std::strerror(reason)),
                Error::Kind::Failure);
  };
  file_ = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (file_ < 0) fail();
  const int yes = 1;
  ::setsockopt(file_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address = loopback(port);
  socklen_t size = sizeof address;
  // The system's interface for addresses of all kinds.
  auto* any = reinterpret_cast<sockaddr*>(&address);
  if (::bind(file_, any, size) != 0 || ::listen(file_, 8) != 0 || ::getsockname(file_, any, &size) != 0) fail();
  port_ = ntohs(address.sin_port);
}

LineServer::~LineServer() {
  for (const Listener& listener : listeners_) ::close(listener.file);
  ::close(file_);
}

void LineServer::let_in() {
  while (true) {
    const int file = ::accept4(file_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (file < 0) return;
    if (listeners_.size() < kMostListeners) {
      listeners_.push_back({file, {}});
    } else {
      ::close(file);
    }
  }
}

void LineServer::tell(std::string_view line) {
  let_in();
  std::erase_if(listeners_, [&](Listener& listener) {
    bool here = send(listener);
    if (here && listener.unsent.empty()) {
      listener.unsent.append(line).push_back('\n');
      here = send(listener);
    }
    if (!here) ::close(listener.file);
    return !here;
  });
}

/// As much as there is room for; false if the listener has gone.
bool LineServer::send(Listener& listener) {
  while (!listener.unsent.empty()) {
    const ssize_t count = ::send(listener.file, listener.unsent.data(), listener.unsent.size(), MSG_NOSIGNAL);
    if (count < 0) return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
    listener.unsent.erase(0, static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace scrubjay
