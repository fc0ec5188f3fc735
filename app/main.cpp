#include "app/command_line.hpp"

#include <fcntl.h>
#include <initializer_list>
#include <unistd.h>

namespace {

/// A standard stream that the caller has closed would give its number to the next file that is
/// opened, and messages would end up in results.
void keep_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) == -1)
            open("/dev/null", stream == STDIN_FILENO ? O_RDONLY : O_WRONLY);
}

} // namespace

int main(int count, char** words) {
    keep_standard_streams();
    return searle::app::run_command_line(count, words);
}
