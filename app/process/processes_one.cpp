#include "app/process/processes.hpp"

// The program built without FFSTUDY_MPI.
namespace ff::app {

Processes::Processes() = default;
Processes::~Processes() = default;

std::vector<bool> Processes::share_finished(std::vector<bool> finished) const {
    return finished;
}

void Processes::send(std::span<const std::uint64_t> /*message*/) const {}
void Processes::assist(const std::function<void()>& /*work*/) const {}
void Processes::receive(const std::function<bool(std::span<const std::uint64_t>)>& /*deliver*/) const {}

}  // namespace ff::app
