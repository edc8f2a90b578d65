// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/typed_entry.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/document/direction.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double largestTyped = 1e9; // as in the fields of the panels

class EntryReader {
public:
    EntryReader(const Scale& scale, const QLocale& locale) : scale_(scale), locale_(locale) {}

    std::optional<double> length(const QString& text)
    {
        const auto length = typedLength(text, scale_, locale_);
        if (!length)
            return refuse(Text::tr("“%1” is not a length: %2.").arg(text.trimmed(), length.error));
        const double units = fromUnit(*length.value, scale_.unit, scale_.millimetresPerUnit);
        if (!(std::abs(units) <= largestTyped))
            return refuse(Text::tr("“%1” is too large.").arg(text.trimmed()));
        return units;
    }
    std::optional<double> angle(QString text)
    {
        const QString typed = text.trimmed();
        text.remove(u'°');
        const auto degrees = plainNumber(text);
        if (!degrees)
            return refuse(Text::tr("“%1” is not an angle: %2.").arg(typed, degrees.error));
        if (!(std::abs(*degrees.value) <= largestTyped))
            return refuse(Text::tr("“%1” is too large.").arg(typed));
        return *degrees.value;
    }
    std::optional<double> factor(QString text)
    {
        const QString typed = text.trimmed();
        const bool percent = typed.endsWith(u'%');
        const auto factor = plainNumber(text.remove(u'%'));
        if (!factor)
            return refuse(Text::tr("“%1” is not a factor: %2.").arg(typed, factor.error));
        if (!(std::abs(*factor.value) <= largestTyped))
            return refuse(Text::tr("“%1” is too large.").arg(typed));
        return *factor.value / (percent ? 100 : 1);
    }
    std::optional<double> count(const QString& text)
    {
        constexpr int least = 3, most = 1000;
        const auto count = plainNumber(text);
        if (!count || *count.value < least || *count.value > most
            || *count.value != std::floor(*count.value))
            return refuse(
                Text::tr("“%1” is not a number of corners: type a whole number from %2 to %3.")
                    .arg(text.trimmed(), locale_.toString(least), locale_.toString(most)));
        return *count.value;
    }
    std::optional<double> share(QString text)
    {
        const QString typed = text.trimmed();
        const bool percent = typed.endsWith(u'%');
        const auto share = plainNumber(text.remove(u'%'));
        const double value = share ? *share.value / (percent || *share.value > 1 ? 100 : 1) : 0;
        if (!(value > 0 && value <= 1))
            return refuse(
                Text::tr("“%1” is not a share: type a percentage from 1 to 100.").arg(typed));
        return value;
    }
    std::optional<double> number(const QString& text, Quantity quantity)
    {
        switch (quantity) {
        case Quantity::Angle:
            return angle(text);
        case Quantity::Factor:
            return factor(text);
        case Quantity::Count:
            return count(text);
        case Quantity::Share:
            return share(text);
        default:
            return length(text);
        }
    }
    static bool isRepeat(const QString& text)
    {
        return text.size() > 1 && (text.endsWith(u'x') || text.endsWith(u'/'));
    }
    std::optional<Entry> repeat(const QString& text)
    {
        bool whole = false;
        const int count = locale_.toInt(text.chopped(1).trimmed(), &whole);
        if (!whole || count < 1 || count > mostCopies) {
            refuse(
                Text::tr("“%1” is not a number of copies: type a whole number from 1 to %2 before "
                         "the %3.")
                    .arg(text, locale_.toString(mostCopies), text.right(1)));
            return std::nullopt;
        }
        return RepeatEntry{count,
                           text.endsWith(u'x') ? RepeatEntry::How::Times : RepeatEntry::How::Parts};
    }
    std::optional<Entry> polar(const QString& text, PointEntry::Origin origin)
    {
        const auto sign = text.indexOf(u'<');
        const QString before = text.left(sign).trimmed();
        const auto degrees = angle(text.mid(sign + 1));
        if (!degrees)
            return std::nullopt;
        if (before.isEmpty())
            return PolarEntry{std::nullopt, *degrees};
        const auto radius = length(before);
        if (!radius)
            return std::nullopt;
        if (origin == PointEntry::Origin::Absolute)
            return PointEntry{directionOf(*degrees) * *radius, origin};
        return PolarEntry{radius, *degrees};
    }
    std::optional<Entry> point(const QString& text, PointEntry::Origin origin, QChar separator)
    {
        const QStringList parts = text.split(separator);
        if (parts.size() != 2) {
            refuse(Text::tr("“%1” is not a point: type two numbers, such as 10%2 20.")
                       .arg(text, QString(separator)));
            return std::nullopt;
        }
        const auto x = length(parts[0]);
        const auto y = x ? length(parts[1]) : std::nullopt;
        return y ? std::optional<Entry>(PointEntry{{*x, *y}, origin}) : std::nullopt;
    }
    /// The character that separates the coordinates of a point; nothing: no point is meant.
    std::optional<QChar> separatorIn(const QString& text) const
    {
        if (text.contains(u';'))
            return u';';
        const bool comma = locale_.decimalPoint() != QStringLiteral(",") && text.contains(u',');
        return comma ? std::optional<QChar>(u',') : std::nullopt;
    }
    const QString& error() const { return error_; }

private:
    /// A number, which may be a sum, without a unit.
    Result<double> plainNumber(const QString& text) const
    {
        if (std::ranges::any_of(text, [](QChar c) { return c.isLetter(); }))
            return Result<double>::failure(Text::tr("type a number without a unit"));
        return typedLength(text, {}, locale_);
    }
    std::nullopt_t refuse(const QString& sentence)
    {
        error_ = sentence;
        return std::nullopt;
    }

    Scale scale_;
    QLocale locale_;
    QString error_;
};

} // namespace

Result<Entry> readEntry(const QString& typed, Quantity quantity, const Scale& scale,
                        const QLocale& locale)
{
    EntryReader reader(scale, locale);
    QString text = typed.trimmed();
    auto origin = PointEntry::Origin::Usual;
    if (text.startsWith(u'#') || text.startsWith(u'@')) {
        origin = text[0] == u'#' ? PointEntry::Origin::Absolute : PointEntry::Origin::Relative;
        text = text.mid(1).trimmed();
    }
    const auto separator = reader.separatorIn(text);
    std::optional<Entry> entry;
    if (text.contains(u'<'))
        entry = reader.polar(text, origin);
    else if (separator)
        entry = reader.point(text, origin, *separator);
    else if (origin != PointEntry::Origin::Usual)
        entry = reader.point(text, origin, u',');
    else if (reader.isRepeat(text))
        entry = reader.repeat(text);
    else if (const auto number = reader.number(text, quantity))
        entry = NumberEntry{*number};
    return entry ? Result<Entry>::of(*entry) : Result<Entry>::failure(reader.error());
}

} // namespace app
