using System;
using System.Collections.Generic;
using System.Globalization;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Preflight;

/// <summary>
/// How large the target that is the hardest to resolve is in the pictures of a mission, from its height above level
/// ground: those in which it is too small are not searched. Immutable; any thread.
/// </summary>
internal sealed class SearchResolution
{
    // Of what is needed. The height of a flight and its tilt vary by a few parts in a hundred.
    private const double Slack = 1.05;

    private readonly TargetClass _target;
    private readonly double _heightMetres;

    private SearchResolution(TargetClass target, double heightMetres, double pixels, double neededPixels)
        => (_target, _heightMetres, Pixels, NeededPixels) = (target, heightMetres, pixels, neededPixels);

    /// <summary>
    /// Side of the smallest target of the class in the middle of the picture; 0 where it shows no ground.
    /// </summary>
    public double Pixels { get; }

    /// <summary>What a picture is searched from on.</summary>
    public double NeededPixels { get; }

    /// <summary>Whether no picture from that height would be searched.</summary>
    public bool IsTooCoarse => !(Pixels >= NeededPixels);

    /// <summary>Whether some would not.</summary>
    public bool IsScarce => !(Pixels >= Slack * NeededPixels);

    /// <summary>The greatest height that would do, in whole metres, to be read.</summary>
    public double SufficientHeightMetres => Math.Floor(_heightMetres * Pixels / (Slack * NeededPixels));

    /// <summary>Judges a mission's camera; null where there is nothing to search for, or no smallest size.</summary>
    /// <param name="camera">The camera, without faults.</param>
    /// <param name="mount">How it sits on the vehicle.</param>
    /// <param name="pitch">Where it points, up positive.</param>
    /// <param name="yaw">Where it points, right positive.</param>
    /// <param name="heightMetres">Height above the ground.</param>
    /// <param name="minTargetPixels">What is to be resolved of a target that is as easy to find as a panel.</param>
    /// <param name="classes">Those that are searched for.</param>
    public static SearchResolution? Of(
        CameraModel camera, CameraMount mount, Angle pitch, Angle yaw, double heightMetres, double minTargetPixels,
        IEnumerable<TargetClass> classes)
    {
        TargetClass? hardest = null;
        foreach (TargetClass one in classes)
        {
            if (hardest is null || one.ResolvedSideMetres < hardest.ResolvedSideMetres)
                hardest = one;
        }

        if (hardest is null || !(minTargetPixels > 0))
            return null;
        double sampling = SamplingMetres(camera, mount.At(pitch, yaw), heightMetres);
        double needed = minTargetPixels * hardest.MinSideMetres / hardest.ResolvedSideMetres;
        return new SearchResolution(hardest, heightMetres, hardest.MinSideMetres / sampling, needed);
    }

    /// <summary>In words: <c>person of 0.5 m: 6.6 pixels from 40 m; 4 are needed</c>.</summary>
    public override string ToString()
    {
        if (Pixels <= 0)
            return "the middle of the picture shows no ground";
        string text = string.Format(
            CultureInfo.InvariantCulture, "{0} of {1:0.##} m: {2:0.0} pixels from {3:0.#} m; {4:0.0} are needed",
            _target.Name, _target.MinSideMetres, Math.Floor(10 * Pixels) / 10, _heightMetres,
            Math.Ceiling((10 * NeededPixels) - 1e-9) / 10);
        return !IsScarce ? text : string.Format(
            CultureInfo.InvariantCulture, "{0}, as from {1:0} m", text, SufficientHeightMetres);
    }

    // As Image Processing does: by the area of the pixel in the middle. A vehicle that is level and flies north.
    private static double SamplingMetres(CameraModel camera, in CameraExtrinsics extrinsics, double heightMetres)
    {
        (double column, double row) = (camera.CentreX, camera.CentreY);
        if (!TryLocate(camera, extrinsics, heightMetres, column - 0.5, row, out NedPosition left)
            || !TryLocate(camera, extrinsics, heightMetres, column + 0.5, row, out NedPosition right)
            || !TryLocate(camera, extrinsics, heightMetres, column, row - 0.5, out NedPosition above)
            || !TryLocate(camera, extrinsics, heightMetres, column, row + 0.5, out NedPosition below))
            return double.PositiveInfinity;
        return Math.Sqrt(Math.Abs(
            ((right.North - left.North) * (below.East - above.East))
                - ((right.East - left.East) * (below.North - above.North))));
    }

    private static bool TryLocate(
        CameraModel camera, in CameraExtrinsics extrinsics, double heightMetres, double column, double row,
        out NedPosition ground)
    {
        ground = default;
        if (!camera.TryUndistort(column, row, out double x, out double y))
            return false;
        (double forward, double right, double down) = extrinsics.BodyFromCamera.Apply(x, y, 1);
        var ray = new GroundRay(
            new NedPosition(
                extrinsics.PositionMetres.Forward, extrinsics.PositionMetres.Right,
                extrinsics.PositionMetres.Down - heightMetres),
            new NedVector(forward, right, down));
        return ray.TryIntersectLevel(0, Angle.FromDegrees(1), out ground);
    }
}
