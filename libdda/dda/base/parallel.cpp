#include "dda/base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <exception>
#include <latch>
#include <vector>

namespace dda {

namespace {
/// Indices below which handing work to another thread costs more than it saves (a hand-over takes about 10
/// us).
constexpr std::size_t shortest_shared_loop = 512;
}  // namespace

struct Crew::Pool {
    explicit Pool(int helpers) : threads(static_cast<std::size_t>(helpers)) {}
    boost::asio::thread_pool threads;
};

Crew::Crew(int threads) : threads_(std::max(threads, 1)) {
    if (threads_ > 1) pool_ = std::make_unique<Pool>(threads_ - 1);
}

Crew::~Crew() = default;

void Crew::for_ranges(std::size_t count, const std::function<void(std::size_t, std::size_t)>& body) const {
    if (!pool_ || count < shortest_shared_loop) {
        if (count > 0) body(0, count);
        return;
    }
    const auto parts = static_cast<std::size_t>(threads_);
    in_parts([&](std::size_t part) { body(count * part / parts, count * (part + 1) / parts); });
}

void Crew::for_tasks(std::size_t count, const std::function<void(std::size_t, std::size_t)>& body) const {
    if (!pool_ || count < 2) {
        for (std::size_t k = 0; k < count; ++k) body(k, 0);
        return;
    }
    std::atomic<std::size_t> next{0};
    in_parts([&](std::size_t part) {
        for (std::size_t k = next++; k < count; k = next++) body(k, part);
    });
}

void Crew::in_parts(const std::function<void(std::size_t)>& body) const {
    const auto parts = static_cast<std::size_t>(threads_);
    std::vector<std::exception_ptr> failures(parts);
    std::latch done(static_cast<std::ptrdiff_t>(parts - 1));
    const auto work = [&](std::size_t part) {
        try {
            body(part);
        } catch (...) {
            failures[part] = std::current_exception();
        }
    };
    for (std::size_t part = 1; part < parts; ++part) {
        boost::asio::post(pool_->threads, [&, part] {
            work(part);
            done.count_down();
        });
    }
    work(0);
    done.wait();
    for (const auto& failure : failures) {
        if (failure) std::rethrow_exception(failure);
    }
}

}  // namespace dda
