#include "tests/protocol/usb/fake_usb.h"

#include <fmt/format.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <umockdev.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace hazer::protocol::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kPacketSize = 64;
constexpr auto kLatency = std::chrono::milliseconds(1);
constexpr const char* kHub = "/devices/pci0000:00/0000:00:14.0/usb1";

struct Unref {
    void operator()(void* object) const { g_object_unref(object); }
};
using Data = std::unique_ptr<UMockdevIoctlData, Unref>;

Data dataAt(UMockdevIoctlData* parent, std::size_t offset, std::size_t size) {
    return Data(umockdev_ioctl_data_resolve(parent, offset, size, nullptr));
}

Data shared(UMockdevIoctlData* data) {
    return Data(static_cast<UMockdevIoctlData*>(g_object_ref(data)));
}

/// Of a struct that an ioctl was given.
template <class Struct>
Struct& as(const Data& data) {
    return *reinterpret_cast<Struct*>(data->data);
}

std::string hex(const Bytes& bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) text += fmt::format("{:02X}", byte);
    return text;
}

std::uint8_t lowByte(unsigned value) {
    return static_cast<std::uint8_t>(value & 0xFF);
}

/// Device and configuration descriptor (USB 2.0, 9.6) with one interface, an endpoint 81 for reading and a
/// 02.
Bytes descriptorsOf(const FakeUsbDescription& d) {
    const std::uint8_t type = d.isHid ? 3 : 2;  // interrupt, bulk
    const std::uint8_t interfaceClass = d.isHid ? 3 : 0xFF;
    return {18, 1, 0, 2, 0, 0, 0, 8, lowByte(d.vendor), lowByte(d.vendor >> 8U), lowByte(d.product),
            lowByte(d.product >> 8U), lowByte(d.bcdDevice), lowByte(d.bcdDevice >> 8U), 1, 2, 3, 1,
            //
            9, 2, 32, 0, 1, 1, 0, 0x80, 45,
            //
            9, 4, 0, 0, 2, interfaceClass, 0xFF, 0xFF, 2,
            //
            7, 5, 0x81, type, kPacketSize, 0, 1,
            //
            7, 5, 0x02, type, kPacketSize, 0, 1};
}

/// In the language of umockdev: path, node, properties, attributes.
std::string describeDevice(const FakeUsbDescription& d) {
    const std::string descriptors = hex(descriptorsOf(d));
    std::string text =
        fmt::format("P: {}/{}\nN: bus/usb/001/{:03}={}\n", kHub, d.port, d.device, descriptors);
    text += fmt::format(
        "E: BUSNUM=001\nE: DEVNAME=/dev/bus/usb/001/{:03}\nE: DEVNUM={:03}\nE: DEVTYPE=usb_device\nE: "
        "DRIVER=usb\n"
        "E: MAJOR=189\nE: MINOR={}\nE: SUBSYSTEM=usb\n",
        d.device, d.device, d.device - 1);
    text += fmt::format(
        "A: bConfigurationValue=1\nA: bcdDevice={:04x}\nA: busnum=1\nA: devnum={}\nA: idVendor={:04x}\n"
        "A: idProduct={:04x}\nA: speed=12\n",
        d.bcdDevice, d.device, d.vendor, d.product);
    text += fmt::format("A: manufacturer={}\nA: product={}\nA: serial={}\nH: descriptors={}\n",
                        d.manufacturer, d.name, d.serial, descriptors);
    return text;
}

std::string describeHub() {
    const char* const descriptors =
        "12010002090001406B1D020005060302010109021900010100E0000904000001090000000705810304000C";
    return fmt::format(
        "P: {}\nN: bus/usb/001/001={}\nE: BUSNUM=001\nE: DEVNAME=/dev/bus/usb/001/001\nE: DEVNUM=001\n"
        "E: DEVTYPE=usb_device\nE: DRIVER=usb\nE: MAJOR=189\nE: MINOR=0\nE: SUBSYSTEM=usb\n"
        "A: bConfigurationValue=1\nA: busnum=1\nA: devnum=1\nA: idVendor=1d6b\nA: idProduct=0002\nA: "
        "speed=480\n"
        "H: descriptors={}\n",
        kHub, descriptors, descriptors);
}

