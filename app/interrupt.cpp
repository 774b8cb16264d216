#include "app/interrupt.h"

#include <csignal>
#include <stdexcept>

namespace hazer::app {
namespace {

volatile std::sig_atomic_t interruptAsked = 0;

void rememberInterrupt(int) {
    interruptAsked = 1;
}

}  // namespace

Interrupt::Interrupt() {
    interruptAsked = 0;
    std::signal(SIGINT, rememberInterrupt);
    std::signal(SIGTERM, rememberInterrupt);
}

Interrupt::~Interrupt() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

bool Interrupt::asked() const {
    return interruptAsked != 0;
}

void Interrupt::throwIfAsked() const {
    if (asked()) throw std::runtime_error("stopped before the work was done");
}

}  // namespace hazer::app
