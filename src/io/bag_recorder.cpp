#include <scrubjay/io/bag_recorder.hpp>

namespace scrubjay {

void BagRecorder::publish(const ros::TopicInfo& topic, std::int64_t nanoseconds,
                          const std::shared_ptr<const ros::Bytes>& bytes) {
  auto found = numbers_.find(topic.name);
  if (found == numbers_.end()) {
    std::string name(topic.name);
    if (!topic.name.starts_with('/')) name.insert(name.begin(), '/');
    const std::size_t number = bag_->add(
        {name, std::string(topic.type.name), topic.type.definition(), std::string(topic.type.hash), topic.qos});
    found = numbers_.emplace(topic.name, number).first;
  }
  bag_->write(found->second, nanoseconds, *bytes);
}

}  // namespace scrubjay
