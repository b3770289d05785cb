#include <algorithm>
#include <scrubjay/robot/command_echo.hpp>

namespace scrubjay {

void CommandEcho::tell(int left, int right, double stamp) {
  if (count_ > 0) {
    const Told& last = told_[(count_ - 1) % told_.size()];
    if (last.left == left && last.right == right) return;
  }
  told_[count_++ % told_.size()] = {left, right, stamp};
}

bool CommandEcho::is_deaf(int left, int right, double stamp) {
  double until = stamp;  // when the one looked at was replaced
  for (std::size_t back = 1; back <= std::min(count_, told_.size()); ++back) {
    const Told& told = told_[(count_ - back) % told_.size()];
    if (back > 1 && stamp - until >= kDelay) break;
    if (told.left == left && told.right == right) {
      echoes_ = echoes_ || left != 0 || right != 0;
      return false;
    }
    until = told.since;
  }
  // The newest may be on its way yet.
  if (!echoes_ || stamp - until < kDelay || stamp - said_ < kDelay) return false;
  said_ = stamp;
  return true;
}

}  // namespace scrubjay
