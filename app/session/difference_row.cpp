// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/difference_row.h"

#include "app/base/finite.h"
#include "app/base/number.h"
#include "app/base/numbers.h"
#include "app/base/text.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace app {

using clipping::Segment;
using Key = DifferenceColumn::Key;
using Kind = Difference::Kind;

namespace {

enum class Side : std::uint8_t { A, B };

const Variant& variantOf(const Comparison& comparison, Side side)
{
    return side == Side::A ? comparison.a : comparison.b;
}

bool isThere(const Session& session, const Difference& difference)
{
    return session.differences.asked() && difference.source < session.scene.lines().size();
}

/// The piece of one side; the line must exist.
std::optional<Segment> pieceOf(const Session& session, const Difference& difference, Side side)
{
    return clipped(variantOf(*session.differences.asked(), side),
                   session.scene.lines()[difference.source], session.differences.found().window);
}

QString inFull(double number)
{
    if (!std::isfinite(number))
        return Text::tr("not a number");
    return shortestText(number);
}

template <class Number>
QString pieceText(const std::optional<Segment>& piece, const Number& number)
{
    if (!piece)
        return QStringLiteral("–");
    const auto point = [&](const Point& p) {
        return Text::tr("%1; %2", "coordinates").arg(number(p.x), number(p.y));
    };
    return piece->a == piece->b
               ? point(piece->a)
               : Text::tr("%1 → %2", "from, to").arg(point(piece->a), point(piece->b));
}

/// In the unit of rulers and fields, with as many decimals.
template <Side side>
QString shortPieceText(const Session& session, const Difference& difference)
{
    if (!isThere(session, difference))
        return {};
    const double size = session.now().page().realMillimetresPerUnit();
    const auto rounded = [&](double length) {
        return std::isfinite(length) ? lengthNumber(length, session.display().unit, size)
                                     : inFull(length);
    };
    return pieceText(pieceOf(session, difference, side), rounded);
}

/// The length of the piece that only one side sees, in user units.
double lengthOf(const Session& session, const Difference& difference)
{
    const auto piece =
        pieceOf(session, difference, difference.kind == Kind::OnlyA ? Side::A : Side::B);
    return piece ? glm::distance(piece->a, piece->b) : 0;
}

/// The distance of the ends of two pieces, in either direction.
double distanceOf(const Session& session, const Difference& difference)
{
    const auto a = pieceOf(session, difference, Side::A), b = pieceOf(session, difference, Side::B);
    if (!a || !b)
        return 0;
    return std::min(std::max(glm::distance(a->a, b->a), glm::distance(a->b, b->b)),
                    std::max(glm::distance(a->a, b->b), glm::distance(a->b, b->a)));
}

/// The least length that is not displayed as zero, in user units.
double leastToRead(const Session& session)
{
    const Unit unit = session.display().unit;
    return fromUnit(std::pow(10, -infoOf(unit).decimals), unit,
                    session.now().page().realMillimetresPerUnit());
}

QString amountText(const Session& session, double length)
{
    if (!std::isfinite(length))
        return QStringLiteral("∞");
    const double least = leastToRead(session);
    const QString text = lengthText(std::max(length, least), session.display().unit,
                                    session.now().page().realMillimetresPerUnit());
    return length == 0 ? Text::tr("a point") : length < least ? QStringLiteral("< ") + text : text;
}

QString differenceText(const Session& session, const Difference& difference)
{
    if (!isThere(session, difference))
        return {};
    if (difference.kind != Kind::EndsApart)
        return amountText(session, lengthOf(session, difference));
    if (const double distance = distanceOf(session, difference); distance >= leastToRead(session))
        return amountText(session, distance);
    return difference.ulps == 1 ? Text::tr("1 ulp")
                                : Text::tr("%1 ulps").arg(ulpsText(difference.ulps));
}

QString lineText(const Session& session, const Difference& difference)
{
    return isThere(session, difference) ? countText(difference.source + std::size_t(1)) : QString();
}

QString whatText(const Session& session, const Difference& difference)
{
    if (!isThere(session, difference))
        return {};
    const Comparison& comparison = *session.differences.asked();
    if (difference.kind == Kind::EndsApart)
        return Text::tr("different ends");
    return Text::tr("only %1 keeps it")
        .arg(nameOf(variantOf(comparison, difference.kind == Kind::OnlyA ? Side::A : Side::B)));
}

QString placeText(const Session& session, const Difference& difference)
{
    if (!isThere(session, difference))
        return {};
    const std::size_t object = session.scene.lines().objectOf(difference.source);
    const Containers& containers = session.now().containers();
    return Text::tr("%1, shape %2")
        .arg(containers[containers.layerOf(object)].name, countText(object + 1));
}

Key byLine(const Session&, const Difference& difference) { return {double(difference.source), 0}; }
Key byKind(const Session&, const Difference& difference) { return {double(difference.kind), 0}; }

/// Ends that are apart come first: their distance is usually less than the length of any piece.
Key byAmount(const Session& session, const Difference& difference)
{
    if (difference.kind == Kind::EndsApart)
        return {0, difference.ulps};
    const double length = isThere(session, difference) ? lengthOf(session, difference) : 0;
    return {1, std::isfinite(length) ? length : std::numeric_limits<double>::infinity()};
}

/// By the first end of the piece; invisible pieces and NaNs come last.
template <Side side>
Key byPiece(const Session& session, const Difference& difference)
{
    const auto piece =
        isThere(session, difference) ? pieceOf(session, difference, side) : std::nullopt;
    if (piece && isFinite(piece->a))
        return {piece->a.x, piece->a.y};
    return {std::numeric_limits<double>::infinity(), 0};
}

template <Side side>
QString pieceHeading(const Comparison&)
{
    return side == Side::A ? Text::tr("A") : Text::tr("B");
}

template <Side side>
QString pieceMeaning(const Comparison& comparison)
{
    return Text::tr("The part of the line that %1 keeps").arg(nameOf(variantOf(comparison, side)));
}

} // namespace

