using System.Collections.Generic;
using System.Text;
using System.Threading;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.Text;

namespace Rabit.Mavlink.Tests.Generator.Compiler;

/// <summary>An additional file with the metadata that a project would give it.</summary>
internal sealed class TestFile(string path, string text, string? role = null, string? space = null) : AdditionalText
{
    public override string Path => path;

    public Dictionary<string, string> Metadata { get; } = new()
    {
        ["build_metadata.AdditionalFiles.MavlinkRole"] = role ?? "",
        ["build_metadata.AdditionalFiles.MavlinkNamespace"] = space ?? "",
    };

    public override SourceText GetText(CancellationToken cancellationToken = default)
        => SourceText.From(text, Encoding.UTF8);
}
