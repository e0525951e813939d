#include "common/base/sha256.hpp"

#include <openssl/evp.h>
#include <algorithm>
#include <array>
#include <fstream>
#include <new>
#include <vector>

#include "common/base/output_error.hpp"

namespace rockslope {

namespace {

/// OpenSSL's functions fail here only where it has no memory.
void check(int outcome) {
    if (outcome != 1) throw std::bad_alloc();
}

}  // namespace

void Sha256::Free::operator()(evp_md_ctx_st* context) const {
    EVP_MD_CTX_free(context);
}

Sha256::Sha256() : context_(EVP_MD_CTX_new()) {
    check(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
}

Sha256::Sha256(const Sha256& other) : context_(EVP_MD_CTX_new()) {
    check(EVP_MD_CTX_copy_ex(context_.get(), other.context_.get()));
}

Sha256& Sha256::operator=(const Sha256& other) {
    *this = Sha256(other);
    return *this;
}

void Sha256::add(std::string_view bytes) {
    check(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()));
}

std::string Sha256::digest() const {
    Sha256 finished = *this;
    std::array<unsigned char, 32> bytes{};
    check(EVP_DigestFinal_ex(finished.context_.get(), bytes.data(), nullptr));
    std::string text;
    for (const unsigned char byte : bytes) {
        text += "0123456789abcdef"[byte >> 4];
        text += "0123456789abcdef"[byte & 15];
    }
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
