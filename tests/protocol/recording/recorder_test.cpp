#include "protocol/recording/recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "protocol/recording/pcap_format.h"
#include "protocol/recording/usb_wrapping.h"
#include "tests/protocol/recording/capture_builder.h"
#include "tests/support/temporary_folder.h"

namespace hazer::protocol::test {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr WallTime kStart{std::chrono::seconds(1'700'000'000)};

Datagram datagramOf(const Bytes& bytes, std::chrono::nanoseconds time = {}) {
    return {{{10, 0, 0, 5}, false, 6454}, {{10, 0, 0, 99}, false, 6454}, kStart + time, bytes};
}

Bytes numbered(std::uint32_t number) {
    return dmxDatagram({.slots = bigEndian32(number)});
}

class RecorderTest : public ::testing::Test {
 protected:
    hazer::test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "night.pcap";
};

TEST_F(RecorderTest, WritesWhatItsReaderGives) {
    const Bytes bytes = dmxDatagram({.sequence = 3});
    {
        Recorder recorder({.file = file_});
        recorder.record(datagramOf(bytes));
        IpEndpoint from{{}, true, 1234};
        from.address[0] = 0xFD;
        from.address[15] = 7;
        IpEndpoint to = from;
        to.port = 5568;
        recorder.record({from, to, kStart + 123'456'789ns, bytes});
    }
    const auto packets = readAll(*openRecording(file_));
    ASSERT_THAT(packets, SizeIs(2));
    EXPECT_EQ(packets[0].from, (IpEndpoint{{10, 0, 0, 5}, false, 6454}));
    EXPECT_EQ(packets[0].bytes, bytes);
    EXPECT_EQ(packets[1].time, 123'456'789ns);
    EXPECT_TRUE(packets[1].from.isIpv6);
    EXPECT_EQ(packets[1].from.address[15], 7);
    EXPECT_EQ(packets[1].to.port, 5568);
    EXPECT_EQ(packets[1].bytes, bytes);
}

// Worked out by hand: RFC 1071 over the header, and over the pseudo header, ports, length and payload.
TEST_F(RecorderTest, ChecksumsAreRight) {
    std::vector<std::uint8_t> record;
    appendPcapRecord(record, {{{10, 0, 0, 1}, false, 1}, {{10, 0, 0, 2}, false, 2}, kStart, Bytes{0xAB}});
    ASSERT_EQ(record.size(), 16u + 20u + 8u + 1u);
    const auto sum = [&](std::size_t first, std::size_t end) {
        std::uint32_t total = 0;
        for (std::size_t i = first; i < end; i += 2) {
            total += static_cast<std::uint32_t>(record[i] << 8 | (i + 1 < end ? record[i + 1] : 0));
        }
        while (total > 0xFFFF) total = (total & 0xFFFF) + (total >> 16);
        return total;
    };
    EXPECT_EQ(sum(16, 36), 0xFFFFu);
    const std::uint32_t pseudo = 0x0A00 + 0x0001 + 0x0A00 + 0x0002 + 17 + 9;
    std::uint32_t udp = sum(36, 45) + pseudo;
    while (udp > 0xFFFF) udp = (udp & 0xFFFF) + (udp >> 16);
    EXPECT_EQ(udp, 0xFFFFu);
}

TEST_F(RecorderTest, KeepsExistingFilesUnlessTold) {
    { Recorder recorder({.file = file_}); }
    EXPECT_THROW(Recorder({.file = file_}), RecordingError);
    try {
        Recorder recorder({.file = file_});
    } catch (const RecordingError& error) {
        EXPECT_THAT(error.what(), HasSubstr("--force"));
    }
    { Recorder recorder({.file = file_, .replacesFile = true}); }
    EXPECT_EQ(std::filesystem::file_size(file_), kPcapFileHeaderSize);
    EXPECT_THROW(Recorder({.file = folder_.path() / "none" / "a.pcap"}), RecordingError);
}

TEST_F(RecorderTest, FullDeviceIsSaidAtOnce) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full here";
    try {
        Recorder recorder({.file = "/dev/full", .replacesFile = true});
        FAIL();
    } catch (const RecordingError& error) {
        EXPECT_THAT(error.what(), HasSubstr("No space left on device; make room"));
    }
}

/// Lets files of this process grow to `bytes` only, as a full disk would.
class FileSizeLimit {
 public:
    explicit FileSizeLimit(rlim_t bytes) {
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
        handler_ = signal(SIGXFSZ, SIG_IGN);
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &before_);
        signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
    rlimit before_{};
    void (*handler_)(int) = SIG_DFL;
};

TEST_F(RecorderTest, FullDiskLeavesWholeRecords) {
    const std::size_t recordSize = 16 + 20 + 8 + numbered(0).size();
    const std::size_t fit = 100;
    Recorder recorder({.file = file_});
    {
        const FileSizeLimit limit(kPcapFileHeaderSize + fit * recordSize + recordSize / 2);
        for (std::uint32_t i = 0; i < 1000; ++i) recorder.record(datagramOf(numbered(i)));
        recorder.finish();
    }
    const RecorderStatus status = recorder.status();
    EXPECT_EQ(status.packets, fit);
    EXPECT_EQ(status.dropped, 1000 - fit);
    EXPECT_THAT(status.failure, HasSubstr("ended after 100 packets, which are whole: File too large"));
    EXPECT_EQ(std::filesystem::file_size(file_), kPcapFileHeaderSize + fit * recordSize);
    EXPECT_EQ(status.bytes, std::filesystem::file_size(file_));
    const auto reader = openRecording(file_);
    const auto packets = readAll(*reader);
    ASSERT_THAT(packets, SizeIs(fit));
    EXPECT_EQ(packets.back().bytes, numbered(fit - 1));
    EXPECT_THAT(reader->warnings(), IsEmpty());
    recorder.record(datagramOf(numbered(1)));
    EXPECT_EQ(recorder.status().dropped, 1000 - fit + 1);
}

// A disk that hangs: nothing is written, and yet nobody waits; what finds no room is counted.
TEST_F(RecorderTest, FullQueueDropsAndCounts) {
    ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
    std::uint64_t recorded = 0;
    std::jthread reader([&] {
        std::ifstream stream(file_, std::ios::binary);
        std::this_thread::sleep_for(200ms);
        std::vector<char> all((std::istreambuf_iterator<char>(stream)), {});
        recorded = all.size();
    });
    RecorderStatus status;
    {
        Recorder recorder({.file = file_, .replacesFile = true, .queueBytes = 64 * 1024});
        const auto start = std::chrono::steady_clock::now();
        for (std::uint32_t i = 0; i < 10'000; ++i) recorder.record(datagramOf(numbered(i)));
        EXPECT_LT(std::chrono::steady_clock::now() - start, 190ms);
        recorder.finish();
        status = recorder.status();
    }
    reader.join();
    EXPECT_GT(status.dropped, 0u);
    EXPECT_EQ(status.packets + status.dropped, 10'000u);
    EXPECT_EQ(recorded, status.bytes);
}

// A child records numbered packets and tells by a pipe which one it has handed over; it is killed in
// mid-work.
TEST_F(RecorderTest, SurvivesBeingKilled) {
    for (int round = 0; round < 5; ++round) {
        const std::filesystem::path file = folder_.path() / ("killed" + std::to_string(round));
        int pipes[2];
        ASSERT_EQ(pipe(pipes), 0);
        const pid_t child = fork();
        if (child == 0) {
            Recorder recorder({.file = file});
            for (std::uint32_t i = 0;; ++i) {
                recorder.record(datagramOf(numbered(i), i * 1ms));
                std::this_thread::sleep_for(1ms);
                if (write(pipes[1], &i, sizeof i) != sizeof i) _exit(1);
            }
        }
        close(pipes[1]);
        std::uint32_t handedOver = 0;
        while (handedOver < 50u + 13u * static_cast<std::uint32_t>(round)) {
            ASSERT_EQ(read(pipes[0], &handedOver, sizeof handedOver),
                      static_cast<ssize_t>(sizeof handedOver));
        }
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        std::uint32_t last = 0;
        while (read(pipes[0], &last, sizeof last) == static_cast<ssize_t>(sizeof last)) handedOver = last;
        close(pipes[0]);
        const auto packets = readAll(*openRecording(file));
        ASSERT_GE(packets.size(), handedOver) << "packets 0.." << handedOver << " were handed over";
        for (std::uint32_t i = 0; i < packets.size(); ++i) EXPECT_EQ(packets[i].bytes, numbered(i));
    }
}

TEST_F(RecorderTest, TakesPacketsOfSeveralThreads) {
    {
        Recorder recorder({.file = file_});
        std::vector<std::jthread> threads;
        for (int thread = 0; thread < 4; ++thread) {
            threads.emplace_back([&] {
                for (std::uint32_t i = 0; i < 1000; ++i) recorder.record(datagramOf(numbered(i)));
            });
        }
        threads.clear();
        recorder.finish();
        EXPECT_EQ(recorder.status().packets, 4000u);
        EXPECT_EQ(recorder.status().dropped, 0u);
    }
    EXPECT_THAT(readAll(*openRecording(file_)), SizeIs(4000));
}

TEST_F(RecorderTest, RefusesPayloadsThatNoDatagramHas) {
    Recorder recorder({.file = file_});
    recorder.record(datagramOf(Bytes(kMaxRecordedPayload)));
    recorder.record(datagramOf(Bytes(kMaxRecordedPayload + 1)));
    recorder.finish();
    EXPECT_EQ(recorder.status().packets, 1u);
    EXPECT_EQ(recorder.status().dropped, 1u);
}

TEST(UsbWrapping, ComesBackAsItWas) {
    const Bytes slots{1, 2, 3};
    UsbFrame frame{.line = 7, .name = "ENTTEC DMX USB PRO", .slots = slots};
    frame.source.transport = Transport::kDmx;
    frame.source.id = {1, 2, 3, 4, 5, 6, 7, 8};
    const std::vector<std::uint8_t> wrapped = wrapUsbFrame(frame, 9);
    EXPECT_TRUE(isWrappedUsbFrame(wrapped));
    const SacnPacket parsed = parseSacn(wrapped);
    const auto* data = std::get_if<SacnData>(&parsed);
    ASSERT_NE(data, nullptr);
    EXPECT_EQ(data->sequence, 9);
    const auto again = unwrapUsbFrame(*data);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->line, 7);
    EXPECT_EQ(again->source, frame.source);
    EXPECT_EQ(again->name, frame.name);
    EXPECT_TRUE(std::ranges::equal(again->slots, slots));
    for (std::size_t size = 0; size < wrapped.size(); ++size) isWrappedUsbFrame(prefixOf(wrapped, size));
}

}  // namespace
}  // namespace hazer::protocol::test