/// A transfer that a program waits for.
struct Urb {
    Data urb;
    Data buffer;
    bool isDiscarded = false;

    usbdevfs_urb& fields() const { return as<usbdevfs_urb>(urb); }
    std::size_t size() const { return static_cast<std::size_t>(fields().buffer_length); }
    bool isRead() const { return (fields().endpoint & 0x80) != 0; }

    void finish(int status, std::size_t size) const {
        fields().status = status;
        fields().actual_length = static_cast<int>(size);
    }
};

}  // namespace

/// What the device does. Lives on the fake's thread while programs have it open.
struct FakeUsbDevice::Impl {
    explicit Impl(bool hid) : isHid(hid) {}

    /// The result of an ioctl: 0 or above, or -errno.
    long handle(unsigned long request, UMockdevIoctlData* argument) {
        const std::lock_guard lock(mutex);
        if (isUnplugged && request != USBDEVFS_DISCARDURB && request != USBDEVFS_REAPURBNDELAY)
            return -ENODEV;
        const std::size_t size = _IOC_SIZE(request);
        const Data data = size > 0 ? dataAt(argument, 0, size) : nullptr;
        switch (request) {
            case USBDEVFS_GET_CAPABILITIES:
                as<std::uint32_t>(data) = USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_BULK_CONTINUATION |
                                          USBDEVFS_CAP_NO_PACKET_SIZE_LIM |
                                          USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
                return 0;
            case USBDEVFS_GETDRIVER:
                if (!hasDriver) return -ENODATA;
                std::strcpy(as<usbdevfs_getdriver>(data).driver, "ftdi_sio");
                return 0;
            case USBDEVFS_DISCONNECT_CLAIM:
                if (isBusy) return -EBUSY;
                hasDriver = false;
                isClaimed = true;
                return 0;
            case USBDEVFS_CLAIMINTERFACE:
                if (isBusy || hasDriver) return -EBUSY;
                isClaimed = true;
                return 0;
            case USBDEVFS_RELEASEINTERFACE:
                isClaimed = false;
                return 0;
            case USBDEVFS_IOCTL:
                hasDriver =
                    static_cast<unsigned long>(as<usbdevfs_ioctl>(data).ioctl_code) == USBDEVFS_CONNECT;
                return 1;
            case USBDEVFS_CLEAR_HALT:
                isHalted = false;
                ++clearedHalts;
                return 0;
            case USBDEVFS_SUBMITURB:
                return submit(data.get());
            case USBDEVFS_DISCARDURB:
                return discard(*reinterpret_cast<gulong*>(argument->data));
            case USBDEVFS_REAPURB:
            case USBDEVFS_REAPURBNDELAY:
                return reap(data.get());
            default:
                return -ENOTTY;
        }
    }

    long submit(UMockdevIoctlData* urb) {
        const auto& fields = *reinterpret_cast<usbdevfs_urb*>(urb->data);
        auto buffer =
            dataAt(urb, offsetof(usbdevfs_urb, buffer), static_cast<std::size_t>(fields.buffer_length));
        pending.push_back({shared(urb), std::move(buffer)});
        return 0;
    }

    long discard(gulong address) {
        const auto found = std::ranges::find_if(
            pending, [&](const Urb& urb) { return urb.urb->client_addr == address && !urb.isDiscarded; });
        if (found == pending.end()) return -EINVAL;
        found->isDiscarded = true;
        return 0;
    }

    long reap(UMockdevIoctlData* result) {
        const auto done = std::ranges::find_if(pending, [&](Urb& urb) { return isDone(urb); });
        if (done == pending.end()) return isUnplugged ? -ENODEV : -EAGAIN;
        umockdev_ioctl_data_set_ptr(result, 0, done->urb.get());
        pending.erase(done);
        return 0;
    }

