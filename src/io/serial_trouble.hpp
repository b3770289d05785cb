/// \file
/// Why a serial port can't be opened, and what to do about it.
#pragma once

#include <filesystem>
#include <scrubjay/error.hpp>

namespace scrubjay {

/// The error for `path`, which couldn't be opened as a serial port because of `reason` (an errno).
Error serial_open_error(const std::filesystem::path& path, int reason);
/// The error for a port that another program has locked.
Error serial_in_use_error(const std::filesystem::path& path);

}  // namespace scrubjay
