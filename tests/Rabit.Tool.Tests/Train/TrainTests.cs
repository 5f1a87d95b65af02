using System;
using System.IO;
using Rabit.Vision;
using Xunit;

namespace Rabit.Tool.Tests.Train;

/// <summary><c>rabit train</c> as a user starts it.</summary>
public sealed class TrainTests : IDisposable
{
    private readonly string _folder =
        Directory.CreateDirectory(Path.Combine(Path.GetTempPath(), Guid.NewGuid().ToString("N"))).FullName;

    private string Labels => Path.Combine(_folder, "labels.json");

    private string Output => Path.Combine(_folder, "square.template");

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Train_LabelledPictures_WritesATemplateAndSaysHowWellItDoes()
    {
        WritePictures();
        File.WriteAllText(Labels, $$"""
            { "pictures": [
              { "file": "a.png", "metresPerPixel": 0.1, "boxes": [{{Boxes}}] },
              { "file": "b.png", "metresPerPixel": 0.1, "group": "b", "boxes": [{{Boxes}}] } ] }
            """);
        ToolProcess done = Run("--name", "square", "--length", "1", "--width", "1", "--metres-per-pixel", "0.1");
        Assert.Equal((0, 0), (done.ExitCode, done.Errors.Count));
        Assert.Contains("trained with 10 objects of 2 pictures, 2 boxes ignored", done.Text, StringComparison.Ordinal);
        ObjectTemplate template = ObjectTemplate.Load(Output);
        Assert.Equal(("square", 1.0, 0.1), (template.Name, template.LengthMetres, template.MetresPerPixel));
    }

    [Theory]
    [InlineData("{ \"pictures\": [] }", "pictures is empty")]
    [InlineData("{ \"pictures\": [{ \"file\": \"a.png\", \"boxes\": [] }] }", "pictures[0].metresPerPixel is missing")]
    [InlineData("{ \"pictures\": [{ \"file\": \"a.png\", \"metresPerPixel\": 0.1, \"boxes\": [{ \"x\": 1 }] }] }",
        "pictures[0].boxes[0].x is unknown; there are left, top, width, height, headingDegrees, ignored")]
    [InlineData("{ \"pictures\": [{ \"file\": \"none.png\", \"metresPerPixel\": 0.1, \"boxes\": [] }] }", "none.png")]
    [InlineData("{ \"pictures\": [{ \"file\": \"a.png\", \"metresPerPixel\": 3, \"boxes\": [] }] }", "too coarse")]
    [InlineData("{ \"pictures\": [{ \"file\": \"a.png\", \"metresPerPixel\": 0.1, \"boxes\": [] }] }",
        "There are 0 objects to train with; at least 4 are needed.")]
    [InlineData("{ \"pictures\": [{ \"file\": \"a.png\", \"metresPerPixel\": 1e-9, \"boxes\": [] }] }",
        "labels.json: pictures[0].metresPerPixel is 1E-09; it must be 0.0001 at least")]
    [InlineData("{ \"pictures\": [{ \"file\": \"a.png\", \"metresPerPixel\": 0, \"boxes\": [] }] }",
        "labels.json: pictures[0].metresPerPixel is 0; it must be 0.0001 at least")]
    [InlineData("{ \"pictures\": [{ \"file\": \"a.png\", \"metresPerPixel\": 0.0014, \"boxes\": [] }] }",
        "labels.json: pictures[0].metresPerPixel is 0.0014: 160 x 100 pixels of that size are less than one pixel of the")]
    [InlineData("{ \"pictures\": [{ \"file\": \"a.png\", \"boxes\": [], \"boxes\": [] }] }",
        "labels.json: pictures[0].boxes is there twice")]
    [InlineData("{ \"pictures\": [{ \"file\": \"a.png\", \"metresPerPixel\": 0.1, \"boxes\": [{ \"left\": 1, \"top\": 1, \"width\": 9, \"height\": 9, \"headingDegrees\": 1e300 }] }] }",
        "pictures[0].boxes[0].headingDegrees is 1E+300; it must be -360 to 360")]
    [InlineData("[1]", "the whole must be an object")]
    [InlineData("{", "it is not JSON")]
    public void Train_WrongLabels_NamesThem(string labels, string fault)
    {
        WritePictures();
        File.WriteAllText(Labels, labels);
        ToolProcess refused = Run();
        Assert.Equal(2, refused.ExitCode);
        Assert.StartsWith("rabit train: ", Assert.Single(refused.Errors), StringComparison.Ordinal);
        Assert.Contains(fault, refused.Errors[0], StringComparison.Ordinal);
        Assert.False(File.Exists(Output));
    }

    [Theory]
    [InlineData("labels.json", "--output would overwrite ")]
    [InlineData("b.png", "--output would overwrite ")]
    [InlineData("sub", "sub: that is a folder")]
    public void Train_OutputThatWouldBeLost_IsRefusedAtOnce(string output, string fault)
    {
        WritePictures();
        Directory.CreateDirectory(Path.Combine(_folder, "sub"));
        string labels = $$"""
            { "pictures": [
              { "file": "a.png", "metresPerPixel": 0.1, "boxes": [{{Boxes}}] },
              { "file": "b.png", "metresPerPixel": 0.1, "boxes": [{{Boxes}}] } ] }
            """;
        File.WriteAllText(Labels, labels);
        byte[] picture = File.ReadAllBytes(Path.Combine(_folder, "b.png"));

        ToolProcess refused = ToolProcess.Run("train", Labels, "--output", Path.Combine(_folder, output));

        Assert.Equal(2, refused.ExitCode);
        Assert.Contains(fault, Assert.Single(refused.Errors), StringComparison.Ordinal);
        Assert.Equal(labels, File.ReadAllText(Labels));
        Assert.Equal(picture, File.ReadAllBytes(Path.Combine(_folder, "b.png")));
    }

