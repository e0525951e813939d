#include "blockgen/sampling/random_stream.hpp"

#include <Random123/philox.h>

namespace rockslope::blockgen {

namespace {

/// FNV-1a hash, 64 bits.
std::uint64_t hash_of(const std::string& name) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, const std::string& name) : seed_(seed), name_(hash_of(name)) {}

double RandomStream::draw(std::uint64_t purpose, std::int64_t line, std::uint64_t index) const {
    const r123::Philox4x64::ctr_type counter = {{index, static_cast<std::uint64_t>(line), purpose, 0}};
    const r123::Philox4x64::key_type key = {{seed_, name_}};
    const std::uint64_t bits = r123::Philox4x64()(counter, key)[0];
    return (static_cast<double>(bits >> 12u) + 0.5) * 0x1p-52;
}

}  // namespace rockslope::blockgen
