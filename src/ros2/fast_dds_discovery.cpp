#include <fastdds/rtps/builtin/data/ParticipantProxyData.h>
#include <fastdds/rtps/builtin/data/ReaderProxyData.h>
#include <fastdds/rtps/builtin/data/WriterProxyData.h>
#include <fastrtps/utils/IPLocator.h>

#include "fast_dds.hpp"
#include "user_data.hpp"
#include "vendor.hpp"

namespace scrubjay::ros {
namespace {

namespace rtps = eprosima::fastrtps::rtps;

std::string text_of(const dds::UserDataQosPolicy& data) {
  return {data.data_vec().begin(), data.data_vec().end()};
}

template <class Proxy>
Endpoint endpoint_from(const Proxy& data, bool writes) {
  const std::string topic = data.topicName().to_string();
  Endpoint endpoint{.writes = writes,
                    .topic = topic_of_dds(topic).value_or(topic),
                    .type = ros_type_name(data.typeName().to_string())};
  endpoint.hash = value_in(text_of(data.m_qos.m_userData), "typehash");
  endpoint.qos.reliability =
      data.m_qos.m_reliability.kind == dds::RELIABLE_RELIABILITY_QOS ? Reliability::Reliable : Reliability::BestEffort;
  endpoint.qos.durability =
      data.m_qos.m_durability.kind == dds::VOLATILE_DURABILITY_QOS ? Durability::Volatile : Durability::TransientLocal;
  endpoint.qos.depth = 0;
  return endpoint;
}

Guid guid_from(const rtps::GUID_t& guid) {
  Guid bytes{};
  std::copy(std::begin(guid.guidPrefix.value), std::end(guid.guidPrefix.value), bytes.begin());
  std::copy(std::begin(guid.entityId.value), std::end(guid.entityId.value), bytes.begin() + 12);
  return bytes;
}

Peer peer_from(const rtps::ParticipantProxyData& data) {
  Peer peer{.name = data.m_participantName.to_string(), .vendor = vendor_name(data.m_VendorId[0], data.m_VendorId[1])};
  peer.enclave = value_in(text_of(data.m_userData), "enclave");
  for (const rtps::Locator_t& locator : data.default_locators.unicast) {
    if (locator.kind != LOCATOR_KIND_UDPv4) continue;
    peer.address = rtps::IPLocator::toIPv4string(locator);
    break;
  }
  return peer;
}

/// Hears of others.
class Announcements final : public dds::DomainParticipantListener {
 public:
  explicit Announcements(Graph& graph) : graph_(graph) {}

  void on_participant_discovery(dds::DomainParticipant*, rtps::ParticipantDiscoveryInfo&& told) override {
    using Told = rtps::ParticipantDiscoveryInfo;
    const bool here = told.status == Told::DISCOVERED_PARTICIPANT || told.status == Told::CHANGED_QOS_PARTICIPANT;
    if (here) {
      graph_.set_participant(guid_from(told.info.m_guid), peer_from(told.info));
    } else {
      graph_.remove_participant(guid_from(told.info.m_guid));
    }
  }
  void on_subscriber_discovery(dds::DomainParticipant*, rtps::ReaderDiscoveryInfo&& told) override {
    set(told.info, false, told.status != rtps::ReaderDiscoveryInfo::REMOVED_READER);
  }
  void on_publisher_discovery(dds::DomainParticipant*, rtps::WriterDiscoveryInfo&& told) override {
    set(told.info, true, told.status != rtps::WriterDiscoveryInfo::REMOVED_WRITER);
  }

 private:
  template <class Proxy>
  void set(const Proxy& data, bool writes, bool here) {
    if (here) {
      graph_.set_endpoint(guid_from(data.guid()), endpoint_from(data, writes));
    } else {
      graph_.remove_endpoint(guid_from(data.guid()));
    }
  }

  Graph& graph_;
};

}  // namespace

std::unique_ptr<dds::DomainParticipantListener> discovery_listener(Graph& graph) {
  return std::make_unique<Announcements>(graph);
}

Guid guid_of(const dds::DataReader& reader) {
  return guid_from(reader.guid());
}

Guid guid_of(const dds::DataWriter& writer) {
  return guid_from(writer.guid());
}

Guid guid_of(const dds::DomainParticipant& participant) {
  return guid_from(participant.guid());
}

}  // namespace scrubjay::ros
