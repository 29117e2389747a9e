// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/mesh_3mf.hpp"

#include <Model/COM/NMR_DLLInterfaces.h>

#include <Eigen/Geometry>
#include <memory>

#include "geometry/brep/input_error.hpp"
#include "geometry/mesh/late_library.hpp"

namespace abut::geometry {

namespace {

using NMR::PLib3MFBase;

const LateLibrary& lib3mf() {
    static const LateLibrary library(ABUT_LIB3MF, ABUT_LIB3MF_PATH);
    return library;
}

struct Release {
    void operator()(PLib3MFBase* handle) const { ABUT_LATE(lib3mf(), NMR::lib3mf_release, "")(handle); }
};
using Handle = std::unique_ptr<PLib3MFBase, Release>;

/// Every call goes through here: codes other than 0 are failures.
void ask(LIB3MFRESULT code, const std::string& file) {
    if (code != 0)
        throw InputError(file, "the 3MF file is damaged (lib3mf error " + std::to_string(code) + ")", "export it again");
}

class Reader {
public:
    Reader(std::string path, MeshBodies& bodies) : path_(std::move(path)), bodies_(bodies) {}
    void read();

private:
    void open();
    void add_item(PLib3MFBase* item);
    void add_object(PLib3MFBase* object, const Eigen::Affine3d& placement, int depth);
    void add_mesh(PLib3MFBase* object, const Eigen::Affine3d& placement);
    void add_components(PLib3MFBase* object, const Eigen::Affine3d& placement, int depth);
    std::string name_of(PLib3MFBase* object) const;
    std::string unit() const;

