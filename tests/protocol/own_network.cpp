#include "tests/protocol/own_network.h"

#include <fmt/format.h>
#include <sched.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <fstream>

namespace hazer::protocol::test {
namespace {

// Somebody who is not root may still be root of a user namespace, where the system allows that.
bool unshareNetwork() {
    if (unshare(CLONE_NEWNET) == 0) return true;
    const uid_t user = getuid();
    const gid_t group = getgid();
    if (unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0) return false;
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/uid_map") << fmt::format("0 {} 1", user);
    std::ofstream("/proc/self/gid_map") << fmt::format("0 {} 1", group);
    return true;
}

}  // namespace

bool ip(const std::string& arguments) {
    return std::system(fmt::format("ip {} > /dev/null 2>&1", arguments).c_str()) == 0;
}

std::string enterOwnNetwork() {
    if (!unshareNetwork()) {
        return fmt::format("this user may not make a network namespace: {}", std::strerror(errno));
    }
    const bool isMade = ip("link set lo up") && ip("link add viz0 type veth peer name viz1") &&
                        ip("addr add 10.77.0.1/24 dev viz0") && ip("link set viz0 up") &&
                        ip("link set viz1 up") && ip("route add 239.255.0.0/16 dev viz0");
    if (!isMade) return "the program 'ip' (iproute2) is missing or cannot make a veth pair here";
    ip("-6 addr add fd77::1/64 dev viz0 nodad");  // where there is IPv6
    return {};
}

}  // namespace hazer::protocol::test