std::span<const DifferenceColumn> differenceColumns()
{
    static const std::array columns{
        DifferenceColumn{[](const Comparison&) { return Text::tr("Line"); },
                         [](const Comparison&) { return Text::tr("The line's number"); }, lineText,
                         byLine, true},
        DifferenceColumn{
            [](const Comparison&) { return Text::tr("What differs"); },
            [](const Comparison&) {
                return Text::tr(
                    "Which of the two keeps the line, or whether both keep it with different ends");
            },
            whatText, byKind, false},
        DifferenceColumn{
            [](const Comparison&) { return Text::tr("How much"); },
            [](const Comparison&) {
                return Text::tr(
                    "The length of the part that only one of the two keeps, or the distance "
                    "between the ends. A distance too short to read is in ulps: units in the last "
                    "place of the largest coordinate of line and window");
            },
            differenceText, byAmount, true},
        DifferenceColumn{pieceHeading<Side::A>, pieceMeaning<Side::A>, shortPieceText<Side::A>,
                         byPiece<Side::A>, false},
        DifferenceColumn{pieceHeading<Side::B>, pieceMeaning<Side::B>, shortPieceText<Side::B>,
                         byPiece<Side::B>, false},
        // Objects and layers are in the order of their lines.
        DifferenceColumn{
            [](const Comparison&) { return Text::tr("Layer and shape"); },
            [](const Comparison&) { return Text::tr("The line's place in the drawing"); },
            placeText, byLine, false}};
    return columns;
}

QString piecesInFull(const Session& session, const Difference& difference)
{
    if (!isThere(session, difference))
        return {};
    const auto of = [&](Side side) {
        return nameOf(variantOf(*session.differences.asked(), side)) + QStringLiteral(": ")
               + pieceText(pieceOf(session, difference, side), inFull);
    };
    return of(Side::A) + u'\n' + of(Side::B);
}

std::vector<std::uint32_t> sortedBy(const Session& session, const DifferenceColumn& column,
                                    Qt::SortOrder order)
{
    const auto& list = session.differences.found().list;
    std::vector<Key> keys;
    keys.reserve(list.size());
    for (const Difference& difference : list)
        keys.push_back(column.key(session, difference));
    std::vector<std::uint32_t> rows(list.size());
    std::iota(rows.begin(), rows.end(), 0u);
    const bool ascending = order == Qt::AscendingOrder;
    std::ranges::stable_sort(rows, [&](std::uint32_t one, std::uint32_t other) {
        return ascending ? keys[one] < keys[other] : keys[other] < keys[one];
    });
    return rows;
}

} // namespace app
