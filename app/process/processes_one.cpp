#include "app/process/processes.hpp"

// The program built without FFSTUDY_MPI.
namespace ff::app {

Processes::Processes() = default;
Processes::~Processes() = default;

std::vector<bool> Processes::share_finished_units(std::vector<bool> finished) const {
    return finished;
}

void Processes::send(const studies::UnitRecord& /*record*/) const {}
void Processes::assist(const std::function<void()>& /*work*/) const {}
void Processes::receive(const studies::Deliver& /*deliver*/) const {}

}  // namespace ff::app
