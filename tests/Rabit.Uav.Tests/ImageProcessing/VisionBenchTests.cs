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

    // The reference's figures are known of whole sets alone.
    [Theory]
    [InlineData("all", false)]
    [InlineData("odd", true)]
    [InlineData("even", true)]
    public void Run_PartOfASetWithAReference_SaysThatThatIsOfAll(string part, bool isSaid)
    {
        string folder = Directory.CreateDirectory(_page + ".set").FullName;
        string set = Directory.CreateDirectory(Path.Combine(folder, "stills")).FullName;
        foreach (string file in Directory.GetFiles(Stills))
            File.Copy(file, Path.Combine(set, Path.GetFileName(file)));
        File.WriteAllText(
            Path.Combine(folder, "baseline.json"),
            """
            { "sets": { "stills": { "colour": { "fa_per_frame": 1, "centroid_rms_px_clear_panels_6px_up": 1,
              "by_size": { "4-6": "1/2" }, "by_class": {} } } } }
            """);
        (int exit, string output, string errors) = Run(false, set, "--part", part);
        Directory.Delete(folder, recursive: true);
        Assert.Equal((0, ""), (exit, errors));
        Assert.Equal(isSaid, output.Contains("OpenCV's figures are of all of them", StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("1")]
    [InlineData("one/2")]
    [InlineData("1/2/3")]
    public void Run_ReferenceWithACountThatIsNone_NamesFileAndField(string count)
    {
        string folder = Directory.CreateDirectory(_page + ".set").FullName;
        string set = Directory.CreateDirectory(Path.Combine(folder, "stills")).FullName;
        foreach (string file in Directory.GetFiles(Stills))
            File.Copy(file, Path.Combine(set, Path.GetFileName(file)));
        string baseline = Path.Combine(folder, "baseline.json");
        File.WriteAllText(
            baseline,
            """
            { "sets": { "stills": { "colour": { "fa_per_frame": 1, "centroid_rms_px_clear_panels_6px_up": 1,
              "by_size": { "4-6": "COUNT" }, "by_class": {} } } } }
            """.Replace("COUNT", count));
        (int exit, _, string errors) = Run(false, set);
        Directory.Delete(folder, recursive: true);
        Assert.Equal(2, exit);
        Assert.Equal(
            $"{baseline}: \"sets.stills.colour.by_size.4-6\" is not a count as 5/9", errors.TrimEnd());
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

    [Fact]
    public void Run_FolderOfSetsWithAListOfFiles_SaysWhichSetsAreInIt()
    {
        string folder = Directory.CreateDirectory(_page + ".sets").FullName;
        File.WriteAllText(Path.Combine(folder, "manifest.json"), "[{ \"path\": \"a.jpg\" }]");
        File.WriteAllText(Path.Combine(Directory.CreateDirectory(Path.Combine(folder, "a")).FullName, "truth.json"), "");
        (int exit, _, string errors) = Run(false, folder);
        Directory.Delete(folder, recursive: true);
        Assert.Equal(2, exit);
        Assert.StartsWith(
            $"{folder}: it has no truth.json, but these in it do: a. A set is", errors, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("{", " is no truth of a picture set: ")]
    [InlineData("{\"format\":\"other\"}", "its format is \"other\", not \"uav-imagery-truth\"")]
    [InlineData("{\"format\":\"uav-imagery-truth\",\"cameras\":[]}", "\"frames\" is missing")]
    [InlineData("{\"format\":\"uav-imagery-truth\",\"cameras\":[],\"frames\":[]}", "\"frames\" is empty")]
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

    // What follows is a truth of one picture, in which one thing is changed.
    [Theory]
    [InlineData("0, 0, 0, 0]", "0]", "cameras[0]: \"dist_k1_k2_p1_p2_k3\" must be a list of 5 numbers")]
    [InlineData("\"width\": 640,", "", "cameras[0]: \"width\" is missing")]
    [InlineData("\"width\": 640,", "\"width\": -640,", "cameras[0]: its size of -640 x 480 is none")]
    [InlineData("\"fx\": 530,", "\"fx\": 0,", "cameras[0]: \"fx\" and \"fy\" must be above 0")]
    [InlineData("\"name\": \"c\"", "\"name\": 5", "cameras[0]: \"name\" must be a text")]
    [InlineData("\"camera\": \"c\"", "\"camera\": \"d\"", "frames[0]: \"camera\" is d, which is not in \"cameras\"")]
    [InlineData("\"file\": \"a.png\"", "\"file\": null", "frames[0]: \"file\" must be a text")]
    [InlineData("[1, 0, 0]", "[1, 0]", "frames[0]: R_ned_from_cam[0]: it must be a list of 3 numbers")]
    [InlineData("[10, 10]", "[]", "frames[0]: targets[0]: \"visible_centroid_px\" must be a list of 2 numbers")]
    [InlineData("[5, 5, 15, 15]", "[5, 5]", "frames[0]: targets[0]: \"bbox_px\" must be a list of 4 numbers")]
    [InlineData("\"distractors\": []", "\"distractors\": [5]", "frames[0]: distractors[0]: it must be an object")]
    public void Run_TruthWithAWrongField_NamesFileAndField(string before, string after, string fault)
    {
        const string truth = """
            { "format": "uav-imagery-truth",
              "cameras": [{ "name": "c", "width": 640, "height": 480, "fx": 530, "fy": 530, "cx": 319.5, "cy": 239.5,
                "dist_k1_k2_p1_p2_k3": [0, 0, 0, 0, 0] }],
              "frames": [{ "file": "a.png", "camera": "c",
                "pose": { "cam_center_ned_m": [0, 0, -40], "R_ned_from_cam": [[1, 0, 0], [0, 1, 0], [0, 0, 1]] },
                "targets": [{ "class": "panel", "color": "red", "shape": "square", "visible_centroid_px": [10, 10],
                  "size_px": 10, "bbox_px": [5, 5, 15, 15], "fraction_visible": 1, "occluded": false,
                  "truncated": false }],
                "distractors": [] }] }
            """;
        Assert.Contains(before, truth, StringComparison.Ordinal);
        string folder = Directory.CreateDirectory(_page + ".set").FullName;
        string file = Path.Combine(folder, "truth.json");
        File.WriteAllText(file, truth.Replace(before, after));
        (int exit, _, string errors) = Run(false, folder);
        Directory.Delete(folder, recursive: true);
        Assert.Equal(2, exit);
        Assert.StartsWith($"{file} is no truth of a picture set: {fault}", errors, StringComparison.Ordinal);
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
