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
    public void Run_FileThatIncludesAnother_IsOneDialectInTheChosenNamespace()
    {
        GeneratorDriverRunResult result = Run(
            new TestFile("/d/base.xml", Base, "own", "Acme.Messages"),
            new TestFile(
                "/d/root.xml",
                "<mavlink><include>base.xml</include><messages><message id='1' name='M'><field type='uint8_t' "
                    + "name='a'/></message></messages></mavlink>",
                "own", "Acme.Messages"));
        Assert.Empty(result.Diagnostics);
        Assert.Equal(
            ["Acme.Messages.E.g.cs", "Acme.Messages.M.g.cs", "Acme.Messages.RootDialect.Instance.g.cs"], Names(result));
    }

    [Fact]
    public void Run_NoNamespaceChosen_IsMessagesBelowThatOfTheProject() =>
        Assert.Equal(
            ["Acme.App.Messages.BaseDialect.Instance.g.cs", "Acme.App.Messages.E.g.cs"],
            Names(Run(new TestFile("/d/base.xml", Base, "own"))));

    [Fact]
    public void Run_TwoRootsOfOneNamespace_GetOneEach() =>
        Assert.Equal(
            ["N.OneFile.E.g.cs", "N.OneFile.OneFileDialect.Instance.g.cs", "N.Two.E.g.cs",
                "N.Two.TwoDialect.Instance.g.cs", "N.Two2.TwoDialect.Instance.g.cs"],
            Names(Run(
                new TestFile("/d/one-file.xml", Base, "own", "N"), new TestFile("/d/two.xml", Base, "own", "N"),
                new TestFile("/e/two.xml", "<mavlink/>", "own", "N"))));

    [Fact]
    public void Run_IncludeOfThePackage_EmitsOnlyWhatIsNew()
    {
        GeneratorDriverRunResult result = Run(
            new TestFile("/d/mine.xml", """
                <mavlink><include>all.xml</include><enums><enum name="E"><entry name="E_B" value="2"/></enum></enums>
                <messages><message id="70000" name="OWN"><field type="uint8_t" name="a" enum="E"/><field type="uint8_t" name="b" enum="F"/>
                <field type="float[3]" name="c"/><field type="float[4]" name="d"/></message></messages></mavlink>
                """, "own"),
            new TestFile("/p/all.xml", """
                <mavlink><enums><enum name="E"><entry name="E_A" value="1"/></enum><enum name="F"><entry name="F_A" value="1"/></enum></enums>
                <messages><message id="5" name="THEIRS"><field type="float[3]" name="a"/></message></messages></mavlink>
                """, "package"));
        Assert.Empty(result.Diagnostics);
        Assert.Equal(
            ["Acme.App.Messages.FloatArray4.g.cs", "Acme.App.Messages.MineDialect.Instance.g.cs",
                "Acme.App.Messages.MineE.g.cs", "Acme.App.Messages.Own.g.cs"],
            Names(result));
        string own = Text(result, "Own.g.cs");
        Assert.Contains("public global::Rabit.Mavlink.Messages.E A", own);
        Assert.Contains("public global::Rabit.Mavlink.Messages.F B", own);
        Assert.Contains("public global::Rabit.Mavlink.Messages.FloatArray3 C", own);
        Assert.Contains("public FloatArray4 D", own);
        Assert.Contains(
            "public const global::Rabit.Mavlink.Messages.E B = (global::Rabit.Mavlink.Messages.E)(2);",
            Text(result, "MineE.g.cs"));
        Assert.DoesNotContain(" A = ", Text(result, "MineE.g.cs"));
    }

    [Fact]
    public void Run_PackageDefinitionsWithoutOwnOnes_GeneratesNothing() =>
        Assert.Empty(Run(new TestFile("/p/all.xml", Base, "package")).GeneratedTrees);

    [Fact]
    public void Run_IncludeCycle_IsOneErrorAndNoCrash()
    {
        GeneratorDriverRunResult result = Run(
            new TestFile("/d/a.xml", "<mavlink>\n<include>b.xml</include></mavlink>", "own"),
            new TestFile("/d/b.xml", "<mavlink>\n\n<include>a.xml</include></mavlink>", "own"));
        Diagnostic diagnostic = Assert.Single(result.Diagnostics);
        Assert.Equal(("RABMAV004", 2), (diagnostic.Id, diagnostic.Location.GetLineSpan().StartLinePosition.Line));
    }

    [Fact]
    public void Run_FilesWithoutARole_GeneratesNothing()
    {
        GeneratorDriverRunResult result = Run(
            new TestFile("/d/base.xml", Base), new TestFile("/d/BannedSymbols.txt", "no XML at all"));
        Assert.Empty(result.Diagnostics);
        Assert.Empty(result.GeneratedTrees);
    }

    [Fact]
    public void Run_BadDefinition_IsACompilerErrorAtItsLine()
    {
        Diagnostic diagnostic = Run(new TestFile("/d/root.xml", "<mavlink>\n<messages>\n  <message id='x' "
            + "name='M'><field type='uint8_t' name='a'/></message></messages></mavlink>", "own")).Diagnostics.Single();
        Assert.Equal("RABMAV002", diagnostic.Id);
        Assert.Equal(DiagnosticSeverity.Error, diagnostic.Severity);
        Assert.Equal("/d/root.xml", diagnostic.Location.GetLineSpan().Path);
        Assert.Equal(2, diagnostic.Location.GetLineSpan().StartLinePosition.Line);
        Assert.Contains("'x' is no id", diagnostic.GetMessage(null));
    }

    [Fact]
    public void Run_SeveralFilesWithSeveralNamespaces_EachGoesToItsOwn() =>
        Assert.Equal(
            ["Acme.App.Messages.ThreeDialect.Instance.g.cs", "N.One.OneDialect.Instance.g.cs",
                "N.Two.TwoDialect.Instance.g.cs"],
            Names(Run(
                new TestFile("/d/one.xml", "<mavlink/>", "own", "N.One"),
                new TestFile("/d/two.xml", "<mavlink/>", "own", "N.Two"),
                new TestFile("/d/three.xml", "<mavlink/>", "own"))));

    [Fact]
    public void Run_UnknownElement_IsACompilerWarning()
    {
        Diagnostic diagnostic =
            Run(new TestFile("/d/root.xml", "<mavlink><owner/></mavlink>", "own")).Diagnostics.Single();
        Assert.Equal(("RABMAV013", DiagnosticSeverity.Warning), (diagnostic.Id, diagnostic.Severity));
    }

    [Fact]
    public void Run_CommandNumberOfThePackageThatIsNotIncluded_IsAWarningAtItsLine()
    {
        const string Command =
            "<mavlink><enums>\n<enum name='MAV_CMD'><entry name='{0}' value='16'/></enum></enums></mavlink>";
        Diagnostic diagnostic = Run(
            new TestFile(
                "/d/root.xml", Command.Replace("{0}", "MAV_CMD_ACME_TAKEN", System.StringComparison.Ordinal), "own"),
            new TestFile(
                "/p/all.xml", Command.Replace("{0}", "MAV_CMD_NAV_WAYPOINT", System.StringComparison.Ordinal),
                "package")).Diagnostics.Single();
        Assert.Equal(
            ("RABMAV015", DiagnosticSeverity.Warning, 1),
            (diagnostic.Id, diagnostic.Severity, diagnostic.Location.GetLineSpan().StartLinePosition.Line));
        Assert.Contains("MAV_CMD_NAV_WAYPOINT in all.xml", diagnostic.GetMessage(null));
    }

    [Fact]
    public void Run_TwoRootsThatIncludeOneBadFile_ReportsItOnce()
    {
        const string Root = "<mavlink><include>bad.xml</include></mavlink>";
        GeneratorDriverRunResult result = Run(
            new TestFile("/d/a.xml", Root, "own"), new TestFile("/d/b.xml", Root, "own"),
            new TestFile("/d/bad.xml", "<mavlink>", "own"));
        Assert.Equal("RABMAV001", Assert.Single(result.Diagnostics).Id);
    }

    [Fact]
    public void Run_SecondTimeWithoutAChange_ReusesEverything()
    {
        var root = new TestFile("/d/root.xml", Base, "own");
        GeneratorDriver driver = Driver(root).RunGenerators(CSharpCompilation.Create("Check"));
        driver = driver.RunGenerators(CSharpCompilation.Create("Other"));
        IEnumerable<IncrementalStepRunReason> reasons = driver.GetRunResult().Results.Single().TrackedOutputSteps
            .SelectMany(steps => steps.Value).SelectMany(step => step.Outputs).Select(output => output.Reason);
        Assert.All(reasons, reason => Assert.Equal(IncrementalStepRunReason.Cached, reason));
    }

    private static IEnumerable<string> Names(GeneratorDriverRunResult result) =>
        result.Results.Single().GeneratedSources.Select(source => source.HintName)
            .OrderBy(name => name, System.StringComparer.Ordinal);

    private static string Text(GeneratorDriverRunResult result, string end) =>
        result.Results.Single().GeneratedSources
            .Single(source => source.HintName.EndsWith(end, System.StringComparison.Ordinal)).SourceText.ToString();

    private static GeneratorDriverRunResult Run(params TestFile[] files) =>
        Driver(files).RunGenerators(CSharpCompilation.Create("Check")).GetRunResult();

    private static CSharpGeneratorDriver Driver(params TestFile[] files) => CSharpGeneratorDriver.Create(
        [new MavlinkGenerator().AsSourceGenerator()],
        files.ToImmutableArray<AdditionalText>(),
        optionsProvider: new TestOptionsProvider(),
        driverOptions: new GeneratorDriverOptions(
            IncrementalGeneratorOutputKind.None, trackIncrementalGeneratorSteps: true));
}
