using System.Linq;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Documentation;

/// <summary>
/// The examples in the XML documentation of Rabit.Core are code that compiles: they are in Examples.cs, line by line.
/// </summary>
public sealed class ExampleTests
{
    [Fact]
    public void Examples_OfTheDocumentation_AreLinesOfExamplesThatCompile()
    {
        string[] compiled = DocumentationExamples.LinesOf("tests", "Rabit.Core.Tests", "Documentation", "Examples.cs");
        (string File, string[] Lines)[] examples = [.. DocumentationExamples.Find("src", "Rabit.Core")];

        Assert.True(examples.Length >= 8, $"There are only {examples.Length} examples.");
        Assert.Empty(examples.Where(e => !DocumentationExamples.Contain(compiled, e.Lines)).Select(e => e.File));
    }
}
