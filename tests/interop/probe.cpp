// Listens as hazer does, and for every line on stdin prints what stands, as one line of JSON:
//   interop_probe [--artnet ADDRESS PORT_ADDRESSES] [--sacn INTERFACE UNIVERSES]     lists such as 1,2,3
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/number_list.h"
#include "protocol/receiver.h"
#include "protocol/sacn_receiver.h"

namespace {

using namespace hazer;
using nlohmann::json;

json describe(const protocol::UniverseStatus& status) {
    json sources = json::array();
    for (const protocol::SourceStatus& source : status.sources) {
        sources.push_back({{"name", source.name},
                           {"address", source.address},
                           {"priority", source.priority},
                           {"alive", source.isAlive},
                           {"packets", source.packetCount},
                           {"late", source.lateCount}});
    }
    return {{"protocol", status.universe.transport == protocol::Transport::kSacn ? "sacn" : "artnet"},
            {"universe", status.universe.number},
            {"lost", status.isLost},
            {"packets", status.packetCount},
            {"sources", sources},
            {"slots", status.look.slots}};
}

class Probe {
 public:
    void listenToArtNet(const std::string& address, const std::string& portAddresses) {
        protocol::ReceiverConfig config;
        config.address = address;
        config.portAddresses = app::parseNumberList(portAddresses, 0, 32767).value();
        artNet_ = std::make_unique<protocol::Receiver>(config, store_);
    }

    void listenToSacn(const std::string& interface, const std::string& universes) {
        protocol::SacnReceiverConfig config;
        config.interface = interface;
        config.universes = app::parseNumberList(universes, 1, 63999).value();
        sacn_ = std::make_unique<protocol::SacnReceiver>(config, store_);
    }

    json report() {
        json universes = json::array();
        for (const auto& status : store_.status(protocol::Clock::now()))
            universes.push_back(describe(status));
        json all{{"universes", universes}};
        if (artNet_) all["artnet"] = artNetCounters();
        if (sacn_) all["sacn"] = sacnCounters();
        return all;
    }

 private:
    json artNetCounters() const {
        const protocol::ReceiverCounters counters = artNet_->counters();
        return {{"late", counters.late}, {"polls", counters.polls}, {"malformed", counters.malformed}};
    }

    json sacnCounters() const {
        const protocol::SacnReport report = sacn_->report();
        json discovered = json::array();
        for (const auto& source : report.discovered) {
            discovered.push_back({{"name", source.name}, {"universes", source.universes}});
        }
        return {{"late", report.counters.late},           {"ignored", report.counters.ignored},
                {"malformed", report.counters.malformed}, {"terminations", report.counters.terminations},
                {"syncs", report.counters.syncs},         {"discovered", discovered}};
    }

    protocol::UniverseStore store_;
    std::unique_ptr<protocol::Receiver> artNet_;
    std::unique_ptr<protocol::SacnReceiver> sacn_;
};

}  // namespace

int main(int argumentCount, char** arguments) try {
    const std::vector<std::string> words(arguments + 1, arguments + argumentCount);
    Probe probe;
    for (std::size_t i = 0; i + 2 < words.size(); i += 3) {
        if (words[i] == "--artnet") probe.listenToArtNet(words[i + 1], words[i + 2]);
        if (words[i] == "--sacn") probe.listenToSacn(words[i + 1], words[i + 2]);
    }
    for (std::string line; std::getline(std::cin, line);) std::cout << probe.report() << std::endl;
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "interop_probe: %s\n", error.what());
    return 1;
}
