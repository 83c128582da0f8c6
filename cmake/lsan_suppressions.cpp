// LeakSanitizer asks a program for what it shall not report. Fontconfig, which finds the fonts for
// Cairo, keeps some hundred bytes of its configuration until the end of the process.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }

// Nor what it left out, which tests would read on stderr.
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
