using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Documentation.Tests;

/// <summary>
/// What "dotnet new" makes projects of fits the packages as they are now. eng/templates-check.sh makes the projects,
/// builds and tests them.
/// </summary>
public sealed class TemplateTests
{
    private const string Folder = "src/Rabit.Templates/templates";

    public static TheoryData<string> Templates()
    {
        var data = new TheoryData<string>();
        foreach (string path in Directory.EnumerateDirectories(Path.Combine(Repository.Root, Folder)).Order())
            data.Add(Path.GetFileName(path));
        return data;
    }

    [Theory]
    [MemberData(nameof(Templates))]
    public void Sources_OfATemplate_CompileTogetherWithItsTests(string template)
        => CompiledProgram.Compile(
            [.. SourceFiles.Below($"{Folder}/{template}", "*.cs")
                .Select(f => new DocumentBlock(f, 0, "csharp", string.Empty, SourceFiles.Read(f)))]);

    [Theory]
    [MemberData(nameof(Templates))]
    public void ShortName_OfATemplate_IsThatOfItsFolder(string template)
    {
        using JsonDocument description = JsonDocument.Parse(
            SourceFiles.Read($"{Folder}/{template}/.template.config/template.json"));

        Assert.Equal(template, description.RootElement.GetProperty("shortName").GetString());
        Assert.StartsWith(
            "Rabit.Templates.", description.RootElement.GetProperty("identity").GetString(), StringComparison.Ordinal);
    }
}
