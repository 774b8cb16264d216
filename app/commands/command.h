// What the commands of the program share: how they are added, how their help looks, what they return.
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace hazer::app {

inline constexpr int kExitOk = 0;
inline constexpr int kExitUsage = 1;
inline constexpr int kExitBadInput = 2;
inline constexpr int kExitNoGl = 3;

/// Runs a command whose options have been read, and returns the program's exit code. Throws what main() turns
/// into a sentence.
using Command = std::function<int()>;

// Each adds one command with its options to the program; if it is the one asked for, `chosen` becomes it.
void addLiveCommand(CLI::App& program, Command& chosen);
void addDemoCommand(CLI::App& program, Command& chosen);
void addRenderCommand(CLI::App& program, Command& chosen);
void addReportCommand(CLI::App& program, Command& chosen);
void addSendCommand(CLI::App& program, Command& chosen);
void addMonitorCommand(CLI::App& program, Command& chosen);
void addRecordCommand(CLI::App& program, Command& chosen);
void addReplayCommand(CLI::App& program, Command& chosen);
void addInspectCommand(CLI::App& program, Command& chosen);
void addExplainCommand(CLI::App& program, Command& chosen);
void addLibraryCommand(CLI::App& program, Command& chosen);

/// Lets the help of a command (or of the program) begin with examples, one a line.
void beginHelpWith(CLI::App& command, const std::string& examples);

/// A number from `smallest` to `largest`. CLI::Range lets NaN through, which is neither above nor below.
CLI::Validator numberFrom(double smallest, double largest);

}  // namespace hazer::app
