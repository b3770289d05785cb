#include <gtest/gtest.h>

#include <scrubjay/exploration/frontier_piece.hpp>
#include <string>

namespace scrubjay {
namespace {

// A map from rows of text, the highest first: '.' free, '#' occupied, '?' unknown but rather occupied, ' ' unknown.
struct CutMap {
  explicit CutMap(const std::vector<std::string>& rows) {
    geometry.width = static_cast<std::int32_t>(rows.front().size());
    geometry.height = static_cast<std::int32_t>(rows.size());
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
      for (const char c : *row) cells.push_back(c == '.' ? -50 : c == '#' ? 50 : c == '?' ? 5 : 0);
    }
    frontiers.update(view(), cells_of(geometry));
  }
  GridView<const LogOdds> view() const { return {geometry, cells.data()}; }
  FrontierPiece whole() const { return cut(frontiers.frontiers().front(), 1000).front(); }

  GridGeometry geometry;
  std::vector<LogOdds> cells;
  FrontierMap frontiers;
};

TEST(FrontierPieceTest, PiecesHoldAllCellsOnceAndAreNoLongerThanAsked) {
  const CutMap map(std::vector<std::string>(40, std::string(40, '.')));  // the frontier runs around the border
  const Frontier& frontier = map.frontiers.frontiers().front();
  std::size_t count = 0;
  for (const FrontierPiece& piece : cut(frontier, 10)) {
    count += piece.cells.size();
    for (const CellIndex a : piece.cells) {
      EXPECT_LE(std::abs(a.x - piece.cells.front().x), 10);
      EXPECT_LE(std::abs(a.y - piece.cells.front().y), 10);
    }
    EXPECT_NE(std::find(piece.cells.begin(), piece.cells.end(), piece.middle), piece.cells.end());
  }
  EXPECT_EQ(count, frontier.cells.size());
}

TEST(FrontierPieceTest, ItsMiddleIsInTheMiddle) {
  const CutMap map({
      "#         #",  //
      "#.........#",  //
      "###########",  //
  });
  EXPECT_EQ(map.whole().middle, (CellIndex{5, 1}));
}

TEST(FrontierPieceTest, CountsTheUnknownCellsBehindIt) {
  const CutMap map({
      "#######",  //
      "#..#  #",  //
      "#..   #",  //
      "#..#  #",  //
      "#######",  //
  });
  EXPECT_TRUE(borders_on_unknown(map.view(), map.whole(), 7));
  EXPECT_FALSE(borders_on_unknown(map.view(), map.whole(), 8));
}

TEST(FrontierPieceTest, WhatIsRatherOccupiedHidesTheUnknownBehind) {
  const CutMap map({
      "#######",  //
      "#..?  #",  //
      "#..?  #",  //
      "#..?  #",  //
      "#######",  //
  });
  EXPECT_FALSE(borders_on_unknown(map.view(), map.whole(), 1));
}

TEST(FrontierPieceTest, BeyondTheMapTheUnknownIsEndless) {
  const CutMap map({
      "###",  //
      "#..",  //
      "###",  //
  });
  EXPECT_TRUE(borders_on_unknown(map.view(), map.whole(), 1000000));
}

}  // namespace
}  // namespace scrubjay
