// SPDX-License-Identifier: GPL-3.0-or-later
// The Python module abut: scenes and results as dictionaries like those of their files, lists of numbers as numpy arrays.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>

#include "geometry/brep/input_error.hpp"
#include "src/analysis/analysis.hpp"
#include "src/results/case_result.hpp"
#include "src/scene/read_scene.hpp"
#include "src/session/session.hpp"

namespace py = pybind11;

namespace abut {
namespace {

/// A scene as a dictionary like that of a scene file, whose own files are looked for from `folder`; or the path of such a file.
Scene scene_of(const py::object& scene, const std::string& folder) {
    if (!py::isinstance<py::dict>(scene)) return read_scene(py::str(scene));
    const py::object text = py::module_::import("json").attr("dumps")(scene, py::arg("allow_nan") = false);
    return read_scene_text(py::cast<std::string>(text), folder + "/scene");
}

py::array_t<double> array_of(const std::vector<double>& values) {
    return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::array_t<double> pair_of(const Vec2& v) {
    return array_of({v.x(), v.y()});
}

/// Columns of numbers of field samples by name.
void put_samples(const std::vector<FieldSample>& samples, py::dict& to) {
    const auto column = [&](const char* name, auto value) {
        std::vector<double> values;
        for (const FieldSample& s : samples) values.push_back(value(s));
        to[name] = array_of(values);
    };
    column("x", [](const FieldSample& s) { return s.at.x(); });
    column("y", [](const FieldSample& s) { return s.at.y(); });
    column("ux", [](const FieldSample& s) { return s.displacement.x(); });
    column("uy", [](const FieldSample& s) { return s.displacement.y(); });
    column("xx", [](const FieldSample& s) { return s.stress.xx; });
    column("yy", [](const FieldSample& s) { return s.stress.yy; });
    column("xy", [](const FieldSample& s) { return s.stress.xy; });
    column("zz", [](const FieldSample& s) { return s.stress.zz; });
    column("von_mises", [](const FieldSample& s) { return von_mises(s.stress); });
}

py::list fields_list(const std::vector<PartField>& fields, const std::vector<PartResult>& parts) {
    py::list list;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        py::dict field;
        field["part"] = parts[i].name;
        put_samples(fields[i].samples, field);
        py::array_t<int> patches({static_cast<py::ssize_t>(fields[i].patches.size()), py::ssize_t{4}});
        auto corners = patches.mutable_unchecked<2>();
        for (py::ssize_t k = 0; k < corners.shape(0); ++k)
            for (py::ssize_t c = 0; c < 4; ++c)
                corners(k, c) = fields[i].patches[static_cast<std::size_t>(k)].corner[static_cast<std::size_t>(c)];
        field["patches"] = patches;
        py::list boundary;
        for (const std::vector<FieldSample>& loop : fields[i].boundary) {
            py::dict samples;
            put_samples(loop, samples);
            boundary.append(samples);
        }
        field["boundary"] = boundary;
        list.append(field);
    }
    return list;
}

/// As result.json; contacts have their "profile", "fields" are those of the parts, "units" the scene's.
py::dict result_dict(const Result& result) {
    py::dict dict = py::module_::import("json").attr("loads")(result_json(result));
    py::list contacts = dict["contacts"];
    for (std::size_t k = 0; k < result.contacts.size(); ++k) {
        const ContactProfile& p = result.contacts[k].profile;
        py::dict profile;
        profile["edge"] = p.edge;
        profile["edge2"] = p.edge2;
        for (const auto& [name, values] : {std::pair{"s", &p.s},
                                           {"x", &p.x},
                                           {"y", &p.y},
                                           {"pressure", &p.pressure},
                                           {"gap", &p.gap},
                                           {"shear", &p.shear},
                                           {"s2", &p.s2},
                                           {"x2", &p.x2},
                                           {"y2", &p.y2}})
            profile[name] = array_of(*values);
        contacts[k]["profile"] = profile;
    }
    dict["fields"] = fields_list(result.fields, result.parts);
    py::dict units;  // labels, may be empty
    units["length"] = result.length_unit;
    units["force"] = result.force_unit;
    dict["units"] = units;
    return dict;
}

py::dict answer_dict(const Answer& answer) {
    py::dict dict;
    dict["status"] = answer.status;
    dict["message"] = answer.message;
    dict["doubts"] = answer.doubts;
    py::list contacts, probes;
    for (const ContactAnswer& c : answer.contacts) {
        py::dict contact, largest;
        largest["value"] = c.max_pressure.value;
        largest["at"] = pair_of(c.max_pressure.at);
        contact["parts"] = c.parts;
        contact["between"] = c.between;
        contact["kind"] = c.kind;
        contact["status"] = c.status;
        contact["force"] = pair_of(c.force);
        contact["moment"] = c.moment;
        contact["contact_length"] = c.contact_length;
        contact["max_pressure"] = largest;
        contact["error_at_ends"] = c.error_at_ends;
        contact["edge"] = c.places->edge;
        contact["s"] = array_of(c.places->s);
        contact["x"] = array_of(c.places->x);
        contact["y"] = array_of(c.places->y);
        contact["pressure"] = array_of(c.pressure);
        contact["shear"] = array_of(c.shear);
        contacts.append(contact);
    }
    for (const ProbeAnswer& p : answer.probes) {
        py::dict probe;
        probe["part"] = p.part;
        probe["at"] = pair_of(p.at);
        probe["displacement"] = pair_of(p.displacement);
        probes.append(probe);
    }
    dict["contacts"] = contacts;
    dict["probes"] = probes;
    return dict;
}

AnalyzeOptions with_threads(int threads) {
    AnalyzeOptions options;
    options.threads = threads;
    return options;
}

/// Runs without Python's lock: other threads go on.
template <class F>
decltype(auto) unlocked(F work) {
    const py::gil_scoped_release release;
    return work();
}

py::dict analyze_scene(const py::object& scene, const std::string& folder, int threads) {
    const Scene read = scene_of(scene, folder);
    if (read.cases.empty()) return result_dict(unlocked([&] { return analyze(read, with_threads(threads)); }));
    py::dict cases;
    for (const CaseResult& c : unlocked([&] { return analyze_cases(read, with_threads(threads)); }))
        cases[py::str(c.name)] = result_dict(c.result);
    py::dict dict;
    dict["cases"] = cases;
    return dict;
}

}  // namespace
}  // namespace abut

