#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace rockslope::fuzz {

/// Damages a text like transfers and editors do: it changes bytes, removes, repeats or swaps pieces, and
/// inserts words that are difficult for readers. The same seed does the same damage.
class Mutator {
  public:
    explicit Mutator(unsigned long seed) : random_(seed) {}

    /// A random index below n; 0 if n is 0.
    std::size_t pick(std::size_t n) { return n == 0 ? 0 : random_() % n; }

    std::string of(std::string text) {
        static const std::vector<std::string> words = {
            "-1", "0", "1e308", "nan", "inf",          "\"",  "[", "]",
            "{",  "}", "\n",    "=",   "999999999999", "deg", ",", "#"};
        for (std::size_t k = 1 + pick(6); k > 0; --k) {
            const std::size_t at = pick(text.size()),
                              length = pick(std::min<std::size_t>(40, text.size() - at)),
                              other = pick(text.size());
            switch (pick(6)) {
                case 0:
                    if (!text.empty()) text[at] = static_cast<char>(random_() & 255u);
                    break;
                case 1:
                    text.erase(at, length);
                    break;
                case 2:
                    text.insert(other, text.substr(at, length));
                    break;
                case 3:
                    text.resize(at);
                    break;
                default:
                    text.replace(at, pick(4), words[pick(words.size())]);
            }
        }
        return text;
    }

  private:
    std::mt19937 random_;
};

}  // namespace rockslope::fuzz
