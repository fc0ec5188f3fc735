#include "app/failures.hpp"

#include "app/case_reader.hpp"
#include "app/checkpoint_file.hpp"
#include "app/exit_code.hpp"
#include "app/result_folder.hpp"
#include "app/solved_case.hpp"
#include "app/usage_error.hpp"
#include "geometry/mesh_error.hpp"
#include "rheometry/tables/table_error.hpp"
#include "solvers/openfoam/child_process.hpp"
#include "solvers/openfoam/disk_space.hpp"
#include "solvers/openfoam/openfoam_solver.hpp"
#include "solvers/suspension/suspension_motion.hpp"
#include "solvers/unsuitable_scene.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <new>
#include <string_view>
#include <system_error>

namespace searle::app {
namespace {

int tell(ExitCode code, std::string_view message) {
    std::fputs(fmt::format("searle: {}\n", message).c_str(), stderr);
    return code;
}

int called(const std::function<int()>& verb) {
    try {
        return verb();
    } catch (const casefile::CaseError& error) {
        // Several lines that open with file:line, as compilers do: nothing in front of them.
        std::fputs(fmt::format("{}\n", error.what()).c_str(), stderr);
        return ExitCode::wrong_usage;
    } catch (const rheometry::TableError& error) {
        return tell(ExitCode::wrong_usage, error.what());
    } catch (const UsageError& error) {
        return tell(ExitCode::wrong_usage, error.what());
    } catch (const solvers::suspension::StepFailure& error) {
        return tell(ExitCode::not_reached, fmt::format("{}; nothing was written", error.what()));
    } catch (const solvers::openfoam::OpenFoamFailed& error) {
        return tell(ExitCode::not_reached, error.what());
    } catch (const solvers::openfoam::StartFailure& error) {
        return tell(ExitCode::engine_missing,
                    fmt::format("{}; apt-get install {} brings OpenFOAM and what it needs",
                                error.what(), solvers::openfoam::package));
    } catch (const solvers::openfoam::DiskFull& error) {
        return tell(ExitCode::program_fault, error.what());
    } catch (const CheckpointError& error) {
        return tell(ExitCode::wrong_usage, error.what());
    } catch (const solvers::UnsuitableScene& error) {
        return tell(ExitCode::wrong_usage, error.what());
    } catch (const geometry::MeshError& error) {
        return tell(ExitCode::wrong_usage, error.what());
    } catch (const geometry::MeshToolMissing& error) {
        return tell(ExitCode::engine_missing, error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return tell(ExitCode::program_fault,
                    fmt::format("{}: {}", error.path1().string(), error.code().message()));
    } catch (const OutputPlaceError& error) {
        return tell(ExitCode::wrong_usage, error.what());
    } catch (const OutputWriteError& error) {
        return tell(ExitCode::program_fault, error.what());
    } catch (const EngineMissing& error) {
        return tell(ExitCode::engine_missing, error.what());
    } catch (const std::bad_alloc&) {
        return tell(ExitCode::program_fault, "there is not enough memory for this case");
    } catch (const std::exception& error) {
        return tell(ExitCode::program_fault,
                    fmt::format("{}\nThis is a fault of the program; please report it with the "
                                "case file and the output of `searle doctor`.",
                                error.what()));
    }
}

} // namespace

int with_failures_told(const std::function<int()>& verb) {
    const int code = called(verb);
    errno = 0;
    std::cout.flush();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout)
        return tell(ExitCode::program_fault,
                    fmt::format("standard output could not be written: {}",
                                std::generic_category().message(errno == 0 ? EIO : errno)));
    return code;
}

} // namespace searle::app
