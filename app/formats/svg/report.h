// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"
#include "app/formats/svg/losses.h"

#include <string_view>

namespace app::svg {

/// Counts the content of a file that an import cannot keep, or keeps in another form, with the line
/// of its first occurrence.
class Report {
public:
    /// The line of what is added from now on; 0: none in particular.
    void turnTo(qint64 line) { line_ = pins_ > 0 ? line_ : line; }
    qint64 line() const { return line_; }

    /// While it exists, nothing is added.
    class Silence {
    public:
        explicit Silence(Report& report) : report_(report) { ++report_.silences_; }
        ~Silence() { --report_.silences_; }
        Silence(const Silence&) = delete;
        Silence& operator=(const Silence&) = delete;

    private:
        Report& report_;
    };

    /// While it exists, the line stays: that of an image, for all that is in it.
    class Pin {
    public:
        explicit Pin(Report& report) : report_(report) { ++report_.pins_; }
        ~Pin() { --report_.pins_; }
        Pin(const Pin&) = delete;
        Pin& operator=(const Pin&) = delete;

    private:
        Report& report_;
    };

    void add(const LossKind& kind, int count = 1);
    /// Adds one loss of a kind whose sentence quotes `text`.
    void add(const LossKind& kind, std::string_view text);
    std::vector<Loss> losses() const; ///< in the order of first occurrence

private:
    struct Counted {
        const LossKind* kind;
        int count;
        qint64 line;
        QStringList texts{}; ///< the first different texts, shortened for display
    };
    Counted& of(const LossKind& kind);
    Counted& of(const LossKind& kind, const QString& text);

    std::vector<Counted> counted_;
    qint64 line_ = 0;
    int silences_ = 0, pins_ = 0;
};

} // namespace app::svg
