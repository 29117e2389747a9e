// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/readers/read_3mf.hpp"

#include <Model/COM/NMR_DLLInterfaces.h>

#include <Eigen/Geometry>
#include <memory>

#include "geometry/brep/input_error.hpp"

namespace abut::geometry {

namespace {

using NMR::PLib3MFBase;

struct Release {
    void operator()(PLib3MFBase* handle) const { NMR::lib3mf_release(handle); }
};
using Handle = std::unique_ptr<PLib3MFBase, Release>;

/// Every call goes through here: codes other than 0 are failures.
void ask(LIB3MFRESULT code, const std::string& file) {
    if (code != 0)
        throw InputError(file, "the 3MF file is damaged (lib3mf error " + std::to_string(code) + ")", "export it again");
}

class Reader {
public:
    Reader(std::string path, MeshRecords& records) : path_(std::move(path)), records_(records) {}
    void read();

private:
    void open();
    void add_item(PLib3MFBase* item);
    void add_object(PLib3MFBase* object, const Eigen::Affine3d& placement);
    void add_mesh(PLib3MFBase* object, const Eigen::Affine3d& placement);
    void add_components(PLib3MFBase* object, const Eigen::Affine3d& placement);
    std::string name_of(PLib3MFBase* object) const;
    std::string unit() const;

    std::string path_;
    MeshRecords& records_;
    Handle model_;
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
    model_ = get(path_, NMR::lib3mf_createmodel);
    const Handle reader = get(path_, NMR::lib3mf_model_queryreader, model_.get(), "3mf");
    if (NMR::lib3mf_reader_readfromfileutf8(reader.get(), path_.c_str()) == 0) return;
    DWORD code = 0;
    const char* message = nullptr;
    NMR::lib3mf_getlasterror(reader.get(), &code, &message);
    throw InputError(path_, "the file is no 3MF, or damaged" + (message ? " (" + std::string(message) + ")" : std::string()),
                     "export it again");
}

std::string Reader::unit() const {
    DWORD unit = 0;
    ask(NMR::lib3mf_model_getunit(model_.get(), &unit), path_);
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
    if (NMR::lib3mf_object_getnameutf8(object, nullptr, 0, &needed) != 0 || needed == 0) return "";
    std::string name(static_cast<std::size_t>(needed) + 1, '\0');
    ask(NMR::lib3mf_object_getnameutf8(object, name.data(), static_cast<ULONG>(name.size()), &needed), path_);
    return name.c_str();  // NOLINT(readability-redundant-string-cstr): up to the first zero
}

void Reader::add_mesh(PLib3MFBase* object, const Eigen::Affine3d& placement) {
    DWORD n_vertices = 0, n_triangles = 0;
    ask(NMR::lib3mf_meshobject_getvertexcount(object, &n_vertices), path_);
    ask(NMR::lib3mf_meshobject_gettrianglecount(object, &n_triangles), path_);
    if (n_vertices == 0 || n_triangles == 0) return records_.ignore("object", "without triangles");
    std::vector<NMR::MODELMESHVERTEX> vertices(n_vertices);
    std::vector<NMR::MODELMESHTRIANGLE> triangles(n_triangles);
    ask(NMR::lib3mf_meshobject_getvertices(object, vertices.data(), n_vertices, nullptr), path_);
    ask(NMR::lib3mf_meshobject_gettriangleindices(object, triangles.data(), n_triangles, nullptr), path_);
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
    records_.object(mesh);
}

void Reader::add_components(PLib3MFBase* object, const Eigen::Affine3d& placement) {
    DWORD n = 0;
    ask(NMR::lib3mf_componentsobject_getcomponentcount(object, &n), path_);
    for (DWORD k = 0; k < n; ++k) {
        const Handle component = get(path_, NMR::lib3mf_componentsobject_getcomponent, object, k);
        const Handle inner = get(path_, NMR::lib3mf_component_getobjectresource, component.get());
        NMR::MODELTRANSFORM transform;
        ask(NMR::lib3mf_component_gettransform(component.get(), &transform), path_);
        add_object(inner.get(), placement * placement_of(transform));
    }
}

void Reader::add_object(PLib3MFBase* object, const Eigen::Affine3d& placement) {
    BOOL is_mesh = 0, is_components = 0;
    ask(NMR::lib3mf_object_ismeshobject(object, &is_mesh), path_);
    ask(NMR::lib3mf_object_iscomponentsobject(object, &is_components), path_);
    DWORD type = 0;
    ask(NMR::lib3mf_object_gettype(object, &type), path_);
    if (type == NMR::MODELOBJECTTYPE_SUPPORT || type == NMR::MODELOBJECTTYPE_SOLIDSUPPORT)
        return records_.ignore("object", "only supports the print");
    if (is_mesh) return add_mesh(object, placement);
    if (is_components) add_components(object, placement);
}

void Reader::add_item(PLib3MFBase* item) {
    const Handle object = get(path_, NMR::lib3mf_builditem_getobjectresource, item);
    NMR::MODELTRANSFORM transform;
    ask(NMR::lib3mf_builditem_getobjecttransform(item, &transform), path_);
    add_object(object.get(), placement_of(transform));
}

void Reader::read() {
    open();
    records_.unit(unit());
    const Handle items = get(path_, NMR::lib3mf_model_getbuilditems, model_.get());
    BOOL has_next = 0;
    int n_items = 0;
    for (;; ++n_items) {
        ask(NMR::lib3mf_builditemiterator_movenext(items.get(), &has_next), path_);
        if (!has_next) break;
        const Handle item = get(path_, NMR::lib3mf_builditemiterator_getcurrent, items.get());
        add_item(item.get());
    }
    if (n_items == 0) throw InputError(path_, "the 3MF file lists nothing to build", "export the parts themselves");
}

}  // namespace

void read_3mf(const std::string& path, MeshRecords& records) {
    Reader(path, records).read();
}

}  // namespace abut::geometry
