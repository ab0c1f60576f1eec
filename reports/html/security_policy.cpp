#include "reports/html/security_policy.hpp"

#include "core/support/contract.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>

namespace ff::reports {
namespace {

/// 'sha256-...' in base 64, as policies write it.
std::string source(std::string_view text) {
    std::array<unsigned char, 32> digest{};
    const int done = EVP_Digest(text.data(), text.size(), digest.data(), nullptr, EVP_sha256(), nullptr);
    FF_ENSURE(done == 1);
    std::array<unsigned char, 45> base64{};  // 4 letters for 3 bytes, and an end
    EVP_EncodeBlock(base64.data(), digest.data(), static_cast<int>(digest.size()));
    return fmt::format(" 'sha256-{}'", std::string(base64.begin(), base64.end() - 1));
}

std::string sources(std::string_view directive, std::span<const std::string_view> texts) {
    std::string out(directive);
    for (const std::string_view text : texts) out += source(text);
    return texts.empty() ? out + " 'none'" : out;
}

}  // namespace

std::string security_policy(std::span<const std::string_view> styles, std::span<const std::string_view> scripts) {
    return fmt::format("default-src 'none'; {}; {}; base-uri 'none'; form-action 'none'", sources("style-src", styles),
                       sources("script-src", scripts));
}

}  // namespace ff::reports
