#include "wire.hpp"

#include <fmt/format.h>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include <scrubjay/error.hpp>
#include <scrubjay/messages/rmw_dds_common.hpp>

namespace scrubjay::ros {
namespace {

/// Of others' `ros_discovery_info`, before we look at them.
constexpr int kMostWaitingInfos = 100;

}  // namespace

/// Hears what becomes of a writer.
class Wire::Offer final : public dds::DataWriterListener {
 public:
  Offer(Sink& sink, std::string topic, const Qos& qos) : sink_(sink), topic_(std::move(topic)), qos_(qos) {}

  void on_offered_incompatible_qos(dds::DataWriter*, const dds::OfferedIncompatibleQosStatus& status) override {
    sink_.tell(fmt::format("{}: a reader doesn't hear us, as it asks for another {}; we offer {}", topic_,
                           policy_name(status.last_policy_id), text_of(qos_)));
  }

 private:
  Sink& sink_;
  std::string topic_;
  Qos qos_;
};

/// Hears what a reader gets.
class Wire::Request final : public dds::DataReaderListener {
 public:
  Request(Sink& sink, std::string topic, const Qos& qos, std::function<void(std::span<const std::byte>)> receive)
      : sink_(sink), topic_(std::move(topic)), qos_(qos), receive_(std::move(receive)) {}

  void on_data_available(dds::DataReader* reader) override {
    bool valid = false;
    while (take_next(*reader, message_, valid)) {
      if (valid) receive_(message_);
    }
  }
  void on_requested_incompatible_qos(dds::DataReader*, const dds::RequestedIncompatibleQosStatus& status) override {
    sink_.tell(fmt::format("{}: we don't hear a writer, as it offers another {}; we ask for {}", topic_,
                           policy_name(status.last_policy_id), text_of(qos_)));
  }

