/// \file
/// A robot's URDF, parsed.
#pragma once

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <filesystem>
#include <string>

namespace scrubjay {

struct UrdfFile {
  std::string text;
  urdf::ModelInterfaceSharedPtr model;  ///< never null
};

/// Throws Error with the path and urdfdom's reason for what isn't a URDF robot.
UrdfFile read_urdf(const std::filesystem::path& path);

}  // namespace scrubjay
