/// \file
/// A transport that keeps from Fast DDS what it would fall over.
#pragma once

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include <memory>

namespace scrubjay::ros {

/// UDP as described, without submessages of eProsima's statistics: where Fast DDS is built with them and with its
/// assertions (Debian's 2.9.1), a damaged one ends the process.
std::shared_ptr<eprosima::fastdds::rtps::TransportDescriptorInterface> shielded(
    std::shared_ptr<eprosima::fastdds::rtps::UDPv4TransportDescriptor> udp);

}  // namespace scrubjay::ros
