// The judge's end: one worker at a time, started when it is needed and anew after it died.
#include "tests/grading/judge.hpp"

#include "common/grading/judged.hpp"
#include "common/image/descriptor.hpp"
#include "common/math/input_error.hpp"
#include "common/math/stopwatch.hpp"
#include "common/math/todo.hpp"
#include "common/sandbox/isolation.hpp"
#include "common/sandbox/sandbox.hpp"
#include "common/sandbox/system_files.hpp"
#include "common/terminal/core_time.hpp"
#include "tests/catch.hpp"
#include "tests/grading/together.hpp"
#include "tests/own_options.hpp"
#include "tests/support.hpp"
#include "tests/together.hpp"

#include <fmt/format.h>

#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <map>
#include <mutex>
#include <set>

namespace rt::grading {

namespace {

/// How many objects a worker is to know by their numbers, and how many bytes of them; then both ends forget.
constexpr std::size_t most_known = 256;
constexpr std::size_t most_known_bytes = std::size_t{64} << 20;

/// What a worker may use. Calls, and all of them together, have limits of their own on their time.
Limits worker_limits() {
    Limits limits;
    limits.cpu_seconds = 300;
    limits.wall_seconds = 3600;
    limits.process_memory = std::uint64_t{2} << 30;
    limits.memory = std::uint64_t{1} << 30;
    return limits;
}

test::OwnOption worker_program("--worker", "file", "the program that answers the tests' calls");
test::OwnOption isolation("--isolation", "level", "of its box");
test::OwnOption call_limit("--call-seconds", "number", "what one call may take; default: 10");
test::OwnOption judge_limit("--judge-seconds", "number", "what all of them may take; default: 300");

std::string required(const test::OwnOption& option) {
    if (option.values.empty())
        throw InputError(fmt::format("{} is missing: ./course grade starts the judges", option.name));
    return option.values.back();
}

double seconds_of(const test::OwnOption& option, double otherwise) {
    return option.values.empty() ? otherwise : std::stod(option.values.back());
}

/// Ends this judge for what is no worker's doing, so that no test fails by it: its report comes to no end, by
/// which whoever started it knows (common/grading/run_judge.hpp).
[[noreturn]] void fail_as_judge(const std::string& why) {
    std::cerr << "judge: " << why << std::endl;
    std::_Exit(2);
}

/// What `action` returns; what it throws is no worker's doing.
template <class Action>
auto own_work(Action action) {
    try {
        return action();
    } catch (const std::exception& error) {
        fail_as_judge(error.what());
    }
}

class Worker {
public:
    Worker() : Worker(Descriptor(Channel::make_file())) {}

    Channel channel;
    std::map<std::pair<std::type_index, std::size_t>, std::uint32_t> known;
    std::size_t known_bytes = 0;
    bool forgets = false;  // the next call tells it to

    bool is_alive() const { return !boxed.ended(); }

    /// How it ended, once it is not alive; ends it where it is.
    NoAnswer death(const std::string& what) {
        const Ending ending = own_work([&] { return boxed.wait(); });
        const char* how = ending.end == End::Memory                                   ? "too much memory"
                          : ending.end == End::CpuTime || ending.end == End::WallTime ? "timed out"
                                                                                      : "crashed";
        return {how, fmt::format("{} {}", what, in_words(ending, box.limits))};
    }

private:
    explicit Worker(const Descriptor& file)
        : channel(file.number, Side::Judge), box(box_of(required(worker_program))), boxed(run(file)) {}

    static Sandbox box_of(const std::filesystem::path& program) {
        Sandbox box;
        box.isolation = isolation_named(required(isolation));
        box.limits = worker_limits();
        box.mounts = library_mounts();
        box.mounts.push_back({program.string(), "/worker"});
        return box;
    }

    Boxed run(const Descriptor& file) const {
        const int descriptors[] = {file.number};
        return start(box, {seen_from(box, required(worker_program))}, descriptors);
    }

