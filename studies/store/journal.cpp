#include "studies/store/journal.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>
#include <sys/vfs.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

namespace ff::studies {
namespace {

/// Magic numbers of linux/magic.h and statfs(2), written out: several are missing from the headers of the system.
constexpr std::array<std::uint64_t, 16> network_file_systems{
    0x6969,      // NFS
    0x517b,      // SMB
    0xff534d42,  // CIFS
    0xfe534d42,  // SMB2
    0x5346414f,  // AFS
    0x6b414653,  // AFS of the kernel
    0x73757245,  // Coda
    0x00c36400,  // Ceph
    0x0bd00bd0,  // Lustre
    0x47504653,  // GPFS
    0x19830326,  // BeeGFS
    0xaad7aaea,  // PanFS
    0x01161970,  // GFS2
    0x7461636f,  // OCFS2
    0x01021997,  // 9P
    0x65735546,  // FUSE: sshfs, GlusterFS and others
};

}  // namespace

Journal journal_for(std::uint64_t file_system_type) {
    const bool network = std::find(network_file_systems.begin(), network_file_systems.end(), file_system_type) !=
                         network_file_systems.end();
    return network ? Journal::rollback : Journal::write_ahead;
}

Journal journal_in(const std::filesystem::path& folder) {
    struct statfs information {};
    const std::filesystem::path place = folder.empty() ? "." : folder;
    if (::statfs(place.c_str(), &information) != 0) {
        throw IoError(fmt::format("{}: its file system cannot be looked at ({}). Check that the folder exists.",
                                  place.string(), std::generic_category().message(errno)));
    }
    // The field is signed on some systems; magic numbers have 32 bits.
    return journal_for(static_cast<std::uint32_t>(information.f_type));
}

}  // namespace ff::studies
