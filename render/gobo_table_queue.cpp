#include "render/gobo_table_queue.h"

#include <utility>

namespace hazer::render {

GoboTableQueue::~GoboTableQueue() {
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
}

void GoboTableQueue::request(const GoboTableKey& key, std::shared_ptr<const GoboPicture> picture) {
    {
        const std::scoped_lock lock(mutex_);
        requests_.push_back({key, std::move(picture)});
    }
    changed_.notify_all();
    if (!thread_.joinable()) thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

std::vector<GoboTableQueue::Finished> GoboTableQueue::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(finished_, {});
}

void GoboTableQueue::wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return requests_.empty() && !isBuilding_; });
}

std::optional<GoboTableQueue::Request> GoboTableQueue::nextRequest(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    if (!changed_.wait(lock, stop, [this] { return !requests_.empty(); })) return std::nullopt;
    Request request = std::move(requests_.front());
    requests_.pop_front();
    isBuilding_ = true;
    return request;
}

void GoboTableQueue::work(const std::stop_token& stop) {
    while (const std::optional<Request> request = nextRequest(stop)) {
        GoboTable table = build_(*request->picture, request->key.profile, stop);
        if (stop.stop_requested()) return;
        {
            const std::scoped_lock lock(mutex_);
            finished_.push_back({request->key, std::move(table)});
            isBuilding_ = false;
        }
        changed_.notify_all();
    }
}

}  // namespace hazer::render
