// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/readers/step/step_file.hpp"

#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRep_Tool.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Interface_CheckIterator.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_SolidModel.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cctype>
#include <map>

#include "geometry/brep/input_error.hpp"
#include "geometry/mesh/body_names.hpp"
#include "geometry/mesh/mesh.hpp"

namespace abut::geometry {

namespace {

/// Empty where a translator made the name up.
std::string name_of(const TDF_Label& label) {
    Handle(TDataStd_Name) attribute;
    if (!label.FindAttribute(TDataStd_Name::GetID(), attribute)) return "";
    std::string name = TCollection_AsciiString(attribute->Get()).ToCString();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return std::iscntrl(static_cast<unsigned char>(c)); }, ' ');
    const std::size_t first = name.find_first_not_of(' '), last = name.find_last_not_of(' ');
    name = first == std::string::npos ? "" : name.substr(first, last - first + 1);
    const bool is_made_up = name.rfind("Open CASCADE STEP translator", 0) == 0 || name.rfind("=>[", 0) == 0 ||
                            name == "SOLID" || name == "COMPOUND" || name == "SHELL" || name == "NONE";
    return is_made_up ? "" : name;
}

/// Solids out of the tree of products.
class Products {
public:
    Products(StepFile& file, std::string path, StepRecords& records) : file_(file), path_(std::move(path)), records_(records) {}

    /// `used_as`: what the assembly calls this use of a product; for products without a name.
    void add(const TDF_Label& label, const TopLoc_Location& above, const std::string& used_as) {
        TDF_Label product = label;
        TopLoc_Location place = above;
        if (XCAFDoc_ShapeTool::IsReference(label)) {
            place = above * XCAFDoc_ShapeTool::GetLocation(label);
            XCAFDoc_ShapeTool::GetReferredShape(label, product);
        }
        const std::string own = name_of(product), name = own.empty() ? used_as : own;
        if (!XCAFDoc_ShapeTool::IsAssembly(product)) return add_shapes(XCAFDoc_ShapeTool::GetShape(product).Moved(place), name);
        TDF_LabelSequence components;
        XCAFDoc_ShapeTool::GetComponents(product, components);
        for (int k = 1; k <= components.Length(); ++k) add(components(k), place, name_of(components(k)));
    }

private:
    void add_shapes(const TopoDS_Shape& shape, const std::string& name) {
        const std::string product = name.empty() ? "a product without a name" : name;
        std::vector<TopoDS_Shape> solids;
        for (TopExp_Explorer at(shape, TopAbs_SOLID); at.More(); at.Next()) solids.push_back(at.Current());
        int n_open = 0;
        for (TopExp_Explorer at(shape, TopAbs_SHELL, TopAbs_SOLID); at.More(); at.Next()) {
            if (!BRep_Tool::IsClosed(at.Current())) {
                ++n_open;
                continue;
            }
            solids.push_back(BRepBuilderAPI_MakeSolid(TopoDS::Shell(at.Current())).Solid());
            records_.repair({"a closed shell of " + product + " is taken for a solid", Vec2::Zero(), 0});
        }
        if (n_open > 0) records_.ignore("open shell of " + product, "bounds no solid");
        if (TopExp_Explorer(shape, TopAbs_FACE, TopAbs_SHELL).More())
            records_.ignore("surface of " + product, "bounds no solid");
        if (TopExp_Explorer(shape, TopAbs_EDGE, TopAbs_FACE).More()) records_.ignore("curve of " + product, "bounds no solid");
        for (const TopoDS_Shape& solid : solids) add_solid(solid, name, solids.size() > 1);
    }

    void add_solid(const TopoDS_Shape& solid, const std::string& name, bool is_one_of_several) {
        if (file_.solids.size() >= most_bodies)
            throw InputError(path_, "the file holds more than " + std::to_string(most_bodies) + " solids",
                             "export only the parts that matter");
        file_.solids.push_back({names_.next(name, is_one_of_several), solid});
        for (TopExp_Explorer at(solid, TopAbs_SHELL); at.More(); at.Next()) {
            if (BRep_Tool::IsClosed(at.Current())) continue;
            records_.repair(
                {"the solid " + file_.solids.back().name + " is not closed: its section may not be either", Vec2::Zero(), 0});
            return;
        }
    }

