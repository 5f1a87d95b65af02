using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Rabit.Mavlink.Generator.Roslyn;
using Xunit;

namespace Rabit.Mavlink.Tests.Generator.Compiler;

public class MavlinkGeneratorTests
{
    private const string Base = "<mavlink><enums><enum name='E'><entry name='E_A' value='1'/></enum></enums></mavlink>";

    [Fact]
    public void Run_RootWithInclude_GeneratesIntoTheChosenNamespace()
    {
        GeneratorDriverRunResult result = Run(
            new TestFile("/d/root.xml", "<mavlink><include>base.xml</include><messages><message id='1' name='M'/></messages></mavlink>", "root", "Acme.Messages"),
            new TestFile("/d/base.xml", Base, "include"));
        Assert.Empty(result.Diagnostics);
        Assert.Equal(
            new[] { "Acme.Messages.E.g.cs", "Acme.Messages.M.g.cs", "Acme.Messages.RootDialect.Instance.g.cs" },
            result.Results.Single().GeneratedSources.Select(source => source.HintName).OrderBy(name => name));
    }

    [Fact]
    public void Run_FilesThatNobodyMarked_GeneratesNothing()
    {
        GeneratorDriverRunResult result = Run(new TestFile("/d/base.xml", Base), new TestFile("/d/BannedSymbols.txt", "no XML at all"));
        Assert.Empty(result.Diagnostics);
        Assert.Empty(result.GeneratedTrees);
    }

    [Fact]
    public void Run_BadDefinition_IsACompilerErrorAtItsLine()
    {
        Diagnostic diagnostic = Run(new TestFile("/d/root.xml", "<mavlink>\n<messages>\n  <message id='x' name='M'/></messages></mavlink>", "root")).Diagnostics.Single();
        Assert.Equal("RABMAV002", diagnostic.Id);
        Assert.Equal(DiagnosticSeverity.Error, diagnostic.Severity);
        Assert.Equal("/d/root.xml", diagnostic.Location.GetLineSpan().Path);
        Assert.Equal(2, diagnostic.Location.GetLineSpan().StartLinePosition.Line);
        Assert.Contains("'x' is no id", diagnostic.GetMessage(null));
    }

    [Fact]
    public void Run_TwoRootsThatIncludeOneBadFile_ReportsItOnce()
    {
        const string Root = "<mavlink><include>bad.xml</include></mavlink>";
        GeneratorDriverRunResult result = Run(
            new TestFile("/d/a.xml", Root, "root"), new TestFile("/d/b.xml", Root, "root"), new TestFile("/d/bad.xml", "<mavlink>", "include"));
        Assert.Equal("RABMAV001", Assert.Single(result.Diagnostics).Id);
    }

    [Fact]
    public void Run_SecondTimeWithoutAChange_ReusesEverything()
    {
        var root = new TestFile("/d/root.xml", Base, "root");
        GeneratorDriver driver = Driver(root).RunGenerators(CSharpCompilation.Create("Check"));
        driver = driver.RunGenerators(CSharpCompilation.Create("Other"));
        IEnumerable<IncrementalStepRunReason> reasons = driver.GetRunResult().Results.Single().TrackedOutputSteps
            .SelectMany(steps => steps.Value).SelectMany(step => step.Outputs).Select(output => output.Reason);
        Assert.All(reasons, reason => Assert.Equal(IncrementalStepRunReason.Cached, reason));
    }

    private static GeneratorDriverRunResult Run(params TestFile[] files) =>
        Driver(files).RunGenerators(CSharpCompilation.Create("Check")).GetRunResult();

    private static CSharpGeneratorDriver Driver(params TestFile[] files) => CSharpGeneratorDriver.Create(
        [new MavlinkGenerator().AsSourceGenerator()],
        files.ToImmutableArray<AdditionalText>(),
        optionsProvider: new TestOptionsProvider(),
        driverOptions: new GeneratorDriverOptions(IncrementalGeneratorOutputKind.None, trackIncrementalGeneratorSteps: true));
}