 private:
  Sink& sink_;
  std::string topic_;
  Qos qos_;
  std::function<void(std::span<const std::byte>)> receive_;
  Bytes message_;  // of the last time: room for the next one. Fast DDS calls from one thread at a time
};

Wire::Wire(const ParticipantOptions& options, const std::string& node, Ears& ears)
    : ears_(ears),
      most_read_(options.most_read),
      gid_size_(gid_size(options.distribution)),
      discovery_(discovery_listener(ears.graph)),
      node_{.space = options.names.space(), .name = node} {
  FirstError error;
  participant_ = join_domain(options.domain, participant_qos(options), *discovery_);
  if (!participant_) {
    const std::string with = options.security ? " with the certificate " + options.security->certificate : "";
    throw Error(fmt::format("Fast DDS can't join domain {}{}: {}", options.domain, with, error.text()),
                Error::Kind::Failure);
  }
  guid_ = guid_of(*participant_);
  publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  subscriber_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  if (options.presence != Presence::Unseen) begin_discovery_info(options);
}

Wire::~Wire() = default;

bool Wire::can_have(const std::string& topic, const MessageType& type) const {
  const auto found = types_.find(dds_topic(topic));
  return found == types_.end() || found->second == dds_type_name(type.name);
}

dds::Topic* Wire::topic_for(const std::string& dds_name, const std::string& dds_type) {
  if (dds::TopicDescription* known = participant_->lookup_topicdescription(dds_name)) {
    return static_cast<dds::Topic*>(known);
  }
  if (!participant_->find_type(dds_type)) participant_->register_type(pass_through_type(dds_type, most_read_));
  dds::Topic* topic = participant_->create_topic(dds_name, dds_type, dds::TOPIC_QOS_DEFAULT);
  if (topic == nullptr) throw Error(fmt::format("Fast DDS can't make the topic {}", dds_name), Error::Kind::Failure);
  types_[dds_name] = dds_type;
  return topic;
}

dds::DataWriter* Wire::write(const std::string& topic, const MessageType& type, const Qos& qos) {
  dds::Topic* const described = topic_for(dds_topic(topic), dds_type_name(type.name));
  FirstError error;
  auto offer = std::make_unique<Offer>(ears_.sink, topic, qos);
  dds::DataWriter* writer = publisher_->create_datawriter(
      described, writer_qos(publisher_->get_default_datawriter_qos(), qos, type.hash), offer.get());
  if (writer == nullptr) {
    throw Error(fmt::format("Fast DDS can't write {}: {}", topic, error.text()), Error::Kind::Failure);
  }
  offers_.push_back(std::move(offer));
  node_.writers.push_back(guid_of(*writer));
  tell_discovery_info();
  return writer;
}

dds::DataReader* Wire::read(const std::string& topic, const MessageType& type, const Qos& qos,
                            std::function<void(std::span<const std::byte>)> receive) {
  dds::Topic* const described = topic_for(dds_topic(topic), dds_type_name(type.name));
  FirstError error;
  auto request = std::make_unique<Request>(ears_.sink, topic, qos, std::move(receive));
  dds::DataReader* reader = subscriber_->create_datareader(
      described, reader_qos(subscriber_->get_default_datareader_qos(), qos, type.hash), request.get());
  if (reader == nullptr) {
    throw Error(fmt::format("Fast DDS can't read {}: {}", topic, error.text()), Error::Kind::Failure);
  }
  requests_.push_back(std::move(request));
  node_.readers.push_back(guid_of(*reader));
  tell_discovery_info();
  return reader;
}

void Wire::begin_discovery_info(const ParticipantOptions& options) {
  constexpr std::string_view kType = ParticipantEntitiesInfo::kType;
  dds::Topic* topic = topic_for(kDiscoveryInfoTopic, dds_type_name(kType));
  // Humble tells no hashes, and its type has another one.
  const std::string_view hash =
      options.distribution == Distribution::Humble ? std::string_view() : ParticipantEntitiesInfo::kHash;
  FirstError error;
  if (options.presence == Presence::Node) {
    info_writer_ = publisher_->create_datawriter(
        topic, writer_qos(publisher_->get_default_datawriter_qos(), kLatched, hash), nullptr);
    if (info_writer_ == nullptr) {
      throw Error("Fast DDS can't write ros_discovery_info: " + error.text(), Error::Kind::Failure);
    }
  }
  const Qos all{Reliability::Reliable, Durability::TransientLocal, kMostWaitingInfos};
  requests_.push_back(std::make_unique<Request>(ears_.sink, kDiscoveryInfoTopic, all,
                                                [this](auto bytes) { hear_discovery_info(bytes); }));
  const dds::DataReader* reader = subscriber_->create_datareader(
      topic, reader_qos(subscriber_->get_default_datareader_qos(), all, hash), requests_.back().get());
  if (reader == nullptr) {
    throw Error("Fast DDS can't read ros_discovery_info: " + error.text(), Error::Kind::Failure);
  }
  tell_discovery_info();
}

void Wire::hear_discovery_info(std::span<const std::byte> bytes) {
  std::optional<DiscoveryInfo> info = decode_discovery_info(bytes, gid_size_);
  if (!info) {
    const std::size_t other =
        gid_size(gid_size_ == gid_size(Distribution::Humble) ? Distribution::Jazzy : Distribution::Humble);
    info = decode_discovery_info(bytes, other);
    ears_.sink.tell(info
                        ? fmt::format("somebody's ros_discovery_info has identifiers of {} bytes, ours has {}, so that "
                                      "their nodes and ours don't see one another (Humble has 24, what came after it "
                                      "16); ROS_DISTRO or --ros-distro tells whose to use",
                                      other, gid_size_)
                        : "somebody's ros_discovery_info can't be read");
    ++ears_.strange_infos;  // what is counted has been told
  }
  if (info) ears_.graph.set_nodes(std::move(*info));
}

void Wire::tell_discovery_info() {
  if (info_writer_ == nullptr) return;
  Bytes message = encode_discovery_info({.participant = guid_, .nodes = {node_}}, gid_size_);
  info_writer_->write(&message);
}

}  // namespace scrubjay::ros
