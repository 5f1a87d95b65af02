using System;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation;

// A detector of your own in the simulated search: pixels in, detections out. The rest stays as it is.
MissionPlan mission = MissionPlan.Parse(
    """
    {
      "name": "raft", "targets": ["raft"],
      "area": [[47.39730, 8.54470], [47.39780, 8.54470], [47.39780, 8.54560], [47.39730, 8.54560]],
      "heightMetres": 30, "speedMetresPerSecond": 5, "laneSpacingMetres": 22
    }
    """,
    "OwnDetector");
var worldOptions = new SimulationOptions { Seed = 4, TargetCount = 1, DistractorCount = 0 };   // one orange panel
worldOptions.TakePlacesFrom(mission);
var world = new SimulatedWorld(worldOptions);
var telemetry = new MemoryLinkPair("telemetry");

using UavSystem uav = UavSystem.Open(new UavOptions
{
    OpenLinks = [telemetry.A],
    OtherManagers = [world.CreateVehicle(telemetry.B)],
    Mission = mission,
    MayCommand = true,
    Camera = world.CreateCamera(),
    Imaging = new ImageProcessingOptions
    {
        Camera = world.CameraModel,
        Mount = world.CameraMount,
        TargetClasses = [new TargetClass("raft") { MinSideMetres = 0.5, MaxSideMetres = 2 }],
        Detector = new RaftDetector(),
    },
    Time = new VirtualTime(worldOptions.Seed),
});
RabitReactor reactor = uav.CreateReactor(new ReactorOptions());
MessageSubscriber<TrackList> tracks = reactor.Workspace.Subscribe<TrackList>(MessageNames.Tracks);
reactor.Start();
reactor.RunFor(TimeSpan.FromMinutes(3));
reactor.Stop();
ReactorResult result = reactor.Finish();
tracks.Fetch();
foreach (TargetTrack track in tracks.Value.Tracks)
    Console.WriteLine($"{track.Class}: {track.State}, {track.Reports} reports, {track.SizeMetres:0.0} m wide");
return result.ExitCode;

/// <summary>Reports the centre of all strongly orange pixels.</summary>
internal sealed class RaftDetector : ITargetDetector
{
    private static readonly TargetClassName Raft = new("raft");

    public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
    {
        ReadOnlySpan<byte> pixels = input.Pixels.Span;
        (double count, double columns, double rows) = (0, 0, 0);
        for (int pixel = 0; pixel < input.Width * input.Height; pixel++)
        {
            if (pixels[3 * pixel] < 150 || pixels[(3 * pixel) + 1] > 140 || pixels[(3 * pixel) + 2] > 80)
                continue;
            count++;
            columns += pixel % input.Width;
            rows += pixel / input.Width;
        }

        if (count < 20)
            return DetectorResult.Found(0);
        (double x, double y, double side) = (columns / count, rows / count, Math.Sqrt(count));
        ref TargetDetection raft = ref detections[0];
        raft = new TargetDetection { Class = Raft, CentreX = x, CentreY = y, WidthPixels = side, HeightPixels = side };
        (raft.Score, raft.Covariance) = (0.9, PixelCovariance.FromSigma(1));
        return DetectorResult.Found(1);
    }
}
