#include "live_text.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

namespace scrubjay::apps {

void LiveText::show(const std::vector<std::string>& lines, bool now) {
  const auto clock = std::chrono::steady_clock::now();
  if (!now && clock - last_ < std::chrono::milliseconds(100)) return;
  pollfd terminal{file_, POLLOUT, 0};
  if (::poll(&terminal, 1, 0) != 1 || (terminal.revents & POLLOUT) == 0) return;
  last_ = clock;
  winsize size{};
  const bool known = ::ioctl(file_, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 && size.ws_row > 1;
  const std::size_t columns = known ? size.ws_col - 1U : 79U;
  const std::size_t count = std::min(lines.size(), known ? size.ws_row - 1U : lines.size());

  std::string text = drawn_ > 0 ? fmt::format("\r\033[{}A", drawn_) : "\r";
  for (std::size_t i = 0; i < count; ++i) text += lines[i].substr(0, columns) + "\033[K\r\n";
  text += "\033[J";
  // What a terminal doesn't take whole is drawn again next time.
  if (::write(file_, text.data(), text.size()) > 0) drawn_ = count;
}

}  // namespace scrubjay::apps
