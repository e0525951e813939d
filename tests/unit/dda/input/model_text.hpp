#pragma once

#include <gtest/gtest.h>

#include <string>

#include "dda/input/read_run.hpp"
#include "support/replaced.hpp"
#include "unit/dda/input/small_models.hpp"

namespace rockslope::io_test {

/// Reads a model text, also with parts of it replaced. Its block file is "two.blocks", of two_block_mesh().
class ModelTextTest : public ::testing::Test {
  protected:
    explicit ModelTextTest(std::string text) : text_(std::move(text)) {
        blockgen::write_block_file(folder / "two.blocks", two_block_mesh());
    }
    dda::RunInput read(const std::string& text, dda::RunReadOptions options = {}) const {
        return dda::read_run(folder.write("run.toml", text), options);
    }
    /// The text with `before`, which it must contain, replaced by `after`.
    std::string changed(const std::string& before, const std::string& after) const {
        return replaced(text_, before, after);
    }
    /// The error text for the changed text, without the folder's path.
    std::string error_with(const std::string& before, const std::string& after) const {
        std::string error = error_of([&] { read(changed(before, after)); });
        const std::string prefix = folder.path().string() + "/";
        for (std::size_t found; (found = error.find(prefix)) != std::string::npos;)
            error.erase(found, prefix.size());
        return error;
    }

    Folder folder;

  private:
    std::string text_;
};

}  // namespace rockslope::io_test
