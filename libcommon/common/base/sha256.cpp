#include "common/base/sha256.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <fstream>
#include <vector>

#include "common/base/output_error.hpp"

namespace rockslope {

namespace {

using Word = std::uint32_t;
using State = std::array<Word, 8>;

constexpr std::size_t block_bytes = 64;

constexpr bool is_prime(Word n) {
    for (Word d = 2; d * d <= n; ++d)
        if (n % d == 0) return false;
    return true;
}

constexpr std::array<Word, 64> first_primes() {
    std::array<Word, 64> primes{};
    Word candidate = 2;
    for (Word& prime : primes) {
        while (!is_prime(candidate)) ++candidate;
        prime = candidate++;
    }
    return primes;
}

/// The first 32 bits of the fractional part of the square or cube root of n, as the standard defines its
/// constants. Finds the largest r with r^degree <= n 2^(32 degree) bit by bit; the low 32 bits are the
/// fraction.
constexpr Word root_fraction(Word n, int degree) {
    using Wide = unsigned __int128;
    std::uint64_t root = 0;
    for (int bit = 36; bit >= 0; --bit) {
        const std::uint64_t trial = root | (std::uint64_t{1} << bit);
        const Wide power = degree == 2 ? Wide{trial} * trial : Wide{trial} * trial * trial;
        if (power <= (Wide{n} << (32 * degree))) root = trial;
    }
    return static_cast<Word>(root);
}

constexpr std::array<Word, 64> round_constants() {
    std::array<Word, 64> constants{};
    const auto primes = first_primes();
    for (std::size_t i = 0; i < 64; ++i) constants[i] = root_fraction(primes[i], 3);
    return constants;
}

constexpr State initial_state() {
    State state{};
    const auto primes = first_primes();
    for (std::size_t i = 0; i < 8; ++i) state[i] = root_fraction(primes[i], 2);
    return state;
}

std::array<Word, 64> schedule(const unsigned char* block) {
    std::array<Word, 64> w{};
    for (std::size_t i = 0; i < 16; ++i)
        w[i] = Word{block[4 * i]} << 24 | Word{block[4 * i + 1]} << 16 | Word{block[4 * i + 2]} << 8 |
               Word{block[4 * i + 3]};
    for (std::size_t i = 16; i < 64; ++i) {
        const Word s0 = std::rotr(w[i - 15], 7) ^ std::rotr(w[i - 15], 18) ^ (w[i - 15] >> 3);
        const Word s1 = std::rotr(w[i - 2], 17) ^ std::rotr(w[i - 2], 19) ^ (w[i - 2] >> 10);
        w[i] = w[i - 16] + s0 + w[i - 7] + s1;
    }
    return w;
}

void compress(State& state, const unsigned char* block) {
    static constexpr auto k = round_constants();
    const auto w = schedule(block);
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t i = 0; i < 64; ++i) {
        const Word s1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
        const Word t1 = h + s1 + ((e & f) ^ (~e & g)) + k[i] + w[i];
        const Word s0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
        const Word t2 = s0 + ((a & b) ^ (a & c) ^ (b & c));
        h = g;
        g = f;
        f = e;
        e = d + t1;
        d = c;
        c = b;
        b = a;
        a = t1 + t2;
    }
    const Word added[] = {a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < 8; ++i) state[i] += added[i];
}

}  // namespace

Sha256::Sha256() : state_(initial_state()) {}

void Sha256::add(std::string_view bytes) {
    length_ += bytes.size();
    if (!rest_.empty()) {
        const std::size_t count = std::min(block_bytes - rest_.size(), bytes.size());
        rest_ += bytes.substr(0, count);
        bytes.remove_prefix(count);
        if (rest_.size() < block_bytes) return;
        compress(state_, reinterpret_cast<const unsigned char*>(rest_.data()));
        rest_.clear();
    }
    for (; bytes.size() >= block_bytes; bytes.remove_prefix(block_bytes))
        compress(state_, reinterpret_cast<const unsigned char*>(bytes.data()));
    rest_ = bytes;
}

std::string Sha256::digest() const {
    // The padding: a one bit, zeros, and the length in bits.
    std::string tail = rest_ + '\x80';
    while (tail.size() % block_bytes != block_bytes - 8) tail += '\0';
    const std::uint64_t bits = length_ * 8;
    for (int shift = 56; shift >= 0; shift -= 8) tail += static_cast<char>(bits >> shift & 0xff);
    State state = state_;
    for (std::size_t i = 0; i < tail.size(); i += block_bytes)
        compress(state, reinterpret_cast<const unsigned char*>(tail.data() + i));
    std::string text;
    for (const Word word : state)
        for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[word >> shift & 15];
    return text;
}

Sha256 sha256_of_beginning(const std::filesystem::path& file, std::uintmax_t length) {
    Sha256 digest;
    std::ifstream stream(file, std::ios::binary);
    std::vector<char> piece(1 << 16);
    while (length > 0) {
        const auto wanted = std::min<std::uintmax_t>(length, piece.size());
        if (!stream.read(piece.data(), static_cast<std::streamsize>(wanted)))
            throw OutputError(file, "cannot be read");
        digest.add({piece.data(), wanted});
        length -= wanted;
    }
    return digest;
}

std::string sha256(std::string_view bytes) {
    Sha256 digest;
    digest.add(bytes);
    return digest.digest();
}

}  // namespace rockslope
