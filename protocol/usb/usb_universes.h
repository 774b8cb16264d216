// Which number the line of a USB interface has.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hazer::protocol {

/// What a show says of one interface.
struct UsbBinding {
    std::string serial;
    std::optional<std::uint16_t> universe{};  ///< Else the next that is free.
};

/// Interfaces get numbers in the order in which they first appear, and keep them while hazer runs, also when
/// they are unplugged for a while.
class UsbUniverses {
 public:
    /// `first`: the lowest number for those that no binding gives one.
    explicit UsbUniverses(const std::vector<UsbBinding>& bindings, std::uint16_t first = 1);

    /// `key`: the serial number, or what stands for it. Nothing once all numbers are used up.
    std::optional<std::uint16_t> of(const std::string& key);

 private:
    std::uint32_t next_;
    std::map<std::string, std::uint16_t> numbers_;
};

}  // namespace hazer::protocol