PYBIND11_MODULE(abut, m) {
    using namespace abut;
    m.doc() = "2D contact analysis of CAD assemblies with B-spline finite elements";
    py::register_exception<InputError>(m, "InputError", PyExc_ValueError);
    m.def(
        "analyze", &analyze_scene, py::arg("scene"), py::arg("folder") = ".", py::arg("threads") = 0,
        "Analyses a scene: a dictionary like a scene file, whose own files are looked for from `folder`, or a path. The result "
        "is a dictionary like result.json with \"profile\" (arrays) in every contact and \"fields\" of every part; of a scene "
        "with load cases {\"cases\": {name: result}}. Raises InputError for whatever is wrong with the scene.");
    py::class_<Session>(m, "Session", "A scene to ask again and again under other factors of its named loads.")
        .def(py::init([](const py::object& scene, const std::string& folder, int threads) {
                 return std::make_unique<Session>(scene_of(scene, folder), with_threads(threads));
             }),
             py::arg("scene"), py::arg("folder") = ".", py::arg("threads") = 0)
        .def_property_readonly("loads", &Session::loads, "The factors by the names of the loads.")
        .def("set_load", &Session::set_load, py::arg("name"), py::arg("factor"))
        .def("set_case", &Session::set_case, py::arg("name"))
        .def(
            "prepare", [](Session& s) { return result_dict(unlocked([&]() -> const Result& { return s.prepare(); })); },
            "Makes grids for the present factors: the result. Seconds.")
        .def(
            "answer", [](Session& s) { return answer_dict(unlocked([&] { return s.answer(); })); },
            "Pressures, forces and displacements of probes under the present factors. Milliseconds.")
        .def(
            "result", [](Session& s) { return result_dict(unlocked([&]() -> const Result& { return s.result(); })); },
            "The whole result under the present factors.")
        .def(
            "fields",
            [](Session& s) {
                const std::vector<PartField> fields = unlocked([&] { return s.fields(); });
                py::list list;
                if (fields.empty()) return list;
                std::vector<PartResult> parts;
                for (const ScenePart& part : s.scene().parts) {
                    parts.emplace_back();
                    parts.back().name = part.name;
                }
                return fields_list(fields, parts);
            },
            "Displacements and stresses of every part under the present factors, on the grids prepared.");
}
