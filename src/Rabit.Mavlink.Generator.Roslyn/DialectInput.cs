using System.Threading;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.Diagnostics;
using Rabit.Mavlink.Generator.Reading;

namespace Rabit.Mavlink.Generator.Roslyn;

/// <summary>
/// An additional file that a project marked as a definition. Metadata of the item: <c>MavlinkDialect</c> is <c>root</c> (generate
/// from it) or <c>include</c> (others may include it); of a root, <c>MavlinkNamespace</c> and <c>MavlinkDialectProperty</c> say
/// where the code goes. A record of strings, so that the compiler sees when nothing changed.
/// </summary>
internal sealed record DialectInput(string Path, string Text, bool IsRoot, string? Namespace, string? DialectProperty)
{
    public DialectFile File => new(Path, Text);

    public static DialectInput? From(AdditionalText file, AnalyzerConfigOptionsProvider provider, CancellationToken cancellation)
    {
        AnalyzerConfigOptions options = provider.GetOptions(file);
        string? role = Metadata(options, "MavlinkDialect")?.ToLowerInvariant();
        if (role is not ("root" or "include"))
            return null;
        return new DialectInput(
            file.Path,
            file.GetText(cancellation)?.ToString() ?? "",
            role == "root",
            Metadata(options, "MavlinkNamespace"),
            Metadata(options, "MavlinkDialectProperty"));
    }

    private static string? Metadata(AnalyzerConfigOptions options, string name) =>
        options.TryGetValue("build_metadata.AdditionalFiles." + name, out string? value) && value.Length != 0 ? value : null;
}
