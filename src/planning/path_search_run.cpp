// The hot loop of the searches (test/bench/planning_bench.cpp: FindAcross, SpreadOverAll).
#include <algorithm>
#include <bit>
#include <cstring>
#include <scrubjay/planning/path_search.hpp>

#include "lattice.hpp"

namespace scrubjay {

using namespace lattice;

inline std::size_t PathSearch::index_of(const Entry& entry) const {
  return std::size_t{row(entry.place)} * static_cast<std::size_t>(costs_.geometry.width) + column(entry.place);
}

template <typename Estimate>
inline std::uint32_t PathSearch::bucket_of(const Estimate& estimate, const Entry& entry) const {
  return (entry.label + estimate(column(entry.place), row(entry.place))) >> Estimate::kBucketBits;
}

/// True if the cell and the eight around it cost the same. Away from the edge only; reads a byte past the last of them.
inline bool PathSearch::is_even(const Entry& entry) const {
  const TravelCost* cell = costs_.cells + index_of(entry);
  const std::int32_t width = costs_.geometry.width;
  const auto three = [](const TravelCost* first) {
    std::uint32_t four = 0;
    std::memcpy(&four, first, sizeof four);
    return std::endian::native == std::endian::little ? four & 0x00FFFFFFU : four >> 8;
  };
  const std::uint32_t wanted = *cell * 0x00010101U;
  return ((three(cell - 1) ^ wanted) | (three(cell - 1 - width) ^ wanted) | (three(cell - 1 + width) ^ wanted)) == 0;
}

/// Takes a step into account: `step` is what it costs, the direction leads to a passable cell.
template <typename Estimate>
inline void PathSearch::offer(const Estimate& estimate, const Entry& from, std::uint32_t direction,
                              std::uint32_t step) {
  const Entry entry{enter(from.place, direction), from.label + step};
  const std::size_t index = index_of(entry);
  if (entry.label >= label_at(index)) return;
  set_label(index, entry.label);
  buckets_[bucket_of(estimate, entry) % kBuckets].push_back(entry);
}

/// Goes on from a cell amidst cells of the same cost, as expand() would, and on from the next, ahead of their turn as
/// far as the horizon: most floor is open, and this is quicker than to queue its cells one by one.
template <typename Estimate>
void PathSearch::run_on(const Estimate& estimate, Entry entry, std::uint32_t cost) {
  const std::uint32_t direction = entry.place >> 28;
  const std::uint32_t step = step_length(direction) * cost;
  for (;;) {
    if (direction % 2 != 0) {
      run_on(estimate, {heading(entry.place, direction + 1), entry.label}, cost);
      run_on(estimate, {heading(entry.place, direction + 7), entry.label}, cost);
    }
    entry = {enter(entry.place, direction), entry.label + step};
    const std::size_t index = index_of(entry);
    if (entry.label >= label_at(index)) return;
    set_label(index, entry.label);
    ++settled_;
    const std::uint32_t bucket = bucket_of(estimate, entry);
    if (bucket > horizon_ || (entry.place & kCell) == goal_ || !is_inside(entry.place, costs_.geometry) ||
        !is_even(entry)) {
      buckets_[bucket % kBuckets].push_back(entry);
      return;
    }
  }
}

/// All steps out of a cell, which may lie at the map's edge.
template <typename Estimate>
void PathSearch::expand_all(const Estimate& estimate, const Entry& entry) {
  const CellIndex cell{static_cast<std::int32_t>(column(entry.place)), static_cast<std::int32_t>(row(entry.place))};
  for (int direction = 0; direction < 8; ++direction) {
    const std::uint32_t step = step_cost(costs_, cell, direction);
    if (step != 0) offer(estimate, entry, static_cast<std::uint32_t>(direction), step);
  }
}

/// The steps out of a cell inside of the map that may be part of a cheapest way: those are left out that the cell
/// before reaches for less without this cell. Where all cells around cost the same, those that it reaches for as much
/// are left out, too (of two equal ways, the one that is diagonal first is kept): that leaves the step straight on, and
/// the two beside it after a diagonal one (Carlson, Moghadam, Harabor, Stuckey, Ebendt, *Jump Point Search Pathfinding
/// in Weighted Grids*, 2023; Harabor, Grastien, *Online Graph Pruning for Pathfinding on Grid Maps*, 2011).
template <typename Estimate>
void PathSearch::expand(const Estimate& estimate, const Entry& entry) {
  const TravelCost* cell = costs_.cells + index_of(entry);
  const std::uint32_t here = *cell;
  if (is_even(entry)) {
    run_on(estimate, entry, kTwoCells + 2 * here);
    return;
  }
  const std::uint32_t ahead = entry.place >> 28;
  const auto cost = [&](std::uint32_t turn) -> std::uint32_t { return cell[offsets_[(ahead + turn) % 8]]; };
  const std::uint32_t front = cost(0);
  const std::uint32_t back = cost(4);
  if (ahead % 2 == 0) {
    if (front != kNoWay) offer(estimate, entry, ahead, kStraight * (kTwoCells + here + front));
    for (const std::uint32_t side : {1U, 7U}) {
      const std::uint32_t beside = cost(2 * side);
      if (beside == kNoWay) continue;
      // Diagonally from the cell before to the one beside, and on from there.
      const bool shortcut = cost(3 * side) != kNoWay;
      if (!(shortcut && 5 * (back + beside) < 7 * kTwoCells + 24 * here)) {
        offer(estimate, entry, (ahead + 2 * side) % 8, kStraight * (kTwoCells + here + beside));
      }
      const std::uint32_t corner = cost(side);
      if (front == kNoWay || corner == kNoWay) continue;
      if (shortcut && 5 * back + 29 * beside < 29 * here + 5 * corner) continue;
      offer(estimate, entry, (ahead + side) % 8, kDiagonal * (kTwoCells + here + corner));
    }
    return;
  }
  const bool open = cost(1) != kNoWay && cost(7) != kNoWay;
  if (open && front != kNoWay) offer(estimate, entry, ahead, kDiagonal * (kTwoCells + here + front));
  for (const std::uint32_t side : {1U, 7U}) {
    const std::uint32_t beside = cost(side);
    if (beside == kNoWay) continue;
    const std::uint32_t behind = cost(3 * side);  // passable: a diagonal step led here
    const std::uint32_t corner = cost(2 * side);
    if (!(corner != kNoWay && 29 * behind + 5 * beside < 29 * here + 5 * back)) {
      offer(estimate, entry, (ahead + side) % 8, kStraight * (kTwoCells + here + beside));
    }
    if (corner == kNoWay || 24 * behind < 10 * kTwoCells + 5 * back + 34 * here + 5 * corner) continue;
    offer(estimate, entry, (ahead + 2 * side) % 8, kDiagonal * (kTwoCells + here + corner));
  }
}

/// Empties the buckets in order. The label of the goal is final when nothing cheaper is left.
template <typename Estimate>
void PathSearch::run(const Estimate& estimate, std::span<const Seed> seeds) {
  static_assert((kBuckets - 1 - Estimate::kAhead) << Estimate::kBucketBits > 2 * kMaxStep);
  Label best = max_label_;
  std::size_t seed = 0;
  std::size_t empty = kBuckets;
  for (std::uint32_t bucket = 0;; ++bucket) {
    if (empty >= kBuckets) {
      if (seed == seeds.size()) break;
      bucket = std::max(bucket, seeds[seed].total >> Estimate::kBucketBits);
    }
    std::vector<Entry>& entries = buckets_[bucket % kBuckets];
    for (; seed < seeds.size() && seeds[seed].total >> Estimate::kBucketBits <= bucket; ++seed) {
      const Entry entry{place_of(seeds[seed].cell) | kFromNowhere << 28, seeds[seed].label};
      if (entry.label >= label_at(index_of(entry))) continue;
      set_label(index_of(entry), entry.label);
      entries.push_back(entry);
    }
    used_ = std::max(used_, static_cast<Label>((bucket + kBuckets) << Estimate::kBucketBits));
    if (bucket > best >> Estimate::kBucketBits) break;
    horizon_ = bucket + Estimate::kAhead;
    empty = entries.empty() ? empty + 1 : 0;
    while (!entries.empty()) {
      const Entry entry = entries.back();
      entries.pop_back();
      if (entry.label != label_at(index_of(entry)) || entry.label > best) continue;
      ++settled_;
      if ((entry.place & kCell) == goal_) {
        best = entry.label;
      } else if (entry.place >> 28 != kFromNowhere && is_inside(entry.place, costs_.geometry)) {
        expand(estimate, entry);
      } else {
        expand_all(estimate, entry);
      }
    }
  }
  for (auto& entries : buckets_) entries.clear();
}

template void PathSearch::run(const OctileDistance& estimate, std::span<const Seed> seeds);
template void PathSearch::run(const NoEstimate& estimate, std::span<const Seed> seeds);

}  // namespace scrubjay
