#include <gtest/gtest.h>

#include <io/packed.hpp>
#include <io/temporary_folder.hpp>
#include <scrubjay/error.hpp>
#include <scrubjay/io/relations_file.hpp>

namespace scrubjay {
namespace {

const char* const kRelations =
    "# t1 t2 x y z roll pitch yaw\n10.5 11.25 0.4 -0.1 9 9 9 -0.07\n11.25 10.5 1 2 0 0 0 4\n";

void expect_both(const std::vector<Relation>& relations) {
  ASSERT_EQ(relations.size(), 2u);
  EXPECT_EQ(relations[0].from, 10.5);
  EXPECT_EQ(relations[0].to, 11.25);
  EXPECT_EQ(relations[0].motion, (Pose2{0.4, -0.1, -0.07}));
  EXPECT_EQ(relations[1].motion, (Pose2{1.0, 2.0, wrap_angle(4.0)}));
}

TEST(RelationsFileTest, ReadsTimesAndTheMotionInThePlane) {
  expect_both(parse_relations(unpacked(kRelations), "a.relations"));
  expect_both(parse_relations(packed(kRelations), "a.relations.gz"));
  const TemporaryFolder folder;
  expect_both(read_relations(folder.write("a.relations", kRelations)));
}

TEST(RelationsFileTest, SaysWhereItIsWrong) {
  const auto complaint = [](const std::string& text) {
    return message_of([&] { parse_relations(unpacked(text), "r"); });
  };
  EXPECT_EQ(complaint("1 2 3 4 5 6 7\n"), "r:1: field 8: yaw is missing; want a number");
  EXPECT_EQ(complaint("1 2 3 4 5 6 7 8\n1 2 3 x 5 6 7 8\n"), "r:2: field 4: y is \"x\"; want a number");
  EXPECT_EQ(complaint("1 2 3 4 5 6 7 8 9\n"), "r:1: more than eight numbers; want t1 t2 x y z roll pitch yaw");
  EXPECT_EQ(complaint("\n# none\n"), "r: no relations; want lines of t1 t2 x y z roll pitch yaw");
}

}  // namespace
}  // namespace scrubjay