    std::string path_;
    MeshBodies& bodies_;
    Handle model_;
    std::size_t n_components_ = 0;
};

/// Calls that hand out a handle.
template <class Call, class... Arguments>
Handle get(const std::string& file, Call call, Arguments... arguments) {
    PLib3MFBase* handle = nullptr;
    ask(call(arguments..., &handle), file);
    return Handle(handle);
}

Eigen::Affine3d placement_of(const NMR::MODELTRANSFORM& t) {
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) map(row, column) = static_cast<double>(t.m_fFields[row][column]);
    return map;
}

void Reader::open() {
    model_ = get(path_, ABUT_LATE(lib3mf(), NMR::lib3mf_createmodel, path_));
    const Handle reader = get(path_, ABUT_LATE(lib3mf(), NMR::lib3mf_model_queryreader, path_), model_.get(), "3mf");
    if (ABUT_LATE(lib3mf(), NMR::lib3mf_reader_readfromfileutf8, path_)(reader.get(), path_.c_str()) == 0) return;
    DWORD code = 0;
    const char* message = nullptr;
    ABUT_LATE(lib3mf(), NMR::lib3mf_getlasterror, path_)(reader.get(), &code, &message);
    throw InputError(path_, "the file is no 3MF, or damaged" + (message ? " (" + std::string(message) + ")" : std::string()),
                     "export it again");
}

std::string Reader::unit() const {
    DWORD unit = 0;
    ask(ABUT_LATE(lib3mf(), NMR::lib3mf_model_getunit, path_)(model_.get(), &unit), path_);
    switch (unit) {
        case NMR::MODELUNIT_MICROMETER:
            return "um";
        case NMR::MODELUNIT_CENTIMETER:
            return "cm";
        case NMR::MODELUNIT_INCH:
            return "in";
        case NMR::MODELUNIT_FOOT:
            return "ft";
        case NMR::MODELUNIT_METER:
            return "m";
        default:
            return "mm";  // what a 3MF file without a unit means
    }
}

std::string Reader::name_of(PLib3MFBase* object) const {
    ULONG needed = 0;
    if (ABUT_LATE(lib3mf(), NMR::lib3mf_object_getnameutf8, path_)(object, nullptr, 0, &needed) != 0 || needed == 0) return "";
    std::string name(static_cast<std::size_t>(needed) + 1, '\0');
    ask(ABUT_LATE(lib3mf(), NMR::lib3mf_object_getnameutf8, path_)(object, name.data(), static_cast<ULONG>(name.size()),
                                                                   &needed),
        path_);
    return name.c_str();  // NOLINT(readability-redundant-string-cstr): up to the first zero
}

void Reader::add_mesh(PLib3MFBase* object, const Eigen::Affine3d& placement) {
    DWORD n_vertices = 0, n_triangles = 0;
    ask(ABUT_LATE(lib3mf(), NMR::lib3mf_meshobject_getvertexcount, path_)(object, &n_vertices), path_);
    ask(ABUT_LATE(lib3mf(), NMR::lib3mf_meshobject_gettrianglecount, path_)(object, &n_triangles), path_);
    if (n_vertices == 0 || n_triangles == 0) return bodies_.ignore("object", 1, "without triangles");
    std::vector<NMR::MODELMESHVERTEX> vertices(n_vertices);
    std::vector<NMR::MODELMESHTRIANGLE> triangles(n_triangles);
    ask(ABUT_LATE(lib3mf(), NMR::lib3mf_meshobject_getvertices, path_)(object, vertices.data(), n_vertices, nullptr), path_);
    ask(ABUT_LATE(lib3mf(), NMR::lib3mf_meshobject_gettriangleindices, path_)(object, triangles.data(), n_triangles, nullptr),
        path_);
    Mesh mesh{name_of(object), {}, {}};
    mesh.vertices.reserve(n_vertices);
    for (const NMR::MODELMESHVERTEX& v : vertices)
        mesh.vertices.push_back(placement * Vec3(static_cast<double>(v.m_fPosition[0]), static_cast<double>(v.m_fPosition[1]),
                                                 static_cast<double>(v.m_fPosition[2])));
    const bool mirrors = placement.linear().determinant() < 0;
    for (const NMR::MODELMESHTRIANGLE& t : triangles) {
        const int a = static_cast<int>(t.m_nIndices[0]), b = static_cast<int>(t.m_nIndices[1]),
                  c = static_cast<int>(t.m_nIndices[2]);
        mesh.triangles.push_back(mirrors ? std::array<int, 3>{a, c, b} : std::array<int, 3>{a, b, c});
    }
    bodies_.add(std::move(mesh));
}

void Reader::add_components(PLib3MFBase* object, const Eigen::Affine3d& placement, int depth) {
    DWORD n = 0;
    ask(ABUT_LATE(lib3mf(), NMR::lib3mf_componentsobject_getcomponentcount, path_)(object, &n), path_);
    for (DWORD k = 0; k < n; ++k) {
        if (++n_components_ > most_bodies) throw InputError(path_, "the file places too many components", "export fewer parts");
        const Handle component = get(path_, ABUT_LATE(lib3mf(), NMR::lib3mf_componentsobject_getcomponent, path_), object, k);
        const Handle inner = get(path_, ABUT_LATE(lib3mf(), NMR::lib3mf_component_getobjectresource, path_), component.get());
        NMR::MODELTRANSFORM transform;
        ask(ABUT_LATE(lib3mf(), NMR::lib3mf_component_gettransform, path_)(component.get(), &transform), path_);
        add_object(inner.get(), placement * placement_of(transform), depth + 1);
    }
}

void Reader::add_object(PLib3MFBase* object, const Eigen::Affine3d& placement, int depth) {
    if (depth > deepest_components) throw InputError(path_, "components are nested too deeply", "export the file again");
    BOOL is_mesh = 0, is_components = 0;
    ask(ABUT_LATE(lib3mf(), NMR::lib3mf_object_ismeshobject, path_)(object, &is_mesh), path_);
    ask(ABUT_LATE(lib3mf(), NMR::lib3mf_object_iscomponentsobject, path_)(object, &is_components), path_);
    DWORD type = 0;
    ask(ABUT_LATE(lib3mf(), NMR::lib3mf_object_gettype, path_)(object, &type), path_);
    if (type == NMR::MODELOBJECTTYPE_SUPPORT || type == NMR::MODELOBJECTTYPE_SOLIDSUPPORT)
        return bodies_.ignore("object", 1, "only supports the print");
    if (is_mesh) return add_mesh(object, placement);
    if (is_components) add_components(object, placement, depth);
}

void Reader::add_item(PLib3MFBase* item) {
    const Handle object = get(path_, ABUT_LATE(lib3mf(), NMR::lib3mf_builditem_getobjectresource, path_), item);
    NMR::MODELTRANSFORM transform;
    ask(ABUT_LATE(lib3mf(), NMR::lib3mf_builditem_getobjecttransform, path_)(item, &transform), path_);
    add_object(object.get(), placement_of(transform), 0);
}

void Reader::read() {
    open();
    bodies_.set_unit(unit());
    const Handle items = get(path_, ABUT_LATE(lib3mf(), NMR::lib3mf_model_getbuilditems, path_), model_.get());
    BOOL has_next = 0;
    int n_items = 0;
    for (;; ++n_items) {
        ask(ABUT_LATE(lib3mf(), NMR::lib3mf_builditemiterator_movenext, path_)(items.get(), &has_next), path_);
        if (!has_next) break;
        const Handle item = get(path_, ABUT_LATE(lib3mf(), NMR::lib3mf_builditemiterator_getcurrent, path_), items.get());
        add_item(item.get());
    }
    if (n_items == 0) throw InputError(path_, "the 3MF file lists nothing to build", "export the parts themselves");
}

}  // namespace

void read_3mf(const std::string& path, MeshBodies& bodies) {
    Reader(path, bodies).read();
}

}  // namespace abut::geometry
