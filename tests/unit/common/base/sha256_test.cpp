#include "common/base/sha256.hpp"

#include <gtest/gtest.h>

namespace rockslope::sha256_test {
namespace {

// The examples of FIPS 180-4.
TEST(Sha256, GivesThePublishedDigests) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256(std::string(1000000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, TakesBytesInPiecesOfAnyLength) {
    std::string bytes;
    for (int k = 0; k < 1000; ++k) bytes += static_cast<char>(k * k);
    for (const std::size_t length : {1, 7, 63, 64, 65, 129, 1000}) {
        Sha256 digest;
        for (std::size_t at = 0; at < bytes.size(); at += length)
            digest.add(std::string_view(bytes).substr(at, length));
        EXPECT_EQ(digest.digest(), sha256(bytes)) << "pieces of " << length;
    }
}

}  // namespace
}  // namespace rockslope::sha256_test
