// Counts allocations by operator new, for tests of code that must not allocate. Does not count
// malloc. A test program that counts links AllocationCounter.cpp, which replaces the operators.
#pragma once

namespace idiophone::test {

/// [any thread] Counts the allocations of all threads since construction.
class AllocationCounter {
public:
    AllocationCounter();

    long allocations() const;

private:
    long before;
};

} // namespace idiophone::test