    bool isDone(const Urb& urb) {
        if (urb.isDiscarded || isUnplugged) {
            urb.finish(urb.isDiscarded ? -ENOENT : -ENODEV, 0);
            return true;
        }
        if (isMute) return false;
        if (urb.fields().type == USBDEVFS_URB_TYPE_CONTROL) return doControl(urb);
        return urb.isRead() ? doRead(urb) : doWrite(urb);
    }

    bool doControl(const Urb& urb) {
        const std::uint8_t* setup = urb.buffer->data;
        const auto word = [&](int at) { return static_cast<std::uint16_t>(setup[at] | setup[at + 1] << 8); };
        controlRequests.push_back({setup[1], word(2), word(4)});
        urb.finish(0, 0);
        return true;
    }

    bool doWrite(const Urb& urb) {
        const std::uint8_t* bytes = urb.buffer->data;
        const auto size = urb.size();
        written.emplace_back(bytes, bytes + size);
        if (answer) queueSerial(answer(written.back()), 0x60);
        urb.finish(0, size);
        return true;
    }

    bool doRead(const Urb& urb) {
        if (isHalted) {
            urb.finish(-EPIPE, 0);
            return true;
        }
        if (failures > 0) {
            --failures;
            isHalted = failure == EPIPE;
            urb.finish(-failure, 0);
            return true;
        }
        if (packets.empty()) return doIdleRead(urb);
        std::size_t size = 0;
        bool isFull = true;
        while (isFull && !packets.empty() && size + kPacketSize <= urb.size()) {
            std::memcpy(urb.buffer->data + size, packets.front().data(), packets.front().size());
            size += packets.front().size();
            isFull = packets.front().size() == kPacketSize;
            packets.pop_front();
        }
        urb.finish(0, size);
        return true;
    }

    /// An FTDI chip that hears nothing says so every millisecond.
    bool doIdleRead(const Urb& urb) {
        if (isHid || isQuiet || Clock::now() - lastIdle < kLatency) return false;
        lastIdle = Clock::now();
        urb.buffer->data[0] = 0x01;
        urb.buffer->data[1] = 0x60;
        urb.finish(0, 2);
        return true;
    }

    void queueSerial(const Bytes& bytes, std::uint8_t lineStatus) {
        constexpr std::size_t kPayload = kPacketSize - 2;
        for (std::size_t at = 0; at < bytes.size(); at += kPayload) {
            Bytes packet{0x01, lineStatus};
            const auto end = std::min(at + kPayload, bytes.size());
            packet.insert(packet.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                          bytes.begin() + static_cast<std::ptrdiff_t>(end));
            packets.push_back(std::move(packet));
        }
    }

    const bool isHid;
    mutable std::mutex mutex;
    std::vector<Urb> pending;
    std::deque<Bytes> packets;
    std::function<Bytes(const Bytes&)> answer;
    std::vector<UsbControlRequest> controlRequests;
    std::vector<Bytes> written;
    Clock::time_point lastIdle;
    int failures = 0;
    int failure = 0;
    int clearedHalts = 0;
    bool isHalted = false;
    bool isMute = false;
    bool isQuiet = false;
    bool isBusy = false;
    bool hasDriver = true;
    bool isClaimed = false;
    bool isUnplugged = false;
    UMockdevIoctlBase* handler = nullptr;
};

struct FakeUsbBus::Impl {
    Impl() : testbed(umockdev_testbed_new()), loop(g_main_loop_new(nullptr, FALSE)) {
        umockdev_testbed_add_from_string(testbed, describeHub().c_str(), nullptr);
        thread = std::thread([this] { g_main_loop_run(loop); });
    }

    ~Impl() {
        while (!g_main_loop_is_running(loop)) std::this_thread::yield();
        g_main_loop_quit(loop);
        thread.join();
        g_main_loop_unref(loop);
        g_object_unref(testbed);
    }

    UMockdevTestbed* testbed;
    GMainLoop* loop;
    std::vector<std::shared_ptr<void>> devices;  ///< Programs may have them open after they were unplugged.
    std::thread thread;
};

FakeUsbBus::FakeUsbBus() : impl_(std::make_unique<Impl>()) {}

FakeUsbBus::~FakeUsbBus() = default;

