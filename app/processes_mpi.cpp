#include "app/processes.hpp"

#include "core/error.hpp"
#include "studies/record_words.hpp"

#include <mpi.h>

#include <chrono>
#include <exception>
#include <limits>
#include <thread>

// An error of MPI ends the whole job with a message of its own: MPI_ERRORS_ARE_FATAL is its default.
namespace ff::app {
namespace {

constexpr int leader = 0;
enum Tag : int { a_record, the_end };

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
    // The others may wait for this process: leaving without a word makes mpirun end them, after the message is out.
    if (std::uncaught_exceptions() == 0) MPI_Finalize();
}

std::vector<bool> Processes::share_finished_units(std::vector<bool> finished) const {
    std::uint64_t size = finished.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, leader, MPI_COMM_WORLD);
    std::vector<unsigned char> bytes(finished.begin(), finished.end());
    bytes.resize(size);
    MPI_Bcast(bytes.data(), static_cast<int>(size), MPI_UNSIGNED_CHAR, leader, MPI_COMM_WORLD);
    return {bytes.begin(), bytes.end()};
}

void Processes::send(const studies::UnitRecord& record) const {
    const auto words = studies::to_words(record);
    if (words.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw UserError("mpirun: a work unit is too large for one message. Take fewer patches, or use --shard.");
    MPI_Send(words.data(), static_cast<int>(words.size()), MPI_UINT64_T, leader, a_record, MPI_COMM_WORLD);
}

void Processes::send_end() const {
    MPI_Send(nullptr, 0, MPI_UINT64_T, leader, the_end, MPI_COMM_WORLD);
}

void Processes::receive(const studies::Deliver& deliver) const {
    std::vector<std::uint64_t> words;
    for (std::uint64_t running = part_.count - 1; running > 0;) {
        int waiting = 0;
        MPI_Status status;
        MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &waiting, &status);
        if (waiting == 0) {
            // A blocking call would keep a core busy that shoots rays.
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            continue;
        }
        int size = 0;
        MPI_Get_count(&status, MPI_UINT64_T, &size);
        words.resize(static_cast<std::size_t>(size));
        MPI_Recv(words.data(), size, MPI_UINT64_T, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
        if (status.MPI_TAG == the_end) {
            --running;
        } else if (!deliver(studies::from_words(words))) {
            return;
        }
    }
}

}  // namespace ff::app
