// Each job has a stack of its own, stops at its call and goes on with its answer. They take turns on one
// thread.
#include "tests/grading/together.hpp"

#include "tests/together.hpp"

#include <sys/mman.h>
#include <ucontext.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <new>
#include <utility>

namespace rt::grading {

namespace {

constexpr std::size_t most_jobs = 256, stack_size = std::size_t{256} << 10, page = 4096;

/// Memory for a stack, and below it a page that nobody may touch.
class Stack {
public:
    Stack()
        : memory(::mmap(nullptr, stack_size, PROT_READ | PROT_WRITE,
                        MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK, -1, 0)) {
        if (memory == MAP_FAILED || ::mprotect(memory, page, PROT_NONE) != 0) throw std::bad_alloc();
    }
    ~Stack() { ::munmap(memory, stack_size); }
    Stack(const Stack&) = delete;
    Stack& operator=(const Stack&) = delete;

    void* const memory;
};

/// The stack of the job at a place: kept from one run to the next.
const Stack& stack(std::size_t place) {
    static std::vector<std::unique_ptr<Stack>> stacks;
    while (stacks.size() <= place) stacks.push_back(std::make_unique<Stack>());
    return *stacks[place];
}

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
        ucontext_t context;
        Call* call = nullptr;
        bool is_done = false;
    };

    static void begin();
    void work();
    void make(Place& place, const Stack& its_stack);
    void go_on(Place& place);

    std::size_t count_, next_ = 0;
    const std::function<void(std::size_t)>& job_;
    std::map<std::size_t, std::exception_ptr> thrown_;
    std::vector<std::unique_ptr<Place>> places_;
    ucontext_t scheduler_;
    Place* current_ = nullptr;
    bool one_by_one_ = false;
};

Jobs* jobs = nullptr;  // those that run now

void Jobs::begin() { jobs->work(); }

void Jobs::work() {
    while (next_ < count_) {
        const std::size_t i = next_++;
        try {
            job_(i);
        } catch (...) {
            thrown_[i] = std::current_exception();
            next_ = count_;
        }
    }
    current_->is_done = true;
}

void Jobs::go_on(Place& place) {
    current_ = &place;
    ::swapcontext(&scheduler_, &place.context);
    current_ = nullptr;
}

bool Jobs::wait_for(Call& call) {
    Place& place = *current_;
    place.call = &call;
    ::swapcontext(&place.context, &scheduler_);
    return call.answer.has_value();
}

bool Jobs::answer_waiting() {
    std::vector<Call*> waiting;
    for (const auto& place : places_)
        if (place->call) waiting.push_back(std::exchange(place->call, nullptr));
    if (!waiting.empty() && !answer(waiting)) one_by_one_ = true;
    return !waiting.empty();
}

void Jobs::make(Place& place, const Stack& its_stack) {
    ::getcontext(&place.context);
    place.context.uc_stack.ss_sp = its_stack.memory;
    place.context.uc_stack.ss_size = stack_size;
    place.context.uc_link = &scheduler_;
    ::makecontext(&place.context, &Jobs::begin, 0);
}

void Jobs::run() {
    for (std::size_t i = 0; i < std::min(count_, most_jobs); ++i)
        make(*places_.emplace_back(std::make_unique<Place>()), stack(i));
    while (!places_.empty()) {
        for (const auto& place : places_) go_on(*place);
        std::erase_if(places_, [](const auto& place) { return place->is_done; });
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
