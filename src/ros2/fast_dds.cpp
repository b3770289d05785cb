#include "fast_dds.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <fmt/format.h>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>

#include <cstring>
#include <mutex>
#include <scrubjay/error.hpp>
#include <scrubjay/ros2/socket_buffers.hpp>

#include "fast_dds_shield.hpp"
#include "security_properties.hpp"
#include "user_data.hpp"

namespace scrubjay::ros {
namespace {

namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::Duration_t;

/// Participants of one host that are asked without multicast, as rmw_cyclonedds and rmw_fastrtps have it.
constexpr std::uint32_t kMostPerHost = 32;
constexpr const char* kLoopback = "127.0.0.1";
constexpr const char* kDiscoveryGroup = "239.255.0.1";  // RTPS 2.3, 9.6.1.4

class PassThroughType final : public dds::TopicDataType {
 public:
  PassThroughType(const std::string& name, std::size_t most) {
    m_typeSize = static_cast<std::uint32_t>(most);
    m_isGetKeyDefined = false;
    auto_fill_type_object(false);
    auto_fill_type_information(false);
    setName(name.c_str());
  }

  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    const Bytes& bytes = *static_cast<const Bytes*>(data);
    if (bytes.size() > payload->max_size) return false;
    std::memcpy(payload->data, bytes.data(), bytes.size());
    payload->length = static_cast<std::uint32_t>(bytes.size());
    payload->encapsulation = CDR_LE;
    return true;
  }
  bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
    const auto* first = reinterpret_cast<const std::byte*>(payload->data);
    static_cast<Bytes*>(data)->assign(first, first + payload->length);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return static_cast<std::uint32_t>(static_cast<const Bytes*>(data)->size()); };
  }
  void* createData() override { return new Bytes; }
  void deleteData(void* data) override { delete static_cast<Bytes*>(data); }
  bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

/// Once a process, before anything else: the user's profiles, and no ways around the wire.
void set_up() {
  static std::once_flag once;
  std::call_once(once, [] {
    dds::DomainParticipantFactory::get_instance()->load_profiles();
    // One way to others, whether they are in this process or not.
    eprosima::fastrtps::LibrarySettingsAttributes settings;
    settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
    eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
  });
}

rtps::Locator_t locator_of(const std::string& host) {
  rtps::Locator_t locator;
  const auto found = rtps::IPLocator::resolveNameDNS(host);
  if (found.first.empty()) {
    throw Error(fmt::format("the static peer {} isn't to be found; want a name or an address of IPv4", host));
  }
  rtps::IPLocator::setIPv4(locator, *found.first.begin());
  return locator;
}

bool is_loopback(const rtps::Locator_t& locator) {
  return rtps::IPLocator::isLocal(locator);
}

/// UDP, and shared memory if it is asked for. Nothing leaves this machine if `here_alone`.
void set_transports(dds::DomainParticipantQos& qos, bool shared_memory, bool here_alone) {
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->sendBufferSize = kSocketBuffer;
  udp->receiveBufferSize = kSocketBuffer;
  udp->maxInitialPeersRange = kMostPerHost;
  if (here_alone) udp->interfaceWhiteList.emplace_back(kLoopback);
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports = {shielded(std::move(udp))};
  if (shared_memory) {
    qos.transport().user_transports.push_back(
        std::make_shared<eprosima::fastdds::rtps::SharedMemTransportDescriptor>());
  }
}

void set_discovery(dds::DomainParticipantQos& qos, const ParticipantOptions& options,
                   const std::vector<rtps::Locator_t>& static_peers) {
  auto& builtin = qos.wire_protocol().builtin;
  const auto ask = [&](const rtps::Locator_t& peer) { builtin.initialPeersList.push_back(peer); };
  switch (options.discovery.range) {
    case DiscoveryRange::Off:
      builtin.discovery_config.discoveryProtocol = rtps::DiscoveryProtocol_t::NONE;
      return;
    case DiscoveryRange::SystemDefault:
      return;
    case DiscoveryRange::Localhost:
      ask(locator_of(kLoopback));
      if (options.distribution == Distribution::Humble) {
        // Its nodes look for one another by multicast through the loopback device.
        ask(locator_of(kDiscoveryGroup));
      } else {
        // Any port of unicast keeps Fast DDS from listening to multicast. It takes the next one that is free, among
        // those that peers ask; without this, it would count on from all participants that this process ever had.
        rtps::Locator_t first;
        first.port = qos.wire_protocol().port.getUnicastPort(static_cast<std::uint32_t>(options.domain), 0);
        builtin.metatrafficMulticastLocatorList.clear();
        builtin.metatrafficUnicastLocatorList.push_back(first);
      }
      break;
    case DiscoveryRange::Subnet:
      // Peers of our own come in place of the default one, which is the group.
      if (!static_peers.empty()) ask(locator_of(kDiscoveryGroup));
      break;
  }
  for (const rtps::Locator_t& peer : static_peers) ask(peer);
}

std::vector<rtps::octet> octets(const std::string& text) {
  return {text.begin(), text.end()};
}

