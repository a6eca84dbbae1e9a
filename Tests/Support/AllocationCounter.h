// Counts what operator new hands out, for tests of code that must not allocate. It does not see
// malloc. A test program that counts links AllocationCounter.cpp, which replaces the operators.
#pragma once

namespace idiophone::test {

/// [any thread] Counts on every thread, from when it is made.
class AllocationCounter {
public:
    AllocationCounter();

    long allocations() const;

private:
    long before;
};

} // namespace idiophone::test
