/// \file
/// The group of packets that tells the most, and a stream of it.
#pragma once

#include <scrubjay/oi/command.hpp>
#include <scrubjay/oi/model.hpp>
#include <scrubjay/oi/sensor_id.hpp>

namespace scrubjay::oi {

/// The largest group that a model knows (OI specification, "Sensor Packets"; Roomba SCI, "Sensors").
inline SensorId all_packets(Model model) {
  switch (model) {
    case Model::Create2:
      return 100;
    case Model::Create1:
      return 6;
    case Model::Roomba400:
      break;
  }
  return 0;
}

/// The command that has that group streamed, and nothing else. A Roomba 400 knows no such command.
inline Stream stream_of_all(Model model) {
  Stream stream;
  const SensorId id = all_packets(model);
  if (const auto ids = decltype(stream.ids)::of({&id, 1})) stream.ids = *ids;
  return stream;
}

/// What a frame of that stream carries between header and checksum: the group's id and its data [bytes].
inline std::uint8_t payload_of_all(Model model) {
  return static_cast<std::uint8_t>(all_packets(model).bytes() + 1);
}

}  // namespace scrubjay::oi
