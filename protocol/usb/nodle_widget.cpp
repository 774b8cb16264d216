#include "protocol/usb/nodle_widget.h"

#include <algorithm>

namespace hazer::protocol {
namespace {

constexpr std::size_t kBlockSize = 32;
constexpr std::size_t kReportSize = 1 + kBlockSize;
constexpr std::uint8_t kModeReport = 16;
constexpr std::uint8_t kInputToComputer = 4;

}  // namespace

void NodleWidget::receive(std::span<const std::uint8_t> transfer, TimePoint, const ShowSlots& show) {
    if (transfer.empty()) return;
    const std::size_t first = transfer[0] * kBlockSize;
    if (transfer.size() != kReportSize || first >= slots_.size()) {
        ++facts_.malformed;
        return;
    }
    std::ranges::copy(transfer.subspan(1), slots_.begin() + static_cast<std::ptrdiff_t>(first));
    ++facts_.frames;
    show(slots_);
}

std::vector<std::uint8_t> NodleWidget::takeRequest(TimePoint) {
    if (isStarted_) return {};
    isStarted_ = true;
    std::vector<std::uint8_t> report(kReportSize);
    report[0] = kModeReport;
    report[1] = kInputToComputer;
    return report;
}

std::optional<TimePoint> NodleWidget::nextDeadline() const {
    if (isStarted_) return std::nullopt;
    return TimePoint::min();
}

}  // namespace hazer::protocol
