using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Tests.Shared;
using VisionBench;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Vision.Tests.Markers;

/// <summary>
/// Sets of pictures with their truth: generated ones, of which a part is in tests/data, and photos.
/// </summary>
public sealed class MarkerSetTests(ITestOutputHelper output)
{
    private static readonly string Data = Path.Combine(Repository.Root, "tests", "data", "markers");

    // Of the part that is in tests/data: all of the still pictures and crops, every fourth of the sequence.
    [Theory]
    [InlineData("stills_640", 15, 12, 0.35)]
    [InlineData("stills_1640", 8, 8, 0.25)]
    [InlineData("sequence_01", 10, 9, 0.45)]
    [InlineData("marker_crops", 32, 32, 0.35)]
    public void Find_GeneratedPictures_FindsThemWithoutAWrongId(string set, int expected, int atLeast, double cornerRms)
    {
        var reader = new PictureReader();
        var score = new MarkerScore();
        using JsonDocument truth = JsonDocument.Parse(File.ReadAllText(Path.Combine(Data, "truth.json")));
        foreach (JsonElement entry in truth.RootElement.EnumerateArray())
        {
            string file = entry.GetProperty("file").GetString()!;
            if (entry.GetProperty("set").GetString() == set)
                score.Add(
                    reader.Load(Path.Combine(Data, file)), file,
                    [.. entry.GetProperty("markers").EnumerateArray().Select(m => MarkerOf(m, m))]);
        }

        Check(score, set, expected, atLeast, cornerRms);
        Assert.InRange(score.ChiSquare, 0.02, 2);
    }

    [GeneratedPicturesFact]
    public void Find_WholeSets_FindsThemWithoutAWrongId()
    {
        CheckFrames("stills_640", 15, 12, 0.35);
        CheckFrames("stills_1640", 8, 8, 0.25);
        CheckFrames("sequence_01", 38, 35, 0.4);
    }

    // The truth is that of another detector, which does not correct the growth of white, and of which a second one
    // agreed. "complete: false" has more tags than are listed: those of the room have the ids 0 to 20, those on the
    // cubes of NASA all 0.
    [RealPicturesFact("markers")]
    public void Find_Photos_FindsAgreedTagsWithoutAWrongId()
    {
        string folder = RealPicturesFactAttribute.FolderOf("markers")!;
        using JsonDocument truth = JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, "truth.json")));
        var reader = new PictureReader();
        var score = new MarkerScore();
        foreach (JsonElement entry in truth.RootElement.GetProperty("files").EnumerateArray())
        {
            string file = entry.GetProperty("file").GetString()!;
            bool isComplete = entry.GetProperty("complete").GetBoolean();
            int lastId = entry.GetProperty("group").GetString() == "nasa" ? 0 : 20;
            score.Add(
                reader.Load(Path.Combine(folder, file)), file,
                [.. entry.GetProperty("tags").EnumerateArray().Select(ListedMarker.OfPhoto)],
                m => !isComplete && m.Family == MarkerFamily.AprilTag36h11 && m.Id <= lastId);
        }

        output.WriteLine("photos: " + score);
        Assert.Empty(score.Wrong);
        Assert.Equal(159, score.Expected);
        Assert.True(score.Found >= 155, score.ToString());
        Assert.True(score.CornerMedian <= 0.3, score.ToString());
    }

    private void CheckFrames(string set, int expected, int atLeast, double cornerRms)
    {
        string folder = Path.Combine(GeneratedPicturesFactAttribute.Folder!, set);
        using JsonDocument truth = JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, "truth.json")));
        var reader = new PictureReader();
        var score = new MarkerScore();
        foreach (JsonElement frame in truth.RootElement.GetProperty("frames").EnumerateArray())
        {
            string file = frame.GetProperty("file").GetString()!;
            List<ListedMarker> markers = [.. frame.GetProperty("targets").EnumerateArray()
                .Where(t => t.GetProperty("class").GetString() == "marker")
                .Select(t => MarkerOf(t.GetProperty("marker"), t))];
            score.Add(reader.Load(Path.Combine(folder, file)), file, markers);
        }

        Check(score, set, expected, atLeast, cornerRms);
    }

    private static ListedMarker MarkerOf(JsonElement marker, JsonElement target)
        => ListedMarker.Of(marker, target.GetProperty("fraction_visible").GetDouble());

    private void Check(MarkerScore score, string set, int expected, int atLeast, double cornerRms)
    {
        output.WriteLine($"{set}: {score}");
        Assert.Empty(score.Wrong);
        Assert.Equal(expected, score.Expected);
        Assert.True(score.Found >= atLeast, score.ToString());
        Assert.True(score.CornerRms <= cornerRms, score.ToString());
    }
}
