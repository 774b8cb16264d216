#include "tests/support/datagram.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <bit>
#include <stdexcept>

namespace hazer::test {
namespace {

sockaddr toAddress(std::uint32_t host, std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(host);
    address.sin_port = htons(port);
    return std::bit_cast<sockaddr>(address);
}

int openUdpSocket() {
    const int handle = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (handle < 0) throw std::runtime_error("no UDP socket can be opened");
    return handle;
}

}  // namespace

void sendDatagram(std::uint16_t port, std::string_view bytes) {
    const int handle = openUdpSocket();
    const sockaddr to = toAddress(INADDR_LOOPBACK, port);
    const ssize_t sent = sendto(handle, bytes.data(), bytes.size(), 0, &to, sizeof(to));
    close(handle);
    if (sent < 0) throw std::runtime_error("a datagram could not be sent");
}

OccupiedPort::OccupiedPort() : socket_(openUdpSocket()), port_(0) {
    sockaddr address = toAddress(INADDR_ANY, 0);
    socklen_t size = sizeof(address);
    if (bind(socket_, &address, size) != 0 || getsockname(socket_, &address, &size) != 0) {
        throw std::runtime_error("no UDP port can be bound");
    }
    port_ = ntohs(std::bit_cast<sockaddr_in>(address).sin_port);
}

OccupiedPort::~OccupiedPort() {
    close(socket_);
}

}  // namespace hazer::test
