using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Mavlink.Generator.Emitting;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Reading;

namespace Rabit.Mavlink.Tests.Generator;

/// <summary>Definitions for tests: those of the package, and small ones made on the spot.</summary>
internal static class Definitions
{
    public static IReadOnlyList<DialectFile> PackageFiles { get; } =
        Directory.GetFiles(Path.Combine(TestData.Folder, "..", "dialects"), "*.xml")
            .Select(path => new DialectFile(path, File.ReadAllText(path))).ToList();

    public static Dialect All { get; } = Package("all.xml");

    /// <summary>What the package has, as a user's project sees it.</summary>
    public static ExistingTypes Existing { get; } = new(All, "Rabit.Mavlink.Messages");

    public static Dialect Package(string file)
    {
        DialectReadResult result = DialectReader.Read(
            PackageFiles.Single(candidate => Path.GetFileName(candidate.Path) == file), PackageFiles);
        return result.Faults.Count == 0
            ? result.Dialect
            : throw new InvalidDataException(string.Join("\n", result.Faults));
    }

    /// <summary>
    /// Reads files given as name and content; the first is the root. The content is what stands between the mavlink
    /// tags.
    /// </summary>
    public static DialectReadResult Read(params (string Name, string Content)[] files)
    {
        List<DialectFile> made = files
            .Select(file => new DialectFile("folder/" + file.Name, $"<mavlink>\n{file.Content}\n</mavlink>"))
            .ToList();
        return DialectReader.Read(made[0], made);
    }

    /// <summary>The same with the definitions of the package to include.</summary>
    public static Dialect ReadWithPackage(params (string Name, string Content)[] files)
    {
        List<DialectFile> made = files
            .Select(file => new DialectFile("folder/" + file.Name, $"<mavlink>\n{file.Content}\n</mavlink>"))
            .ToList();
        DialectReadResult result = DialectReader.Read(made[0], made.Concat(PackageFiles).ToList());
        return result.Faults.Count == 0
            ? result.Dialect
            : throw new InvalidDataException(string.Join("\n", result.Faults));
    }

    /// <summary>Reads one file that holds only messages.</summary>
    public static DialectReadResult ReadMessages(string messages)
        => Read(("root.xml", $"<messages>\n{messages}\n</messages>"));

    /// <summary>Reads one file that holds only enums.</summary>
    public static DialectReadResult ReadEnums(string enums) => Read(("root.xml", $"<enums>\n{enums}\n</enums>"));
}
