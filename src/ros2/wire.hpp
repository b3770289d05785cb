/// \file
/// One participant of DDS, with one type to each topic.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "discovery_info.hpp"
#include "fast_dds.hpp"
#include "fast_dds_log.hpp"
#include "graph.hpp"
#include "sink.hpp"

namespace scrubjay::ros {

/// What the listeners of a participant tell, and to whom.
struct Ears {
  Graph graph{};
  Sink sink;
  LogEar log{[this](const std::string& message) { sink.tell(std::string(kFromFastDds) + message); }};
  std::atomic<std::uint64_t> strange_infos{0};
};

/// The one node that it tells of has all of its endpoints. Not to be called from two threads at a time.
class Wire {
 public:
  /// Throws Error if the domain isn't to be joined. `ears` outlives it.
  Wire(const ParticipantOptions& options, const std::string& node, Ears& ears);
  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;
  ~Wire();  // out of line, where its listeners are known

  /// Whether a topic of this name can have this type: DDS knows one type to a topic.
  bool can_have(const std::string& topic, const MessageType& type) const;
  /// Throw Error if DDS doesn't. `topic`: full name.
  dds::DataWriter* write(const std::string& topic, const MessageType& type, const Qos& qos);
  dds::DataReader* read(const std::string& topic, const MessageType& type, const Qos& qos,
                        std::function<void(std::span<const std::byte>)> receive);
  const Guid& guid() const { return guid_; }

 private:
  class Offer;
  class Request;

  void begin_discovery_info(const ParticipantOptions& options);
  void tell_discovery_info();
  void hear_discovery_info(std::span<const std::byte> bytes);
  dds::Topic* topic_for(const std::string& dds_name, const std::string& dds_type);

  Ears& ears_;
  std::size_t most_read_;
  std::size_t gid_size_;
  std::unique_ptr<dds::DomainParticipantListener> discovery_;
  std::vector<std::unique_ptr<Offer>> offers_;
  std::vector<std::unique_ptr<Request>> requests_;
  DomainMember participant_;  // behind all that its threads use
  dds::Publisher* publisher_ = nullptr;
  dds::Subscriber* subscriber_ = nullptr;
  dds::DataWriter* info_writer_ = nullptr;
  Guid guid_{};
  NodeInfo node_;
  std::map<std::string, std::string> types_;  ///< of a topic, by their names in DDS
};

}  // namespace scrubjay::ros
