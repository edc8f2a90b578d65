// SPDX-License-Identifier: GPL-3.0-or-later
// Calls the library in every way that it offers. Not a test itself: see answers.h.
#include "tests/clipping/answers.h"

#include "clipping/algorithm.h"
#include "clipping/batch/kernels.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <type_traits>

namespace clipping {
namespace {

class Writer {
public:
    explicit Writer(Answers& out) : out_(out) {}
    template <std::integral T>
    void write(T value)
    {
        const auto at = out_.size();
        out_.resize(at + sizeof(T));
        std::memcpy(out_.data() + at, &value, sizeof(T));
    }
    void write(double x) { write(std::bit_cast<std::uint64_t>(std::isnan(x) ? quiet : x)); }
    template <class T, glm::length_t N>
    void write(const BasicSegment<T, N>& s)
    {
        for (const auto& p : {s.a, s.b})
            for (glm::length_t k = 0; k < N; ++k)
                write(static_cast<double>(p[k]));
    }

private:
    static constexpr double quiet = std::numeric_limits<double>::quiet_NaN();
    Answers& out_;
};

template <class S>
S segmentFrom(const double* x)
{
    S s;
    using T = std::remove_cvref_t<decltype(s.a.x)>;
    constexpr auto n = std::remove_cvref_t<decltype(s.a)>::length();
    for (glm::length_t k = 0; k < n; ++k)
        s.a[k] = static_cast<T>(x[k]), s.b[k] = static_cast<T>(x[n + k]);
    return s;
}

template <class S>
std::vector<S> segmentsOf(const Block& block)
{
    constexpr std::size_t n = 2 * std::remove_cvref_t<decltype(S{}.a)>::length();
    std::vector<S> all;
    for (std::size_t i = 0; i + n <= block.segments.size(); i += n)
        all.push_back(segmentFrom<S>(&block.segments[i]));
    return all;
}

template <class W>
W windowOf(const Block& block)
{
    if constexpr (std::is_same_v<W, ConvexPolygon>) {
        ConvexPolygon polygon;
        for (std::size_t i = 0; i + 2 <= block.window.size(); i += 2)
            polygon.corners.emplace_back(block.window[i], block.window[i + 1]);
        return polygon;
    } else {
        using V = decltype(W{}.min);
        const auto both =
            segmentFrom<BasicSegment<typename V::value_type, V::length()>>(block.window.data());
        return {both.a, both.b};
    }
}

template <class S>
void writePieces(const std::vector<BasicClipped<S>>& pieces, Writer& to)
{
    to.write(pieces.size());
    for (const auto& piece : pieces)
        to.write(piece.segment), to.write(piece.source), to.write(piece.cut);
}

using Ask = std::function<Answers(const Block&)>;
struct Asked : Question {
    Ask ask;
};

template <class S, class W, class Piece>
Ask askAll(const Functions<S, W, Piece>& uses)
{
    return [&uses](const Block& block) {
        Answers bytes;
        Writer to(bytes);
        const auto in = segmentsOf<S>(block);
        const auto window = windowOf<W>(block);
        for (const S& s : in) {
            const auto piece = uses.clip(s, window);
            to.write(char(piece.has_value()));
            if (piece)
                to.write(*piece);
        }
        std::vector<BasicClipped<Piece>> out(in.size());
        out.resize(uses.clipAll(in, window, out));
        writePieces(out, to);
        const OperationCounts n = uses.count(in, window);
        for (const auto x :
             {n.additions, n.multiplications, n.divisions, n.comparisons, n.negations})
            to.write(x);
        return bytes;
    };
}

template <class T>
Ask askKernel(BatchResult (*clip)(const Batch<T>&))
{
    return [clip](const Block& block) {
        Answers bytes;
        Writer to(bytes);
        const auto in = segmentsOf<BasicSegment<T>>(block);
        std::vector<BasicClipped<BasicSegment<T>>> out(in.size());
        const auto result =
            clip({in.data(), 0, in.size(), windowOf<BasicWindow<T>>(block), out.data()});
        out.resize(result.pieces);
        writePieces(out, to);
        return bytes;
    };
}

const std::vector<Asked>& everything()
{
    static const std::vector<Asked> all = [] {
        std::vector<Asked> list;
        const auto add = [&](std::string_view row, const char* use, Numbers numbers,
                             const auto* uses) {
            if (uses)
                list.push_back({{std::string(row) + ' ' + use, numbers}, askAll(*uses)});
        };
        for (const Algorithm& row : algorithms()) {
            add(row.key, "corrected", Numbers::Plane, &row.corrected);
            add(row.key, "published", Numbers::Plane, row.published);
            add(row.key, "float", Numbers::PlaneInFloat, row.floats);
            add(row.key, "polygon", Numbers::Polygon, row.polygon);
            add(row.key, "searched polygon", Numbers::Polygon, row.polygonBySearch);
            add(row.key, "box", Numbers::Space, row.box);
            add(row.key, "line", Numbers::Plane, row.line);
            add(row.key, "ray", Numbers::Plane, row.ray);
        }
        for (const InstructionSet& set : instructionSets())
            if (set.available) {
                const std::string name = "kernel " + std::string(set.name);
                list.push_back({{name + " double", Numbers::Plane}, askKernel<double>(set.clip)});
                list.push_back(
                    {{name + " float", Numbers::PlaneInFloat}, askKernel<float>(set.clipSingle)});
            }
        return list;
    }();
    return all;
}

} // namespace

std::vector<Question> questions() { return {everything().begin(), everything().end()}; }

Answers answers(const Question& question, const Block& block)
{
    for (const Asked& asked : everything())
        if (asked.name == question.name)
            return asked.ask(block);
    return {};
}

} // namespace clipping
