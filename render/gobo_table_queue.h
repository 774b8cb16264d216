// Builds tables of gobos on a thread of its own, one after the other. Knows nothing of OpenGL.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "render/gobo_table.h"

namespace hazer::render {

class GoboTableQueue {
 public:
    struct Finished {
        GoboTableKey key;
        GoboTable table;
    };

    using Builder = std::function<GoboTable(const GoboPicture&, const GoboProfile&, const std::stop_token&)>;

    explicit GoboTableQueue(Builder build = buildGoboTable) : build_(std::move(build)) {}
    /// Gives up what is not finished, and waits for the thread: some milliseconds.
    ~GoboTableQueue();
    GoboTableQueue(const GoboTableQueue&) = delete;
    GoboTableQueue& operator=(const GoboTableQueue&) = delete;

    /// Has a table built after those asked for before; asked twice, it is built twice. The first call starts
    /// the thread.
    void request(const GoboTableKey& key, std::shared_ptr<const GoboPicture> picture);

    /// What has been finished since the last call.
    std::vector<Finished> take();

    /// Waits until all that was asked for is finished.
    void wait();

 private:
    struct Request {
        GoboTableKey key;
        std::shared_ptr<const GoboPicture> picture;
    };
    std::optional<Request> nextRequest(const std::stop_token& stop);
    void work(const std::stop_token& stop);

    Builder build_;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Request> requests_;
    std::vector<Finished> finished_;
    bool isBuilding_ = false;
    std::jthread thread_;
};

}  // namespace hazer::render
