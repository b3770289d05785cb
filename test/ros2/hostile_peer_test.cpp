/// \file
/// Peers that send what nobody should.
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/messages/nav_msgs.hpp>

#include "ros2/wire_fixture.hpp"

namespace scrubjay::ros {
namespace {

using HostilePeerTest = WireTest;

TEST_F(HostilePeerTest, AMessageThatIsTooLongIsNotTaken) {
  Participant robot(options());
  ParticipantOptions small = options();
  small.most_read = 1000;
  Participant listener(small);
  Inbox inbox;
  Writer& writer = robot.write("chatter", kTypeOf<String>);
  listener.read("chatter", kTypeOf<String>, {}, inbox.receive());
  ASSERT_TRUE(eventually([&] { return writer.readers() == 1; }));
  for (const std::size_t size : {2'000U, 200'000U, 2'000'000U}) writer.publish(text(std::string(size, 'x')));
  writer.publish(text("short"));
  ASSERT_TRUE(eventually([&] { return inbox.size() > 0; }));
  EXPECT_EQ(decode<String>(inbox.all()[0])->data, "short");
}

/// Bytes of a message, damaged: cut, with bits flipped, with a length that is too large, or nothing but noise.
Bytes damaged(Bytes message, Random& random) {
  switch (random.below(4)) {
    case 0:
      message.resize(random.below(static_cast<std::uint32_t>(message.size() + 1)));
      break;
    case 1:
      for (int i = 0; i < 8; ++i) {
        message[random.below(static_cast<std::uint32_t>(message.size()))] ^=
            static_cast<std::byte>(1U << random.below(8));
      }
      break;
    case 2:
      for (std::size_t i = 0; i < 4; ++i) message[4 * (1 + random.below(10)) + i] = std::byte{0xff};
      break;
    default:
      message.resize(random.below(300));
      for (std::byte& byte : message) byte = static_cast<std::byte>(random.below(256));
  }
  return message;
}

TEST_F(HostilePeerTest, TenThousandDamagedMessagesDoNoHarm) {
  std::atomic<int> came = 0;
  std::atomic<int> whole_ones = 0;
  Participant robot(options());
  Participant hostile(options());
  constexpr int kAtOnce = 99;
  const Qos deep{Reliability::Reliable, Durability::Volatile, kAtOnce + 1};
  Reader& reader = robot.read("path", kTypeOf<Path>, deep, [&](std::span<const std::byte> bytes) {
    const auto path = decode<Path>(bytes);
    if (path && path->header.frame_id == "whole") ++whole_ones;
    ++came;
  });
  Writer& writer = hostile.write("path", kTypeOf<Path>, deep);
  ASSERT_TRUE(eventually([&] { return writer.readers() == 1 && reader.writers() == 1; }));
  Random random(2026);
  Path path;
  path.header.frame_id = "whole";
  path.poses.resize(3);
  const Bytes whole = encode(path);
  path.header.frame_id = "map";
  const Bytes other = encode(path);
  // In batches that end in a whole one: DDS itself throws away some that are too short.
  for (int batch = 1; batch <= 10'000 / kAtOnce + 1; ++batch) {
    for (int i = 0; i < kAtOnce; ++i) writer.publish(damaged(other, random));
    writer.publish(whole);
    ASSERT_TRUE(eventually([&] { return whole_ones == batch; }));
  }
  EXPECT_GT(came, 9'000);
}

/// Sends a datagram to the ports of the first participants in a domain.
void send_datagram(int domain, const std::string& bytes) {
  const int file = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  for (int port = 7410 + 250 * domain; port < 7420 + 250 * domain; ++port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ::sendto(file, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&address), sizeof address);
  }
  ::close(file);
}

TEST_F(HostilePeerTest, DatagramsOfNoiseAndOnesThatEndFastDdsDoNoHarm) {
  Participant robot(options());
  Participant listener(options());
  Inbox inbox;
  Writer& writer = robot.write("chatter", kTypeOf<String>);
  Reader& reader = listener.read("chatter", kTypeOf<String>, {}, inbox.receive());
  ASSERT_TRUE(eventually([&] { return writer.readers() == 1 && reader.writers() == 1; }));
  const std::string header = std::string("RTPS\x02\x03\x01\x0f", 8) + std::string(12, 'x');
  // Statistics of eProsima's, which Fast DDS has at a message's end alone, and something behind them.
  send_datagram(domain_.number(),
                header + std::string("\x80\x01\x38\x00", 4) + std::string(56, 'x') + "\x01\x01\x04\x04");
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    std::string noise = i % 2 == 0 ? header : "";
    for (std::uint32_t n = random.below(200); n > 0; --n) noise += static_cast<char>(random.below(256));
    send_datagram(domain_.number(), noise);
  }
  writer.publish(text("still here"));
  EXPECT_TRUE(eventually([&] { return inbox.size() == 1; }));
}

}  // namespace
}  // namespace scrubjay::ros
