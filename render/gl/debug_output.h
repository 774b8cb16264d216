// KHR_debug where the context has it: errors are counted and logged.
#pragma once

namespace hazer::render::gl {

/// Switches the context's messages on, on the thread that causes them. Does nothing where KHR_debug is
/// missing (it is newer than 4.1).
void enableDebugOutput();

/// Errors the context has reported since the start of the program. Tests expect 0.
int debugErrorCount();

/// Names a pass in a debugger such as RenderDoc, for as long as it lives. Costs nothing without KHR_debug.
class DebugGroup {
 public:
    explicit DebugGroup(const char* name);
    ~DebugGroup();
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;
};

}  // namespace hazer::render::gl
