#:property PublishAot=false
// a program of one file, run as "dotnet run eng/inspect-packages.cs -- FOLDER", is named after what it does
#pragma warning disable MA0048

// Looks into the packages of a folder: is everything there that a user should find? Given a second folder, made from
// the same sources elsewhere: are its packages the same, byte for byte?
using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Reflection.Metadata;
using System.Reflection.PortableExecutable;
using System.Xml.Linq;

// eng/packages.txt: the packages, and what each may depend on. The root of the repository is the current folder: a
// deterministic build does not know where its sources are.
var allowed = new Dictionary<string, string[]>(StringComparer.Ordinal);
var packages = new List<string>();
var tools = new HashSet<string>(StringComparer.Ordinal);
foreach (string line in File.ReadLines("eng/packages.txt").Where(line => line.Length != 0 && line[0] != '#'))
{
    string[] columns = line.Split(' ', StringSplitOptions.RemoveEmptyEntries);
    packages.Add(columns[0]);
    if (columns[1] == "tool")
        tools.Add(columns[0]);
    if (columns[1] != "none")
        allowed[columns[0] + "/net10.0"] = columns[1] is "-" or "tool" ? [] : columns[1].Split(',');
    if (columns[2] != "none")
        allowed[columns[0] + "/.NETStandard2.0"] = columns[2] == "-" ? [] : columns[2].Split(',');
}

var faults = new List<string>();

foreach (string id in packages)
{
    // The version begins with a digit; Rabit.Uav.Simulation is no version of Rabit.Uav.
    string[] files =
        [.. Directory.GetFiles(args[0], id + ".*.nupkg").Where(f => char.IsDigit(Path.GetFileName(f)[id.Length + 1]))];
    if (files.Length != 1)
    {
        faults.Add($"{id}: {files.Length} packages in {args[0]}, not one");
        continue;
    }

    Inspect(id, files[0]);
    if (args.Length > 1)
    {
        Compare(files[0]);
        string symbols = Path.ChangeExtension(files[0], ".snupkg");
        if (File.Exists(symbols))
            Compare(symbols);
    }
}

foreach (string fault in faults)
    Console.Error.WriteLine(fault);
Console.WriteLine($"{packages.Count} packages, {faults.Count} faults");
return faults.Count == 0 ? 0 : 1;

