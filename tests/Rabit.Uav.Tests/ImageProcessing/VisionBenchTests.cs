using System;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Tests.Shared;
using VisionBench;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>The program that scores detectors: its table, its page, its bar and its errors.</summary>
public sealed class VisionBenchTests : IDisposable
{
    private readonly string _page = Path.Combine(Path.GetTempPath(), $"bench-{Guid.NewGuid():N}.html");

    private static string Stills => Path.Combine(TestData.Folder, "detection", "stills");

    public void Dispose() => File.Delete(_page);

    [Fact]
    public void Run_Html_WritesEveryPictureWithItsMissesAndFalseAlarms()
    {
        (int exit, string output, string errors) = Run(false, Stills, "--list", "--html", _page);
        Assert.Equal((0, ""), (exit, errors));
        string page = File.ReadAllText(_page);
        Assert.Equal(12, Occurrences(page, "<figure "));
        Assert.Equal(12, Occurrences(page, "src=\"data:image/jpeg;base64,"));
        Assert.Equal(CountOf(output, " missed "), Occurrences(page, "<rect class=\"missed\""));
        Assert.Equal(CountOf(output, " false "), Occurrences(page, "<rect class=\"alarm\""));
        Assert.True(CountOf(output, " missed ") > 0 && CountOf(output, " false ") > 0, output);
        Assert.DoesNotContain("http", page, StringComparison.Ordinal);
    }

    [Fact]
    public void Run_OnATerminal_ShowsABarAndTakesItAway()
    {
        (_, _, string errors) = Run(true, Stills);
        Assert.Contains("\rstills [==============================] 12 of 12", errors, StringComparison.Ordinal);
        Assert.Equal("", errors.Split('\r').Last());
    }

    [Theory]
    [InlineData("--html", "--html: it is no argument, or something is missing after it")]
    [InlineData("--part", "--part: it is no argument, or something is missing after it")]
    public void Run_WrongArgument_NamesIt(string argument, string text)
    {
        (int exit, _, string errors) = Run(false, argument);
        Assert.Equal(2, exit);
        Assert.Contains(text, errors, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("truth.json")]
    [InlineData("frame.png")]
    [InlineData("page")]
    public void Run_PageThatIsNamedAsNone_IsRefused(string file)
    {
        (int exit, _, string errors) = Run(false, Stills, "--html", Path.Combine(_page, file));
        Assert.Equal(2, exit);
        Assert.Contains(file + " must end in .html", errors, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--help")]
    [InlineData("-h")]
    [InlineData("--list", "--help")]
    public void Run_Help_SaysWhatThereIsAndIsNoError(params string[] args)
    {
        (int exit, string output, string errors) = Run(false, args);
        Assert.Equal((0, ""), (exit, errors));
        Assert.StartsWith("usage: VisionBench FOLDER", output, StringComparison.Ordinal);
        Assert.Contains("exit code", output, StringComparison.Ordinal);
    }

    [Fact]
    public void Run_NoFolder_IsAnErrorThatSaysHow()
    {
        (int exit, string output, string errors) = Run(false, "--list");
        Assert.Equal((2, ""), (exit, output));
        Assert.StartsWith("no folder is given; --help says more", errors, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("nowhere", ": there is no such folder")]
    [InlineData("detection/red-panel.template", ": it is a file, not a folder")]
    [InlineData("jpeg", ": it has no truth.json")]
    [InlineData("detection", ": it has no truth.json, but these in it do: stills, stills_1640")]
    public void Run_FolderThatIsNoSet_IsNamedWithWhatIsExpected(string folder, string fault)
    {
        string path = Path.Combine(Repository.Root, "tests", "data", folder);
        (int exit, _, string errors) = Run(false, path);
        Assert.Equal(2, exit);
        Assert.Equal(
            $"{path}{fault}. A set is a folder with a truth.json (format uav-imagery-truth), or a manifest.json of "
                + "photos, and the pictures that it lists.",
            errors.TrimEnd());
    }

    [Theory]
    [InlineData("{", " is no truth of a picture set: ")]
    [InlineData("{\"format\":\"other\"}", "its format is \"other\", not \"uav-imagery-truth\"")]
    [InlineData("{\"format\":\"uav-imagery-truth\",\"cameras\":[]}", "\"frames\" is missing")]
    public void Run_TruthThatIsNone_IsNamed(string truth, string fault)
    {
        string folder = Directory.CreateDirectory(_page + ".set").FullName;
        string file = Path.Combine(folder, "truth.json");
        File.WriteAllText(file, truth);
        (int exit, _, string errors) = Run(false, folder);
        Directory.Delete(folder, recursive: true);
        Assert.Equal(2, exit);
        Assert.StartsWith(file, errors, StringComparison.Ordinal);
        Assert.Contains(fault, errors, StringComparison.Ordinal);
    }

    [Fact]
    public void Run_PageThatCannotBeWritten_NamesIt()
    {
        (int exit, _, string errors) = Run(false, Stills, "--html", Path.Combine(_page, "none", "page.html"));
        Assert.Equal(2, exit);
        Assert.Contains("page.html", errors, StringComparison.Ordinal);
    }

    private static (int Exit, string Output, string Errors) Run(bool isTerminal, params string[] args)
    {
        using var output = new StringWriter(CultureInfo.InvariantCulture);
        using var errors = new StringWriter(CultureInfo.InvariantCulture);
        int exit = VisionBenchProgram.Run(args, output, errors, isTerminal);
        return (exit, output.ToString(), errors.ToString());
    }

    private static int Occurrences(string text, string what)
        => text.Split([what], StringSplitOptions.None).Length - 1;

    // Lines of the list begin with the name of a picture.
    private static int CountOf(string output, string what)
        => output.Split('\n').Count(l => l.StartsWith("  f0", StringComparison.Ordinal)
            && l.Contains(what, StringComparison.Ordinal));
}
