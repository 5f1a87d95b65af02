using System.IO;
using System.Threading.Tasks;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Analyzers;

/// <summary>What users copy: the examples of the XML documentation of Rabit.Core.</summary>
public sealed class ExampleAnalysisTests
{
    [Fact]
    public async Task Examples_OfTheDocumentation_AreWhatTheAnalyzersAsk()
    {
        string examples = await File.ReadAllTextAsync(
            Path.Combine(Repository.Root, "tests", "Rabit.Core.Tests", "Documentation", "Examples.cs"));

        Assert.Empty(await AnalyzedManager.ReportOf(examples));
    }
}