void Inspect(string id, string file)
{
    using ZipArchive package = ZipFile.OpenRead(file);
    XElement metadata = Metadata(package);
    bool isTemplates = !allowed.ContainsKey(id + "/net10.0");
    string[] frameworks = allowed.ContainsKey(id + "/.NETStandard2.0") ? ["net10.0", "netstandard2.0"] : ["net10.0"];
    string Text(string name) => metadata.Elements().FirstOrDefault(e => e.Name.LocalName == name)?.Value ?? "";

    Check(Text("id") == id, "id");
    Check(Text("description").Length > 20 && Text("description") != "Package Description", "description");
    Check(Text("tags").Length > 0, "tags");
    Check(
        Text("license") == "MIT"
            && metadata.Elements()
                .Any(e => e.Name.LocalName == "license" && e.Attribute("type")?.Value == "expression"),
        "licence expression");
    Check(
        Text("readme") == "README.md"
            && Read(package, "README.md").Contains(
                isTemplates ? "dotnet new" : tools.Contains(id) ? "dotnet tool install" : "```csharp",
                StringComparison.Ordinal),
        tools.Contains(id) ? "readme with its installation" : "readme with a program");
    Check(
        Text("icon") == "icon.png" && Bytes(package, "icon.png") is [0x89, (byte)'P', (byte)'N', (byte)'G', ..],
        "icon");
    Check(
        Text("releaseNotes").Contains("CHANGELOG.md", StringComparison.Ordinal)
            && package.GetEntry("CHANGELOG.md") is not null,
        "release notes");
    if (isTemplates)
    {
        InspectTemplates(id, package, Text("version"));
        return;
    }

    foreach (ZipArchiveEntry assembly in package.Entries.Where(
        e => e.Name.StartsWith("Rabit.", StringComparison.Ordinal) && e.Name.EndsWith(".dll", StringComparison.Ordinal)))
        Check(
            PathOfSymbols(Bytes(package, assembly.FullName)) is var path
                && (path.StartsWith("/_", StringComparison.Ordinal) || Path.GetFileName(path) == path),
            $"freedom from the packer's paths: {assembly.FullName} says {path}");
    if (tools.Contains(id))
        InspectTool(id, package, metadata);
    foreach (string framework in frameworks.Where(_ => !tools.Contains(id)))
    {
        Check(package.GetEntry($"lib/{framework}/{id}.dll") is not null, $"assembly for {framework}");
        Check(
            Read(package, $"lib/{framework}/{id}.xml").Contains("<member name=\"T:", StringComparison.Ordinal),
            $"documentation for {framework}");
    }

    string symbols = Path.ChangeExtension(file, ".snupkg");
    Check(File.Exists(symbols), "symbol package");
    if (File.Exists(symbols))
    {
        using ZipArchive pdbs = ZipFile.OpenRead(symbols);
        foreach (string framework in frameworks)
        {
            string pdb = tools.Contains(id) ? $"tools/{framework}/any/{id}.pdb" : $"lib/{framework}/{id}.pdb";
            Check(pdbs.GetEntry(pdb) is not null, $"symbols for {framework}");
            if (pdbs.GetEntry(pdb) is not null)
                InspectSources(id, framework, Bytes(pdbs, pdb));
        }
    }

    foreach (XElement group in metadata.Descendants()
        .Where(e => e.Name.LocalName == "group" && e.Parent!.Name.LocalName == "dependencies"))
    {
        string framework = group.Attribute("targetFramework")!.Value;
        string[] unwanted = [.. group.Elements().Select(e => e.Attribute("id")!.Value)
            .Except(allowed.GetValueOrDefault($"{id}/{framework}", []), StringComparer.Ordinal)];
        Check(unwanted.Length == 0, $"freedom from {string.Join(", ", unwanted)} for {framework}");
    }

    if (id == "Rabit.Core")
        Check(package.GetEntry("analyzers/dotnet/cs/Rabit.Core.Analyzers.dll") is not null, "analyzers");
    if (id == "Rabit.Mavlink")
    {
        Check(package.GetEntry("analyzers/dotnet/cs/Rabit.Mavlink.Generator.Roslyn.dll") is not null, "generator");
        Check(
            Read(package, "lib/net10.0/Rabit.Mavlink.xml").Contains("AttitudeQuaternion", StringComparison.Ordinal),
            "documentation of messages");
        foreach (string needed in new[]
        {
            "build/Rabit.Mavlink.props", "build/Rabit.Mavlink.targets", "buildTransitive/Rabit.Mavlink.props",
            "buildTransitive/Rabit.Mavlink.targets", "definitions/all.xml", "definitions/common.xml"
        })
            Check(package.GetEntry(needed) is not null, needed);
    }

    // A package that depends on Rabit.Mavlink, directly or not, passes its generator on.
    foreach (XElement dependency in metadata.Descendants().Where(
        e => e.Name.LocalName == "dependency" && packages.Contains(e.Attribute("id")!.Value, StringComparer.Ordinal)))
        Check(
            dependency.Attribute("exclude")?.Value.Contains("Analyzers", StringComparison.Ordinal) != true,
            $"way for the generator: it excludes the analyzers of {dependency.Attribute("id")!.Value}");

    void Check(bool holds, string what)
    {
        if (!holds)
            faults.Add($"{id}: has no {what}");
    }
}

// Files that "dotnet new" makes a project of: of all templates of the sources, each with the version of this package, and
// nothing else.
void InspectTemplates(string id, ZipArchive package, string version)
{
    XElement metadata = Metadata(package);
    if (!metadata.Descendants().Any(e => e.Name.LocalName == "packageType" && e.Attribute("name")?.Value == "Template"))
        faults.Add($"{id}: is no package of templates");
    if (metadata.Descendants().Any(e => e.Name.LocalName == "dependency"))
        faults.Add($"{id}: depends on packages");
    foreach (string unwanted in package.Entries.Select(e => e.FullName)
        .Where(n => n.StartsWith("lib/", StringComparison.Ordinal) || n.Contains("/obj/") || n.Contains("/bin/")))
        faults.Add($"{id}: has {unwanted}");
    foreach (string template in Directory.GetDirectories($"src/{id}/templates").Select(f => Path.GetFileName(f)))
    {
        if (package.GetEntry($"content/{template}/.template.config/template.json") is null)
            faults.Add($"{id}: has no template {template}");
        if (!Read(package, $"content/{template}/Directory.Packages.props").Contains(
            $"<RabitVersion>{version}</RabitVersion>", StringComparison.Ordinal))
            faults.Add($"{id}: {template} does not ask for version {version}");
    }
}

