/// \file
/// The group of packets that tells the most.
#pragma once

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

}  // namespace scrubjay::oi
