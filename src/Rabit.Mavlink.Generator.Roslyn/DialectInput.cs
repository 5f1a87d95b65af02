using System.Threading;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.Diagnostics;
using Rabit.Mavlink.Generator.Reading;

namespace Rabit.Mavlink.Generator.Roslyn;

/// <summary>
/// An additional file that is a definition. Metadata of the item: <c>MavlinkRole</c> says whose it is;
/// <c>MavlinkNamespace</c> and <c>MavlinkDialectProperty</c> say where the code goes. A record of strings, so that the
/// compiler sees when nothing changed.
/// </summary>
internal sealed record DialectInput(
    string Path, string Text, DialectRole Role, string? Namespace, string? DialectProperty)
{
    public DialectFile File => new(Path, Text);

    public static DialectInput? From(
        AdditionalText file, AnalyzerConfigOptionsProvider provider, CancellationToken cancellation)
    {
        AnalyzerConfigOptions options = provider.GetOptions(file);
        DialectRole role = Metadata(options, "MavlinkRole") switch
        {
            "own" => DialectRole.Own,
            "package" => DialectRole.Package,
            "source" => DialectRole.PackageSource,
            _ => DialectRole.None,
        };
        if (role == DialectRole.None)
            return null;
        return new DialectInput(
            file.Path,
            file.GetText(cancellation)?.ToString() ?? "",
            role,
            Metadata(options, "MavlinkNamespace"),
            Metadata(options, "MavlinkDialectProperty"));
    }

    private static string? Metadata(AnalyzerConfigOptions options, string name) =>
        options.TryGetValue("build_metadata.AdditionalFiles." + name, out string? value) && value.Length != 0
            ? value
            : null;
}