    Sandbox box;
    Boxed boxed;
};

// A killed grader takes its judges with it, and they their boxes.
const bool ends_with_grader = prctl(PR_SET_PDEATHSIG, SIGKILL) == 0;

// The tests' clock: what calls have taken. What they take to get there and back does not count.
double seconds_in_calls = 0;
const bool clock_is_set = (
    test::running_seconds = [] { return seconds_in_calls; }, true);

std::unique_ptr<Worker> worker;
std::recursive_mutex one_at_a_time;
std::set<std::uint32_t> endless;  // functions that did not return once, and are not asked again

/// What one call may take. The longest that a solution makes takes less than a second.
double call_seconds() {
    static const double limit = seconds_of(call_limit, 10);
    return limit;
}
/// And all tests of the chapter. What has ended before counts; calls after that have no answer.
double judge_seconds() {
    static const double limit = seconds_of(judge_limit, 300);
    return limit;
}

/// Whether more has passed, of the time that a machine with nothing else to do would have taken: marks do not
/// depend on how many programs share the processors.
class Timer {
public:
    bool is_past(double limit) const {
        const double passed = watch.seconds();
        if (passed <= limit) return false;
        const CoreTime own = core_time(getpid());
        return own.running <= 0 || passed > limit * (1 + own.waiting / own.running);
    }

private:
    Stopwatch watch;
};

int open_callbacks = 0;  // a worker waits for the results of so many
struct OpenCallback {
    OpenCallback() { ++open_callbacks; }
    ~OpenCallback() { --open_callbacks; }
    OpenCallback(const OpenCallback&) = delete;
    OpenCallback& operator=(const OpenCallback&) = delete;
};

const Timer since_start;
bool out_of_time = false;

/// Nothing more is expected of this worker.
[[noreturn]] void give_up(const NoAnswer& why) {
    worker.reset();
    throw why;
}
[[noreturn]] void give_up(const std::string& why) { give_up(NoAnswer("crashed", why)); }

Message wait_for_message(std::uint32_t number, std::string_view name) {
    const Timer since_call;
    bool late = false;
    std::optional<Message> message = worker->channel.receive(
        [&] { return worker->is_alive() && !(late = since_call.is_past(call_seconds())); });
    if (message) return std::move(*message);
    if (!late) give_up(worker->death(std::string(name)));
    endless.insert(number);
    give_up(NoAnswer("timed out", fmt::format("{} did not return in {:g} s", name, call_seconds())));
}

/// What a worker says in words, its beginning: it goes into a report a test.
std::string text_of(const Message& message) {
    constexpr std::size_t most = 4000;
    const bool whole = message.bytes.size() <= most;
    const std::string text(reinterpret_cast<const char*>(message.bytes.data()),
                           whole ? message.bytes.size() : most);
    return whole ? text : text + " …";
}

void answer_callback(const Message& message, std::string_view name, const Callbacks& callbacks) {
    if (message.number >= callbacks.size()) give_up(fmt::format("{} called back what there is not", name));
    Reader in(message.bytes);
    Writer out;
    const OpenCallback open;
    try {
        callbacks[message.number](in, out);
    } catch (const BadBytes& error) {
        give_up(fmt::format("{} called back with nonsense: {}", name, error.what()));
    } catch (...) {
        worker.reset();  // it still waits for the result
        throw;
    }
    if (!worker) throw NoAnswer("crashed", fmt::format("{} was called back and lost", name));
    worker->channel.send(Kind::Result, 0, out.bytes());
}

void forget_if_full() {
    if (worker->known.size() < most_known && worker->known_bytes < most_known_bytes) return;
    worker->known.clear();
    worker->known_bytes = 0;
    worker->forgets = true;
}

void start_worker() {
    // What did not come to its first call three times will not the next time, and takes its time for that.
    static int failed = 0;
    static std::optional<NoAnswer> hopeless;
    if (failed == 3) throw NoAnswer(*hopeless);
    try {
        worker = own_work([] { return std::make_unique<Worker>(); });
        const Message message = wait_for_message(UINT32_MAX, "the program, before anything was called,");
        if (message.kind != Kind::Ready) give_up("the program did not wait for calls");
        failed = 0;
    } catch (const NoAnswer& why) {
        ++failed;
        hopeless = why;
        throw;
    }
}

CATCH_TRANSLATE_EXCEPTION(const NoAnswer& error) {
    if (test::stopped.empty()) test::stopped = error.how;
    return error.what();
}

}  // namespace

namespace {

/// What came of a call: its result, or what it threw.
std::vector<std::byte> outcome_of(Message&& message, std::string_view name) {
    switch (message.kind) {
        case Kind::Return:
            return std::move(message.bytes);
        case Kind::Missing:
            throw NotImplemented(text_of(message));
        case Kind::Refused:
            throw InputError(text_of(message));
        case Kind::Threw:
            throw std::runtime_error(text_of(message));
        default:
            give_up(fmt::format("{} answered what there is not", name));
    }
}

/// Puts the answers to calls where they belong. Throws BadBytes where they are none.
void read_answers(const Message& message, std::span<Call* const> calls) {
    Reader in(message.bytes);
    for (Call* const call : calls) {
        const auto kind = in.read<std::uint32_t>();
        const std::span<const std::byte> bytes = in.take(in.read<std::uint64_t>());
        call->answer = Message{static_cast<Kind>(kind), 0, {bytes.begin(), bytes.end()}};
    }
    if (!in.at_end()) throw BadBytes("too much");
}

std::uint32_t number_with_forget(std::uint32_t number) {
    return std::exchange(worker->forgets, false) ? number | forget : number;
}

}  // namespace

void refuse_hopeless(std::uint32_t number, std::string_view name) {
    const std::lock_guard lock(one_at_a_time);
    out_of_time = out_of_time || since_start.is_past(judge_seconds());
    if (out_of_time)
        throw NoAnswer("timed out",
                       fmt::format("the chapter's tests took longer than {:g} s", judge_seconds()));
    if (endless.contains(number))
        throw NoAnswer("timed out", fmt::format("{} did not return before, and {}", name, not_called_again));
}

bool answer(std::span<Call* const> calls) {
    const std::lock_guard lock(one_at_a_time);
    try {
        if (!worker) start_worker();
        Writer out;
        for (const Call* const call : calls) {
            out(number_with_forget(call->number));
            out(static_cast<std::uint64_t>(call->arguments.size()));
            out.raw(call->arguments.data(), call->arguments.size());
        }
        worker->channel.send(Kind::Calls, static_cast<std::uint32_t>(calls.size()), out.bytes());
        const Message message = wait_for_message(UINT32_MAX, "one of several calls");
        if (message.kind != Kind::Answers) give_up("calls were not answered");
        read_answers(message, calls);
        forget_if_full();
        return true;
    } catch (const std::exception& error) {
        // Which of them it was, and what happened, shows when they are asked for one by one. Where together
        // they take longer than one may, they always are.
        const auto* const none = dynamic_cast<const NoAnswer*>(&error);
        if (none && none->how == "timed out") test::together_elsewhere = nullptr;
        worker.reset();
        for (Call* const call : calls) call->answer.reset();
        return false;
    }
}

std::optional<std::vector<std::byte>> ask(std::uint32_t number, std::string_view name,
                                          std::span<const std::byte> arguments, const Callbacks& callbacks) {
    const std::lock_guard lock(one_at_a_time);
    if (is_together() && callbacks.empty() && open_callbacks == 0) {
        Call call{number, arguments, {}};
        if (!answered_together(call)) return {};
        return outcome_of(std::move(*call.answer), name);
    }
    if (answer_waiting()) return {};  // what the worker knows may have changed: arguments are written anew
    if (!worker) start_worker();
    worker->channel.send(Kind::Call, number_with_forget(number), arguments);
    for (;;) {
        Message message = wait_for_message(number, name);
        if (message.kind == Kind::Callback) {
            answer_callback(message, name, callbacks);
        } else {
            forget_if_full();
            return outcome_of(std::move(message), name);
        }
    }
}

Known known(std::type_index type, std::span<const std::byte> bytes) {
    const std::lock_guard lock(one_at_a_time);
    if (!worker) start_worker();
    const std::size_t content =
        std::hash<std::string_view>()({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    const auto next = static_cast<std::uint32_t>(worker->known.size());
    const auto [entry, is_new] = worker->known.try_emplace({type, content}, next);
    if (is_new) worker->known_bytes += bytes.size();
    return {entry->second, is_new};
}

void add_counts(Reader& in) {
    const auto seconds = in.read<double>();
    if (seconds >= 0) seconds_in_calls += seconds;
    const auto rays = in.read<RayCounts>();
    const auto searches = in.read<SearchCounts>();
    RayCounts& ours = ray_counts();
    ours.camera += rays.camera;
    ours.shadow += rays.shadow;
    ours.reflection += rays.reflection;
    ours.refraction += rays.refraction;
    ours.random_numbers += rays.random_numbers;
    search_counts().cells += searches.cells;
    search_counts().shapes += searches.shapes;
}

void returned_nonsense(std::string_view name, const char* what) {
    const std::lock_guard lock(one_at_a_time);
    give_up(fmt::format("{} returned nonsense: {}", name, what));
}

}  // namespace rt::grading
