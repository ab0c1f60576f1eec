#include "core/support/child_process.hpp"

#include "core/support/error.hpp"
#include "core/support/processor_time.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/timerfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <system_error>
#include <utility>

namespace ff {

/// A file descriptor of this process.
class Descriptor {
  public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&&) = delete;

    [[nodiscard]] int number() const { return number_; }
    [[nodiscard]] bool is_open() const { return number_ >= 0; }
    void close() {
        if (number_ >= 0) ::close(number_);
        number_ = -1;
    }

  private:
    int number_;
};

/// The two ends of a pipe, or of a pair of sockets.
struct Pipe {
    Descriptor read;
    Descriptor write;
};

namespace {

constexpr std::size_t kept_of_errors = 2000;
constexpr int milliseconds_between_looks = 5;

[[noreturn]] void fail_to_start(const std::string& program, int error) {
    throw IoError("{}: cannot be started ({}). Check its name and its installation.", program,
                  std::generic_category().message(error));
}

Pipe make_pipe(const std::string& program) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail_to_start(program, errno);
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// A pipe that can be written to without a signal where nobody reads.
Pipe make_socket(const std::string& program) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail_to_start(program, errno);
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// Between fork and exec only what a signal handler may do as well.
[[noreturn]] void become(char* const* argv, const char* folder, ChildStreams streams, ChildSignals signals,
                         pid_t parent, int report) {
    sigset_t none;
    sigemptyset(&none);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() == parent && (signals == ChildSignals::as_usual || ::setpgid(0, 0) == 0) &&
        (folder == nullptr || ::chdir(folder) == 0) && ::dup2(streams.input, STDIN_FILENO) >= 0 &&
        ::dup2(streams.output, STDOUT_FILENO) >= 0 && ::dup2(streams.errors, STDERR_FILENO) >= 0 &&
        ::pthread_sigmask(SIG_SETMASK, &none, nullptr) == 0) {
        std::signal(SIGPIPE, SIG_DFL);
        std::signal(SIGXFSZ, SIG_DFL);
        ::execvp(argv[0], argv);
    }
    const int error = errno;
    [[maybe_unused]] const auto written = ::write(report, &error, sizeof error);
    ::_exit(127);
}

/// Appends what there is to read; closes the descriptor at the end.
void read_some(Descriptor& from, std::string& to) {
    std::array<char, 1 << 16> buffer;  // NOLINT(cppcoreguidelines-pro-type-member-init): read fills it
    const ssize_t got = ::read(from.number(), buffer.data(), buffer.size());
    if (got > 0)
        to.append(buffer.data(), static_cast<std::size_t>(got));
    else if (got == 0 || (errno != EINTR && errno != EAGAIN))
        from.close();
}

Descriptor timer(double seconds, const std::string& program) {
    Descriptor timer(::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK));
    itimerspec when{};
    double whole = 0;
    when.it_value.tv_nsec = static_cast<long>(std::modf(seconds, &whole) * 1e9);
    when.it_value.tv_sec = static_cast<time_t>(whole);
    if (!timer.is_open() || ::timerfd_settime(timer.number(), 0, &when, nullptr) != 0) fail_to_start(program, errno);
    return timer;
}

/// Waits for the end of a process, or for the timer. @return false where the timer came first
bool ends_before(const Descriptor& timer, pid_t child, int& status) {
    // Kernels before 5.3 have no descriptors of processes; poll leaves out what is negative.
    const Descriptor process(static_cast<int>(::syscall(SYS_pidfd_open, child, 0)));
    while (wait_counting(child, status, WNOHANG) == 0) {
        std::array<pollfd, 2> wait{pollfd{timer.number(), POLLIN, 0}, pollfd{process.number(), POLLIN, 0}};
        if (::poll(wait.data(), wait.size(), process.is_open() ? -1 : milliseconds_between_looks) > 0 &&
            wait[0].revents != 0)
            return false;
    }
    return true;
}

void end_child(pid_t child) {
    ::kill(-child, SIGKILL);
    wait_for_child(child);
}

/// How a process ended that prints nothing more but may still be running, or why it is ended here.
void take_end(const Descriptor& end, pid_t child, ChildOutput& result) {
    int status = 0;
    if (result.end == ChildOutput::End::exited && !ends_before(end, child, status))
        result.end = ChildOutput::End::too_slow;
    if (result.end != ChildOutput::End::exited) {
        end_child(child);
    } else if (WIFSIGNALED(status)) {
        result.end = ChildOutput::End::killed;
        result.code = WTERMSIG(status);
    } else {
        result.code = WEXITSTATUS(status);
    }
}

