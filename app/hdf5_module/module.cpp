#include "app/hdf5_module/module.hpp"

#include <cstring>
#include <hdf5.h>

namespace searle::app {
namespace {

/// An HDF5 object that is closed when it goes.
class Handle {
public:
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Handle() { shut(); }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    [[nodiscard]] hid_t id() const { return id_; }
    [[nodiscard]] bool is_open() const { return id_ >= 0; }
    /// False when closing, which writes what is left, failed.
    bool shut() {
        const bool done = id_ < 0 || close_(id_) >= 0;
        id_ = -1;
        return done;
    }

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// HDF5 prints its errors unless told not to.
void keep_quiet() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

bool write_text(hid_t file, const char* name, const std::string& text) {
    const hsize_t size = text.size();
    const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    const Handle set(
        H5Dcreate2(file, name, H5T_NATIVE_CHAR, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Dclose);
    return set.is_open() &&
           H5Dwrite(set.id(), H5T_NATIVE_CHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) >= 0;
}

bool write_column(hid_t file, const std::string& name, const std::vector<double>& values) {
    const hsize_t size = values.size();
    const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    const Handle set(H5Dcreate2(file, name.c_str(), H5T_IEEE_F64LE, space.id(), H5P_DEFAULT,
                                H5P_DEFAULT, H5P_DEFAULT),
                     H5Dclose);
    return set.is_open() && (values.empty() || H5Dwrite(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL,
                                                        H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
}

hssize_t points_in(hid_t set) {
    const Handle space(H5Dget_space(set), H5Sclose);
    return space.is_open() ? H5Sget_simple_extent_npoints(space.id()) : -1;
}

/// What is read, and the size of the file that it is read from.
struct Reading {
    StoredColumns& columns;
    hsize_t file_size;
};

/// True when the values stand in the file as they were written: a damaged size would fill the
/// memory.
bool holds(hid_t set, hssize_t points, std::size_t value_size, hsize_t file_size) {
    const hsize_t stored = H5Dget_storage_size(set);
    return points >= 0 && static_cast<hsize_t>(points) <= file_size / value_size &&
           stored == static_cast<hsize_t>(points) * value_size;
}

herr_t collect(hid_t file, const char* name, const H5L_info_t*, void* into) {
    auto& [all, file_size] = *static_cast<Reading*>(into);
    const bool is_text = std::strcmp(name, "identity") == 0;
    const Handle set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
    const hssize_t points = set.is_open() ? points_in(set.id()) : -1;
    if (!set.is_open() || !holds(set.id(), points, is_text ? 1 : sizeof(double), file_size)) {
        all.damaged = true;
        return 0;
    }
    const auto count = static_cast<std::size_t>(points);
    if (is_text) {
        all.identity.resize(count);
        all.damaged |= H5Dread(set.id(), H5T_NATIVE_CHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                               all.identity.data()) < 0;
        return 0;
    }
    std::vector<double>& column = all.columns[name];
    column.resize(count);
    if (count > 0)
        all.damaged |=
            H5Dread(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, column.data()) < 0;
    return 0;
}

} // namespace
} // namespace searle::app

extern "C" bool searle_hdf5_write(const char* file, const searle::app::StoredColumns* columns) {
    using namespace searle::app;
    keep_quiet();
    Handle out(H5Fcreate(file, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    bool good = out.is_open() && write_text(out.id(), "identity", columns->identity);
    for (const auto& [name, values] : columns->columns)
        good = good && write_column(out.id(), name, values);
    return out.shut() && good;
}

extern "C" bool searle_hdf5_read(const char* file, searle::app::StoredColumns* columns) {
    using namespace searle::app;
    keep_quiet();
    const Handle in(H5Fopen(file, H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    hsize_t start = 0;
    hsize_t size = 0;
    if (!in.is_open() || H5Fget_filesize(in.id(), &size) < 0)
        return false;
    Reading reading{*columns, size};
    return H5Literate(in.id(), H5_INDEX_NAME, H5_ITER_INC, &start, collect, &reading) >= 0 &&
           !columns->damaged;
}
