#include "dda/base/parallel.hpp"

#include <atomic>

#include "dda/base/helpers.hpp"

namespace dda {

namespace {
/// Indices below which handing work to another thread costs more than it saves.
constexpr std::size_t shortest_shared_loop = 512;
}  // namespace

Crew::Crew(int threads) : threads_(std::max(threads, 1)) {
    if (threads_ > 1) helpers_ = std::make_unique<Helpers>(static_cast<std::size_t>(threads_) - 1);
}

Crew::~Crew() = default;

void Crew::for_ranges(std::size_t count, FunctionRef<void(std::size_t, std::size_t)> body) const {
    if (!helpers_ || count < shortest_shared_loop) {
        if (count > 0) body(0, count);
        return;
    }
    const auto parts = static_cast<std::size_t>(threads_);
    helpers_->work_together(
        [&](std::size_t part) { body(count * part / parts, count * (part + 1) / parts); });
}

void Crew::for_tasks(std::size_t count, FunctionRef<void(std::size_t, std::size_t)> body) const {
    if (!helpers_ || count < 2) {
        for (std::size_t k = 0; k < count; ++k) body(k, 0);
        return;
    }
    std::atomic<std::size_t> next{0};
    helpers_->work_together([&](std::size_t part) {
        for (std::size_t k = next++; k < count; k = next++) body(k, part);
    });
}

}  // namespace dda