    StepFile& file_;
    std::string path_;
    StepRecords& records_;
    BodyNames names_{"solid"};
};

/// The unit of the file's numbers. OpenCASCADE brings all of them to millimetres; they go back to the file's unit.
void find_unit(STEPControl_Reader& reader, StepFile& file, StepRecords& records) {
    static const std::map<std::string, std::string> known = {{"millimetre", "mm"}, {"centimetre", "cm"}, {"metre", "m"},
                                                             {"micrometre", "um"}, {"inch", "in"},       {"foot", "ft"}};
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    reader.FileUnits(lengths, angles, solid_angles);
    file.unit = "mm";
    if (lengths.IsEmpty()) {
        records.repair({"the file states no unit of length: millimetres are assumed", Vec2::Zero(), 0});
        return;
    }
    std::string name = lengths.First().ToCString();
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    const auto found = known.find(name);
    if (found != known.end())
        file.unit = found->second;
    else
        records.repair({"the file's unit of length, '" + name +
                            "', is none that is known here: taken for what OpenCASCADE makes of " + "it, and brought to mm",
                        Vec2::Zero(), 0});
    file.unit_size = unit_factor(file.unit, "mm");
    for (int k = 2; k <= lengths.Length(); ++k)
        if (!(lengths(k) == lengths.First()))
            return records.repair(
                {"the file mixes units of length, " + name + " and others: all is brought to " + file.unit, Vec2::Zero(), 0});
}

/// What of the file's own solids came to nothing, and how many of its entities are damaged.
void tell_losses(STEPControl_Reader& reader, StepRecords& records) {
    const Handle(StepData_StepModel) model = reader.StepModel();
    const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
    for (int k = 1; k <= model->NbEntities(); ++k) {
        if (!model->Value(k)->IsKind(STANDARD_TYPE(StepShape_SolidModel))) continue;
        const Handle(Transfer_Binder) binder = process->Find(model->Value(k));
        if (!binder.IsNull() && !TransferBRep::ShapeResult(binder).IsNull()) continue;
        records.problem("the solid #" + std::to_string(model->IdentLabel(model->Value(k))) + " of the file cannot be read", "",
                        "export it again");
    }
    int n_damaged = 0;
    std::string first;
    Interface_CheckIterator checks = reader.WS()->ModelCheckList(Standard_True);
    for (checks.Start(); checks.More(); checks.Next()) {
        if (!checks.Value()->HasFailed()) continue;
        if (n_damaged++ == 0 && checks.Number() > 0)
            first = ", the first #" + std::to_string(model->IdentLabel(model->Value(checks.Number())));
    }
    if (n_damaged > 0)
        records.repair({std::to_string(n_damaged) + " entities of the file are damaged" + first +
                            ": what is made of them may be wrong or missing",
                        Vec2::Zero(), 0});
}

}  // namespace

StepFile read_step(const std::string& path, StepRecords& records) {
    // What it has to say of a file it would print beside our one sentence.
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
    STEPCAFControl_Reader reader;
    reader.SetColorMode(Standard_False);
    reader.SetLayerMode(Standard_False);
    reader.SetPropsMode(Standard_False);
    reader.SetGDTMode(Standard_False);
    reader.SetMatMode(Standard_False);
    reader.SetNameMode(Standard_True);
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
        throw InputError(path, "the file is no STEP, or damaged", "export it again");
    StepFile file;
    find_unit(reader.ChangeReader(), file, records);
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
    if (!reader.Transfer(document)) throw InputError(path, "nothing of the STEP file can be read", "export it again");
    TDF_LabelSequence products;
    XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(products);
    Products tree(file, path, records);
    for (int k = 1; k <= products.Length(); ++k) tree.add(products(k), {}, "");
    tell_losses(reader.ChangeReader(), records);
    if (file.solids.empty())
        throw InputError(path, "the STEP file holds no solids", "export solids: surfaces and meshes have no inside");
    return file;
}

}  // namespace abut::geometry
