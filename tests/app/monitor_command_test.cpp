// hazer monitor as a person would run it, with a desk on loopback.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <asio/io_context.hpp>
#include <asio/ip/udp.hpp>
#include <atomic>
#include <nlohmann/json.hpp>
#include <thread>

#include "protocol/sender.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace hazer::app {
namespace {

using ::testing::HasSubstr;

// The system gave it to nobody a moment ago.
std::uint16_t freePort() {
    asio::io_context context;
    const asio::ip::udp::socket socket(context, {asio::ip::address_v4::loopback(), 0});
    return socket.local_endpoint().port();
}

/// Sends universe 5 while a command runs.
class Desk {
 public:
    explicit Desk(std::uint16_t port) : thread_([this, port] { send(port); }) {}
    ~Desk() {
        isOver_ = true;
        thread_.join();
    }

 private:
    void send(std::uint16_t port) {
        protocol::ArtNetSender sender("127.0.0.1", port);
        const std::vector<std::uint8_t> slots{10, 20};
        while (!isOver_) {
            try {
                sender.send(5, slots);
            } catch (const std::exception&) {  // nobody listens yet
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
    }

    std::atomic<bool> isOver_ = false;
    std::thread thread_;
};

/// Inputs that nothing from outside reaches.
constexpr const char* kLoopback =
    "[[input]]\naddress='127.0.0.1'\n[[input]]\nprotocol='sacn'\ninterface='lo'\n";

test::ProcessResult monitor(std::uint16_t port, std::vector<std::string> arguments,
                            const std::string& patch = "") {
    const test::TemporaryFolder folder;
    const std::string show = folder.write("show.toml", kLoopback + patch).string();
    arguments.insert(arguments.begin(), {"monitor", show});
    arguments.insert(arguments.end(), {"--port", std::to_string(port), "--sacn-port", "0"});
    const Desk desk(port);
    return test::runProcess(HAZER_PROGRAM, arguments);
}

TEST(MonitorCommand, PrintsOneTableWhereNobodyWatches) {
    const test::ProcessResult result = monitor(freePort(), {"--for", "0.5"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_THAT(result.output, HasSubstr("Art-Net 5 (0:0:5)      live"));
    EXPECT_THAT(result.output, HasSubstr("127.0.0.1"));
    EXPECT_EQ(result.output.find('\x1b'), std::string::npos) << "nothing for terminals";
}

TEST(MonitorCommand, PrintsOneJsonDocument) {
    const test::ProcessResult result = monitor(freePort(), {"--json", "--for", "0.5", "--slots", "5"});
    const auto json = nlohmann::json::parse(result.output);
    ASSERT_EQ(json["universes"].size(), 1U) << result.output;
    EXPECT_EQ(json["universes"][0]["universe"], 5);
    EXPECT_EQ(json["universes"][0]["slots"][1], 20);
    EXPECT_EQ(json["universes"][0]["sources"][0]["address"], "127.0.0.1");
    EXPECT_GT(json["packets"], 1);
}

TEST(MonitorCommand, FollowsWithALineASecond) {
    const test::ProcessResult result = monitor(freePort(), {"--json", "--follow", "--for", "2"});
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 2) << result.output;
    const auto last = nlohmann::json::parse(result.output.substr(result.output.find('\n') + 1));
    EXPECT_EQ(last["universes"].size(), 1U);
}

TEST(MonitorCommand, AsksForTheUniversesOfAShow) {
    const test::ProcessResult result =
        monitor(freePort(), {"--json", "--for", "0.5"},
                "[[fixture]]\nname='a'\ngdtf='par-rgbw'\nmode='x'\nuniverse=9\nslot=1\n");
    const auto json = nlohmann::json::parse(result.output);
    ASSERT_EQ(json["universes"].size(), 2U) << result.output;
    EXPECT_EQ(json["universes"][0]["asked"], false);
    EXPECT_EQ(json["universes"][1]["universe"], 9);
    EXPECT_EQ(json["universes"][1]["asked"], true);
}

/// In a network of its own, with a cable between two interfaces. Universe 7 is announced; 300 by itself is
/// not heard by anybody who does not ask.
TEST(MonitorCommand, WithoutAShowHearsWhateverThereIs) {
    const std::string script =
        "ip link set lo up && ip link add viz0 type veth peer name viz1 && ip addr add 10.77.0.1/24 dev viz0 "
        "&& ip link set viz0 up && ip link set viz1 up || exit 77\n"
        "log=$(mktemp)\n"
        "\"$0\" monitor --json --for 3 --slots 7 2>\"$log\" & monitor=$!\n"
        // A source announces itself as it starts, and then again after ten seconds: it has to be heard.
        "looks=0; until grep -q listening \"$log\" || [ $looks -ge 100 ]; do sleep 0.1; looks=$((looks + "
        "1)); done\n"
        "\"$0\" send --protocol sacn --universe 7 --slot 1=9 --interface viz0 --seconds 3 >&2 &\n"
        "\"$0\" send --universe 5 --to 127.0.0.1 --seconds 3 >&2 &\n"
        "wait $monitor; code=$?; wait; cat \"$log\" >&2; rm \"$log\"; exit $code";
    const test::ProcessResult result =
        test::runProcess("/usr/bin/unshare", {"-rn", "sh", "-c", script, HAZER_PROGRAM});
    constexpr int kNoNetwork = 77;
    if (result.exitCode == kNoNetwork || result.errors.find("unshare:") != std::string::npos)
        GTEST_SKIP() << "no network of our own: " << result.errors;
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const auto json = nlohmann::json::parse(result.output);
    ASSERT_EQ(json["universes"].size(), 2U) << result.output;
    EXPECT_EQ(json["universes"][0]["protocol"], "artnet");
    EXPECT_EQ(json["universes"][1]["protocol"], "sacn");
    EXPECT_EQ(json["universes"][1]["slots"][0], 9);
    EXPECT_EQ(json["sacn"][0]["announced"][0]["universes"], nlohmann::json({7}));
    EXPECT_THAT(result.errors, HasSubstr("listening to Art-Net on UDP port 6454, sACN on UDP port 5568"));
}

TEST(MonitorCommand, WrongUsageIsExitCode1) {
    const auto code = [](const std::vector<std::string>& arguments) {
        return test::runProcess(HAZER_PROGRAM, arguments).exitCode;
    };
    EXPECT_EQ(code({"monitor", "--for", "0"}), 1);
    EXPECT_EQ(code({"monitor", "--slots", "-1"}), 1);
    EXPECT_EQ(code({"monitor", "--universe", "0"}), 1);
    EXPECT_EQ(code({"monitor", "--universe", "1-64000"}), 1);
    EXPECT_EQ(code({"monitor", "/nowhere/a.toml", "--for", "1"}), 2);
}

}  // namespace
}  // namespace hazer::app
