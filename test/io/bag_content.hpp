/// \file
/// What tests write into bags, and what they find there.
#pragma once

#include <cstddef>
#include <scrubjay/io/bag.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sqlite_file.hpp"

namespace scrubjay {

inline const BagTopic kMapTopic{"/map", "nav_msgs/msg/OccupancyGrid", "int8[] data\n", "RIHS01_8d34", ros::kLatched};
inline const BagTopic kScanTopic{"/scan",
                                 "sensor_msgs/msg/LaserScan",
                                 "float32 angle_min\n",
                                 "RIHS01_64c1",
                                 {ros::Reliability::BestEffort, ros::Durability::Volatile, 5}};

inline std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text));
}

struct BagContent {
  std::vector<BagTopic> topics;
  std::vector<std::string> messages;  ///< topic, nanoseconds and bytes of each
  bool cut = false;
};

inline BagContent content_of_bag(const std::filesystem::path& path) {
  const std::unique_ptr<BagReader> reader = open_bag(path);
  BagContent content;
  while (const auto message = reader->next()) {
    const std::string bytes(reinterpret_cast<const char*>(message->bytes.data()), message->bytes.size());
    content.messages.push_back(reader->topics()[message->topic].name + " " + std::to_string(message->nanoseconds) +
                               " " + bytes);
  }
  content.topics = reader->topics();
  content.cut = reader->cut();
  return content;
}

}  // namespace scrubjay
