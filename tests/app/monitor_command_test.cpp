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

test::ProcessResult monitor(std::uint16_t port, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "monitor");
    arguments.insert(arguments.end(), {"--port", std::to_string(port)});
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

TEST(MonitorCommand, HearsTheInputsOfAShow) {
    const test::TemporaryFolder folder;
    const std::string show = (folder.path() / "show.toml").string();
    folder.write(
        "show.toml",
        "[[input]]\naddress='127.0.0.1'\n[[fixture]]\nname='a'\ngdtf='par-rgbw'\nmode='x'\nuniverse=9\n"
        "slot=1\n");
    const test::ProcessResult result = monitor(freePort(), {show, "--json", "--for", "0.5"});
    const auto json = nlohmann::json::parse(result.output);
    ASSERT_EQ(json["universes"].size(), 2U) << result.output;
    EXPECT_EQ(json["universes"][0]["asked"], false);
    EXPECT_EQ(json["universes"][1]["universe"], 9);
    EXPECT_EQ(json["universes"][1]["asked"], true);
}

TEST(MonitorCommand, WrongUsageIsExitCode1) {
    const auto code = [](const std::vector<std::string>& arguments) {
        return test::runProcess(HAZER_PROGRAM, arguments).exitCode;
    };
    EXPECT_EQ(code({"monitor", "--for", "0"}), 1);
    EXPECT_EQ(code({"monitor", "--slots", "-1"}), 1);
    EXPECT_EQ(code({"monitor", "/nowhere/a.toml", "--for", "1"}), 2);
}

}  // namespace
}  // namespace hazer::app
