// Ctrl-C as something to ask for, so that work ends in its own time.
#pragma once

namespace hazer::app {

/// While it lives, Ctrl-C and SIGTERM do not end the program but are remembered. One at a time.
class Interrupt {
 public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    /// Has somebody asked to end?
    bool asked() const;

    /// Throws std::runtime_error if somebody has, so that work in hand is cleared away on the way out.
    void throwIfAsked() const;
};

}  // namespace hazer::app
