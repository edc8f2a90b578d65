// SPDX-License-Identifier: GPL-3.0-or-later
// Stands in for libFuzzer where there is no clang: NAME RUNS FOLDER runs every file of the folder,
// and then RUNS changed copies of them, the same ones every time.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

#include "tests/fuzz/target.h"

namespace {

using Data = std::vector<std::uint8_t>;

std::vector<Data> corpusIn(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        paths.push_back(entry.path());
    std::ranges::sort(paths); // the folder's order is no order
    std::vector<Data> corpus;
    for (const auto& path : paths) {
        std::ifstream in(path, std::ios::binary);
        corpus.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
    return corpus;
}

/// A few bytes changed, some of another input put in, or the end cut off.
Data changed(Data data, const std::vector<Data>& corpus, std::mt19937_64& random)
{
    const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
    for (auto times = 1 + below(6); times > 0 && !data.empty(); --times)
        data[below(data.size())] = static_cast<std::uint8_t>(random());
    const Data& other = corpus[below(corpus.size())];
    if (below(4) == 0)
        std::copy_n(other.begin(), below(std::min(data.size(), other.size()) + 1), data.begin());
    if (below(8) == 0)
        data.resize(below(data.size() + 1));
    if (below(8) == 0)
        data.insert(data.end(), other.begin(), other.end());
    return data;
}

} // namespace

int main(int count, char** arguments)
{
    if (count != 3)
        found("usage: NAME RUNS FOLDER");
    const auto corpus = corpusIn(arguments[2]);
    if (corpus.empty())
        found("there is no corpus in " + std::string(arguments[2]));
    for (const Data& data : corpus)
        LLVMFuzzerTestOneInput(data.data(), data.size());
    std::mt19937_64 random(1);
    const long runs = std::atol(arguments[1]);
    for (long i = 0; i < runs; ++i) {
        const Data data = changed(corpus[random() % corpus.size()], corpus, random);
        LLVMFuzzerTestOneInput(data.data(), data.size());
    }
    std::printf("%zu inputs of the corpus and %ld changed ones: nothing found\n", corpus.size(),
                runs);
}