void keep_the_last(std::string& errors) {
    if (errors.size() > 2 * kept_of_errors) errors.erase(0, errors.size() - kept_of_errors);
}

/// Waits for output of a child, and reads some of it. @return false where the child is to be ended, for the reason in
/// `result`
bool read_or_refuse(const Descriptor& end, Descriptor& output, Descriptor& errors, std::uint64_t most_output,
                    ChildOutput& result) {
    std::array<pollfd, 3> wait{pollfd{end.number(), POLLIN, 0}, pollfd{output.number(), POLLIN, 0},
                               pollfd{errors.number(), POLLIN, 0}};
    if (::poll(wait.data(), wait.size(), -1) < 0) return true;
    if (wait[1].revents != 0) read_some(output, result.output);
    if (wait[2].revents != 0) read_some(errors, result.errors);
    keep_the_last(result.errors);
    if (result.output.size() > most_output) result.end = ChildOutput::End::too_large;
    if (wait[0].revents != 0) result.end = ChildOutput::End::too_slow;
    return result.end == ChildOutput::End::exited;
}

}  // namespace

pid_t start_child(const ChildCommand& command, ChildStreams streams, ChildSignals signals) {
    std::vector<std::string> words = command.words;
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const std::string folder = command.folder.string();
    Pipe report = make_pipe(command.words.front());
    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child == 0)
        become(argv.data(), folder.empty() ? nullptr : folder.c_str(), streams, signals, parent, report.write.number());
    if (child < 0) fail_to_start(command.words.front(), errno);
    report.write.close();
    int error = 0;  // the pipe closes without one where the program has started
    if (::read(report.read.number(), &error, sizeof error) == static_cast<ssize_t>(sizeof error)) {
        wait_for_child(child);
        fail_to_start(command.words.front(), error);
    }
    return child;
}

int wait_for_child(pid_t child) {
    int status = 0;
    while (wait_counting(child, status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

ChildOutput read_from_child(const ChildCommand& command, std::uint64_t most_output, double deadline) {
    const std::string& program = command.words.front();
    const Descriptor nothing(::open("/dev/null", O_RDONLY | O_CLOEXEC));
    if (!nothing.is_open()) fail_to_start(program, errno);
    Pipe output = make_pipe(program);
    Pipe errors = make_pipe(program);
    const Descriptor end = timer(deadline, program);
    const pid_t child =
        start_child(command, {nothing.number(), output.write.number(), errors.write.number()}, ChildSignals::none);
    output.write.close();
    errors.write.close();

    ChildOutput result;
    while ((output.read.is_open() || errors.read.is_open()) &&
           read_or_refuse(end, output.read, errors.read, most_output, result)) {
    }
    take_end(end, child, result);
    return result;
}

struct ChildConversation::Ends {
    Pipe input;
    Pipe output;
    Pipe errors;
    pid_t child = -1;  ///< process that is spoken with; -1 once the conversation is over
};

ChildConversation::ChildConversation(const ChildCommand& command)
    : program_(command.words.front()),
      ends_(std::make_unique<Ends>(Ends{make_socket(program_), make_pipe(program_), make_pipe(program_)})) {
    ends_->child =
        start_child(command, {ends_->input.read.number(), ends_->output.write.number(), ends_->errors.write.number()},
                    ChildSignals::none);
    ends_->input.read.close();
    ends_->output.write.close();
    ends_->errors.write.close();
}

ChildConversation::~ChildConversation() {
    if (ends_->child > 0) end_child(ends_->child);
}

ChildOutput ChildConversation::ask(std::string_view line, const Size& size, std::uint64_t most_output,
                                   double deadline) {
    Ends& ends = *ends_;
    ChildOutput result;
    const Descriptor end = timer(deadline, program_);
    // A line is shorter than a socket holds, and one is under way at a time: it is sent at once, or nobody reads.
    const ssize_t written = ::send(ends.input.write.number(), line.data(), line.size(), MSG_NOSIGNAL);
    bool over = written != static_cast<ssize_t>(line.size());
    while (!over) {
        if (result.output.size() == size(result.output)) return result;
        over = !read_or_refuse(end, ends.output.read, ends.errors.read, most_output, result) ||
               !ends.output.read.is_open();
    }
    take_end(end, std::exchange(ends.child, -1), result);
    const bool ended_by_itself = result.end == ChildOutput::End::exited || result.end == ChildOutput::End::killed;
    while (ends.errors.read.is_open() && ended_by_itself) read_some(ends.errors.read, result.errors);
    keep_the_last(result.errors);
    return result;
}

}  // namespace ff
