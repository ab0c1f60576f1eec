#include "app/process/processes.hpp"

#include "app/process/signals.hpp"

#include "core/support/error.hpp"

#include <mpi.h>

#include <chrono>
#include <exception>
#include <limits>
#include <thread>
#include <utility>

// An error of MPI ends the whole job with a message of its own: MPI_ERRORS_ARE_FATAL is its default.
namespace ff::app {
namespace {

constexpr int leader = 0;
enum Tag : int { a_message, the_end, asked_to_end };

/// A message without content.
void tell(int process, Tag what) {
    MPI_Send(nullptr, 0, MPI_UINT64_T, process, what, MPI_COMM_WORLD);
}

/// A blocking call would keep a core busy that shoots rays.
void pause() {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// Called by processes other than the leader: receives a message of the leader. @return false when it is the last one
bool listen(std::mutex& talking, bool& told) {
    const std::lock_guard lock(talking);
    if (stop_flag() && !std::exchange(told, true)) tell(leader, asked_to_end);
    int waiting = 0;
    MPI_Status status;
    MPI_Iprobe(leader, MPI_ANY_TAG, MPI_COMM_WORLD, &waiting, &status);
    if (waiting == 0) return true;
    MPI_Recv(nullptr, 0, MPI_UINT64_T, leader, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (status.MPI_TAG == the_end) return false;
    told = true;
    ask_for_the_end();
    return true;
}

}  // namespace

Processes::Processes() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
    if (provided < MPI_THREAD_SERIALIZED) {
        throw UserError(
            "mpirun: this MPI allows no threads (the first process receives on one). Use one built with threads.");
    }
    int rank = 0;
    int count = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    part_ = {static_cast<std::uint64_t>(rank) + 1, static_cast<std::uint64_t>(count)};
}

Processes::~Processes() {
    // The others may be waiting for this process: leaving without a message to them makes mpirun end them, after the
    // error has been printed.
    if (std::uncaught_exceptions() == 0) MPI_Finalize();
}

std::vector<bool> Processes::share_finished(std::vector<bool> finished) const {
    std::uint64_t size = finished.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, leader, MPI_COMM_WORLD);
    std::vector<unsigned char> bytes(finished.begin(), finished.end());
    bytes.resize(size);
    MPI_Bcast(bytes.data(), static_cast<int>(size), MPI_UNSIGNED_CHAR, leader, MPI_COMM_WORLD);
    return {bytes.begin(), bytes.end()};
}

void Processes::send(std::span<const std::uint64_t> message) const {
    if (message.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw UserError("mpirun: a work unit is too large for one message. Take fewer patches, or use --shard.");
    const std::lock_guard lock(talking_);
    MPI_Send(message.data(), static_cast<int>(message.size()), MPI_UINT64_T, leader, a_message, MPI_COMM_WORLD);
}

void Processes::assist(const std::function<void()>& work) const {
    std::jthread listener([this] {
        for (bool told = false; listen(talking_, told);) pause();
    });
    try {
        work();
    } catch (...) {
        listener.detach();  // nobody will tell it of the end; the job ends with this process
        throw;
    }
    const std::lock_guard lock(talking_);
    tell(leader, the_end);
}

void Processes::receive(const std::function<bool(std::span<const std::uint64_t>)>& deliver) const {
    std::vector<std::uint64_t> words;
    const auto tell_all = [&](Tag what) {
        for (int process = 1; process < static_cast<int>(part_.count); ++process) tell(process, what);
    };
    bool told = false;
    for (std::uint64_t running = part_.count - 1; running > 0;) {
        if (stop_flag() && !std::exchange(told, true)) tell_all(asked_to_end);
        int waiting = 0;
        MPI_Status status;
        MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &waiting, &status);
        if (waiting == 0) {
            pause();
            continue;
        }
        int size = 0;
        MPI_Get_count(&status, MPI_UINT64_T, &size);
        words.resize(static_cast<std::size_t>(size));
        MPI_Recv(words.data(), size, MPI_UINT64_T, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
        if (status.MPI_TAG == the_end) {
            --running;
        } else if (status.MPI_TAG == asked_to_end) {
            ask_for_the_end();
        } else if (!deliver(words)) {
            return;
        }
    }
    tell_all(the_end);
}

}  // namespace ff::app
