/// \file
/// All of Fast DDS that is another one in another of its versions is behind this header, and in no other file than
/// fast_dds*.cpp. This is 2.x (from 2.9); 3.x has other names for the package, its headers and namespaces, a type whose
/// methods take references, listeners with other announcements, and `FASTDDS_DEFAULT_PROFILES_FILE`.
#pragma once

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <scrubjay/messages/cdr.hpp>
#include <scrubjay/ros2/participant.hpp>
#include <string>

#include "graph.hpp"
#include "guid.hpp"

namespace scrubjay::ros {

namespace dds = eprosima::fastdds::dds;

/// A type whose messages are `Bytes`, passed through as they are. `most` bounds what a reader takes [bytes].
dds::TypeSupport pass_through_type(const std::string& dds_type_name, std::size_t most);

/// What a participant is made with: the user's profile (`FASTRTPS_DEFAULT_PROFILES_FILE`), if there is one, and over it
/// what the options say. Throws Error about a static peer that isn't to be found.
dds::DomainParticipantQos participant_qos(const ParticipantOptions& options);
/// `base` with what we offer or ask for. `hash`: of the type; empty if it isn't to be told.
dds::DataWriterQos writer_qos(dds::DataWriterQos base, const Qos& qos, std::string_view hash);
dds::DataReaderQos reader_qos(dds::DataReaderQos base, const Qos& qos, std::string_view hash);

struct LeaveDomain {
  void operator()(dds::DomainParticipant* participant) const;
};
using DomainMember = std::unique_ptr<dds::DomainParticipant, LeaveDomain>;

/// None if Fast DDS doesn't let it. `listener` outlives it.
DomainMember join_domain(int domain, const dds::DomainParticipantQos& qos, dds::DomainParticipantListener& listener);

/// Whether all matched reliable readers have everything, within this time.
bool wait_for_acknowledgments(dds::DataWriter& writer, std::chrono::nanoseconds most);

/// Tells the graph of others; it outlives the listener.
std::unique_ptr<dds::DomainParticipantListener> discovery_listener(Graph& graph);

/// False if DDS didn't take it.
bool write_message(dds::DataWriter& writer, const Bytes& message);
/// False if there is no message. One without bytes, such as that a writer has gone, isn't `valid`.
bool take_next(dds::DataReader& reader, Bytes& message, bool& valid);

Guid guid_of(const dds::DataReader& reader);
Guid guid_of(const dds::DataWriter& writer);
Guid guid_of(const dds::DomainParticipant& participant);

std::string policy_name(dds::QosPolicyId_t policy);

}  // namespace scrubjay::ros
