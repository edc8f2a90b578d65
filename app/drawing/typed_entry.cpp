// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/typed_entry.h"

#include "app/base/numbers.h"
#include "app/document/direction.h"

#include <QCoreApplication>

namespace app {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("Entry", text); }

constexpr double limit = 1e9; // as in the fields of the panels

class EntryReader {
public:
    EntryReader(const Scale& scale, const QLocale& locale) : scale_(scale), locale_(locale) {}

    std::optional<double> length(const QString& text)
    {
        const auto length = typedLength(text, scale_, locale_);
        if (!length)
            return refuse(tr("“%1” is not a length: %2.").arg(text.trimmed(), length.error));
        const double units = fromUnit(*length.value, scale_.unit, scale_.millimetresPerUnit);
        if (!(std::abs(units) <= limit))
            return refuse(tr("“%1” is too large.").arg(text.trimmed()));
        return units;
    }
    std::optional<double> angle(QString text)
    {
        const QString typed = text.trimmed();
        text.remove(u'°');
        const auto degrees = typedLength(text, {}, locale_);
        if (!degrees)
            return refuse(tr("“%1” is not an angle: %2.").arg(typed, degrees.error));
        if (!(std::abs(*degrees.value) <= limit))
            return refuse(tr("“%1” is too large.").arg(typed));
        return *degrees.value;
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
            refuse(tr("“%1” is not a point: type two numbers, such as 10%2 20.")
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

Result<Entry> readEntry(const QString& typed, bool isAngle, const Scale& scale,
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
    else if (const auto number = isAngle ? reader.angle(text) : reader.length(text))
        entry = NumberEntry{*number};
    return entry ? Result<Entry>::of(*entry) : Result<Entry>::failure(reader.error());
}

} // namespace app
