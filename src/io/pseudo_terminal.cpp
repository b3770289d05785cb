#include <fcntl.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <scrubjay/error.hpp>
#include <scrubjay/io/pseudo_terminal.hpp>
#include <utility>

namespace scrubjay {
namespace {

namespace fs = std::filesystem;

/// Throws Error unless `link` is one that somebody has left behind: to nowhere, since a pseudo-terminal goes with the
/// program that opened it, or to `ours`, whose number was that one's before.
void expect_stale(const fs::path& link, const fs::path& ours) {
  std::error_code error;
  const bool is_link = fs::is_symlink(fs::symlink_status(link, error));
  if (is_link && !fs::exists(link, error)) return;
  const fs::path led_to = is_link ? fs::read_symlink(link, error) : fs::path();
  if (led_to == ours) return;
  if (led_to.parent_path() == "/dev/pts") {
    throw Error(fmt::format("{}: leads to {}, which is in use; want another name, or remove the link if it is old",
                            link.string(), led_to.string()));
  }
  throw Error(fmt::format("{}: is there already and no link to a pseudo-terminal; want another name or remove it",
                          link.string()));
}

/// There whole or not at all, and never in the place of anything but a stale link.
void make_link(const fs::path& link, const fs::path& target) {
  const auto fail = [&](int reason) {
    throw Error(
        fmt::format("{}: cannot make the link to {}: {}", link.string(), target.string(), std::strerror(reason)));
  };
  if (::symlink(target.c_str(), link.c_str()) == 0) return;
  if (errno != EEXIST) fail(errno);
  expect_stale(link, target);
  fs::path fresh = link;
  fresh += fmt::format(".{}~", ::getpid());
  ::unlink(fresh.c_str());  // left by a process of that number that was killed
  if (::symlink(target.c_str(), fresh.c_str()) != 0) fail(errno);
  if (::rename(fresh.c_str(), link.c_str()) != 0) {
    const int reason = errno;
    ::unlink(fresh.c_str());
    fail(reason);
  }
}

}  // namespace

PseudoTerminal::PseudoTerminal(const fs::path& link) : link_(fs::absolute(link)) {
  try {
    open_pair();
    make_link(link_, device_);
  } catch (...) {
    close_pair();
    throw;
  }
}

PseudoTerminal::~PseudoTerminal() {
  std::error_code error;
  // Before the pair is closed: nobody else can have this number yet, so a link to it is ours.
  if (fs::read_symlink(link_, error) == device_) ::unlink(link_.c_str());
  close_pair();
}

void PseudoTerminal::open_pair() {
  const auto fail = [] {
    throw Error(fmt::format("cannot open a pseudo-terminal: {}", std::strerror(errno)), Error::Kind::Failure);
  };
  device_file_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  std::array<char, 128> name{};
  if (device_file_ < 0 || ::grantpt(device_file_) != 0 || ::unlockpt(device_file_) != 0) fail();
  if (const int reason = ::ptsname_r(device_file_, name.data(), name.size()); reason != 0) errno = reason, fail();
  device_ = name.data();
  client_file_ = ::open(name.data(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (client_file_ < 0) fail();
  keep_raw();
}

void PseudoTerminal::close_pair() {
  if (client_file_ >= 0) ::close(client_file_);
  if (device_file_ >= 0) ::close(device_file_);
}

/// The settings are those of the pair, not of a client: one that left them cooked would have the echo of what is
/// written here arrive as commands.
void PseudoTerminal::keep_raw() {
  // A client that was killed leaves the pair exclusive as long as anybody, like us, has it open.
  ::ioctl(client_file_, TIOCNXCL);
  termios now{};
  if (::tcgetattr(client_file_, &now) != 0) return;
  termios raw = now;
  ::cfmakeraw(&raw);
  // How a client wants to wait is its own business.
  std::memcpy(raw.c_cc, now.c_cc, sizeof now.c_cc);
  const bool is_raw = raw.c_iflag == now.c_iflag && raw.c_oflag == now.c_oflag && raw.c_lflag == now.c_lflag &&
                      raw.c_cflag == now.c_cflag;
  if (!is_raw) ::tcsetattr(client_file_, TCSANOW, &raw);
}

ByteRead PseudoTerminal::read(std::span<std::uint8_t> buffer) {
  keep_raw();
  const ssize_t count = ::read(device_file_, buffer.data(), buffer.size());
  return {.count = count > 0 ? static_cast<std::size_t>(count) : 0, .stamp = 0.0, .open = true};
}

bool PseudoTerminal::write(std::span<const std::uint8_t> bytes) {
  keep_raw();
  int unread = 0;
  if (::ioctl(client_file_, FIONREAD, &unread) == 0 && static_cast<std::size_t>(unread) + bytes.size() > kBacklog) {
    drop_unread();
  }
  for (bool tried_again = false; !bytes.empty();) {
    const ssize_t written = ::write(device_file_, bytes.data(), bytes.size());
    if (written > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      drop_unread();
      if (std::exchange(tried_again, true)) break;
    }
  }
  dropped_ += bytes.size();
  return true;
}

/// Both what the terminal holds for clients and what is still on its way there.
void PseudoTerminal::drop_unread() {
  int unread = 0;
  ::ioctl(client_file_, FIONREAD, &unread);
  ::tcflush(device_file_, TCOFLUSH);
  ::tcflush(client_file_, TCIFLUSH);
  dropped_ += static_cast<std::uint64_t>(unread);
}

}  // namespace scrubjay