bool FakeUsbBus::isPossible() {
    const char* const loaded = std::getenv("LD_PRELOAD");
    return loaded != nullptr && std::strstr(loaded, "libumockdev-preload") != nullptr;
}

std::string FakeUsbBus::rootFolder() const {
    gchar* root = umockdev_testbed_get_root_dir(impl_->testbed);
    std::string folder = root;
    g_free(root);
    return folder;
}

namespace {

std::string nodeOf(const FakeUsbDescription& description) {
    return fmt::format("/dev/bus/usb/001/{:03}", description.device);
}

std::string sysPathOf(const FakeUsbDescription& description) {
    return fmt::format("/sys{}/{}", kHub, description.port);
}

}  // namespace

FakeUsbDevice::FakeUsbDevice(FakeUsbBus& bus, const FakeUsbDescription& description)
    : impl_(std::make_shared<Impl>(description.isHid)), bus_(bus), description_(description) {
    const auto handle = +[](UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer device) -> gboolean {
        const long result = static_cast<Impl*>(device)->handle(umockdev_ioctl_client_get_request(client),
                                                               umockdev_ioctl_client_get_arg(client));
        umockdev_ioctl_client_complete(client, result < 0 ? -1 : result,
                                       result < 0 ? static_cast<int>(-result) : 0);
        return TRUE;
    };
    UMockdevTestbed* testbed = bus.impl_->testbed;
    umockdev_testbed_add_from_string(testbed, describeDevice(description).c_str(), nullptr);
    bus.impl_->devices.push_back(impl_);
    impl_->handler = umockdev_ioctl_base_new();
    g_signal_connect(impl_->handler, "handle-ioctl", G_CALLBACK(handle), impl_.get());
    umockdev_testbed_attach_ioctl(testbed, nodeOf(description).c_str(), impl_->handler, nullptr);
    umockdev_testbed_uevent(testbed, sysPathOf(description).c_str(), "add");
}

FakeUsbDevice::~FakeUsbDevice() {
    {
        const std::lock_guard lock(impl_->mutex);
        impl_->isUnplugged = true;
    }
    UMockdevTestbed* testbed = bus_.impl_->testbed;
    umockdev_testbed_uevent(testbed, sysPathOf(description_).c_str(), "remove");
    umockdev_testbed_remove_device(testbed, sysPathOf(description_).c_str());
}

void FakeUsbDevice::sendPacket(const Bytes& packet) {
    const std::lock_guard lock(impl_->mutex);
    impl_->packets.push_back(packet);
}

void FakeUsbDevice::sendSerial(const Bytes& bytes, std::uint8_t lineStatus) {
    const std::lock_guard lock(impl_->mutex);
    impl_->queueSerial(bytes, lineStatus);
}

void FakeUsbDevice::answerWith(std::function<Bytes(const Bytes& written)> answer) {
    const std::lock_guard lock(impl_->mutex);
    impl_->answer = std::move(answer);
}

void FakeUsbDevice::failReads(int count, int error) {
    const std::lock_guard lock(impl_->mutex);
    impl_->failures = count;
    impl_->failure = error;
}

void FakeUsbDevice::setMute(bool isMute) {
    const std::lock_guard lock(impl_->mutex);
    impl_->isMute = isMute;
}

void FakeUsbDevice::setQuiet(bool isQuiet) {
    const std::lock_guard lock(impl_->mutex);
    impl_->isQuiet = isQuiet;
}

void FakeUsbDevice::setBusy(bool isBusy) {
    const std::lock_guard lock(impl_->mutex);
    impl_->isBusy = isBusy;
}

std::vector<UsbControlRequest> FakeUsbDevice::controlRequests() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->controlRequests;
}

std::vector<Bytes> FakeUsbDevice::written() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->written;
}

bool FakeUsbDevice::hasKernelDriver() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->hasDriver;
}

bool FakeUsbDevice::isClaimed() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->isClaimed;
}

int FakeUsbDevice::clearedHalts() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->clearedHalts;
}

bool FakeUsbDevice::hasSentAll() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->packets.empty();
}

}  // namespace hazer::protocol::test
