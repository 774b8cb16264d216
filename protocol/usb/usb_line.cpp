#include "protocol/usb/usb_line.h"

#include <libusb.h>

#include <algorithm>
#include <array>
#include <list>
#include <utility>

#include "protocol/usb/ftdi_setup.h"
#include "protocol/usb/ftdi_widget.h"
#include "protocol/usb/nodle_widget.h"

namespace hazer::protocol {
namespace {

using namespace std::chrono_literals;

constexpr unsigned kControlTimeoutMs = 500;
constexpr unsigned kWriteTimeoutMs = 500;
constexpr int kReads =
    6;  // in flight, so that none of the chip's small buffer runs over while one is handled
constexpr int kReadSize = 512;
constexpr int kNodleReportSize = 33;
constexpr int kMostErrorsInARow = 10;
// An FTDI chip reports its status every few milliseconds, whatever the line does; most copies do.
constexpr auto kFtdiSilence = 2s;

int check(int result) {
    if (result < 0) throw UsbError(result);
    return result;
}

struct Endpoint {
    std::uint8_t address = 0;
    std::size_t packetSize = 0;
};

struct ConfigDelete {
    void operator()(libusb_config_descriptor* config) const { libusb_free_config_descriptor(config); }
};

/// The first endpoint of the interface in the direction LIBUSB_ENDPOINT_IN or _OUT. Throws UsbError.
Endpoint endpointOf(libusb_device* device, int port, unsigned direction) {
    libusb_config_descriptor* described = nullptr;
    check(libusb_get_active_config_descriptor(device, &described));
    const std::unique_ptr<libusb_config_descriptor, ConfigDelete> config(described);
    if (port >= config->bNumInterfaces || config->interface[port].num_altsetting < 1)
        throw UsbError(LIBUSB_ERROR_NOT_FOUND);
    const libusb_interface_descriptor& interface = config->interface[port].altsetting[0];
    for (int i = 0; i < interface.bNumEndpoints; ++i) {
        const libusb_endpoint_descriptor& endpoint = interface.endpoint[i];
        constexpr unsigned kSizeBits = 0x7FF;
        const std::size_t packetSize = endpoint.wMaxPacketSize & kSizeBits;
        if ((endpoint.bEndpointAddress & LIBUSB_ENDPOINT_DIR_MASK) == direction && packetSize > 0)
            return {endpoint.bEndpointAddress, packetSize};
    }
    throw UsbError(LIBUSB_ERROR_NOT_FOUND);
}

LibusbHandle open(libusb_device* device) {
    libusb_device_handle* handle = nullptr;
    check(libusb_open(device, &handle));
    return LibusbHandle(handle);
}

/// An interface of a device, taken from the kernel's driver and given back.
class Claim {
 public:
    Claim(libusb_device_handle* handle, int port) : handle_(handle), port_(port) {
        libusb_set_auto_detach_kernel_driver(handle, 1);  // where there are such drivers
        check(libusb_claim_interface(handle, port));
    }
    ~Claim() { libusb_release_interface(handle_, port_); }
    Claim(const Claim&) = delete;
    Claim& operator=(const Claim&) = delete;

 private:
    libusb_device_handle* handle_;
    int port_;
};

std::unique_ptr<UsbWidget> widgetFor(UsbFamily family, std::size_t packetSize) {
    if (family == UsbFamily::kNodle) return std::make_unique<NodleWidget>();
    return std::make_unique<FtdiWidget>(packetSize, Clock::now());
}

}  // namespace

struct UsbLine::Impl {
    struct Transfer {
        Transfer() : usb(libusb_alloc_transfer(0)) {
            if (usb == nullptr) throw UsbError(LIBUSB_ERROR_NO_MEM);
        }
        ~Transfer() { libusb_free_transfer(usb); }
        Transfer(const Transfer&) = delete;
        Transfer& operator=(const Transfer&) = delete;

        libusb_transfer* usb;
        std::array<std::uint8_t, kReadSize> buffer{};
        bool isInFlight = false;
    };

    Impl(libusb_context* usedContext, libusb_device* device, const UsbInterface& described, int usedPort,
         ShowSlots shown)
        : context(usedContext),
          family(described.family),
          port(usedPort),
          input(endpointOf(device, port, LIBUSB_ENDPOINT_IN)),
          output(endpointOf(device, port, LIBUSB_ENDPOINT_OUT)),
          show(std::move(shown)),
          handle(open(device)),
          claim(handle.get(), port),
          widget(widgetFor(family, input.packetSize)) {
        if (family == UsbFamily::kFtdi) setUpFtdi(described.bcdDevice);
        for (Transfer& read : reads) prepare(read, input, readSize(), 0);
        prepare(write, output, 0, kWriteTimeoutMs);
        lastHeard = Clock::now();
        try {
            for (Transfer& read : reads) submit(read);
        } catch (...) {
            cancelAll();
            throw;
        }
    }

    ~Impl() { cancelAll(); }

    void setUpFtdi(std::uint16_t bcdDevice) {
        constexpr std::uint8_t kVendorRequest = 0x40;
        for (const UsbControlRequest& request : ftdiSetup(bcdDevice, port)) {
            check(libusb_control_transfer(handle.get(), kVendorRequest, request.request, request.value,
                                          request.index, nullptr, 0, kControlTimeoutMs));
        }
    }

    // Bulk and interrupt transfers are the same to usbfs but for their type.
    void prepare(Transfer& transfer, const Endpoint& endpoint, int size, unsigned timeoutMs) {
        const auto fill =
            family == UsbFamily::kNodle ? libusb_fill_interrupt_transfer : libusb_fill_bulk_transfer;
        fill(transfer.usb, handle.get(), endpoint.address, transfer.buffer.data(), size, &Impl::complete,
             this, timeoutMs);
    }

