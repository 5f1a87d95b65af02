using System;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Tests.Shared;
using VisionBench;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Markers in the program that scores detectors: among other targets, and in sets of markers alone.</summary>
public sealed class VisionBenchMarkerTests : IDisposable
{
    // Of c002.png, in which the marker 13 is.
    private const string Corners = "[[100.421,63.762],[77.874,124.365],[25.118,97.405],[50.223,34.18]]";

    // The same as libapriltag has them: pixels whose centres are halves, in another order.
    private const string PhotoCorners = "[[78.374,124.865],[100.921,64.262],[50.723,34.68],[25.618,97.905]]";

    private static readonly string Markers = Path.Combine(Repository.Root, "tests", "data", "markers");

    private readonly string _parent = Path.Combine(Path.GetTempPath(), $"bench-{Guid.NewGuid():N}");

    public void Dispose()
    {
        if (Directory.Exists(_parent))
            Directory.Delete(_parent, recursive: true);
    }

    // 32 crops, 15 and 8 in still pictures, 10 of the sequence.
    [Fact]
    public void Run_MarkersOfTheRepository_AreScoredListedAndShown()
    {
        string page = Path.Combine(Directory.CreateDirectory(_parent).FullName, "page.html");

        string output = Run(Markers, "--list", "--html", page);

        int pictures = Directory.GetFiles(Markers).Count(f => Path.GetExtension(f) is ".png" or ".jpg");
        Assert.Contains($"markers, {pictures} pictures of markers", output, StringComparison.Ordinal);
        int missed = output.Split('\n').Count(l => l.Contains(" missed marker "));
        Assert.InRange(missed, 1, 4);
        AssertRow(output, "markers found", $"{65 - missed}/65");
        AssertRow(output, "wrong ids", "0");
        string html = File.ReadAllText(page);
        Assert.Equal(pictures, Occurrences(html, "<figure "));
        Assert.Equal(missed, Occurrences(html, "<rect class=\"missed\""));
        Assert.Equal(65 - missed, Occurrences(html, "<rect class=\"found\""));
        Assert.Contains("<td>markers found</td>", html, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("13", "1/1", "0")]
    [InlineData("14", "0/1", "1")]
    public void Run_Crops_CountsFoundAndWrongIdsBesideTheReference(string id, string found, string wrong)
    {
        string set = WriteSet($$"""
            { "format": "uav-imagery-marker-crops", "crops": [
              { "file": "{{FileOf("c002.png")}}", "expected": { "family": "apriltag_36h11", "id": {{id}} },
                "corners_px": {{Corners}} },
              { "file": "{{FileOf("c001.png")}}", "expected": "none", "corners_px": {{Corners}} } ] }
            """);
        File.WriteAllText(
            Path.Combine(_parent, "baseline.json"),
            """
            { "sets": { "set": { "default": {}, "small-marker":
              { "found": 1, "of": 2, "wrong_ids": 3, "corner_rms_px": 0.917 } } } }
            """);

        string output = Run(set);

        AssertRow(output, "markers found", found, "1/2");
        AssertRow(output, "wrong ids", wrong, "3");
        if (id == "13")
            AssertRow(output, "corner RMS, markers, px", value: null, "0.92");
    }

    [Theory]
    [InlineData("{ \"sets\": { \"set\": { \"small-marker\": { \"found\": 1 } } } }",
        ": \"sets.set.small-marker.of\" is missing")]
    [InlineData("{ \"sets\": { \"set\": { \"small-marker\": { \"found\": \"one\" } } } }",
        ": \"sets.set.small-marker.found\" is not a whole number")]
    [InlineData("{ \"sets\": { \"set\": [] } }", ": \"sets.set\" is not an object")]
    [InlineData("{ \"set\": 1 }", ": \"sets\" is missing")]
    [InlineData("[]", " is not an object")]
    [InlineData("{ \"sets\": ", " is no JSON: ")]
    public void Run_FaultyReference_NamesFileAndField(string text, string fault)
    {
        string set = WriteSet($$"""
            { "format": "uav-imagery-marker-crops", "crops": [
              { "file": "{{FileOf("c001.png")}}", "expected": "none", "corners_px": {{Corners}} } ] }
            """);
        string file = Path.Combine(_parent, "baseline.json");
        File.WriteAllText(file, text);

        (int exit, _, string errors) = RunAll(set);

        Assert.Equal(2, exit);
        Assert.StartsWith(file + fault, errors, StringComparison.Ordinal);
    }

    // A further reading of a picture that is not complete may be right; one of a complete one is wrong.
    [Theory]
    [InlineData("[]", false, "-", "0")]
    [InlineData("[]", true, "-", "1")]
    [InlineData("agreed", true, "1/1", "0")]
    [InlineData("not agreed", true, "-", "0")]
    public void Run_Photos_CountsAgreedTags(string tags, bool isComplete, string found, string wrong)
    {
        string tag = $$"""
            [ { "family": "tag36h11", "id": 13, "agreed": {{(tags == "agreed" ? "true" : "false")}},
                "corners_lb_rb_rt_lt": {{PhotoCorners}} } ]
            """;
        string set = WriteSet($$"""
            { "how": "", "files": [ { "file": "{{FileOf("c002.png")}}", "group": "room",
              "complete": {{(isComplete ? "true" : "false")}}, "tags": {{(tags == "[]" ? tags : tag)}} } ] }
            """);

        string output = Run(set);

        AssertRow(output, "markers found", found);
        AssertRow(output, "wrong ids", wrong);
        if (found == "1/1")
            Assert.InRange(Value(output, "corner RMS, markers, px"), 0, 0.6);
    }

    // Markers among the other targets of a set; and one of which the truth does not say which it is.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Run_SetOfTargets_ScoresItsMarkersToo(bool isSaid)
    {
        string marker = isSaid
            ? $$""", "marker": { "family": "apriltag_36h11", "id": 13, "corners_px": {{Corners}} }"""
            : "";
        string set = WriteSet($$"""
            { "format": "uav-imagery-truth",
              "cameras": [ { "name": "a", "width": 146, "height": 146, "fx": 150, "fy": 150, "cx": 72.5, "cy": 72.5,
                "dist_k1_k2_p1_p2_k3": [0, 0, 0, 0, 0] } ],
              "frames": [ { "file": "{{FileOf("c002.png")}}", "distractors": [],
                "pose": { "R_ned_from_cam": [[0, -1, 0], [1, 0, 0], [0, 0, 1]], "cam_center_ned_m": [0, 0, -20] },
                "targets": [ { "class": "marker", "color": "black_white", "shape": "square", "size_px": 60,
                  "fraction_visible": 1, "occluded": false, "truncated": false, "visible_centroid_px": [63, 80],
                  "bbox_px": [20, 30, 105, 130]{{marker}} } ] } ] }
            """);

        string output = Run(set);

        if (isSaid)
            AssertRow(output, "markers found", "1/1");
        else
            Assert.DoesNotContain("markers found", output, StringComparison.Ordinal);
        Assert.Contains(" ms a frame, markers ", output, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("""[{"file":"a.png"}]""", "")]
    [InlineData("""{"format":"uav-imagery-marker-crops"}""", "")]
    [InlineData(
        """[{"file":"a","markers":[{"family":"other","id":1,"fraction_visible":1,"corners_px":[[0,0],[1,0],[1,1],[0,1]]}]}]""",
        "\"other\" is no family of markers that is read")]
    [InlineData(
        """[{"file":"a.png","markers":[{"family":"apriltag_36h11","id":1,"fraction_visible":1,"corners_px":[]}]}]""",
        "a marker has other than four corners")]
    public void Run_TruthOfMarkersThatIsNone_IsNamed(string truth, string fault)
    {
        string set = WriteSet(truth);

        (int exit, _, string errors) = RunAll(set);

        Assert.Equal(2, exit);
        Assert.StartsWith(Path.Combine(set, "truth.json"), errors, StringComparison.Ordinal);
        Assert.Contains(fault, errors, StringComparison.Ordinal);
    }

    private string WriteSet(string truth)
    {
        string set = Directory.CreateDirectory(Path.Combine(_parent, "set")).FullName;
        File.WriteAllText(Path.Combine(set, "truth.json"), truth);
        return set;
    }

    private static string FileOf(string file) => Path.Combine(Markers, file).Replace("\\", "\\\\");

    private static string Run(params string[] args)
    {
        (int exit, string output, string errors) = RunAll(args);
        Assert.Equal((0, ""), (exit, errors));
        return output;
    }

    private static (int Exit, string Output, string Errors) RunAll(params string[] args)
    {
        using var output = new StringWriter(CultureInfo.InvariantCulture);
        using var errors = new StringWriter(CultureInfo.InvariantCulture);
        int exit = VisionBenchProgram.Run(args, output, errors, isTerminal: false);
        return (exit, output.ToString(), errors.ToString());
    }

    private static string[] Row(string output, string name)
        => output.Split('\n').Single(l => l.StartsWith("  " + name, StringComparison.Ordinal))
            .Substring(2 + name.Length).Split([' ', '\r'], StringSplitOptions.RemoveEmptyEntries);

    private static double Value(string output, string name)
        => double.Parse(Row(output, name)[0], CultureInfo.InvariantCulture);

    private static void AssertRow(string output, string name, string? value, params string[] reference)
    {
        string[] row = Row(output, name);
        Assert.Equal(reference, row.Skip(1));
        if (value is not null)
            Assert.Equal(value, row[0]);
    }

    private static int Occurrences(string text, string what)
        => text.Split([what], StringSplitOptions.None).Length - 1;
}
