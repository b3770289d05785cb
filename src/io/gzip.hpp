/// \file
/// Text files that may be packed with gzip.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace scrubjay {

/// No text that we read is longer, packed or not; what claims to be would only fill the memory.
inline constexpr std::size_t kLongestText = std::size_t{256} << 20;

/// The text in `file`: unpacked if it begins as gzip does (several members one after another are one text), as it is
/// otherwise. Throws Error, with `name`, if it is cut or damaged, or longer than kLongestText.
std::string unpacked(std::span<const std::uint8_t> file, const std::string& name);

/// The same from a file.
std::string read_text(const std::filesystem::path& path);

}  // namespace scrubjay
