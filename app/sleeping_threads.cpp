#include "app/sleeping_threads.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>
#include <vector>

namespace searle::app {

void restart_with_sleeping_threads() {
    if (std::getenv("OMP_WAIT_POLICY") != nullptr)
        return;
    std::ifstream stream("/proc/self/cmdline", std::ios::binary);
    std::string words{std::istreambuf_iterator<char>(stream), {}};
    std::vector<char*> arguments;
    for (std::size_t start = 0; start < words.size(); start = words.find('\0', start) + 1)
        arguments.push_back(words.data() + start);
    if (arguments.empty())
        return;
    arguments.push_back(nullptr);
    setenv("OMP_WAIT_POLICY", "passive", 0);
    execv("/proc/self/exe", arguments.data());
}

} // namespace searle::app
