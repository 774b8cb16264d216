#include "protocol/usb/ftdi_widget.h"

#include <fmt/format.h>

#include <array>

namespace hazer::protocol {
namespace {

using namespace std::chrono_literals;

// DMX comes at least once a second; most of it forty times. A Pro passes it on without being asked.
constexpr auto kListenFor = 150ms;
// Interfaces have been seen to answer within 200 ms; some are busy for longer after they were plugged in.
constexpr auto kAnswerTime = 400ms;
constexpr int kMostAsked = 2;

// Any request but 3 and 6 puts the port to receiving. The last one asks for whole frames.
constexpr std::array kStartRequests{EnttecLabel::kSerialNumber, EnttecLabel::kParameters,
                                    EnttecLabel::kManufacturer, EnttecLabel::kDeviceName,
                                    EnttecLabel::kReceiveMode};

std::vector<std::uint8_t> packRequest(EnttecLabel label) {
    switch (label) {
        case EnttecLabel::kParameters:
            return packEnttec(label, std::array<std::uint8_t, 2>{0, 0});  // no user bytes
        case EnttecLabel::kReceiveMode:
            return packEnttec(label, std::array<std::uint8_t, 1>{0});  // every frame, whole
        default:
            return packEnttec(label);
    }
}

}  // namespace

FtdiWidget::FtdiWidget(std::size_t packetSize, TimePoint now)
    : packetSize_(packetSize), deadline_(now + kListenFor) {}

void FtdiWidget::receive(std::span<const std::uint8_t> transfer, TimePoint now, const ShowSlots& show) {
    while (const auto packet = takeFtdiPacket(transfer, packetSize_)) {
        if (!isPro()) listenTo(*packet, show);
        if (!frames_.hasHeardDmx()) receiveMessages(packet->payload, now, show);
    }
}

void FtdiWidget::listenTo(const FtdiPacket& packet, const ShowSlots& show) {
    if (const auto slots = frames_.receive(packet)) show(*slots);
    if (frames_.hasHeardDmx()) phase_ = Phase::kOpen;
}

void FtdiWidget::receiveMessages(std::span<const std::uint8_t> bytes, TimePoint now, const ShowSlots& show) {
    while (const auto message = decoder_.next(bytes)) {
        if (!take(*message, show)) {
            ++facts_.malformed;
            continue;
        }
        if (!isPro()) {
            phase_ = Phase::kStarting;
            deadline_ = now;
        }
        endWait(*message, now);
    }
}

// False if the message is none that an interface would send.
bool FtdiWidget::take(const EnttecMessage& message, const ShowSlots& show) {
    const auto label = static_cast<EnttecLabel>(message.label);
    switch (label) {
        case EnttecLabel::kReceivedDmx:
            return takeDmx(message.data, show);
        case EnttecLabel::kChangeOfState:
            return takeChanges(message.data, show);
        case EnttecLabel::kParameters:
            if (const auto parameters = parseEnttecParameters(message.data)) {
                facts_.firmware = parameters->firmware;
                return true;
            }
            return false;
        case EnttecLabel::kSerialNumber:
            if (const auto serial = parseEnttecSerial(message.data)) {
                facts_.serial = *serial;
                return true;
            }
            return false;
        case EnttecLabel::kManufacturer:
        case EnttecLabel::kDeviceName:
            if (const auto identity = parseEnttecIdentity(message.data)) {
                take(*identity, label);
                return true;
            }
            return false;
        case EnttecLabel::kReceiveMode:
            break;
    }
    return isPro();  // something else that this make knows of
}

bool FtdiWidget::takeDmx(std::span<const std::uint8_t> data, const ShowSlots& show) {
    const auto dmx = parseEnttecDmx(data);
    if (!dmx) return false;
    if (dmx->queueOverflowed || dmx->overrun) {
        ++facts_.lostFrames;
    } else if (dmx->startCode != 0) {
        ++facts_.otherCodes;
    } else {
        ++facts_.frames;
        changes_.begin(dmx->slots);
        knowsFrame_ = true;
        show(dmx->slots);
    }
    return true;
}

bool FtdiWidget::takeChanges(std::span<const std::uint8_t> data, const ShowSlots& show) {
    if (!changes_.apply(data)) return false;
    if (!knowsFrame_) return true;  // changes of what another program knew
    ++facts_.frames;
    show(changes_.slots());
    return true;
}

void FtdiWidget::take(const EnttecIdentity& identity, EnttecLabel label) {
    (label == EnttecLabel::kManufacturer ? manufacturer_ : device_) = identity.name;
}

// The answer to the last request of the start: the next one need not wait.
void FtdiWidget::endWait(const EnttecMessage& message, TimePoint now) {
    if (phase_ != Phase::kStarting || startStep_ == 0) return;
    if (message.label == static_cast<std::uint8_t>(kStartRequests[startStep_ - 1])) deadline_ = now;
}

std::vector<std::uint8_t> FtdiWidget::takeRequest(TimePoint now) {
    if (now < deadline_) return {};
    switch (phase_) {
        case Phase::kListening:
        case Phase::kAsking:
            return askAgain(now);
        case Phase::kStarting:
            return nextStartRequest(now);
        case Phase::kPro:
        case Phase::kOpen:
            break;
    }
    return {};
}

std::vector<std::uint8_t> FtdiWidget::askAgain(TimePoint now) {
    if (asked_ == kMostAsked) {
        phase_ = Phase::kOpen;
        return {};
    }
    phase_ = Phase::kAsking;
    ++asked_;
    deadline_ = now + kAnswerTime;
    return packRequest(EnttecLabel::kSerialNumber);
}

std::vector<std::uint8_t> FtdiWidget::nextStartRequest(TimePoint now) {
    if (startStep_ == kStartRequests.size()) {
        phase_ = Phase::kPro;
        return {};
    }
    const EnttecLabel label = kStartRequests[startStep_++];
    const bool isAnswered = label != EnttecLabel::kReceiveMode;
    if (!isAnswered) forgetFrame();
    deadline_ = isAnswered ? now + kAnswerTime : now;
    return packRequest(label);
}

// Setting the mode makes the interface forget its frame as well.
void FtdiWidget::forgetFrame() {
    changes_.begin({});
    knowsFrame_ = true;
}

std::optional<TimePoint> FtdiWidget::nextDeadline() const {
    if (phase_ == Phase::kPro || phase_ == Phase::kOpen) return std::nullopt;
    return deadline_;
}

void FtdiWidget::interrupt() {
    decoder_ = {};
    frames_.interrupt();
}

UsbWidgetFacts FtdiWidget::facts() const {
    UsbWidgetFacts facts = facts_;
    if (phase_ == Phase::kOpen) {
        const OpenDmxFrames::Counters& counters = frames_.counters();
        facts = {};
        facts.kind = "Open DMX";
        facts.frames = counters.frames;
        facts.otherCodes = counters.otherCodes;
        facts.lostFrames = counters.broken + counters.doubtful;
    } else if (isPro()) {
        facts.kind = "DMX USB Pro";
        facts.name = manufacturer_.empty() || device_.empty() ? manufacturer_ + device_
                                                              : fmt::format("{} {}", manufacturer_, device_);
    }
    return facts;
}

}  // namespace hazer::protocol