    // A report must end its transfer, so that there is no room for two.
    int readSize() const {
        if (family == UsbFamily::kFtdi) return kReadSize;
        const auto packet = static_cast<int>(std::min<std::size_t>(input.packetSize, kReadSize));
        return (kNodleReportSize + packet - 1) / packet * packet;
    }

    void submit(Transfer& transfer) {
        check(libusb_submit_transfer(transfer.usb));
        transfer.isInFlight = true;
    }

    static void LIBUSB_CALL complete(libusb_transfer* usb) noexcept {
        Impl& line = *static_cast<Impl*>(usb->user_data);
        if (usb == line.write.usb) {
            line.write.isInFlight = false;  // an unanswered request is asked again, or done without
            return;
        }
        const auto read = std::ranges::find(line.reads, usb, &Transfer::usb);
        read->isInFlight = false;
        line.completeRead(*read);
    }

    void completeRead(Transfer& read) {
        const int failure = take(read);
        if (failure != 0) widget->interrupt();
        errorsInARow = failure == 0 ? 0 : errorsInARow + 1;
        const bool isFinal = failure == LIBUSB_ERROR_NO_DEVICE || errorsInARow > kMostErrorsInARow;
        if (isFinal) error = failure;
        if (isClosing || isFinal || isStalled) return;
        const int submitted = libusb_submit_transfer(read.usb);
        read.isInFlight = submitted == 0;
        if (submitted != 0) error = submitted;
    }

    /// 0, or one of libusb_error.
    int take(const Transfer& read) {
        switch (read.usb->status) {
            case LIBUSB_TRANSFER_COMPLETED:
                lastHeard = Clock::now();
                widget->receive(
                    std::span(read.buffer).first(static_cast<std::size_t>(read.usb->actual_length)),
                    lastHeard, show);
                return 0;
            case LIBUSB_TRANSFER_NO_DEVICE:
                return LIBUSB_ERROR_NO_DEVICE;
            case LIBUSB_TRANSFER_STALL:
                isStalled = true;
                return LIBUSB_ERROR_PIPE;
            case LIBUSB_TRANSFER_OVERFLOW:
                return LIBUSB_ERROR_OVERFLOW;
            case LIBUSB_TRANSFER_CANCELLED:
                return 0;
            case LIBUSB_TRANSFER_TIMED_OUT:
            case LIBUSB_TRANSFER_ERROR:
                break;
        }
        return LIBUSB_ERROR_IO;
    }

    void advance(TimePoint now) {
        if (error != 0) throw UsbError(error);
        if (family == UsbFamily::kFtdi && now - lastHeard > kFtdiSilence) askForLife();
        if (isStalled) restart();
        if (!write.isInFlight) ask(now);
    }

    void askForLife() {
        constexpr std::uint8_t kVendorAnswer = 0xC0;
        constexpr std::uint8_t kModemStatus = 0x05;
        std::array<std::uint8_t, 2> status{};
        check(libusb_control_transfer(handle.get(), kVendorAnswer, kModemStatus, 0, ftdiIndex(port),
                                      status.data(), status.size(), kControlTimeoutMs));
        lastHeard = Clock::now();
    }

    // A stalled endpoint refuses everything until it is told to go on.
    void restart() {
        isStalled = false;
        check(libusb_clear_halt(handle.get(), input.address));
        for (Transfer& read : reads) {
            if (!read.isInFlight) submit(read);
        }
    }

    void ask(TimePoint now) {
        const auto request = widget->takeRequest(now);
        if (request.empty()) return;
        std::ranges::copy(request, write.buffer.begin());
        write.usb->length = static_cast<int>(request.size());
        submit(write);
    }

    bool isAnyInFlight() const {
        return write.isInFlight || std::ranges::any_of(reads, &Transfer::isInFlight);
    }

    // libusb promises to complete every transfer that is cancelled, and needs it whole until then.
    void cancelAll() {
        isClosing = true;
        for (Transfer& read : reads) {
            if (read.isInFlight) libusb_cancel_transfer(read.usb);
        }
        if (write.isInFlight) libusb_cancel_transfer(write.usb);
        while (isAnyInFlight()) {
            timeval wait{.tv_sec = 0, .tv_usec = 100'000};
            const int result = libusb_handle_events_timeout_completed(context, &wait, nullptr);
            if (result != 0 && result != LIBUSB_ERROR_INTERRUPTED) break;
        }
    }

    libusb_context* context;
    UsbFamily family;
    int port;
    Endpoint input;
    Endpoint output;
    ShowSlots show;
    LibusbHandle handle;
    Claim claim;
    std::unique_ptr<UsbWidget> widget;
    std::array<Transfer, kReads> reads;
    Transfer write;
    TimePoint lastHeard;
    int errorsInARow = 0;
    int error = 0;  ///< One of libusb_error: the line cannot go on.
    bool isStalled = false;
    bool isClosing = false;
};

UsbLine::UsbLine(libusb_context* context, libusb_device* device, const UsbInterface& interface, int port,
                 ShowSlots show)
    : impl_(std::make_unique<Impl>(context, device, interface, port, std::move(show))) {}

UsbLine::~UsbLine() = default;

void UsbLine::advance(TimePoint now) {
    impl_->advance(now);
}

std::optional<TimePoint> UsbLine::nextDeadline() const {
    if (impl_->write.isInFlight) return std::nullopt;  // its end wakes us
    return impl_->widget->nextDeadline();
}

UsbWidgetFacts UsbLine::facts() const {
    return impl_->widget->facts();
}

}  // namespace hazer::protocol