template <class EndpointQos>
void set_common(EndpointQos& to, const Qos& qos, std::string_view hash) {
  to.reliability().kind =
      qos.reliability == Reliability::Reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  to.durability().kind =
      qos.durability == Durability::TransientLocal ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  to.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  to.history().depth = qos.depth;
  to.resource_limits().allocated_samples = 0;
  to.data_sharing().off();
  if (!hash.empty()) to.user_data().data_vec(octets(user_data("typehash", hash)));
}

}  // namespace

dds::TypeSupport pass_through_type(const std::string& dds_type_name, std::size_t most) {
  return dds::TypeSupport(new PassThroughType(dds_type_name, most));
}

dds::DomainParticipantQos participant_qos(const ParticipantOptions& options) {
  set_up();
  dds::DomainParticipantQos qos = dds::DomainParticipantFactory::get_instance()->get_default_participant_qos();
  const bool has_profile = !(qos == dds::PARTICIPANT_QOS_DEFAULT);
  std::vector<rtps::Locator_t> static_peers;
  for (const std::string& peer : options.discovery.static_peers) static_peers.push_back(locator_of(peer));
  const bool here_alone = options.discovery.range == DiscoveryRange::Off ||
                          (options.discovery.range == DiscoveryRange::Localhost &&
                           std::all_of(static_peers.begin(), static_peers.end(), is_loopback));
  // A profile's transports are the user's business, but not whether something leaves this machine.
  if (here_alone || qos.transport().user_transports.empty()) set_transports(qos, options.shared_memory, here_alone);
  set_discovery(qos, options, static_peers);
  auto& builtin = qos.wire_protocol().builtin;
  if (!has_profile) builtin.discovery_config.leaseDuration_announcementperiod = Duration_t(0, 500'000'000);
  builtin.readerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  builtin.writerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.name(options.enclave);
  qos.user_data().data_vec(octets(user_data("enclave", options.enclave)));
  if (options.security) {
    for (const auto& [name, value] : security_properties(*options.security)) {
      qos.properties().properties().emplace_back(name, value);
    }
  }
  return qos;
}

dds::DataWriterQos writer_qos(dds::DataWriterQos base, const Qos& qos, std::string_view hash) {
  set_common(base, qos, hash);
  // Memory of the messages' own sizes, used again.
  base.endpoint().history_memory_policy = rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  base.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
  base.representation().m_value = {dds::XCDR_DATA_REPRESENTATION};
  // Readers acknowledge what they have when they are asked, several times a second. What is latched is large and rare:
  // of that they are asked with each message, for nothing takes its place if a part was lost.
  base.reliable_writer_qos().disable_heartbeat_piggyback = qos.durability == Durability::Volatile;
  base.reliable_writer_qos().times.heartbeatPeriod = Duration_t(0, 200'000'000);
  return base;
}

dds::DataReaderQos reader_qos(dds::DataReaderQos base, const Qos& qos, std::string_view hash) {
  set_common(base, qos, hash);
  // What doesn't fit in the type's size isn't taken: nobody makes us reserve what they like.
  base.endpoint().history_memory_policy = rtps::PREALLOCATED_MEMORY_MODE;
  base.type_consistency().representation.m_value = {dds::XCDR_DATA_REPRESENTATION};
  return base;
}

DomainMember join_domain(int domain, const dds::DomainParticipantQos& qos, dds::DomainParticipantListener& listener) {
  return DomainMember(dds::DomainParticipantFactory::get_instance()->create_participant(
      static_cast<std::uint32_t>(domain), qos, &listener, dds::StatusMask::none()));
}

void LeaveDomain::operator()(dds::DomainParticipant* participant) const {
  participant->set_listener(nullptr);
  participant->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant);
}

bool write_message(dds::DataWriter& writer, const Bytes& message) {
  return writer.write(const_cast<Bytes*>(&message));  // which only our type reads
}

bool take_next(dds::DataReader& reader, Bytes& message, bool& valid) {
  dds::SampleInfo info;
  if (reader.take_next_sample(&message, &info) != ReturnCode_t::RETCODE_OK) return false;
  valid = info.valid_data;
  return true;
}

bool wait_for_acknowledgments(dds::DataWriter& writer, std::chrono::nanoseconds most) {
  const double seconds = std::max(0.0, std::chrono::duration<double>(most).count());
  return writer.wait_for_acknowledgments(Duration_t(static_cast<long double>(seconds))) == ReturnCode_t::RETCODE_OK;
}

std::string policy_name(dds::QosPolicyId_t policy) {
  switch (policy) {
    case dds::DURABILITY_QOS_POLICY_ID:
      return "durability";
    case dds::DEADLINE_QOS_POLICY_ID:
      return "deadline";
    case dds::LATENCYBUDGET_QOS_POLICY_ID:
      return "latency budget";
    case dds::OWNERSHIP_QOS_POLICY_ID:
      return "ownership";
    case dds::LIVELINESS_QOS_POLICY_ID:
      return "liveliness";
    case dds::PARTITION_QOS_POLICY_ID:
      return "partition";
    case dds::RELIABILITY_QOS_POLICY_ID:
      return "reliability";
    case dds::DATAREPRESENTATION_QOS_POLICY_ID:
      return "data representation";
    default:
      return fmt::format("policy {}", static_cast<int>(policy));
  }
}

}  // namespace scrubjay::ros
