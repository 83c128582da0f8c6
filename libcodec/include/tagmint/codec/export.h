#pragma once

/// Marks what the shared library offers to its users: all else is hidden (-fvisibility=hidden).
/// Every public class, and every public function that is not inline, has it.
#ifndef TAGMINT_API
#define TAGMINT_API __attribute__((visibility("default")))
#endif
