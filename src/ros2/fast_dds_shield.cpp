#include "fast_dds_shield.hpp"

#include <fastdds/rtps/network/SenderResource.h>
#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/TransportReceiverInterface.h>

#include "rtps_message.hpp"

namespace scrubjay::ros {
namespace {

namespace transport = eprosima::fastdds::rtps;
namespace rtps = eprosima::fastrtps::rtps;

class Shield final : public transport::ChainingTransport {
 public:
  explicit Shield(const transport::ChainingTransportDescriptor& descriptor);

  transport::TransportDescriptorInterface* get_configuration() override { return descriptor_.get(); }
  bool send(rtps::SenderResource* sender, const rtps::octet* bytes, std::uint32_t size, rtps::LocatorsIterator* first,
            rtps::LocatorsIterator* last, const std::chrono::steady_clock::time_point& timeout) override {
    return sender->send(bytes, size, first, last, timeout);
  }
  void receive(transport::TransportReceiverInterface* receiver, const rtps::octet* bytes, std::uint32_t size,
               const rtps::Locator_t& local, const rtps::Locator_t& remote) override {
    const auto standard = static_cast<std::uint32_t>(length_of_standard_part({bytes, size}));
    if (standard > 0) receiver->OnDataReceived(bytes, standard, local, remote);
  }

 private:
  std::unique_ptr<transport::TransportDescriptorInterface> descriptor_;
};

struct ShieldDescriptor final : transport::ChainingTransportDescriptor {
  using ChainingTransportDescriptor::ChainingTransportDescriptor;
  transport::TransportInterface* create_transport() const override { return new Shield(*this); }
};

Shield::Shield(const transport::ChainingTransportDescriptor& descriptor)
    : ChainingTransport(descriptor), descriptor_(std::make_unique<ShieldDescriptor>(descriptor.low_level_descriptor)) {}

}  // namespace

std::shared_ptr<transport::TransportDescriptorInterface> shielded(
    std::shared_ptr<transport::UDPv4TransportDescriptor> udp) {
  return std::make_shared<ShieldDescriptor>(std::move(udp));
}

}  // namespace scrubjay::ros
