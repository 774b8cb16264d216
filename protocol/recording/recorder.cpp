#include "protocol/recording/recorder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "protocol/recording/pcap_format.h"
#include "protocol/recording/recording.h"

namespace hazer::protocol {
namespace {

const char* remedyFor(int error) {
    if (error == EEXIST) return "; choose another name, or say --force to replace it";
    if (error == ENOSPC || error == EDQUOT) return "; make room, or record elsewhere";
    if (error == ENOENT) return "; make its folder first";
    return "";
}

/// A file that only ever holds whole records.
class RecordFile {
 public:
    RecordFile(const std::filesystem::path& file, bool replaces) : file_(file) {
        const int create = O_WRONLY | O_CREAT | O_CLOEXEC | (replaces ? O_TRUNC : O_EXCL);
        descriptor_ = ::open(file.c_str(), create, 0644);
        if (descriptor_ < 0) fail(errno);
        const std::vector<std::uint8_t> header = packPcapFileHeader();
        if (const int error = writeWhole(header)) {
            ::close(descriptor_);
            fail(error);
        }
    }
    ~RecordFile() { ::close(descriptor_); }
    RecordFile(const RecordFile&) = delete;
    RecordFile& operator=(const RecordFile&) = delete;

    /// Appends records, which stand one behind another. If not all find room, what is left of a torn one is
    /// cut off again. Returns 0 or the error, and counts those that are whole.
    int append(std::span<const std::uint8_t> records, std::uint64_t& count) {
        const std::uint64_t before = size_;
        const int error = writeWhole(records);
        const WholeRecords whole = wholeRecords(records, static_cast<std::size_t>(size_ - before));
        count = whole.count;
        if (error == 0) return 0;
        size_ = before + whole.bytes;
        // Where even that fails, readers stop before the torn record.
        [[maybe_unused]] const int cut = ::ftruncate(descriptor_, static_cast<off_t>(size_));
        return error;
    }

    std::uint64_t size() const { return size_; }

 private:
    [[noreturn]] void fail(int error) const {
        throw RecordingError(
            fmt::format("cannot record to {}: {}{}", file_.string(), std::strerror(error), remedyFor(error)));
    }

    int writeWhole(std::span<const std::uint8_t> bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) return errno;
            if (written == 0) return EIO;
            size_ += static_cast<std::uint64_t>(written);
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
        return 0;
    }

    std::filesystem::path file_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

struct Queue {
    std::vector<std::uint8_t> records;
    std::uint64_t count = 0;
};

}  // namespace

struct Recorder::Impl {
    explicit Impl(const RecorderConfig& config)
        : path(config.file), queueBytes(config.queueBytes), file(config.file, config.replacesFile) {
        waiting.records.reserve(queueBytes);  // costs address space only until it is used
        inWork.records.reserve(queueBytes);
        published.bytes = file.size();
        thread = std::jthread([this] { writeUntilDone(); });
    }

    void record(const Datagram& datagram) {
        const std::lock_guard lock(mutex);
        const std::size_t size = datagram.bytes.size();
        const bool hasRoom =
            size <= kMaxRecordedPayload && waiting.records.size() + size + kPcapRecordOverhead <= queueBytes;
        if (isDone || !hasRoom) {
            ++published.dropped;
            return;
        }
        Datagram known = datagram;
        known.to.isIpv6 = known.from.isIpv6;  // where a socket does not tell where a packet arrived
        appendPcapRecord(waiting.records, known);
        ++waiting.count;
        arrived.notify_one();
    }

    void finish() {
        {
            const std::lock_guard lock(mutex);
            isDone = true;
            arrived.notify_one();
        }
        if (thread.joinable()) thread.join();
    }

    void writeUntilDone() {
        while (takeWaiting()) {
            std::uint64_t written = 0;
            const int error = file.append(inWork.records, written);
            const std::lock_guard lock(mutex);
            published.packets += written;
            published.bytes = file.size();
            if (error != 0) return giveUp(error, inWork.count - written);
        }
    }

    /// False when there is nothing left and there will not be.
    bool takeWaiting() {
        std::unique_lock lock(mutex);
        arrived.wait(lock, [this] { return isDone || waiting.count > 0; });
        inWork.records.clear();
        inWork.count = 0;
        std::swap(waiting, inWork);
        return inWork.count > 0;
    }

    void giveUp(int error, std::uint64_t lost) {
        isDone = true;
        published.dropped += lost + waiting.count;
        published.failure =
            fmt::format("recording to {} ended after {} packets, which are whole: {}{}", path.string(),
                        published.packets, std::strerror(error), remedyFor(error));
    }

    const std::filesystem::path path;
    const std::size_t queueBytes;
    RecordFile file;
    mutable std::mutex mutex;
    std::condition_variable arrived;
    Queue waiting;
    Queue inWork;  ///< Of the writing thread alone.
    RecorderStatus published;
    bool isDone = false;
    std::jthread thread;
};

Recorder::Recorder(const RecorderConfig& config) : impl_(std::make_unique<Impl>(config)) {}

Recorder::~Recorder() {
    impl_->finish();
}

void Recorder::record(const Datagram& datagram) {
    impl_->record(datagram);
}

RecorderStatus Recorder::status() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->published;
}

void Recorder::finish() {
    impl_->finish();
}

}  // namespace hazer::protocol
