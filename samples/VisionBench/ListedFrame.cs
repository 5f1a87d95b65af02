using System;
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
        string name = json.TextOf("file");
        Name = Path.GetFileNameWithoutExtension(name);
        FilePath = Path.Combine(folder, name);
        Index = index;
        Camera = camera;
        JsonElement pose = json.FieldOf("pose");
        double[][] rows = [.. pose.EachOf("R_ned_from_cam", (row, _) => TruthJson.Numbers(row, 3)
            ?? throw new FormatException("it must be a list of 3 numbers"))];
        if (rows.Length != 3)
            throw new FormatException("\"R_ned_from_cam\" must be a list of 3 rows");
        NedFromCamera = Rotation.FromMatrix(
            rows[0][0], rows[0][1], rows[0][2], rows[1][0], rows[1][1], rows[1][2], rows[2][0], rows[2][1], rows[2][2]);
        HeightMetres = -pose.NumbersOf("cam_center_ned_m", 3)[2];
        Targets = [.. json.EachOf("targets", (t, _) => new ListedTarget(t))];
        Distractors = [.. json.EachOf("distractors", (d, _) => new ListedDistractor(d))];
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
}
