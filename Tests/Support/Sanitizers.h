// Defines whether a sanitizer watches this build: it keeps memory of its own, and its allocations
// do not fail.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define IDIOPHONE_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define IDIOPHONE_SANITIZED 1
#endif
#endif
#ifndef IDIOPHONE_SANITIZED
#define IDIOPHONE_SANITIZED 0
#endif
