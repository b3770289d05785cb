/// \file
/// A robot that does as a test tells it, and all that is published of it.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <scrubjay/mapping/growing_map.hpp>
#include <scrubjay/messages/publications.hpp>

namespace scrubjay::ros {

inline constexpr double kTick = 0.015;  // [s]

/// Keeps all that is published, by topic.
class KeptMessages final : public MessageSink {
 public:
  void publish(const TopicInfo& topic, std::int64_t nanoseconds, const std::shared_ptr<const Bytes>& bytes) override {
    stamps_[std::string(topic.name)].push_back(nanoseconds);
    bytes_[std::string(topic.name)].push_back(bytes);
  }
  template <Message M>
  std::vector<M> of(const Topic<M>& topic) const {
    std::vector<M> messages;
    const auto found = bytes_.find(std::string(topic.name));
    if (found == bytes_.end()) return messages;
    for (const auto& bytes : found->second) messages.push_back(decode<M>(*bytes).value());
    return messages;
  }
  const std::map<std::string, std::vector<std::int64_t>>& stamps() const { return stamps_; }
  void forget() {
    bytes_.clear();
    stamps_.clear();
  }

 private:
  std::map<std::string, std::vector<std::shared_ptr<const Bytes>>> bytes_;
  std::map<std::string, std::vector<std::int64_t>> stamps_;
};

/// A robot that does as it is told, tick by tick.
class PublicationsTest : public testing::Test {
 protected:
  PublicationsTest() : map_(0.05) {}

  void begin(const RobotModel& robot = {}, PublicationParams params = {}) {
    if (!params.epoch) params.epoch = 0;
    publications_.emplace(robot, std::move(params), std::vector<MessageSink*>{&kept_});
  }
  void tick() {
    frame_.stamp += kTick;
    const Decision decision{{}, doing_, false};
    publications_->notify({frame_, estimate_, std::as_const(map_).view(), decision, changed_, plan_, leftovers_});
    changed_ = {};
  }
  void ticks(int count) {
    for (int i = 0; i < count; ++i) tick();
  }
  /// Evidence at a place, in a map that grows to it.
  void mark(const Point2& place, LogOdds evidence) {
    map_.cover(place, 0.2);
    const CellIndex cell = map_.view().geometry.cell_at(place);
    map_.view()[cell] = evidence;
    changed_ = bounding(changed_, {cell, {cell.x + 1, cell.y + 1}});
  }

  /// The same evidence for all cells between two corners.
  void mark_floor(const Point2& low, const Point2& high, LogOdds evidence = -100) {
    for (double y = low.y() + 0.025; y < high.y(); y += 0.05) {
      for (double x = low.x() + 0.025; x < high.x(); x += 0.05) mark({x, y}, evidence);
    }
  }

  KeptMessages kept_;
  std::optional<Publications> publications_;
  Frame frame_;
  const char* doing_ = "looking";
  PoseEstimate estimate_;
  GrowingMap map_;
  CellRect changed_;
  std::vector<Point2> plan_;
  std::vector<Leftover> leftovers_;
};

}  // namespace scrubjay::ros
