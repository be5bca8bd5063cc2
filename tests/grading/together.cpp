// Each job has a stack of its own, stops at its call and goes on with its answer. They take turns on one
// thread.
#include "tests/grading/together.hpp"

#include "tests/together.hpp"

#include <boost/context/fiber.hpp>
#include <boost/context/protected_fixedsize_stack.hpp>

#include <algorithm>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <utility>

namespace rt::grading {

namespace {

using boost::context::fiber;
using boost::context::stack_context;

constexpr std::size_t most_jobs = 256, stack_size = std::size_t{256} << 10;

/// Stacks with a page below that nobody may touch, kept from one run of jobs to the next.
struct KeptStacks {
    static std::vector<stack_context>& kept() {
        static std::vector<stack_context> stacks;
        return stacks;
    }
    stack_context allocate() const {
        if (kept().empty()) return boost::context::protected_fixedsize_stack(stack_size).allocate();
        const stack_context stack = kept().back();
        kept().pop_back();
        return stack;
    }
    void deallocate(stack_context& stack) const noexcept { kept().push_back(stack); }
};

class Jobs {
public:
    Jobs(std::size_t count, const std::function<void(std::size_t)>& job) : count_(count), job_(job) {}

    void run();
    bool are_one_by_one() const { return one_by_one_; }
    bool wait_for(Call& call);
    bool answer_waiting();

private:
    /// One of those that are under way; one after the other.
    struct Place {
        fiber stopped;  // nothing when it is done
        Call* call = nullptr;
    };

    fiber work(fiber&& scheduler);

    std::size_t count_, next_ = 0;
    const std::function<void(std::size_t)>& job_;
    std::map<std::size_t, std::exception_ptr> thrown_;
    std::vector<std::unique_ptr<Place>> places_;
    fiber scheduler_;
    Place* current_ = nullptr;
    bool one_by_one_ = false;
};

Jobs* jobs = nullptr;  // those that run now

fiber Jobs::work(fiber&& scheduler) {
    scheduler_ = std::move(scheduler);
    while (next_ < count_) {
        const std::size_t i = next_++;
        try {
            job_(i);
        } catch (...) {
            thrown_[i] = std::current_exception();
            next_ = count_;
        }
    }
    return std::move(scheduler_);
}

bool Jobs::wait_for(Call& call) {
    current_->call = &call;
    scheduler_ = std::move(scheduler_).resume();
    return call.answer.has_value();
}

bool Jobs::answer_waiting() {
    std::vector<Call*> waiting;
    for (const auto& place : places_)
        if (place->call) waiting.push_back(std::exchange(place->call, nullptr));
    if (!waiting.empty() && !answer(waiting)) one_by_one_ = true;
    return !waiting.empty();
}

void Jobs::run() {
    for (std::size_t i = 0; i < std::min(count_, most_jobs); ++i)
        places_.push_back(
            std::make_unique<Place>(Place{fiber(std::allocator_arg, KeptStacks(), [this](fiber&& scheduler) {
                return work(std::move(scheduler));
            })}));
    while (!places_.empty()) {
        for (const auto& place : places_) {
            current_ = place.get();
            place->stopped = std::move(place->stopped).resume();
        }
        std::erase_if(places_, [](const auto& place) { return !place->stopped; });
        answer_waiting();
    }
    if (!thrown_.empty()) std::rethrow_exception(thrown_.begin()->second);
}

void run_together(std::size_t count, const std::function<void(std::size_t)>& job) {
    if (jobs) {  // a job that has jobs of its own
        for (std::size_t i = 0; i < count; ++i) job(i);
        return;
    }
    Jobs own(count, job);
    jobs = &own;
    try {
        own.run();
    } catch (...) {
        jobs = nullptr;
        throw;
    }
    jobs = nullptr;
}

const bool is_set = (test::together_elsewhere = run_together, true);

}  // namespace

bool is_together() { return jobs && !jobs->are_one_by_one(); }

bool answered_together(Call& call) { return jobs->wait_for(call); }

bool answer_waiting() { return jobs && jobs->answer_waiting(); }

}  // namespace rt::grading