    [Theory]
    [InlineData("0.00149", 2)]
    [InlineData("0.0015", 0)]
    public void Train_PictureOfOnePixelOfTheTemplate_IsTheSmallest(string metresPerPixel, int exitCode)
    {
        WritePictures();
        File.WriteAllText(Labels, $$"""
            { "pictures": [
              { "file": "a.png", "metresPerPixel": 0.1, "boxes": [{{Boxes}}] },
              { "file": "b.png", "metresPerPixel": {{metresPerPixel}}, "boxes": [] } ] }
            """);

        ToolProcess done = Run();

        Assert.True(done.ExitCode == exitCode, string.Join("\n", done.Errors));
        Assert.Equal(exitCode == 0 ? 0 : 1, done.Errors.Count);
    }

    [Fact]
    public void Train_WrongOptions_NamesThem()
    {
        File.WriteAllText(Labels, "{ \"pictures\": [] }");
        Assert.Contains("the length first", Run("--length", "1").Errors[0], StringComparison.Ordinal);
        Assert.Contains(
            "there is no folder",
            ToolProcess.Run("train", Labels, "-o", Path.Combine(_folder, "none", "a")).Errors[0],
            StringComparison.Ordinal);
        Assert.Contains("--output", ToolProcess.Run("train", Labels).Errors[0], StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--length", "NaN", "0.01 to 100")]
    [InlineData("--width", "-1", "0.01 to 100")]
    [InlineData("--metres-per-pixel", "0", "1E-05 to 100")]
    [InlineData("--false-alarms", "1e9", "1E-06 to 1000")]
    public void Train_OptionOutOfItsRange_IsRefusedByItsName(string option, string value, string range)
    {
        File.WriteAllText(Labels, "{ \"pictures\": [] }");

        ToolProcess refused = Run(option, value);

        Assert.Equal(2, refused.ExitCode);
        Assert.StartsWith(
            $"rabit train: {option} is {value}; it must be {range}.", Assert.Single(refused.Errors),
            StringComparison.Ordinal);
    }

    [Fact]
    public void Train_FolderOrNothingForAFile_IsNamed()
    {
        File.WriteAllText(Labels, "{ \"pictures\": [] }");
        Assert.Equal(
            [$"rabit train: {_folder}: that is a folder", "rabit train: --output is empty"],
            [
                ToolProcess.Run("train", _folder, "-o", Output).Errors[0],
                ToolProcess.Run("train", Labels, "-o", "").Errors[0],
            ]);
    }

    [Fact]
    public void Train_NamedPipe_IsRefusedAndNotWaitedFor()
    {
        if (!Directory.Exists("/proc/self"))
            return;   // named pipes are looked for on Linux
        string pipe = Path.Combine(_folder, "pipe");
        Assert.Equal(0, ToolProcess.RunInShell($"mkfifo \"{pipe}\"").ExitCode);
        File.WriteAllText(Labels, "{ \"pictures\": [] }");
        string fault = $"rabit train: {pipe}: it is a pipe, not a file";

        ToolProcess ofLabels = ToolProcess.Run("train", pipe, "-o", Output);
        ToolProcess ofOutput = ToolProcess.Run("train", Labels, "-o", pipe);

        Assert.Equal((2, fault), (ofLabels.ExitCode, Assert.Single(ofLabels.Errors)));
        Assert.Equal((2, fault), (ofOutput.ExitCode, Assert.Single(ofOutput.Errors)));
    }

    // Five squares and one that is cut.
    private static string Boxes
    {
        get
        {
            string boxes = "{ \"left\": 0, \"top\": 0, \"width\": 9, \"height\": 9, \"ignored\": true }";
            for (int i = 0; i < 5; i++)
            {
                boxes += FormattableString.Invariant(
                    $", {{ \"left\": {20 + (25 * i)}, \"top\": {30 + (7 * i)}, \"width\": 10, \"height\": 10 }}");
            }

            return boxes;
        }
    }

    private ToolProcess Run(params string[] more) => ToolProcess.Run(["train", Labels, "--output", Output, .. more]);

    private void WritePictures()
    {
        for (int picture = 0; picture < 2; picture++)
        {
            var random = new Random(picture);
            byte[] pixels = new byte[160 * 100 * 3];
            for (int i = 0; i < 160 * 100; i++)
            {
                (int x, int y) = (i % 160, i / 160);
                bool isSquare = false;
                for (int s = 0; s < 5; s++)
                    isSquare |= x >= 20 + (25 * s) && x < 30 + (25 * s) && y >= 30 + (7 * s) && y < 40 + (7 * s);
                byte level = (byte)((isSquare ? 200 : 90) + random.Next(20));
                (pixels[3 * i], pixels[(3 * i) + 1], pixels[(3 * i) + 2]) = (level, level, level);
            }

            File.WriteAllBytes(
                Path.Combine(_folder, picture == 0 ? "a.png" : "b.png"),
                PngPicture.Encode(new RgbPicture(160, 100, pixels)));
        }
    }
}
