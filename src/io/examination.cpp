#include <algorithm>
#include <cmath>
#include <scrubjay/io/examination.hpp>
#include <scrubjay/oi/all_packets.hpp>
#include <scrubjay/oi/sensor_views.hpp>
#include <utility>

namespace scrubjay {
namespace {

using oi::PacketId;

constexpr double kInterval = 0.015;    // between two frames of a stream (OI specification, "Stream") [s]
constexpr double kLongestReply = 0.1;  // the longest reply takes 42 ms at 19,200 baud; an adapter holds back 16 ms
constexpr double kFirstFrame = 1.0;    // a stream that hasn't begun by then won't [s]
constexpr double kBannerBegins = 1.5;  // a robot that prints nothing by then has no banner [s]
constexpr double kBannerLasts = 6.0;   // starting anew takes about 5 s (OI specification, "Reset")
constexpr double kStarted = 9.0;       // a robot that doesn't answer by then won't [s]
constexpr double kSilenceAfter = 0.5;  // a release followed by so much silence was the last word [s]
constexpr int kQuietReads = 40;        // a tick each: a stream that isn't over by then doesn't heed us
constexpr std::size_t kMaxBanner = 4096;
constexpr std::size_t kReadSize = 1024;

constexpr oi::SensorId kTenBytes = 3;  // battery and charging; every model has that group

double percentile(std::vector<double>& sorted, double share) {
  const auto last = static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(std::ceil(share * last))];
}

void append_printable(std::string& text, std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    if (text.size() >= kMaxBanner) return;
    if (byte == '\n' || (byte >= 0x20 && byte < 0x7F)) text += static_cast<char>(byte);
  }
}

}  // namespace

Examination::Examination(ByteChannel& channel, Clock now, std::stop_token stop)
    : channel_(channel), now_(std::move(now)), stop_(std::move(stop)) {}

Examination::~Examination() {
  if (report_.contact != Contact::Robot || report_.link_lost) return;
  send(oi::Start{});
  if (report_.model != oi::Model::Roomba400) send(oi::PauseResumeStream{0});
}

bool Examination::send(const oi::Command& command) {
  const bool sent = channel_.write(encode(command));
  if (!sent) report_.link_lost = true;
  return sent;
}

/// Reads until nothing comes any more.
void Examination::quieten() {
  std::array<std::uint8_t, kReadSize> buffer;
  for (int i = 0; i < kQuietReads && going_on(); ++i) {
    const ByteRead read = channel_.read(buffer);
    heard_ += read.count;
    if (!read.open) report_.link_lost = true;
    if (read.count == 0) return;
  }
}

/// How long the answer took [s]; none if it didn't come, or something else did.
std::optional<double> Examination::ask(oi::SensorId id, oi::Model model) {
  oi::QueryReader reader(model);
  const oi::Query query{id};
  if (!reader.expect(query)) return std::nullopt;
  const double asked = now_();
  if (!send(query)) return std::nullopt;
  std::array<std::uint8_t, kReadSize> buffer;
  oi::Sensors answer;
  while (going_on()) {
    const ByteRead read = channel_.read(buffer);
    heard_ += read.count;
    if (!read.open) report_.link_lost = true;
    const std::span<const std::uint8_t> bytes(buffer.data(), read.count);
    if (reader.feed(bytes, answer) < bytes.size() || (reader.awaited() == 0 && reader.rejected() > 0)) break;
    if (reader.awaited() == 0) {
      report_.sensors.update(answer);
      return read.stamp - asked;
    }
    if (read.stamp - asked >= kLongestReply) break;
  }
  quieten();
  return std::nullopt;
}

bool Examination::answers(oi::Model model) {
  // A bad wire spoils the one reply or the other: whoever says anything at all is asked more often.
  constexpr int kAttempts = 12;
  for (int i = 0; i < kAttempts && going_on(); ++i) {
    const std::size_t before = heard_;
    if (ask(oi::all_packets(model), model)) return true;
    if (heard_ == before && i > 0) return false;
  }
  return false;
}

/// What a robot is that answers as this model does: it may have been silent when it was asked for more.
oi::Model Examination::richest(oi::Model model) {
  for (const oi::Model richer : oi::kRichestFirst) {
    if (richer == model || answers(richer)) return richer;
  }
  return model;
}

Contact Examination::find_robot() {
  report_.contact = Contact::Silent;
  heard_ = 0;
  send(oi::Start{});
  send(oi::PauseResumeStream{0});
  quieten();
  for (const oi::Model model : oi::kRichestFirst) {
    const std::size_t before = heard_;
    if (!answers(model)) {
      // Who says something when asked for the longer list has it; the shorter ones it would answer as well.
      if (heard_ > before) break;
      continue;
    }
    report_.contact = Contact::Robot;
    report_.model = richest(model);
    report_.quirks = {};
    if (!report_.sensors.has(PacketId::OiMode)) return report_.contact;
    // Start leads to Passive from wherever the robot was.
    report_.quirks.mode_one_too_high = oi::is_one_too_high(report_.sensors[PacketId::OiMode], oi::OiMode::Passive);
    report_.mode = oi::corrected_mode(report_.sensors[PacketId::OiMode], report_.quirks);
    return report_.contact;
  }
  if (heard_ > 0) report_.contact = Contact::Foreign;
  return report_.contact;
}

