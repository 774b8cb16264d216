// Any bytes as what comes from a USB interface. The first byte chooses which; the rest is its stream, in
// transfers whose lengths stand before them.
#include <algorithm>
#include <cstdlib>
#include <vector>

#include "protocol/usb/enttec_message.h"
#include "protocol/usb/ftdi_widget.h"
#include "protocol/usb/nodle_widget.h"

namespace {

using namespace hazer::protocol;
using Bytes = std::vector<std::uint8_t>;
using Span = std::span<const std::uint8_t>;

void require(bool condition) {
    if (!condition) std::abort();
}

/// 0..127 as they are, then 112..620 in steps of 4.
std::size_t lengthOf(std::size_t byte) {
    return byte < 128 ? byte : 4 * (byte - 100);
}

/// In heap blocks of their exact size.
std::vector<Bytes> transfersOf(Span stream) {
    std::vector<Bytes> transfers;
    while (!stream.empty()) {
        const std::size_t size = std::min(lengthOf(stream[0]), stream.size() - 1);
        transfers.emplace_back(stream.begin() + 1, stream.begin() + 1 + static_cast<std::ptrdiff_t>(size));
        stream = stream.subspan(1 + size);
    }
    return transfers;
}

/// Labels and data of the messages, one after the other.
Bytes messagesIn(const std::vector<Bytes>& pieces) {
    EnttecDecoder decoder;
    Bytes found;
    for (const Bytes& piece : pieces) {
        Span rest(piece);
        while (const auto message = decoder.next(rest)) {
            require(message->data.size() <= kMaxEnttecData);
            found.push_back(message->label);
            found.insert(found.end(), message->data.begin(), message->data.end());
        }
        require(rest.empty());
    }
    return found;
}

void checkCuts(const std::vector<Bytes>& pieces) {
    Bytes whole;
    for (const Bytes& piece : pieces) whole.insert(whole.end(), piece.begin(), piece.end());
    std::vector<Bytes> single;
    for (const std::uint8_t byte : whole) single.push_back({byte});
    const Bytes messages = messagesIn(pieces);
    require(messages == messagesIn({whole}));
    require(messages == messagesIn(single));
}

void play(UsbWidget& widget, const std::vector<Bytes>& transfers) {
    TimePoint now{std::chrono::hours(1)};
    std::uint64_t shown = 0;
    const auto show = [&](Span slots) {
        require(slots.size() <= kSlotCount);
        ++shown;
    };
    for (const Bytes& transfer : transfers) {
        widget.receive(transfer, now, show);
        if (transfer.size() == 2) widget.interrupt();
        require(widget.takeRequest(now).size() <= 33);
        const auto deadline = widget.nextDeadline();
        require(!deadline || *deadline <= now + std::chrono::seconds(1));
        now += std::chrono::milliseconds(20);
        require(widget.facts().frames == shown);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const auto transfers = transfersOf(Span(data, size).subspan(1));
    switch (data[0] % 4) {
        case 0:
            checkCuts(transfers);
            break;
        case 1: {
            NodleWidget nodle;
            play(nodle, transfers);
            break;
        }
        default: {
            FtdiWidget ftdi(data[0] % 4 == 2 ? 64 : 512, TimePoint{std::chrono::hours(1)});
            play(ftdi, transfers);
        }
    }
    return 0;
}
