using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.Simulation.Tests.Camera;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Vision;

/// <summary>The pictures of a flight over a field of targets through Image Processing, and what it reported.</summary>
internal sealed class Survey(
    WorldFrame frame, IReadOnlyList<SimulatedTarget> things, ReportSink sink, SurveyFlight flight)
{
    /// <summary>Flies it with true poses for 45 s.</summary>
    public static Survey Fly(
        ulong seed, double height, Action<SimulatedCameraOptions>? change = null, double pitchDegrees = -90,
        int targets = 10, int partlyHidden = 0, params SimulatedTargetKind[] kinds)
    {
        var camera = new SimulatedCameraOptions();
        change?.Invoke(camera);
        var truth = new TruthHistory(400);
        var frame = new WorldFrame(GeodeticPosition.FromRadians(0.8395, 0.1486, 445));
        IReadOnlyList<SimulatedTarget> things = TargetField.Place(
            seed, Scene.Corners((-5, -10), (-5, 65), (75, 65), (75, -10)), targets, 10, kinds, partlyHidden);
        var source = new SimulatedCamera(camera, truth, things, seed);
        var manager = new ImageProcessingManager(
            new ImageProcessingOptions
            {
                TargetClasses =
                [
                    .. TargetClass.Defaults,
                    .. things.Select(t => t.Declared).OfType<TargetClass>().GroupBy(c => c.Name).Select(c => c.First()),
                ],
                Camera = camera.Camera,
                Mount = new CameraMount
                {
                    GimbalLeverArmMetres = new BodyVector(
                        camera.LeverArmForwardMetres, camera.LeverArmRightMetres, camera.LeverArmDownMetres),
                },
            },
            source);
        var sink = new ReportSink();
        var order = new ImagingCommand
        {
            Mode = ImagingMode.Search,
            CameraPitch = Angle.FromDegrees(pitchDegrees),
            GroundAltitudeAmslMetres = frame.Origin.AltitudeAmslMetres,
        };
        var flight = new SurveyFlight(truth, frame, height, order);
        var reactor = new RabitReactor(new VirtualTime((long)seed))
        {
            flight,
            manager,
            sink
        };
        reactor.Start();
        reactor.RunFor(TimeSpan.FromSeconds(45));
        reactor.Stop();
        Assert.Equal(0, reactor.Finish().ExitCode);
        Assert.Empty(source.BufferHolders());
        Assert.InRange(sink.Observations.Count, 85, 90);
        return new Survey(frame, things, sink, flight);
    }

    public IReadOnlyList<SimulatedTarget> Things { get; } = things;

    public ReportSink Sink { get; } = sink;

    /// <summary>What of the targets was seen, in the pictures that show them whole and so large.</summary>
    public SurveyCount Count(double margin, double minPixels)
    {
        var count = new SurveyCount();
        foreach (CameraObservation observation in Sink.Observations)
        {
            foreach (SimulatedTarget target in Things.Where(
                t => !t.IsDistractor && IsInside(observation, t, margin) && PixelsOf(observation, t) >= minPixels))
            {
                count.Expected++;
                count.Found += IsReported(target, observation) ? 1 : 0;
            }
        }

        count.Wrong = Sink.Reports.Count(IsOfNothing);
        return count;
    }

    /// <summary>By name what was missed in how many pictures, and each report of nothing.</summary>
    public IEnumerable<string> DescribeFaults(double margin)
    {
        foreach (SimulatedTarget target in Things.Where(t => !t.IsDistractor))
        {
            CameraObservation[] seen = [.. Sink.Observations.Where(o => IsInside(o, target, margin))];
            int missed = seen.Count(o => !IsReported(target, o));
            if (missed > 0)
                yield return $"{target.Name} ({target.Class}) missed in {missed} of {seen.Length} pictures";
        }

        foreach (TargetReport report in Sink.Reports.Where(IsOfNothing))
            yield return "wrong: " + Describe(report);
    }

    private bool IsReported(SimulatedTarget target, CameraObservation observation)
        => Sink.Reports.Any(r => r.PictureNumber == observation.Number && r.Class == target.Class
            && ErrorOf(r, target) < 1.5);

    private bool IsOfNothing(TargetReport report)
        => !Things.Any(t => !t.IsDistractor && t.Class == report.Class && ErrorOf(report, t) < 2.5);

    // The shorter side of the picture of a panel of 1 m, from the middle of the camera's track.
    private double PixelsOf(CameraObservation observation, SimulatedTarget target)
    {
        NedPosition camera = flight.PoseAt(observation.Time).Position;
        double height = -camera.Down;
        double range2 = Math.Pow(target.Position.North - camera.North, 2)
            + Math.Pow(target.Position.East - camera.East, 2) + (height * height);
        return 530 * height / range2;
    }

    public double ErrorOf(TargetReport report, SimulatedTarget target)
    {
        NedVector at = frame.ToWorld(report.Position);
        return Math.Sqrt(
            Math.Pow(at.North - target.Position.North, 2) + Math.Pow(at.East - target.Position.East, 2));
    }

    public string Describe(TargetReport report)
    {
        SimulatedTarget nearest = Things.OrderBy(t => ErrorOf(report, t)).First();
        return $"{report.Class} in observation {report.PictureNumber}, {report.SizeMetres:F2} m, score "
            + $"{report.Score:F2}, nearest is {nearest.Name} at {ErrorOf(report, nearest):F1} m";
    }

    public bool IsInside(CameraObservation observation, SimulatedTarget target, double margin)
    {
        NedVector[] corners = [frame.ToWorld(observation.TopLeft), frame.ToWorld(observation.TopRight),
            frame.ToWorld(observation.BottomRight), frame.ToWorld(observation.BottomLeft)];
        for (int i = 0; i < 4; i++)
        {
            (NedVector a, NedVector b) = (corners[i], corners[(i + 1) % 4]);
            (double north, double east) = (b.North - a.North, b.East - a.East);
            double length = Math.Sqrt((north * north) + (east * east));

            // Clockwise seen from above: the inside is to the right.
            double inside =
                ((north * (target.Position.East - a.East)) - (east * (target.Position.North - a.North))) / length;
            if (inside < margin)
                return false;
        }

        return true;
    }
}
