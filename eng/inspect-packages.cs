#:property PublishAot=false
#pragma warning disable MA0048 // a program of one file, run as "dotnet run eng/inspect-packages.cs -- FOLDER", is named after what it does

// Looks into the packages of a folder: is everything there that a user should find? Given a second folder, made from the
// same sources elsewhere: are its packages the same, byte for byte?
using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Xml.Linq;

// What each package may depend on: on .NET 10 on nothing from outside, down-level on Microsoft's own.
var allowed = new Dictionary<string, string[]>(StringComparer.Ordinal)
{
    ["Rabit.Core/net10.0"] = [],
    ["Rabit.Core/.NETStandard2.0"] = ["System.Memory", "System.Threading.Channels", "Microsoft.Bcl.TimeProvider"],
    ["Rabit.Mavlink/net10.0"] = [],
    ["Rabit.Mavlink/.NETStandard2.0"] = ["System.Memory", "Microsoft.Bcl.TimeProvider"],
    ["Rabit.Uav/net10.0"] = ["Rabit.Core", "Rabit.Mavlink"],
    ["Rabit.Uav.Simulation/net10.0"] = ["Rabit.Uav"],
    ["Rabit.Uav.Simulation/.NETStandard2.0"] = ["Rabit.Uav"],
    ["Rabit.Uav/.NETStandard2.0"] = ["Rabit.Core", "Rabit.Mavlink", "System.Collections.Immutable", "System.Text.Json"],
};
string[] packages = ["Rabit.Core", "Rabit.Mavlink", "Rabit.Uav", "Rabit.Uav.Simulation"];
string[] frameworks = ["net10.0", "netstandard2.0"];
var faults = new List<string>();

foreach (string id in packages)
{
    // The version begins with a digit; Rabit.Uav.Simulation is no version of Rabit.Uav.
    string[] files = [.. Directory.GetFiles(args[0], id + ".*.nupkg").Where(f => char.IsDigit(Path.GetFileName(f)[id.Length + 1]))];
    if (files.Length != 1)
    {
        faults.Add($"{id}: {files.Length} packages in {args[0]}, not one");
        continue;
    }

    Inspect(id, files[0]);
    if (args.Length > 1)
    {
        Compare(files[0]);
        Compare(Path.ChangeExtension(files[0], ".snupkg"));
    }
}

foreach (string fault in faults)
    Console.Error.WriteLine(fault);
Console.WriteLine($"{packages.Length} packages, {faults.Count} faults");
return faults.Count == 0 ? 0 : 1;

void Inspect(string id, string file)
{
    using ZipArchive package = ZipFile.OpenRead(file);
    XElement metadata = Metadata(package);
    string Text(string name) => metadata.Elements().FirstOrDefault(e => e.Name.LocalName == name)?.Value ?? "";

    Check(Text("id") == id, "id");
    Check(Text("description").Length > 20 && Text("description") != "Package Description", "description");
    Check(Text("tags").Length > 0, "tags");
    Check(Text("license") == "MIT" && metadata.Elements().Any(e => e.Name.LocalName == "license" && e.Attribute("type")?.Value == "expression"), "licence expression");
    Check(Text("readme") == "README.md" && Read(package, "README.md").Contains("```csharp", StringComparison.Ordinal), "readme with a program");
    foreach (string framework in frameworks)
    {
        Check(package.GetEntry($"lib/{framework}/{id}.dll") is not null, $"assembly for {framework}");
        Check(Read(package, $"lib/{framework}/{id}.xml").Contains("<member name=\"T:", StringComparison.Ordinal), $"documentation for {framework}");
    }

    string symbols = Path.ChangeExtension(file, ".snupkg");
    Check(File.Exists(symbols), "symbol package");
    if (File.Exists(symbols))
    {
        using ZipArchive pdbs = ZipFile.OpenRead(symbols);
        foreach (string framework in frameworks)
            Check(pdbs.GetEntry($"lib/{framework}/{id}.pdb") is not null, $"symbols for {framework}");
    }

    foreach (XElement group in metadata.Descendants().Where(e => e.Name.LocalName == "group"))
    {
        string framework = group.Attribute("targetFramework")!.Value;
        string[] unwanted = [.. group.Elements().Select(e => e.Attribute("id")!.Value).Except(allowed.GetValueOrDefault($"{id}/{framework}", []), StringComparer.Ordinal)];
        Check(unwanted.Length == 0, $"freedom from {string.Join(", ", unwanted)} for {framework}");
    }

    if (id == "Rabit.Mavlink")
    {
        Check(package.GetEntry("analyzers/dotnet/cs/Rabit.Mavlink.Generator.Roslyn.dll") is not null, "generator");
        foreach (string needed in new[] { "build/Rabit.Mavlink.props", "build/Rabit.Mavlink.targets", "buildTransitive/Rabit.Mavlink.props", "buildTransitive/Rabit.Mavlink.targets", "definitions/all.xml", "definitions/common.xml" })
            Check(package.GetEntry(needed) is not null, needed);
    }

    void Check(bool holds, string what)
    {
        if (!holds)
            faults.Add($"{id}: has no {what}");
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

    // Everything but the container's own books, which carry random names.
    using ZipArchive one = ZipFile.OpenRead(file);
    using ZipArchive two = ZipFile.OpenRead(other);
    static IEnumerable<string> Names(ZipArchive package) => package.Entries.Select(e => e.FullName).Where(n => !n.StartsWith("_rels/", StringComparison.Ordinal) && !n.StartsWith("package/", StringComparison.Ordinal));
    foreach (string entry in Names(one).Union(Names(two), StringComparer.Ordinal))
    {
        if (!Bytes(one, entry).SequenceEqual(Bytes(two, entry)))
            faults.Add($"{name}: {entry} differs when it is built in another folder");
    }
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
