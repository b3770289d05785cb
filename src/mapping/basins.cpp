#include "basins.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace scrubjay {
namespace {

using CellId = std::uint32_t;

/// Cells from the widest floor to the narrowest, of equal clearance in the order of the grid.
class Levels {
 public:
  explicit Levels(GridView<const SquaredClearance> clearance) : begins_(std::size_t{1} << 16, 0) {
    const std::size_t size = clearance.geometry.size();
    for (std::size_t i = 0; i < size; ++i) ++begins_[clearance.cells[i]];
    CellId count = 0;
    for (std::size_t level = begins_.size(); level-- > 1;) {
      const CellId here = begins_[level];
      begins_[level] = count;
      count += here;
    }
    begins_[0] = count;
    cells_.resize(count);
    std::vector<CellId> next = begins_;
    for (std::size_t i = 0; i < size; ++i) {
      if (clearance.cells[i] != 0) cells_[next[clearance.cells[i]]++] = static_cast<CellId>(i);
    }
  }
  std::span<const CellId> at(SquaredClearance level) const {
    return std::span(cells_).subspan(begins_[level], begins_[level - 1U] - begins_[level]);
  }

 private:
  std::vector<CellId> begins_;
  std::vector<CellId> cells_;
};

class Flood {
 public:
  Flood(GridView<const SquaredClearance> clearance, std::span<const SquaredClearance> least_peaks)
      : clearance_(clearance), least_peaks_(least_peaks), labels_(clearance.geometry.size(), 0) {
    const auto width = static_cast<CellId>(clearance.geometry.width);
    beside_ = {CellId{0} - width, ~CellId{0}, 1, width};
  }

  std::vector<BasinLabel> run() {
    const Levels levels(clearance_);
    for (std::size_t level = 0xFFFF; level > 0; --level) {
      const std::span<const CellId> cells = levels.at(static_cast<SquaredClearance>(level));
      if (!cells.empty()) flood(cells, static_cast<SquaredClearance>(level));
    }
    return numbered();
  }

 private:
  /// Cells of a level become parts of the basins beside them, and those that have none, new ones.
  void flood(std::span<const CellId> cells, SquaredClearance level) {
    // All basins spread at once, a step at a time, so that they meet in the middle of what is level.
    for (const CellId cell : cells) {
      for (const CellId step : beside_) {
        if (labels_[cell + step] == 0 || clearance_.cells[cell + step] == level) continue;
        labels_[cell] = labels_[cell + step];
        queue_.push_back(cell);
        break;
      }
    }
    spread(level);
    for (const CellId cell : cells) {
      if (labels_[cell] != 0) continue;
      peaks_.push_back(level);
      parents_.push_back(static_cast<BasinLabel>(parents_.size()));
      labels_[cell] = parents_.back();
      queue_.push_back(cell);
      spread(level);
    }
    for (const CellId cell : cells) {
      for (const CellId step : beside_) {
        if (labels_[cell + step] != 0 && labels_[cell + step] != labels_[cell]) {
          meet(labels_[cell], labels_[cell + step], level);
        }
      }
    }
  }

  void spread(SquaredClearance level) {
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const CellId cell = queue_[i];
      for (const CellId step : beside_) {
        if (labels_[cell + step] != 0 || clearance_.cells[cell + step] != level) continue;
        labels_[cell + step] = labels_[cell];
        queue_.push_back(cell + step);
      }
    }
    queue_.clear();
  }

  /// Two basins beside each other, for the first time here where floor is as wide as `saddle` says: one, or two for
  /// ever, since saddles only get narrower from here on.
  void meet(BasinLabel a, BasinLabel b, SquaredClearance saddle) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    if (saddle < least_peaks_.size() && std::min(peaks_[a], peaks_[b]) >= least_peaks_[saddle]) return;
    parents_[std::max(a, b)] = std::min(a, b);
    peaks_[std::min(a, b)] = std::max(peaks_[a], peaks_[b]);
  }

  BasinLabel root(BasinLabel label) {
    while (parents_[label] != label) {
      parents_[label] = parents_[parents_[label]];
      label = parents_[label];
    }
    return label;
  }

  /// Basins by the order of their first cells.
  std::vector<BasinLabel> numbered() {
    std::vector<BasinLabel> numbers(parents_.size(), 0);
    BasinLabel last = 0;
    for (BasinLabel& label : labels_) {
      if (label == 0) continue;
      BasinLabel& number = numbers[root(label)];
      if (number == 0) number = ++last;
      label = number;
    }
    return std::move(labels_);
  }

  GridView<const SquaredClearance> clearance_;
  std::span<const SquaredClearance> least_peaks_;
  std::array<CellId, 4> beside_{};
  std::vector<BasinLabel> labels_;
  std::vector<BasinLabel> parents_{0};
  std::vector<SquaredClearance> peaks_{0};
  std::vector<CellId> queue_;
};

}  // namespace

std::vector<BasinLabel> flood_basins(GridView<const SquaredClearance> clearance,
                                     std::span<const SquaredClearance> least_peaks) {
  return Flood(clearance, least_peaks).run();
}

}  // namespace scrubjay