bool Examination::read_banner() {
  if (report_.model != oi::Model::Create2) return true;
  if (!send(oi::Reset{})) return false;
  const double begin = now_();
  double heard = begin;
  std::array<std::uint8_t, kReadSize> buffer;
  while (going_on()) {
    const ByteRead read = channel_.read(buffer);
    if (!read.open) report_.link_lost = true;
    if (read.count > 0) heard = read.stamp;
    append_printable(report_.banner, {buffer.data(), read.count});
    const double waited = read.stamp - begin;
    if (report_.banner.empty() && waited >= kBannerBegins) break;
    const bool told = oi::parse_release(report_.banner).has_value();
    if (waited >= kBannerLasts || (told && read.stamp - heard >= kSilenceAfter)) break;
  }
  const bool quirky_mode = report_.quirks.mode_one_too_high;
  report_.release = oi::parse_release(report_.banner);
  if (report_.release) report_.quirks = oi::quirks_of(*report_.release);
  report_.quirks.mode_one_too_high = quirky_mode;
  // While it starts it is deaf.
  while (going_on() && now_() - begin < kStarted) {
    send(oi::Start{});
    quieten();
    if (answers(report_.model)) return true;
  }
  return false;
}

void Examination::time_replies(int count) {
  std::vector<double> times;
  report_.replies = {};
  quieten();
  for (int i = 0; i < count && going_on(); ++i) {
    ++report_.replies.asked;
    if (const auto time = ask(kTenBytes, report_.model)) times.push_back(*time);
    // A robot that answers no more isn't worth the wait for each of its answers.
    if (i == 9 && times.empty()) break;
  }
  report_.replies.answered = static_cast<int>(times.size());
  if (times.empty()) return;
  std::sort(times.begin(), times.end());
  report_.replies.median = percentile(times, 0.5);
  report_.replies.p95 = percentile(times, 0.95);
}

void Examination::listen(double seconds, const Look& look) {
  report_.frames = {};
  report_.history = {};
  counting_ = true;
  hear(seconds, look);
  counting_ = false;
}

void Examination::watch(double seconds, const Look& look) {
  hear(seconds, look);
}

void Examination::hear(double seconds, const Look& look) {
  any_frame_ = false;
  if (report_.model == oi::Model::Roomba400) {
    listen_by_asking(seconds, look);
  } else {
    listen_to_stream(seconds, look);
  }
  if (report_.sensors.has(PacketId::OiMode)) {
    report_.mode = oi::corrected_mode(report_.sensors[PacketId::OiMode], report_.quirks);
  }
}

void Examination::take_frame(double stamp, std::uint16_t rejected) {
  any_frame_ = true;
  if (!counting_) return;
  FrameCount& count = report_.frames;
  const bool first = count.frames == 0;
  if (first) first_frame_ = stamp;
  if (!first) count.longest_gap = std::max(count.longest_gap, stamp - last_frame_);
  last_frame_ = stamp;
  ++count.frames;
  count.bad_values += rejected;
  for (std::size_t i = oi::kFirstPacket; i < report_.history.size(); ++i) {
    const std::int32_t value = report_.sensors.value[i];
    PacketHistory& history = report_.history[i];
    history.least = first ? value : std::min(history.least, value);
    history.most = first ? value : std::max(history.most, value);
    history.always = first ? value : history.always & value;
    history.ever |= value;
  }
}

void Examination::end_listening(double stamp) {
  FrameCount& count = report_.frames;
  if (!counting_ || count.frames == 0) return;
  count.seconds = stamp - first_frame_;
  count.longest_gap = std::max(count.longest_gap, stamp - last_frame_);
}

void Examination::listen_to_stream(double seconds, const Look& look) {
  quieten();
  if (!send(oi::stream_of_all(report_.model))) return;
  oi::StreamParser parser(report_.model, oi::payload_of_all(report_.model));
  const double begin = now_();
  double end = begin;
  bool watching = true;
  std::array<std::uint8_t, kReadSize> buffer;
  while (watching && going_on()) {
    const ByteRead read = channel_.read(buffer);
    if (!read.open) report_.link_lost = true;
    parser.feed({buffer.data(), read.count}, [&](const oi::StreamFrame& frame) {
      const oi::DecodeStatus status = oi::decode(frame, report_.model, report_.sensors);
      if (!status.ok) return;
      take_frame(read.stamp, status.rejected);
      if (look && watching) watching = look(report_.sensors, read.stamp);
    });
    end = read.stamp;
    const double limit = !any_frame_ ? std::min(kFirstFrame, seconds) : seconds;
    if (end - begin >= limit) break;
  }
  end_listening(end);
  if (counting_) count_losses(parser.counters());
  send(oi::PauseResumeStream{0});
  quieten();
}

void Examination::count_losses(const oi::StreamParser::Counters& counters) {
  FrameCount& count = report_.frames;
  count.damaged = counters.lost;
  count.stray_bytes = counters.skipped;
  const auto expected = static_cast<std::uint64_t>(std::floor(count.seconds / kInterval + 0.5)) + 1;
  count.missing = count.frames > 0 && expected > count.frames ? expected - count.frames : 0;
}

void Examination::listen_by_asking(double seconds, const Look& look) {
  quieten();
  const double begin = now_();
  double stamp = begin;
  while (going_on() && stamp - begin < seconds) {
    const double asked = now_();
    const auto time = ask(oi::all_packets(report_.model), report_.model);
    stamp = now_();
    if (time) {
      take_frame(asked + *time, 0);
      if (look && !look(report_.sensors, stamp)) break;
    } else {
      if (counting_) ++report_.frames.missing;
      if (!any_frame_ && stamp - begin >= kFirstFrame) break;
    }
  }
  end_listening(stamp);
}

}  // namespace scrubjay
