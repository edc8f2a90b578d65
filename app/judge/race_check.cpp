// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/race_check.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <numeric>

namespace app::plug_in {
namespace {

using clipping::Clipped;
using clipping::Segment;

constexpr double allowedUlps = Contract{}.ulps; ///< for a visibility, with any numbers
constexpr std::size_t mostKept = 8;

std::array<std::uint64_t, 4> segmentBits(const Segment& segment)
{
    return std::bit_cast<std::array<std::uint64_t, 4>>(segment);
}

/// The pieces have just been written, so reading them does not evict anything from the cache.
std::uint64_t sumOf(std::span<const Clipped> pieces)
{
    std::uint64_t sum = pieces.size();
    for (const Clipped& one : pieces) {
        sum = sum * 31 + one.source;
        for (const std::uint64_t of : segmentBits(one.segment))
            sum = (sum ^ of) * 0x100000001b3;
    }
    return sum;
}

bool samePieceBits(const std::optional<Segment>& one, const std::optional<Segment>& other)
{
    return one.has_value() == other.has_value()
           && (!one || segmentBits(*one) == segmentBits(*other));
}

Answer answerOf(const std::optional<Segment>& piece)
{
    if (!piece)
        return {{}, 0, 0};
    return {{piece->a.x, piece->a.y, piece->b.x, piece->b.y}, 1, 0};
}

/// Iterates over the pieces, line by line.
class PieceReader {
public:
    explicit PieceReader(std::span<const Clipped> pieces) : left_(pieces) {}
    /// The piece of a line; call it with ascending lines.
    std::optional<Segment> of(std::size_t line)
    {
        if (left_.empty() || left_.front().source != line)
            return std::nullopt;
        const Segment piece = left_.front().segment;
        left_ = left_.subspan(1);
        return piece;
    }

private:
    std::span<const Clipped> left_;
};

QJsonObject objectOf(const RaceFinding& one)
{
    const auto bytes = [](const auto& of) {
        return QString::fromLatin1(
            QByteArray(reinterpret_cast<const char*>(&of), sizeof of).toBase64());
    };
    return {{"fault", infoOf(one.fault).key},
            {"question", bytes(one.question)},
            {"answer", bytes(one.answer)}};
}

template <class T>
bool readBytes(const QJsonValue& text, T& to)
{
    const QByteArray bytes = QByteArray::fromBase64(text.toString().toLatin1());
    if (bytes.size() != sizeof to)
        return false;
    std::memcpy(&to, bytes.constData(), sizeof to);
    return true;
}

std::optional<RaceFinding> findingOf(const QJsonObject& object)
{
    const auto fault = std::ranges::find(faults(), object["fault"].toString(), &FaultInfo::key);
    RaceFinding one{};
    if (fault == faults().end() || !readBytes(object["question"], one.question)
        || !readBytes(object["answer"], one.answer))
        return std::nullopt;
    one.fault = fault->fault;
    return one;
}

} // namespace

std::size_t RaceFindings::wrong() const
{
    return std::accumulate(byFault.begin(), byFault.end(), std::size_t(0));
}

QByteArray jsonOf(const RaceFindings& found)
{
    QJsonArray byFault, first;
    for (const std::size_t count : found.byFault)
        byFault.append(double(count));
    for (const RaceFinding& one : found.first)
        first.append(objectOf(one));
    return QJsonDocument(QJsonObject{{"checked", double(found.lines)},
                                     {"visible", double(found.visible)},
                                     {"wrong_visible", double(found.wrongVisible)},
                                     {"outside", double(found.outside)},
                                     {"most_ulps", found.mostOff},
                                     {"faults", byFault},
                                     {"findings", first}})
        .toJson(QJsonDocument::Compact);
}

std::optional<RaceFindings> raceFindingsOf(const QByteArray& json)
{
    const QJsonObject object = QJsonDocument::fromJson(json).object();
    const QJsonArray byFault = object["faults"].toArray();
    RaceFindings found;
    if (!object.contains("checked") || byFault.size() != qsizetype(found.byFault.size()))
        return std::nullopt;
    found.lines = std::size_t(object["checked"].toDouble());
    found.visible = std::size_t(object["visible"].toDouble());
    found.wrongVisible = std::size_t(object["wrong_visible"].toDouble());
    found.outside = std::size_t(object["outside"].toDouble());
    found.mostOff = object["most_ulps"].toDouble();
    for (std::size_t i = 0; i < found.byFault.size(); ++i)
        found.byFault[i] = std::size_t(byFault[qsizetype(i)].toDouble());
    for (const auto& one : object["findings"].toArray())
        if (const auto finding = findingOf(one.toObject()))
            found.first.push_back(*finding);
    return found;
}

Clock RaceCheck::clock() const
{
    return {clock_.name, [this] { return clock_.nanoseconds() - paused_; }};
}

void RaceCheck::turn(std::span<const Segment> lines, const clipping::Window& window,
                     std::span<const Clipped> pieces)
{
    const double start = clock_.nanoseconds();
    if (isKnown(lines)) {
        if (sumOf(pieces) != sum_)
            compare(pieces);
    } else {
        lines_.assign(lines.begin(), lines.end());
        pieces_.assign(pieces.begin(), pieces.end());
        window_ = window;
        sum_ = sumOf(pieces);
        wrong_.assign(lines.size(), false);
        found_.lines += lines.size();
        judgeAll(pieces);
    }
    paused_ += clock_.nanoseconds() - start;
}

/// Each run of a race has the same lines; the lines of a class are different ones.
bool RaceCheck::isKnown(std::span<const Segment> lines) const
{
    return lines.size() == lines_.size() && !lines.empty() && lines.front() == lines_.front()
           && lines.back() == lines_.back();
}

void RaceCheck::judgeAll(std::span<const Clipped> pieces)
{
    PieceReader reader(pieces);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        const auto piece = reader.of(i);
        found_.visible += expected({lines_[i], window_}).has_value();
        const auto result = judged({lines_[i], window_}, answerOf(piece), contract_, allowedUlps);
        if (result.fault) {
            add(*result.fault, i, piece);
            continue;
        }
        found_.outside += result.outside > 0;
        found_.mostOff = std::max({found_.mostOff, result.off, result.outside});
    }
}

void RaceCheck::compare(std::span<const Clipped> pieces)
{
    PieceReader now(pieces), then(pieces_);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        const auto piece = now.of(i);
        if (!samePieceBits(piece, then.of(i)))
            add(Fault::Changed, i, piece);
    }
}

void RaceCheck::add(Fault fault, std::size_t line, const std::optional<Segment>& piece)
{
    if (wrong_[line])
        return;
    wrong_[line] = true;
    ++found_.byFault[std::size_t(fault)];
    found_.wrongVisible += expected({lines_[line], window_}).has_value();
    if (found_.first.size() < mostKept)
        found_.first.push_back({fault, {lines_[line], window_}, answerOf(piece)});
}

} // namespace app::plug_in
