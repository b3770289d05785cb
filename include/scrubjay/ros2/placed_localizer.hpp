/// \file
/// A localizer that others may correct.
#pragma once

#include <memory>
#include <scrubjay/localization/localizer.hpp>
#include <scrubjay/ros2/commands.hpp>

namespace scrubjay::ros {

/// Dead reckoning from where others said last that the robot is (/initialpose).
class PlacedLocalizer final : public Localizer {
 public:
  /// `commands` must outlive it.
  PlacedLocalizer(std::unique_ptr<Localizer> reckoning, Commands& commands)
      : reckoning_(std::move(reckoning)), commands_(commands) {}

  const PoseEstimate& update(const Frame& frame) override;

 private:
  std::unique_ptr<Localizer> reckoning_;
  Commands& commands_;
  Pose2 place_;  // of the reckoning's origin
  PoseEstimate estimate_;
};

}  // namespace scrubjay::ros
