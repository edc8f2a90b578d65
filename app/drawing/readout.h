// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/drawing/gesture_measure.h"
#include "app/drawing/typed_entry.h"

namespace app {

/// How a gesture ends.
struct GestureEnd {
    Point point;
    Numbers numbers;
    std::optional<RepeatEntry> repeat{};
};

/// How the numbers of a gesture are measured.
struct Gauge {
    const GestureMeasure* measure = nullptr;
    GestureStart start;
    Point origin; ///< of absolute coordinates
    Scale scale{};
    std::optional<GestureEnd> aim{};   ///< stays, instead of the pointer, where nothing is typed
    std::optional<Point> relativeTo{}; ///< "@10,20", "30<45"; empty: to start.from
    Point shift{0, 0};                 ///< from the pointer to the point that it moves
    Numbers kept{};                    ///< of the fields that the pointer does not steer
    bool repeats = false;              ///< whether "5x" and "5/" have a meaning
    bool alike = false;                ///< with an aim: of two sides, one typed alone is both
};

/// The numbers beside the pointer during a gesture, and what is typed into them. A number that
/// is typed or locked holds; the pointer decides the others.
class Readout {
public:
    enum class State : std::uint8_t { Free, Typed, Locked };

    explicit Readout(const Gauge& gauge) : gauge_(gauge) {}

    const Gauge& gauge() const { return gauge_; }
    /// Goes on with another gauge for the same gesture and the same numbers. False: it is
    /// another gesture.
    bool follow(const Gauge& gauge);
    std::size_t active() const { return active_; }
    State state(std::size_t field) const { return fields_[field].state; }
    /// The typed text of a field; empty: it shows its number.
    const QString& typed(std::size_t field) const { return fields_[field].text; }
    /// The number of a field for a gesture that ends there, with its unit.
    QString number(std::size_t field, const Point& end) const;
    /// Why the last text was refused: one sentence, until the next change.
    const QString& error() const { return error_; }

    /// Typing goes on in that field.
    void activate(std::size_t field);
    /// Replaces the typed text of the active field. A text that is not complete yet holds nothing.
    void type(const QString& text);
    /// Gives the active field back to the pointer.
    void release();
    /// Gives back what is typed but not locked.
    void releaseTyped();
    bool typesPoint() const;     ///< "10,20" is typed in the active field
    bool typesDirection() const; ///< "<45" is typed there, and no length is held
    bool holds() const;          ///< a number or a point, typed or locked
    /// Whether a number or a point is locked.
    bool isLocked() const;
    /// Locks the active field at what is typed, and goes on to the next one that is not locked.
    /// False: refused.
    bool lock();
    /// Whether the gesture can end with what is typed, if the pointer is there; error() says why
    /// not.
    bool accept(const Point& pointer);

    /// Where the gesture ends, if the pointer is there.
    Point end(const Point& pointer) const;
    /// The same with its numbers: exactly those that hold, the others measured.
    GestureEnd result(const Point& pointer) const;
    /// The pointer's place for a multiple of 15°; the same place if no number is an angle.
    Point toStep(const Point& pointer) const;

private:
    struct Field {
        State state = State::Free;
        QString text;
    };
    Result<Entry> entry() const;
    bool take();
    bool hold(const Entry& entry);
    bool hold(double number);
    double valueOf(std::size_t field, const Point& end) const;
    std::size_t count() const { return gauge_.measure->fields.size(); }
    /// The locked field that decides the active one; empty: none.
    std::optional<std::size_t> decider() const;
    bool refuseZero(std::size_t field);
    bool refuse(const QString& sentence);
    bool holdPoint(const PointEntry& entry);
    bool holdPolar(const PolarEntry& entry);
    void holdNumber(std::size_t field, double value);

    Gauge gauge_;
    std::array<Field, mostNumbers> fields_;
    Held held_;
    std::optional<Point> target_; ///< a typed point
    std::optional<RepeatEntry> repeat_;
    std::size_t active_ = 0;
    QString error_;
};

} // namespace app
