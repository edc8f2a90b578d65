// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

namespace app {

/// While an object of this class exists, SIGTERM, SIGHUP and SIGINT end the process as usual, but
/// `last` is called first, immediately, on a thread of its own, even while all other threads are
/// busy. Signals that the program was started to ignore (nohup) stay ignored. At most one object at
/// a time. Without such signals, or if no thread can be started, it does nothing.
class SignalWatch {
public:
    explicit SignalWatch(std::function<void(int signal)> last);
    ~SignalWatch();
    SignalWatch(const SignalWatch&) = delete;
    SignalWatch& operator=(const SignalWatch&) = delete;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace app
