/// \file
/// Schemas and channels of an MCAP file as the topics of a bag.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <scrubjay/io/bag.hpp>
#include <set>
#include <string>
#include <vector>

#include "mcap_format.hpp"

namespace scrubjay::mcap {

/// Collects them. Of records with one number, the first counts: the others must be its copies.
class Topics {
 public:
  /// Takes a record in; false if it is a Schema or Channel record, and damaged, or a channel of an unknown schema.
  bool take(const Record& record);

  const std::vector<BagTopic>& all() const { return topics_; }
  bool knows(std::uint16_t channel) const { return channels_.contains(channel); }
  /// The topic of a channel that is known; none if its messages aren't CDR.
  std::optional<std::size_t> topic_of(std::uint16_t channel) const { return channels_.at(channel); }
  /// Other encodings than CDR that were met.
  const std::set<std::string>& other_encodings() const { return other_encodings_; }

 private:
  bool add(const Channel& channel);
  std::size_t number_of(BagTopic topic);

  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, std::optional<std::size_t>> channels_;
  std::vector<BagTopic> topics_;
  std::set<std::string> other_encodings_;
};

}  // namespace scrubjay::mcap
