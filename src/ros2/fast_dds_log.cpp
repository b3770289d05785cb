#include "fast_dds_log.hpp"

#include <algorithm>
#include <fastdds/dds/log/Log.hpp>
#include <memory>
#include <mutex>
#include <set>
#include <vector>

namespace scrubjay::ros {
namespace {

namespace dds = eprosima::fastdds::dds;

struct Listener {
  const LogEar* ear;
  std::function<void(const std::string& message)> hear;
  std::set<std::string> places;  ///< that it heard from: others may have them say the same with ever other figures
};

/// All of the process: Fast DDS has one log.
struct Listeners {
  std::mutex mutex;
  std::vector<Listener> all;
};

Listeners& listeners() {
  // Never destroyed: Fast DDS's log has a thread that may end later than everything else.
  static Listeners& listeners = *new Listeners;
  return listeners;
}

class Consumer final : public dds::LogConsumer {
 public:
  void Consume(const dds::Log::Entry& entry) override {
    if (entry.kind != dds::Log::Kind::Error) return;
    std::string place = entry.context.category != nullptr ? entry.context.category : "";
    if (entry.context.function != nullptr) place += entry.context.function;
    const std::scoped_lock lock(listeners().mutex);
    for (Listener& listener : listeners().all) {
      if (listener.places.insert(place).second) listener.hear(entry.message);
    }
  }
};

}  // namespace

LogEar::LogEar(std::function<void(const std::string& message)> hear) {
  static std::once_flag once;
  std::call_once(once, [] {
    dds::Log::ClearConsumers();
    dds::Log::RegisterConsumer(std::make_unique<Consumer>());
  });
  dds::Log::Flush();  // what was before isn't for this one
  const std::scoped_lock lock(listeners().mutex);
  listeners().all.push_back({this, std::move(hear), {}});
}

LogEar::~LogEar() {
  dds::Log::Flush();
  const std::scoped_lock lock(listeners().mutex);
  std::erase_if(listeners().all, [&](const Listener& listener) { return listener.ear == this; });
}

std::string FirstError::text() {
  dds::Log::Flush();
  const std::scoped_lock lock(listeners().mutex);
  return first_;
}

}  // namespace scrubjay::ros
