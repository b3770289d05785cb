#include <algorithm>
#include <array>
#include <scrubjay/exploration/frontier_piece.hpp>

namespace scrubjay {
namespace {

std::int64_t squared_distance(CellIndex a, CellIndex b) {
  const std::int64_t x = a.x - b.x;
  const std::int64_t y = a.y - b.y;
  return x * x + y * y;
}

CellIndex middle_of(const std::vector<CellIndex>& cells) {
  std::int64_t x = 0, y = 0;
  for (const CellIndex c : cells) {
    x += c.x;
    y += c.y;
  }
  const auto count = static_cast<std::int64_t>(cells.size());
  const CellIndex mean{static_cast<std::int32_t>(x / count), static_cast<std::int32_t>(y / count)};
  // Among equally near ones the lowest: the cells' order is that of the updates.
  return *std::min_element(cells.begin(), cells.end(), [&](CellIndex a, CellIndex b) {
    const std::int64_t da = squared_distance(a, mean);
    const std::int64_t db = squared_distance(b, mean);
    return da != db ? da < db : a.y != b.y ? a.y < b.y : a.x < b.x;
  });
}

}  // namespace

std::vector<FrontierPiece> cut(const Frontier& frontier, std::int32_t reach) {
  std::vector<FrontierPiece> pieces;
  const std::int64_t squared_reach = std::int64_t{reach} * reach;
  for (const CellIndex cell : frontier.cells) {
    const auto near = std::find_if(pieces.begin(), pieces.end(), [&](const FrontierPiece& piece) {
      return squared_distance(piece.cells.front(), cell) <= squared_reach;
    });
    if (near != pieces.end()) {
      near->cells.push_back(cell);
    } else {
      pieces.push_back({{cell}, cell});
    }
  }
  for (FrontierPiece& piece : pieces) piece.middle = middle_of(piece.cells);
  return pieces;
}

bool borders_on_unknown(GridView<const LogOdds> map, const FrontierPiece& piece, std::size_t enough) {
  constexpr std::array<CellIndex, 4> kBeside{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
  std::vector<CellIndex> found;
  bool beyond = false;  // the map's border: there is no end to it
  const auto look_around = [&](CellIndex cell) {
    for (const CellIndex step : kBeside) {
      const CellIndex next{cell.x + step.x, cell.y + step.y};
      beyond = beyond || !map.contains(next);
      if (beyond) return;
      // What leans to occupied is a wall half seen.
      const bool open = map[next] > kFreeLogOdds && map[next] <= 0;
      if (open && std::find(found.begin(), found.end(), next) == found.end()) found.push_back(next);
    }
  };
  for (const CellIndex cell : piece.cells) {
    look_around(cell);
    if (beyond || found.size() >= enough) return true;
  }
  for (std::size_t next = 0; next < found.size(); ++next) {
    look_around(found[next]);
    if (beyond || found.size() >= enough) return true;
  }
  return false;
}

}  // namespace scrubjay
