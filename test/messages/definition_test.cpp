#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <scrubjay/messages/create_msgs.hpp>
#include <scrubjay/messages/geometry_msgs.hpp>
#include <scrubjay/messages/message_type.hpp>
#include <scrubjay/messages/nav_msgs.hpp>
#include <scrubjay/messages/rmw_dds_common.hpp>
#include <scrubjay/messages/visualization_msgs.hpp>

namespace scrubjay::ros {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr std::string_view kRule = "================================================================================\n";

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(DefinitionTest, NamesItsFieldsAndThenTheTypesThatTheyAreOf) {
  EXPECT_EQ(definition<Mode>(),
            "uint8 MODE_OFF=0\nuint8 MODE_PASSIVE=1\nuint8 MODE_SAFE=2\nuint8 MODE_FULL=3\n"
            "std_msgs/Header header\nuint8 mode\n" +
                std::string(kRule) + "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" +
                std::string(kRule) + "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n");
}

TEST(DefinitionTest, WritesArraysSequencesAndBounds) {
  EXPECT_THAT(definition<PoseWithCovariance>(), HasSubstr("float64[36] covariance\n"));
  EXPECT_THAT(definition<Path>(), HasSubstr("geometry_msgs/PoseStamped[] poses\n"));
  EXPECT_THAT(definition<NodeEntitiesInfo>(), StartsWith("string<=256 node_namespace\n"));
}

TEST(DefinitionTest, DefinesEachTypeOnce) {
  const std::string text = definition<MarkerArray>();
  EXPECT_EQ(count(text, "MSG: std_msgs/Header\n"), 1u);
  EXPECT_EQ(count(text, "MSG: geometry_msgs/Point\n"), 1u);
  EXPECT_EQ(count(text, kRule), count(text, "MSG: "));
}

TEST(DefinitionTest, IsEmptyForWhatHasNoField) {
  EXPECT_EQ(definition<Empty>(), "");
}

TEST(MessageTypeTest, IsNamedAsOverDds) {
  EXPECT_EQ(dds_type_name("nav_msgs/msg/OccupancyGrid"), "nav_msgs::msg::dds_::OccupancyGrid_");
}

TEST(MessageTypeTest, HasNameHashAndDefinition) {
  EXPECT_EQ(kTypeOf<Path>.name, "nav_msgs/msg/Path");
  EXPECT_EQ(kTypeOf<Path>.hash, Path::kHash);
  EXPECT_EQ(kTypeOf<Path>.definition(), definition<Path>());
}

}  // namespace
}  // namespace scrubjay::ros
