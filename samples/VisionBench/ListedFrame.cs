using System.Collections.Immutable;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Vision;

namespace VisionBench;

/// <summary>One picture of a set with its pose and its targets.</summary>
internal sealed class ListedFrame
{
    private readonly double _metresPerPixel = double.NaN;

    public ListedFrame(string folder, int index, JsonElement json, CameraModel camera)
    {
        string name = json.GetProperty("file").GetString()!;
        Name = Path.GetFileNameWithoutExtension(name);
        FilePath = Path.Combine(folder, name);
        Index = index;
        Camera = camera;
        JsonElement pose = json.GetProperty("pose");
        JsonElement rotation = pose.GetProperty("R_ned_from_cam");
        NedFromCamera = Rotation.FromMatrix(
            Row(rotation[0], 0), Row(rotation[0], 1), Row(rotation[0], 2),
            Row(rotation[1], 0), Row(rotation[1], 1), Row(rotation[1], 2),
            Row(rotation[2], 0), Row(rotation[2], 1), Row(rotation[2], 2));
        HeightMetres = -pose.GetProperty("cam_center_ned_m")[2].GetDouble();
        Targets = json.GetProperty("targets").EnumerateArray().Select(t => new ListedTarget(t)).ToImmutableArray();
        Distractors = json.GetProperty("distractors").EnumerateArray().Select(d => new ListedDistractor(d))
            .ToImmutableArray();
        Markers = new MarkerPicture(
            Name, FilePath, index, [.. Targets.Where(t => t.Marker is not null).Select(t => t.Marker!)],
            IsOnAnUnknownMarker);
    }

    /// <summary>A photo whose pose is not known, but what a pixel is on the ground.</summary>
    public ListedFrame(
        string folder, int index, string file, (int Width, int Height) size, double metresPerPixel,
        ImmutableArray<ListedTarget> targets)
    {
        Name = Path.GetFileNameWithoutExtension(file);
        FilePath = Path.Combine(folder, file);
        Index = index;
        Camera = new CameraModel { Width = size.Width, Height = size.Height };
        _metresPerPixel = metresPerPixel;
        Targets = targets;
        Distractors = [];
        Markers = new MarkerPicture(Name, FilePath, index, [], _ => false);
    }

    public string Name { get; }

    public string FilePath { get; }

    /// <summary>From 1, in the order of the set: odd ones are for tuning.</summary>
    public int Index { get; }

    public CameraModel Camera { get; }

    public Rotation NedFromCamera { get; }

    /// <summary>Of the camera above the level ground.</summary>
    public double HeightMetres { get; }

    public ImmutableArray<ListedTarget> Targets { get; }

    public ImmutableArray<ListedDistractor> Distractors { get; }

    /// <summary>The markers among the targets.</summary>
    public MarkerPicture Markers { get; }

    public PictureGroundScale CreateScale() => double.IsNaN(_metresPerPixel)
        ? PictureGroundScale.OfLevelGround(Camera, NedFromCamera, HeightMetres)
        : PictureGroundScale.Uniform(_metresPerPixel);

    // Of some sets the truth does not say which marker it is.
    private bool IsOnAnUnknownMarker(DetectedMarker marker) => Targets.Any(
        t => t.Kind == "marker" && t.Marker is null && t.Covers(marker.Corners.Centre.X, marker.Corners.Centre.Y));

    private static double Row(JsonElement row, int column) => row[column].GetDouble();
}