// What "dotnet tool install" needs: the type of the package, the settings with the command, and all in one folder.
void InspectTool(string id, ZipArchive package, XElement metadata)
{
    const string Folder = "tools/net10.0/any/";
    if (!metadata.Descendants()
        .Any(e => e.Name.LocalName == "packageType" && e.Attribute("name")?.Value == "DotnetTool"))
        faults.Add($"{id}: is no DotnetTool");
    string settings = Read(package, Folder + "DotnetToolSettings.xml");
    if (!settings.Contains($"EntryPoint=\"{id}.dll\"", StringComparison.Ordinal)
        || package.GetEntry($"{Folder}{id}.dll") is null)
        faults.Add($"{id}: has no program");
    foreach (ZipArchiveEntry other in package.Entries.Where(e => e.FullName.StartsWith("lib/", StringComparison.Ordinal)
        || (e.FullName.StartsWith("tools/", StringComparison.Ordinal)
            && !e.FullName.StartsWith(Folder, StringComparison.Ordinal))))
        faults.Add($"{id}: is a tool, and has {other.FullName}");
}

// Every source is in the symbols, and under no path of the machine that packed.
void InspectSources(string id, string framework, byte[] pdb)
{
    // Portable PDB specification, "Embedded Source"
    var embeddedSource = new Guid("0E8A571B-6926-466E-B4AD-8AB04611F5FE");
    using MetadataReaderProvider provider = MetadataReaderProvider.FromPortablePdbStream(new MemoryStream(pdb));
    MetadataReader reader = provider.GetMetadataReader();
    foreach (DocumentHandle handle in reader.Documents)
    {
        string name = reader.GetString(reader.GetDocument(handle).Name);
        if (!name.StartsWith("/_", StringComparison.Ordinal))
            faults.Add($"{id}: its symbols for {framework} have a path of the packer: {name}");
        if (!reader.GetCustomDebugInformation(handle)
            .Any(info => reader.GetGuid(reader.GetCustomDebugInformation(info).Kind) == embeddedSource))
            faults.Add($"{id}: its symbols for {framework} do not hold the source {name}");
    }
}

void Compare(string file)
{
    string name = Path.GetFileName(file);
    string other = Path.Combine(args[1], name);
    if (!File.Exists(other))
    {
        faults.Add($"{name}: is not in {args[1]}");
        return;
    }

    // Everything but the container's own records, which carry random names.
    using ZipArchive one = ZipFile.OpenRead(file);
    using ZipArchive two = ZipFile.OpenRead(other);
    static IEnumerable<string> Names(ZipArchive package) => package.Entries.Select(e => e.FullName).Where(
        n => !n.StartsWith("_rels/", StringComparison.Ordinal) && !n.StartsWith("package/", StringComparison.Ordinal));
    foreach (string entry in Names(one).Union(Names(two), StringComparer.Ordinal))
    {
        if (!Bytes(one, entry).SequenceEqual(Bytes(two, entry)))
            faults.Add($"{name}: {entry} differs when it is built in another folder");
    }
}

// Where the compiler wrote the symbols, as the assembly says.
static string PathOfSymbols(byte[] assembly)
{
    using var reader = new PEReader(new MemoryStream(assembly));
    DebugDirectoryEntry[] entries =
        [.. reader.ReadDebugDirectory().Where(e => e.Type == DebugDirectoryEntryType.CodeView)];
    return entries.Length == 0 ? "" : reader.ReadCodeViewDebugDirectoryData(entries[0]).Path;
}

static XElement Metadata(ZipArchive package)
{
    using Stream stream = package.Entries.Single(e => e.FullName.EndsWith(".nuspec", StringComparison.Ordinal)).Open();
    return XDocument.Load(stream).Root!.Elements().First(e => e.Name.LocalName == "metadata");
}

static string Read(ZipArchive package, string entry) => System.Text.Encoding.UTF8.GetString(Bytes(package, entry));

static byte[] Bytes(ZipArchive package, string entry)
{
    using var copy = new MemoryStream();
    using Stream? stream = package.GetEntry(entry)?.Open();
    stream?.CopyTo(copy);
    return copy.ToArray();
}
