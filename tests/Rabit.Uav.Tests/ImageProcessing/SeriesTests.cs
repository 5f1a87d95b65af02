using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.Geometry;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// Pictures with the poses around them, as an autopilot sends them: other clock, gaps, rolling shutters.
/// </summary>
public sealed class SeriesTests
{
    [Fact]
    public void Find_RecordedSeries_LocatesItsPicturesAsTheReferenceDoes()
    {
        Dictionary<int, JsonElement> series = Vectors.Geolocation.Each("series")
            .ToDictionary(s => s.GetProperty("id").GetInt32());
        Dictionary<int, PoseHistory> histories = series.ToDictionary(s => s.Key, s => Filled(s.Value));
        (int located, int refused) = (0, 0);
        foreach (JsonElement image in Vectors.Geolocation.Each("series_images"))
        {
            int id = image.GetProperty("series").GetInt32();
            JsonElement own = series[id];
            double start = own.Each("samples").First()[0].GetDouble();
            CameraModel camera = CameraVectors.Camera(
                image.GetProperty("cam").GetInt32(), own.Number("line_time_s"));
            var rows = new RowPoses(camera, histories[id], TimeSpan.Zero);
            var frame = new CameraFrame
            {
                FrameStart = Seconds(
                    image.Number("frame_start_camera_clock") - own.Number("clock_offset_s") - start),
                Exposure = Seconds(image.Number("exposure_s")),
            };
            PoseLookup answer = histories[id].Find(rows.TimeOf(frame, image.Number("v")), out Pose pose);
            if (image.Text("status") == "not_bracketed")
            {
                Assert.Equal(PoseLookup.NotYet, answer);
                refused++;
                continue;
            }

            Assert.Equal(PoseLookup.Known, answer);
            JsonElement mount = image.GetProperty("mount");
            var projector = new GroundProjector(
                camera, CameraVectors.Mount(mount), new ErrorBudget(), Angle.FromDegrees(5));
            GroundProjection projection = projector.At(pose, new ImagingCommand
            {
                CameraPitch = Angle.FromRadians(mount.Radians("el")),
                CameraYaw = Angle.FromRadians(mount.Radians("az")),
                GroundAltitudeAmslMetres = image.Number("ground_h"),
            });
            Assert.True(
                projection.TryProjectToGround(image.Number("u"), image.Number("v"), out GeodeticPosition place));
            double error = Vectors.Distance(image.GetProperty("target_interpolated").Position(), place);
            Assert.True(error < 1e-4, $"picture {image.Number("id")} is off by {error} m");
            Assert.True(
                Vectors.Distance(image.GetProperty("target_true").Position(), place)
                    < image.Number("interp_error_m") + 0.005);
            located++;
        }

        Assert.True(located >= 8 && refused >= 1);
        if (Vectors.AreWhole)
            Assert.Equal((144, 16), (located, refused));
    }

    private static PoseHistory Filled(JsonElement series)
    {
        var history = new PoseHistory(TimeSpan.FromSeconds(1));
        double[][] samples = series.Each("samples")
            .Select(s => s.EnumerateArray().Select(n => n.GetDouble()).ToArray()).ToArray();
        foreach (double[] s in samples)
        {
            TimeSpan time = Seconds(s[0] - samples[0][0]);
            history.Add(new PoseSample
            {
                Kind = PoseSampleKind.Position,
                Time = time,
                Position = GeodeticPosition.FromDegrees(s[1], s[2], s[3]),
                VelocityNed = new NedVector(s[4], s[5], s[6]),
            });
            history.Add(new PoseSample
            {
                Kind = PoseSampleKind.Attitude,
                Time = time,
                Attitude = EulerAngles.FromDegrees(s[7], s[8], s[9]),
            });
        }

        return history;
    }

    private static TimeSpan Seconds(double seconds)
        => TimeSpan.FromTicks((long)Math.Round(seconds * TimeSpan.TicksPerSecond));
}
